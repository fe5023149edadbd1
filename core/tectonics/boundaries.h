// Plate boundaries: where they run, and whether plates meet, part or slide there.
//
// Along a boundary with unit normal n from its left plate to its right one, and relative velocity
// v = v_right − v_left:
//
//   v_n = v · n,  v_t = the rest;      kind: transform if |v_t| > |v_n|, else convergent (v_n < 0)
//   convergence = −v_n / |v| · |v|² / (|v|² + v0²),  v0 = slow_speed · plate_speed
//
// in [-1, 1]: 1 head on, -1 parting, 0 sliding or at rest. It is smoothed along each boundary by a
// Gaussian of standard deviation `fade_length`, so that the kind changes gradually. The raster
// `convergence` is the value of the nearest boundary, blurred by `fade_length` (boundaries of
// different kinds meet without a step), times 1 / (1 + (d / fade_distance)²)² with the distance d.
// Normals are those of the straight sides; places are bent as the raster of plates is.
// Paper A, section 7, asks for this ("fading folds where convergent and divergent boundaries
// meet"). Limits: a plate boundary that leaves the map simply ends.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "inputs/vector_map.h"
#include "tectonics/sub_plates.h"

namespace orogen {

enum class PlateBoundaryKind : std::int32_t {
  None = 0,
  Convergent = 1,
  Divergent = 2,
  Transform = 3
};

struct BoundaryParameters {
  double fade_length = 8000.0;     // m
  double fade_distance = 30000.0;  // m
  double slow_speed = 0.1;         // of plate_speed
};

constexpr auto parameter_table(const BoundaryParameters*) {
  using P = BoundaryParameters;
  return std::tuple{
      real("fade_length", &P::fade_length, 100.0, 200e3, "m",
           "Length along a plate boundary over which its kind changes."),
      real("fade_distance", &P::fade_distance, 500.0, 500e3, "m",
           "Distance from a plate boundary at which its convergence has faded to a quarter."),
      real("slow_speed", &P::slow_speed, 0.0, 10.0, "",
           "Relative speed, over the plate speed, at which a boundary counts half."),
  };
}

struct PlateBoundary {
  int left = -1, right = -1;       // plates
  Polyline points;                 // m, bent, at most some 1 km apart
  std::vector<float> convergence;  // at each point
  std::vector<PlateBoundaryKind> kind;
};

struct BoundaryMap {
  std::vector<PlateBoundary> boundaries;
  Raster<float> boundary_distance;     // m; the grid's width + height if there is no boundary
  Raster<float> convergence;           // [-1, 1]
  Raster<std::int32_t> boundary_kind;  // PlateBoundaryKind; None beyond fade_distance
};

BoundaryMap plate_boundaries(const PlateMap& plates, const BoundaryParameters& parameters,
                             const Context& context);

const StageInfo& boundaries_stage();

}  // namespace orogen
