#include "inputs/projection.h"

#include <GeographicLib/AlbersEqualArea.hpp>
#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <GeographicLib/Ellipsoid.hpp>
#include <GeographicLib/LambertConformalConic.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>

#include "foundation/errors.h"
#include "foundation/units.h"

namespace orogen {
namespace {

using Map = std::function<glm::dvec2(glm::dvec2)>;
struct Maps {
  Map forward, reverse;
};

constexpr double kEquatorWgs84 = 6378137.0;
constexpr double kFlatteningWgs84 = 1.0 / 298.257223563;
constexpr double kFlatteningGrs80 = 1.0 / 298.257222101;

[[noreturn]] void refuse(const std::string& proj4, const std::string& why) {
  throw InputError("proj4: " + why + ", in '" + proj4.substr(0, 200) + "'");
}

/// The "+key=value" words of a PROJ string; each must be used, or it is refused.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {
    std::size_t i = 0;
    while (i < text.size()) {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n", i), text.size());
      std::string_view word = text.substr(i, end - i);
      i = end + 1;
      if (word.empty()) continue;
      if (word.front() == '+') word.remove_prefix(1);
      const std::size_t equals = word.find('=');
      const std::string key(word.substr(0, equals));
      if (words_.count(key)) refuse(text_, "+" + key + " stands twice");
      words_[key] = equals == word.npos ? "" : std::string(word.substr(equals + 1));
    }
  }
  std::optional<std::string> take(const std::string& key) {
    const auto it = words_.find(key);
    if (it == words_.end()) return {};
    std::string value = it->second;
    words_.erase(it);
    return value;
  }
  std::optional<double> take_number(const std::string& key, double low, double high) {
    const auto word = take(key);
    if (!word) return {};
    double value = 0.0;
    const auto [end, error] = std::from_chars(word->data(), word->data() + word->size(), value);
    if (error != std::errc() || end != word->data() + word->size() || !(value >= low) ||
        !(value <= high)) {
      char range[80];
      std::snprintf(range, sizeof range, " must be a number from %g to %g", low, high);
      refuse(text_, "+" + key + range);
    }
    return value;
  }
  double number(const std::string& key, double low, double high, double otherwise) {
    return take_number(key, low, high).value_or(otherwise);
  }
  void expect_used() const {
    if (!words_.empty()) refuse(text_, "+" + words_.begin()->first + " is not known here");
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::map<std::string, std::string> words_;
};

struct Figure {
  double a = kEquatorWgs84, f = kFlatteningWgs84;  // m, 1
};

Figure take_figure(Words& words) {
  Figure figure;
  const auto named = [&](const std::string& name) {
    if (name == "GRS80" || name == "NAD83")
      figure.f = kFlatteningGrs80;
    else if (name != "WGS84")
      refuse(words.text(), "of ellipsoids and datums only WGS84, GRS80 and NAD83 are known");
  };
  if (const auto datum = words.take("datum")) named(*datum);
  if (const auto ellipsoid = words.take("ellps")) named(*ellipsoid);
  if (const auto shift = words.take("towgs84"))
    if (shift->find_first_not_of("0,.") != std::string::npos)
      refuse(words.text(), "a datum shift (+towgs84) is not supported");
  if (const auto radius = words.take_number("R", 1e3, 1e9)) figure = {*radius, 0.0};
  if (const auto a = words.take_number("a", 1e3, 1e9)) {
    figure = {*a, 0.0};
    if (const auto b = words.take_number("b", 0.5 * *a, 1.5 * *a)) figure.f = (*a - *b) / *a;
    if (const auto rf = words.take_number("rf", 2.0, 1e12)) figure.f = 1.0 / *rf;
    if (const auto f = words.take_number("f", 0.0, 0.5)) figure.f = *f;
  }
  return figure;
}

Maps azimuthal_equidistant(Words& words, const Figure& figure) {
  const double lat_0 = words.number("lat_0", -90, 90, 0),
               lon_0 = words.number("lon_0", -360, 360, 0);
  const GeographicLib::AzimuthalEquidistant p(GeographicLib::Geodesic(figure.a, figure.f));
  return {[=](glm::dvec2 g) {
            glm::dvec2 q;
            p.Forward(lat_0, lon_0, g.y, g.x, q.x, q.y);
            return q;
          },
          [=](glm::dvec2 q) {
            glm::dvec2 g;
            p.Reverse(lat_0, lon_0, q.x, q.y, g.y, g.x);
            return g;
          }};
}

/// A projection of GeographicLib's about the meridian lon_0, with its false northing at lat_0.
template <class Meridional>
Maps about_meridian(const Meridional& p, double lat_0, double lon_0) {
  double x = 0.0, northing = 0.0;
  p.Forward(lon_0, lat_0, lon_0, x, northing);
  return {[=](glm::dvec2 g) {
            glm::dvec2 q;
            p.Forward(lon_0, g.y, g.x, q.x, q.y);
            return glm::dvec2{q.x, q.y - northing};
          },
          [=](glm::dvec2 q) {
            glm::dvec2 g;
            p.Reverse(lon_0, q.x, q.y + northing, g.y, g.x);
            return g;
          }};
}

Maps transverse_mercator(const Figure& figure, double lat_0, double lon_0, double k) {
  return about_meridian(GeographicLib::TransverseMercator(figure.a, figure.f, k), lat_0, lon_0);
}

Maps lambert_conformal(Words& words, const Figure& figure, double k) {
  const auto lat_1 = words.take_number("lat_1", -89, 89);
  const auto lat_2 = words.take_number("lat_2", -89, 89);
  const auto lat_0 = words.take_number("lat_0", -90, 90);
  if (!lat_1 && !lat_0) refuse(words.text(), "lcc needs +lat_1 (and +lat_2) or +lat_0");
  const double first = lat_1.value_or(lat_0.value_or(0.0)), second = lat_2.value_or(first);
  const GeographicLib::LambertConformalConic p(figure.a, figure.f, first, second, k);
  return about_meridian(p, lat_0.value_or(lat_2 ? 0.0 : first),
                        words.number("lon_0", -360, 360, 0));
}

Maps albers(Words& words, const Figure& figure) {
  const auto lat_1 = words.take_number("lat_1", -89, 89);
  if (!lat_1) refuse(words.text(), "aea needs +lat_1 and +lat_2");
  const double lat_2 = words.number("lat_2", -89, 89, *lat_1);
  const GeographicLib::AlbersEqualArea p(figure.a, figure.f, *lat_1, lat_2, 1.0);
  return about_meridian(p, words.number("lat_0", -90, 90, 0), words.number("lon_0", -360, 360, 0));
}

Maps mercator(Words& words, const Figure& figure, double k) {
  if (const auto lat_ts = words.take_number("lat_ts", -89, 89)) {
    const double sine = std::sin(radians(*lat_ts)), e2 = figure.f * (2.0 - figure.f);
    k = std::cos(radians(*lat_ts)) / std::sqrt(1.0 - e2 * sine * sine);
  }
  const GeographicLib::LambertConformalConic p(figure.a, figure.f, 0.0, k);
  return about_meridian(p, 0.0, words.number("lon_0", -360, 360, 0));
}

Maps polar_stereographic(Words& words, const Figure& figure, std::optional<double> k) {
  const double lat_0 = words.number("lat_0", -90, 90, 0),
               lon_0 = words.number("lon_0", -360, 360, 0);
  if (std::fabs(lat_0) != 90.0)
    refuse(words.text(), "stere is known about a pole only (+lat_0=90 or -90)");
  const bool north = lat_0 > 0;
  GeographicLib::PolarStereographic p(figure.a, figure.f, k.value_or(1.0));
  if (const auto lat_ts = words.take_number("lat_ts", -90, 90))
    p.SetScale(north ? *lat_ts : -*lat_ts, 1.0);
  return {[=](glm::dvec2 g) {
            glm::dvec2 q;
            p.Forward(north, g.y, g.x - lon_0, q.x, q.y);
            return q;
          },
          [=](glm::dvec2 q) {
            glm::dvec2 g;
            p.Reverse(north, q.x, q.y, g.y, g.x);
            return glm::dvec2{std::remainder(g.x + lon_0, 360.0), g.y};
          }};
}

/// Lambert azimuthal equal-area (Snyder 1987, section 24), beta: authalic latitude, r_q: authalic
/// radius. At the poles and the equator the same formulas hold.
Maps lambert_equal_area(Words& words, const Figure& figure) {
  const double lat_0 = words.number("lat_0", -90, 90, 0),
               lon_0 = words.number("lon_0", -360, 360, 0);
  const GeographicLib::Ellipsoid body(figure.a, figure.f);
  const double r_q = std::sqrt(body.Area() / (4.0 * std::numbers::pi));
  const double beta_0 = radians(body.AuthalicLatitude(lat_0));
  const double sin_0 = std::sin(beta_0), cos_0 = std::cos(beta_0);
  // D keeps the scale true at the centre; at a pole both its parts vanish together.
  const double phi_0 = radians(lat_0), e2 = figure.f * (2.0 - figure.f);
  const double m_0 = std::cos(phi_0) / std::sqrt(1.0 - e2 * std::sin(phi_0) * std::sin(phi_0));
  const double d = std::fabs(lat_0) > 89.999999 ? 1.0 : figure.a * m_0 / (r_q * cos_0);
  return {[=](glm::dvec2 g) {
            const double beta = radians(body.AuthalicLatitude(g.y)), turn = radians(g.x - lon_0);
            const double sin_b = std::sin(beta), cos_b = std::cos(beta), cos_t = std::cos(turn);
            const double b = r_q * std::sqrt(2.0 / (1.0 + sin_0 * sin_b + cos_0 * cos_b * cos_t));
            return glm::dvec2{b * d * cos_b * std::sin(turn),
                              b / d * (cos_0 * sin_b - sin_0 * cos_b * cos_t)};
          },
          [=](glm::dvec2 q) {
            const glm::dvec2 s{q.x / d, q.y * d};
            const double rho = std::hypot(s.x, s.y);
            if (rho == 0.0) return glm::dvec2{lon_0, lat_0};
            const double c = 2.0 * std::asin(std::fmin(1.0, 0.5 * rho / r_q));
            const double sin_b = std::cos(c) * sin_0 + s.y * std::sin(c) * cos_0 / rho;
            const double turn = std::atan2(s.x * std::sin(c),
                                           rho * cos_0 * std::cos(c) - s.y * sin_0 * std::sin(c));
            const double beta = std::asin(std::fmax(-1.0, std::fmin(1.0, sin_b)));
            return glm::dvec2{std::remainder(lon_0 + degrees(turn), 360.0),
                              body.InverseAuthalicLatitude(degrees(beta))};
          }};
}

Maps make_maps(Words& words) {
  const auto name = words.take("proj");
  const Figure figure = take_figure(words);
  const auto k_0 = words.take_number("k_0", 1e-3, 1e3), k_1 = words.take_number("k", 1e-3, 1e3);
  const std::optional<double> k = k_0 ? k_0 : k_1;
  if (name == "aeqd") return azimuthal_equidistant(words, figure);
  if (name == "laea") return lambert_equal_area(words, figure);
  if (name == "lcc") return lambert_conformal(words, figure, k.value_or(1.0));
  if (name == "aea") return albers(words, figure);
  if (name == "merc") return mercator(words, figure, k.value_or(1.0));
  if (name == "stere") return polar_stereographic(words, figure, k);
  if (name == "tmerc") {
    const double lat_0 = words.number("lat_0", -90, 90, 0);
    return transverse_mercator(figure, lat_0, words.number("lon_0", -360, 360, 0), k.value_or(1.0));
  }
  if (name == "utm") {
    const auto zone = words.take_number("zone", 1, 60);
    if (!zone || *zone != std::floor(*zone)) refuse(words.text(), "utm needs +zone from 1 to 60");
    const double y_0 = words.take("south") ? 1e7 : 0.0;
    const Maps m = transverse_mercator(figure, 0.0, 6.0 * *zone - 183.0, 0.9996);
    const glm::dvec2 shift{5e5, y_0};
    return {[=](glm::dvec2 g) { return m.forward(g) + shift; },
            [=](glm::dvec2 q) { return m.reverse(q - shift); }};
  }
  const std::string known = "known are aeqd, tmerc, utm, lcc, merc, aea, laea and polar stere";
  if (!name) refuse(words.text(), "+proj is missing; " + known);
  if (name == "longlat" || name == "latlong")
    refuse(words.text(), "degrees are no plane (+proj=" + *name + "); " + known);
  refuse(words.text(), "the projection '" + *name + "' is not known; " + known);
}

}  // namespace

