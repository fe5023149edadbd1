#include "strata/section.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr double kMostPoints = 1e6;
constexpr double kShortest = 1e-6;  // line, in cells

/// Points along a line, `spacing` apart, with its corners.
void place_points(Section& section, const Polyline& line, double spacing) {
  double along = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const glm::dvec2 step = line[i + 1] - line[i];
    const double length = std::hypot(step.x, step.y);
    const int pieces = std::max(1, int(std::ceil(length / spacing - 1e-9)));
    for (int k = 0; k < pieces; ++k) {
      section.points.push_back(line[i] + step * (double(k) / pieces));
      section.distance.push_back(along + length * k / pieces);
    }
    along += length;
  }
  section.points.push_back(line.back());
  section.distance.push_back(along);
}

/// Visits the sub-layers at one place from the bottom up: visit(rock, bottom, top), cut off at the
/// base, at the top of the rock and, sediment, at the ground.
template <class Visit>
void climb(const RockTable& rocks, const float* h, float base, float rock_top, float ground,
           Visit&& visit) {
  float low = base;
  const auto rung = [&](Rock rock, float top, float limit) {
    const float high = std::clamp(top, low, std::max(low, limit));
    visit(rock, low, high);
    low = high;
  };
  for (int k = 0; k <= rocks.layers(); ++k) {
    const float bottom = rocks.bottom_of(k, h);
    const int last = rocks.sub_layers(k) - 1;
    for (int s = 0; s < last; ++s)
      rung({k, s, 0.0f}, bottom + (h[k] - bottom) * rocks.top_share(k, s), rock_top);
    rung({k, last, 0.0f}, k < rocks.layers() ? h[k] : h[k] + kSedimentGap, rock_top);
  }
  rung(loose_sediment(rocks), ground, ground);
}

/// Length of a line that lies on the grid; InputError for any other.
double checked_length(const Polyline& line, const Grid& grid) {
  using detail::format_number;
  if (line.size() < 2) throw InputError("line: at least 2 points are wanted");
  const glm::dvec2 low = grid.origin, high = low + glm::dvec2(grid.width(), grid.height());
  const double slack = 1e-6 * grid.cell_size;
  double length = 0.0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const glm::dvec2 p = line[i];
    if (!(p.x >= low.x - slack && p.x <= high.x + slack && p.y >= low.y - slack &&
          p.y <= high.y + slack))
      throw InputError("line[" + std::to_string(i) + "]: (" + format_number(p.x) + ", " +
                       format_number(p.y) + ") lies outside the terrain, which reaches from (" +
                       format_number(low.x) + ", " + format_number(low.y) + ") to (" +
                       format_number(high.x) + ", " + format_number(high.y) + ") m");
    if (i > 0) length += std::hypot(p.x - line[i - 1].x, p.y - line[i - 1].y);
  }
  if (!(length > kShortest * grid.cell_size))
    throw InputError("line: its points are all the same place");
  return length;
}

}  // namespace

Section cut_section(const RockBody& body, const Polyline& line, double spacing, double base,
                    const Context& context) {
  const double length = checked_length(line, body.elevation.grid());
  if (!std::isfinite(base)) throw InputError("base: a finite height in metres is wanted");
  if (!(spacing > 0.0) || !(length / spacing < kMostPoints))
    throw InputError("spacing: " + detail::format_number(spacing) +
                     " m is not allowed; above 0, and at most 10⁶ points along the line");
  Section section;
  section.base = base;
  place_points(section, line, spacing);
  const std::size_t n = section.points.size();
  std::vector<float> h(body.horizons.heights.size());
  for (std::size_t i = 0; i < n; ++i) {
    context.check();
    body.horizons.at(section.points[i], h.data());
    const float ground = body.ground_at(section.points[i]);
    section.surface.push_back(ground);
    std::size_t band = 0;
    const auto visit = [&](Rock rock, float bottom, float top) {
      if (band == section.bands.size())
        section.bands.push_back({rock.layer, rock.sub_layer, body.rocks.color(rock), {}, {}});
      section.bands[band].bottom.push_back(bottom);
      section.bands[band].top.push_back(top);
      ++band;
    };
    climb(body.rocks, h.data(), float(base), body.rock_top_at(section.points[i], ground), ground,
          visit);
  }
  std::erase_if(section.bands, [](const SectionBand& b) { return b.bottom == b.top; });
  return section;
}

SectionPicture draw_section(const RockBody& body, const Section& section, int width, int height,
                            double top) {
  if (width < 1 || height < 1 || width > 65536 || height > 65536)
    throw InputError("width, height: 1 to 65536 pixels are wanted");
  if (!(top > section.base)) throw InputError("top: must lie above the section's base");
  SectionPicture picture{width, height, std::vector<std::uint32_t>(std::size_t(width) * height)};
  std::vector<float> h(body.horizons.heights.size());
  for (int c = 0; c < width; ++c) {
    const double along = (c + 0.5) / width * section.distance.back();
    const auto after =
        std::upper_bound(section.distance.begin() + 1, section.distance.end() - 1, along) -
        section.distance.begin();
    const double gap = section.distance[after] - section.distance[after - 1];
    const double u = gap > 0.0 ? (along - section.distance[after - 1]) / gap : 0.0;
    const glm::dvec2 place = section.points[after - 1] * (1.0 - u) + section.points[after] * u;
    body.horizons.at(place, h.data());
    const float ground = body.ground_at(place), rock_top = body.rock_top_at(place, ground);
    for (int r = 0; r < height; ++r) {
      const float z = float(top - (r + 0.5) / height * (top - section.base));
      if (z > ground) continue;
      picture.pixels[std::size_t(r) * width + c] =
          0xff000000u | body.rocks.color(body.rock_at(h.data(), z, rock_top));
    }
  }
  return picture;
}

}  // namespace orogen
