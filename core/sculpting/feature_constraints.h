// What feature curves ask of each cell of a grid (paper B, V-A, V-B and V-D).
//
// A cell belongs to the nearest point of a curve, d away:
//   plateau   d <= plateau (at least the cells that the curve runs through), where the blend of the
//             points' elevation flags is 1/2 or more: its height is asked for
//   slope     up to slope_size further: how much the ground falls on the way from the curve
//   envelope  up to `envelope` further: only smoothness is asked for
// Slopes hang on the curve where it asks for heights: onward is away from it. Where it asks for
// none they hang on what lies around them, and onward is towards the curve.
// Sides are blended around a curve's ends by the angle. Where curves overlap, plateau goes before
// slope, slope before envelope, and of the same kind what is nearer to its curve.
#pragma once

#include <cstdint>
#include <span>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "inputs/feature_curve.h"

namespace orogen {

enum class FeatureZone : std::uint8_t { None, Envelope, Slope, Plateau };

struct FeatureConstraints {
  Raster<std::uint8_t> zone;         // a FeatureZone
  Raster<float> distance;            // m, to the curve; infinity outside the envelope
  Raster<float> elevation;           // m, on plateaus
  Raster<float> slope;               // rise over run onward, on slopes
  Raster<float> onward_x, onward_y;  // unit vector away from what holds the height
};

FeatureConstraints feature_constraints(std::span<const FeatureCurve> curves, const Grid& grid,
                                       const Context& context);

}  // namespace orogen