Projection::Projection(std::string_view proj4) : proj4_(proj4) {
  if (proj4.size() > 1000) refuse(proj4_, "longer than 1000 characters");
  Words words(proj4);
  words.take("no_defs");
  words.take("wktext");
  words.take("type");
  if (const auto unit = words.take("units"); unit && *unit != "m")
    refuse(proj4_, "+units must be m");
  try {
    Maps maps = make_maps(words);
    const glm::dvec2 shift{words.number("x_0", -1e9, 1e9, 0), words.number("y_0", -1e9, 1e9, 0)};
    words.expect_used();
    forward_ = [shift, f = std::move(maps.forward)](glm::dvec2 g) { return f(g) + shift; };
    reverse_ = [shift, f = std::move(maps.reverse)](glm::dvec2 q) { return f(q - shift); };
  } catch (const GeographicLib::GeographicErr& error) {
    refuse(proj4_, error.what());
  }
}

Projection Projection::about(double longitude, double latitude) {
  char text[160];
  std::snprintf(text, sizeof text,
                "+proj=aeqd +lat_0=%.4f +lon_0=%.4f +datum=WGS84 +units=m +no_defs", latitude,
                longitude);
  return Projection(text);
}

glm::dvec2 mean_direction(std::span<const glm::dvec2> lon_lat) {
  double x = 0.0, y = 0.0, z = 0.0;
  for (const glm::dvec2& g : lon_lat) {
    const double longitude = radians(g.x), latitude = radians(g.y);
    x += std::cos(latitude) * std::cos(longitude);
    y += std::cos(latitude) * std::sin(longitude);
    z += std::sin(latitude);
  }
  const double length = std::hypot(x, y, z);
  if (!(length > 0.1 * double(lon_lat.size())))
    throw InputError(
        "features: the places are spread around the whole globe, so that the map has "
        "no centre; give a 'frame' with 'proj4', or a smaller map");
  return {degrees(std::atan2(y, x)), degrees(std::atan2(z, std::hypot(x, y)))};
}

}  // namespace orogen
