// Map projections on the ellipsoid: degrees of longitude and latitude to metres and back.
//
// A projection is named by a PROJ string such as "+proj=aeqd +lat_0=42.18 +lon_0=9.06
// +datum=WGS84 +units=m". Known: aeqd, tmerc, utm, lcc, merc, aea, laea and polar stere, on WGS84,
// GRS80, a sphere (R) or a stated ellipsoid (a with b, f or rf). The series and geodesics are
// GeographicLib's (Karney 2011, 2013), good to nanometres; laea follows Snyder (1987), eqs. 24-2 to
// 24-26, through the authalic latitude. Datum shifts, grids and other units are refused by name.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>

namespace orogen {

class Projection {
 public:
  /// InputError for a string that is not understood; it says what is known.
  explicit Projection(std::string_view proj4);

  /// Azimuthal equidistant on WGS84 about a centre (degrees, rounded to 0.0001).
  static Projection about(double longitude, double latitude);

  /// Metres from (longitude, latitude) in degrees. NaN where the projection has no value.
  glm::dvec2 project(glm::dvec2 lon_lat) const { return forward_(lon_lat); }

  /// (longitude, latitude) in degrees from metres, longitude in [-180, 180].
  glm::dvec2 unproject(glm::dvec2 position) const { return reverse_(position); }

  const std::string& proj4() const { return proj4_; }

 private:
  using Map = std::function<glm::dvec2(glm::dvec2)>;
  std::string proj4_;
  Map forward_, reverse_;
};

/// Mean direction of places (longitude, latitude in degrees): the centre of a map that may lie
/// across the antimeridian. InputError if they are spread around the whole globe.
glm::dvec2 mean_direction(std::span<const glm::dvec2> lon_lat);

}  // namespace orogen
