// Springs, and rivers that enter the map: constant sources of water (paper B, VI-A).
#pragma once

#include <glm/vec2.hpp>
#include <tuple>

#include "foundation/parameters.h"

namespace orogen {

struct RiverSource {
  glm::dvec2 position{0.0, 0.0};  // m
  double discharge = 50.0;        // m³/s
};

constexpr auto parameter_table(const RiverSource*) {
  return std::tuple{
      real("discharge", &RiverSource::discharge, 0.0, 1e9, "m3/s",
           "Water that comes out of the ground, or enters the map, here."),
  };
}

}  // namespace orogen
