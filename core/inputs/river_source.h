// Springs, and rivers that enter the map: constant sources of water (paper B, VI-A).
#pragma once

#include <glm/vec2.hpp>

namespace orogen {

struct RiverSource {
  glm::dvec2 position{0.0, 0.0};  // m
  double discharge = 0.0;         // m³/s
};

inline constexpr double kMostDischarge = 1e9;  // m³/s

}  // namespace orogen
