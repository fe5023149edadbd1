// A small made-up island with peaks and rivers, for tests.
#pragma once

#include <cmath>

#include "foundation/noise.h"
#include "foundation/random.h"
#include "hydrology/river_beds.h"
#include "inputs/vector_map.h"

namespace orogen::test {

/// An island some 28 km across in a frame of 32 km: peaks (m), and rivers from near the middle.
inline VectorMap island(int seed = 0) {
  const auto u = [&](int k) { return random_uniform(seed, 77, k); };
  VectorMap map;
  map.frame = {{1000.0, -2000.0}, {32e3, 32e3}, ""};
  const glm::dvec2 middle = map.frame.origin + map.frame.size * 0.5;
  const auto at = [&](double radius, double angle) {
    return middle + radius * glm::dvec2(std::cos(angle), std::sin(angle));
  };
  Coast coast;
  for (int k = 0; k < 90; ++k)
    coast.outer.push_back(at(14e3 + 900 * std::sin(k * 0.7), k * 0.0698));
  map.coasts.push_back(coast);
  for (int k = 0; k < 4; ++k) {
    Peak peak;
    peak.position = at(2e3 + 5e3 * u(k), 1.6 * k + u(10 + k));
    peak.height_m = 600.0 + 900.0 * u(20 + k);
    map.peaks.push_back(peak);
  }
  for (int k = 0; k < 2; ++k) {
    River river;
    const double angle = 0.8 + 3.1 * k + 0.4 * u(30 + k);
    for (int j = 0; j < 8; ++j)
      river.points.push_back(at(3e3 + 1.8e3 * j, angle + 0.12 * std::sin(1.3 * j)));
    map.rivers.push_back(river);
  }
  return map;
}

inline Raster<std::uint8_t> island_land(const VectorMap& map, const Grid& grid) {
  Raster<std::uint8_t> land(grid);
  const glm::dvec2 middle = map.frame.origin + map.frame.size * 0.5;
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      const glm::dvec2 d = grid.center(r, c) - middle;
      const double k = std::fmod(std::atan2(d.y, d.x) + 2 * std::numbers::pi, 2 * std::numbers::pi);
      land(r, c) = std::hypot(d.x, d.y) < 14e3 + 900 * std::sin(k / 0.0698 * 0.7);
    }
  return land;
}

inline Grid island_grid(const VectorMap& map, int n) {
  return grid_over(map.frame.origin, map.frame.size, n);
}

}  // namespace orogen::test
