#include "strata/section_svg.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr double kWidth = 1000.0, kMargin = 50.0, kKeyLine = 18.0;

std::string format(const char* pattern, double a, double b = 0.0) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, a, b);
  return text;
}

std::string hex(std::uint32_t color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%06x", color & 0xffffffu);
  return text;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

/// A round step that cuts `length` into some five parts.
double round_step(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length / 5.0)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= length / 6.0) return step * power;
  return 10.0 * power;
}

class Drawing {
 public:
  Drawing(const Section& section, double exaggeration)
      : section_(section),
        across_(kWidth / section.distance.back()),
        exaggeration_(exaggeration),
        up_(across_ * exaggeration),
        top_(*std::max_element(section.surface.begin(), section.surface.end())) {}

  double x(double along) const { return kMargin + along * across_; }
  double y(double z) const { return kMargin + (top_ - z) * up_; }
  double bottom() const { return y(section_.base); }

  std::string point(std::size_t i, double z) const {
    return format("%.2f,%.2f ", x(section_.distance[i]), y(z));
  }

  std::string band(const SectionBand& band) const {
    std::string points;
    const std::size_t n = section_.points.size();
    for (std::size_t i = 0; i < n; ++i) points += point(i, band.top[i]);
    for (std::size_t i = n; i-- > 0;) points += point(i, band.bottom[i]);
    const std::string color = hex(band.color);
    return "<polygon points=\"" + points + "\" fill=\"" + color + "\" stroke=\"" + color +
           "\" stroke-width=\"0.2\"/>\n";
  }

  std::string ground() const {
    std::string points;
    for (std::size_t i = 0; i < section_.points.size(); ++i)
      points += point(i, section_.surface[i]);
    return "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"#222\"/>\n";
  }

  std::string scales() const {
    std::string out;
    const double length = section_.distance.back(), step = round_step(length);
    for (double s = 0.0; s <= length * 1.0001; s += step)
      out += tick(x(s), bottom() + 14.0, "middle", format("%g km", s / 1000.0));
    const double rise = round_step(std::max(top_ - section_.base, 1.0));
    for (double z = std::ceil(section_.base / rise) * rise; z <= top_; z += rise)
      out += tick(kMargin - 4.0, y(z) + 3.0, "end", format("%g m", z));
    return out;
  }

  std::string exaggeration() const {
    return tick(kMargin + kWidth, kMargin - 30.0, "end",
                exaggeration_ == 1.0 ? "no vertical exaggeration"
                                     : format("vertical exaggeration %g", exaggeration_));
  }

  static std::string tick(double x, double y, const char* anchor, const std::string& text) {
    return "<text" + format(" x=\"%.1f\" y=\"%.1f\"", x, y) + " text-anchor=\"" + anchor + "\">" +
           text + "</text>\n";
  }

 private:
  const Section& section_;
  double across_, exaggeration_, up_, top_;
};

std::string layer_name(const StratigraphicColumn& column, int layer) {
  if (layer == 0) return column.basement.name;
  if (layer > int(column.layers.size())) return "loose sediment";
  return column.layers[layer - 1].name;
}

/// One line for each layer that is met, the youngest first.
std::string key(const Section& section, const StratigraphicColumn& column, double y) {
  std::string out;
  int last = -1;
  for (auto band = section.bands.rbegin(); band != section.bands.rend(); ++band) {
    if (band->layer == last) continue;
    last = band->layer;
    out +=
        "<rect" + format(" x=\"%.1f\" y=\"%.1f\"", kMargin, y) +
        " width=\"24\" height=\"12\" fill=\"" + hex(band->color) + "\" stroke=\"#222\"/>\n" +
        Drawing::tick(kMargin + 32.0, y + 10.0, "start", escaped(layer_name(column, band->layer)));
    y += kKeyLine;
  }
  return out;
}

}  // namespace

std::string section_svg(const Section& section, const StratigraphicColumn& column,
                        double exaggeration) {
  if (!(exaggeration > 0.0 && exaggeration <= 1000.0))
    throw InputError("exaggeration: " + detail::format_number(exaggeration) +
                     " is not allowed; above 0 to 1000 is wanted");
  const Drawing drawing(section, exaggeration);
  const double key_top = drawing.bottom() + 28.0;
  const double height = key_top + kKeyLine * (column.layers.size() + 2) + kMargin;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                    format("%.0f %.0f", kWidth + 2.0 * kMargin, height) +
                    "\" font-family=\"sans-serif\" font-size=\"11\">\n";
  for (const SectionBand& band : section.bands) svg += drawing.band(band);
  return svg + drawing.ground() + drawing.scales() + drawing.exaggeration() +
         key(section, column, key_top) + "</svg>\n";
}

}  // namespace orogen
