#include "hydrology/regional_height.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "foundation/distance_transform.h"
#include "foundation/parallel.h"
#include "hydrology/base_level.h"

namespace orogen {

namespace {

constexpr double kSourceShare = 0.75, kSourceReach = 45e3;  // m
constexpr double kLeastRiverSlope = 0.006;
constexpr double kSpringLength = 3e3;  // s0, m
constexpr double kProfileExponent = 0.2;
constexpr double kRangeShare = 0.7, kRangeReach = 9e3;   // m
constexpr double kValleyReach = 4e3, kLandSlope = 0.02;  // m, 1
constexpr int kSweeps = 400;

double profile(double s) {
  return std::pow(s + kSpringLength, kProfileExponent);
}

/// Height of each of the bed cells, in the order of `beds.cells`.
std::vector<float> bed_heights(const VectorMap& map, const RiverBeds& beds) {
  const Grid& grid = beds.river.grid();
  Raster<float> height(grid);
  std::vector<float> heights(beds.cells.size());
  for (std::size_t begin = 0; begin < beds.cells.size();) {
    const std::int32_t number = beds.river[beds.cells[begin]];
    std::size_t end = begin;
    while (end < beds.cells.size() && beds.river[beds.cells[end]] == number) ++end;
    const River& river = map.rivers[number - 1];
    const std::int32_t below = beds.receivers[begin];
    const double mouth = below >= 0                     ? height[below]
                         : river.end == RiverEnd::Frame ? river.end_height_m.value_or(0.0)
                                                        : 0.0;
    const double length = beds.source_length[begin];
    const glm::dvec2 spring = river.points.front();
    double source = mouth + kLeastRiverSlope * length;
    for (const Peak& peak : map.peaks) {
      const glm::dvec2 d = peak.position - spring;
      source = std::max(source, kSourceShare * peak.height_m.value_or(0.0) *
                                    std::exp(-std::hypot(d.x, d.y) / kSourceReach));
    }
    const double drop = std::max(profile(length) - profile(0.0), 1e-9);
    for (std::size_t i = begin; i < end; ++i) {
      const double s = std::min<double>(beds.source_length[i], length);
      heights[i] = float(mouth + (source - mouth) * (profile(length) - profile(s)) / drop);
      height[beds.cells[i]] = heights[i];
    }
    begin = end;
  }
  return heights;
}

/// Laplace's equation where `fixed` is 0, by successive over-relaxation from `surface`.
void stretch_membrane(Raster<float>& surface, const Raster<std::uint8_t>& fixed,
                      const Context& context) {
  const Grid& grid = surface.grid();
  const float omega = 1.9f;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (int colour = 0; colour < 2; ++colour)
      parallel_rows(context, grid.ny, [&](int r) {
        const int up = std::min(r + 1, grid.ny - 1), down = std::max(r - 1, 0);
        for (int c = (r + colour) & 1; c < grid.nx; c += 2) {
          if (fixed(r, c)) continue;
          const float mean =
              0.25f * (surface(r, std::max(c - 1, 0)) + surface(r, std::min(c + 1, grid.nx - 1)) +
                       surface(up, c) + surface(down, c));
          surface(r, c) += omega * (mean - surface(r, c));
        }
      });
}

}  // namespace

Raster<float> regional_height(const VectorMap& map, const Raster<std::uint8_t>& land,
                              const RiverBeds& beds, const Context& context) {
  const Grid& grid = land.grid();
  Raster<float> surface(grid);
  BaseLevel base = base_level(map, land, beds);
  Raster<std::uint8_t>& fixed = base.cells;
  for (std::size_t i = 0; i < surface.size(); ++i) surface[i] = base.height[i];
  const std::vector<float> heights = bed_heights(map, beds);
  for (std::size_t i = 0; i < beds.cells.size(); ++i) {
    fixed[beds.cells[i]] = 1;
    surface[beds.cells[i]] = heights[i];
  }
  const NearestFeature nearest = nearest_feature(fixed, context);
  Raster<float> membrane = surface;
  for (std::size_t i = 0; i < membrane.size(); ++i)
    if (!fixed[i]) membrane[i] = surface[nearest.nearest[i]];
  stretch_membrane(membrane, fixed, context);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const double base_here = membrane(r, c), d = nearest.distance(r, c);
      double range = 0.0;
      for (const Peak& peak : map.peaks) {
        const glm::dvec2 to = peak.position - grid.center(r, c);
        const double above = peak.height_m.value_or(0.0) - base_here;
        if (above > range)
          range = std::max(range, above * std::exp(-std::hypot(to.x, to.y) / kRangeReach));
      }
      const double away = 1.0 - std::exp(-d / kValleyReach);
      surface(r, c) =
          land(r, c) ? float(base_here + away * (kRangeShare * range + kLandSlope * d)) : 0.0f;
    }
  });
  return surface;
}

}  // namespace orogen
