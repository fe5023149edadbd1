// Maps and plates for tests: two plates whose boundary is the line x = 50 km.
#pragma once

#include "foundation/context.h"
#include "tectonics/boundaries.h"
#include "tectonics/sub_plates.h"
#include "tectonics/velocity_map.h"

namespace orogen::test {

inline VectorMap map_of(const std::vector<glm::dvec2>& peaks, double height = 1500.0,
                        glm::dvec2 size = glm::dvec2(100e3)) {
  VectorMap map;
  map.frame.size = size;
  for (const auto& p : peaks) {
    map.peaks.push_back({});
    map.peaks.back().position = p;
    map.peaks.back().height_m = height;
  }
  return map;
}

/// Two rows of peaks, 16 km to either side of the boundary.
inline VectorMap pair_map() {
  std::vector<glm::dvec2> peaks;
  for (double y = 5e3; y < 100e3; y += 15e3)
    for (double x : {34e3, 66e3}) peaks.push_back({x, y});
  return map_of(peaks);
}

struct Pair {
  PlateMap plates;
  BoundaryMap boundaries;
  VelocityMap velocity;
};

/// The pair with `left` as its western plate's motion and the opposite as the eastern one's; `spin`
/// (rad/yr) turns both plates the same way round.
inline Pair make_pair(const VectorMap& map, const Grid& grid, glm::dvec2 left, double spin,
                      const Context& context, double roughness = 0.0) {
  PlateParameters parameters;
  parameters.boundary_roughness = roughness;
  parameters.line_boundaries = false;
  const PlateMotion motions[] = {{{25e3, 50e3}, left, spin}, {{75e3, 50e3}, -left, -spin}};
  Pair pair;
  pair.plates = infer_plates(map, grid, parameters, 5, context, motions);
  pair.boundaries = plate_boundaries(pair.plates, {}, context);
  pair.velocity = velocity_map(pair.plates, {}, context);
  return pair;
}

}  // namespace orogen::test
