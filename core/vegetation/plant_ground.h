// Ground as plants find it.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

#include "foundation/bilinear.h"
#include "foundation/units.h"
#include "vegetation/placement.h"

namespace orogen {

/// A place on the ground.
struct Site {
  double height;  // m
  double slope;   // rise over run
};

/// `at`: between the centres of cells.
inline Site site_at(const Raster<float>& z, const Bilinear& at) {
  const double south = z(at.r0, at.c1) - z(at.r0, at.c0), north = z(at.r1, at.c1) - z(at.r1, at.c0);
  const double west = z(at.r1, at.c0) - z(at.r0, at.c0), east = z(at.r1, at.c1) - z(at.r0, at.c1);
  const double dx = (1.0 - at.v) * south + at.v * north, dy = (1.0 - at.u) * west + at.u * east;
  return {at(z), std::hypot(dx, dy) / z.grid().cell_size};
}

/// Limits of a kind, made ready.
class KindLimits {
 public:
  explicit KindLimits(const PlantKind& kind)
      : steepest_(std::tan(radians(std::min(kind.max_slope_deg, 89.9)))),
        lowest_(kind.min_altitude),
        highest_(kind.max_altitude) {}

  /// Share of the kind that grows at a site: 1 far from its limits, 0 beyond them.
  double share(const Site& site) const {
    if (site.height < lowest_) return 0.0;
    const double flat = (steepest_ - site.slope) / (kSteepShare * steepest_ + 1e-9);
    const double low = (highest_ - site.height) / kHighBelt;
    return std::clamp(std::min(flat, low), 0.0, 1.0);
  }

 private:
  static constexpr double kSteepShare = 0.2;  // of the steepest slope: there it gets rare
  static constexpr double kHighBelt = 150.0;  // m below the highest place: likewise
  double steepest_, lowest_, highest_;
};

inline std::vector<KindLimits> limits_of(const PlantTable& table) {
  return {table.kinds.begin(), table.kinds.end()};
}

/// No plant stands in water or on ice that never melts.
inline bool is_bare(const PlantGround& ground, std::size_t cell) {
  return ground.biome[cell] == std::int32_t(Biome::Ocean) ||
         ground.biome[cell] == std::int32_t(Biome::Lake) ||
         (ground.water_depth && (*ground.water_depth)[cell] > 0.0f) ||
         (ground.snow_cover && (*ground.snow_cover)[cell] >= 1.0f);
}

}  // namespace orogen
