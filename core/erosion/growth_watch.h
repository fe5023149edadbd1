// Looking on while mountains grow, or water wears them.
//
// A watch sees the ground on a coarse grid, a few times a second. It changes nothing of what grows.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

#include "foundation/raster.h"

namespace orogen {

/// What a watch sees, in metres. Where no running water is computed there is only the elevation.
struct WatchedGround {
  Raster<float> elevation;
  Raster<float> water_depth = {};
  Raster<float> change = {};  // of the elevation since it began
};

class GrowthWatch {
 public:
  /// Takes the years since it began and the ground. Called on the computing thread, which waits
  /// for it.
  using Show = std::function<void(double years, const WatchedGround& ground)>;

  static constexpr auto kInterval = std::chrono::milliseconds(100);  // between pictures, at least
  static constexpr int kResolution = 256;  // cells along the longer side, at most

  explicit GrowthWatch(Show show) : show_(std::move(show)) {}

  bool due() const { return std::chrono::steady_clock::now() - last_ >= kInterval; }

  void show(double years, const WatchedGround& ground) {
    show_(years, ground);
    last_ = std::chrono::steady_clock::now();
  }

  /// The grid of its pictures, over the terrain's rectangle.
  static Grid grid(const Grid& terrain) {
    const int resolution = std::min(kResolution, std::max(terrain.nx, terrain.ny));
    return grid_over(terrain.origin, {terrain.width(), terrain.height()}, resolution);
  }

 private:
  Show show_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace orogen
