// Fold relief and watershed map combined (paper A, section 6).
//
//   h = g (1 − m) + f m          m = smoothstep(river distance / blend_distance)
//
// The paper blends "two maps that may not be locally consistent" (its section 7). With `reconcile`
// f is first brought to agree with the rivers:
//
//   f1 = f + (z_r − f_r) / (1 + (d / R)²)²
//   f2 = f1 held between b and g + valley_wall_slope d
//   b = min over rivers and coast s of z(s) + valley_slope |p − s|
//
// z_r, f_r: heights of the bed and of the folds at the nearest river or coast cell (their
// difference is blurred by a quarter of `reconcile_distance`); d: its distance; R:
// `reconcile_distance` where the folds are raised, `blend_distance` where they are lowered. In the
// blend min(g, f2) stands for g. So f falls towards each river, hardly ever lies below it, and no
// rims stand along rivers.
//
// Limits: the result may have pits away from rivers; later stages drain it.
#pragma once

#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "hydrology/watershed_map.h"

namespace orogen {

struct CombinationParameters {
  double blend_distance = 5000.0;  // m
  bool reconcile = true;
  double reconcile_distance = 12e3;  // m
  double valley_slope = 0.01;
  double valley_wall_slope = 0.7;
};

constexpr auto parameter_table(const CombinationParameters*) {
  using P = CombinationParameters;
  return std::tuple{
      real("blend_distance", &P::blend_distance, 100.0, 200e3, "m",
           "Distance from rivers and coast from which on the folds alone make the relief."),
      boolean("reconcile", &P::reconcile, "Bring the folds to agree with the rivers first."),
      real("reconcile_distance", &P::reconcile_distance, 100.0, 200e3, "m",
           "Distance from rivers over which the folds are shifted to agree with them."),
      real("valley_slope", &P::valley_slope, 0.0, 1.0, "",
           "Least rise of the land away from rivers and coast."),
      real("valley_wall_slope", &P::valley_wall_slope, 0.05, 5.0, "",
           "Rise of the folds away from a river, above that of the watershed map, at most."),
  };
}

/// combined_relief, in metres; 0 at sea.
Raster<float> combine_relief(const Raster<float>& fold_relief, const WatershedMap& watershed,
                             const Raster<std::uint8_t>& land,
                             const CombinationParameters& parameters, const Context& context);

const StageInfo& combination_stage();

}  // namespace orogen
