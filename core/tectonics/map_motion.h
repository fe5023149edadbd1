// The plates that a map's peaks suggest (paper A) as plates that move (paper C).
//
// A plate's rigid part is the convex hull of its cells, drawn in about its centroid until the
// plates' hulls lie apart before and after the move; its points move with its velocity, the fastest
// by `travel` metres:
//
//   c_k = centroid + s (hull_k - centroid),   Φ(c_k) - c_k = v(c_k) travel / max |v|
//
// s is the largest of 0.8, 0.7, ... 0.1 that will do. Between the rigid parts the crust gives way.
// Limits: a single plate, or plates at rest, move nothing and raise nothing.
#pragma once

#include <tuple>

#include "foundation/parameters.h"
#include "inputs/plate_gesture.h"
#include "tectonics/sub_plates.h"

namespace orogen {

struct MapMotionParameters {
  double years = 5e6;
  double travel = 6000.0;  // m
};

constexpr auto parameter_table(const MapMotionParameters*) {
  using P = MapMotionParameters;
  return std::tuple{
      real("years", &P::years, 1e3, 1e9, "yr", "Time for which the map's plates keep moving."),
      real("travel", &P::travel, 1.0, 500e3, "m", "How far the fastest of the map's plates moves."),
  };
}

/// InputError if no drawing in sets the plates apart.
MotionPhase motion_of(const PlateMap& plates, const MapMotionParameters& parameters);

}  // namespace orogen
