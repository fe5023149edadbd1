// Ground bent to feature curves by diffusion (paper B, V-B and V-D).
//
//   H = alpha E + beta G + gamma (1 - alpha - beta) L                                      (9)
//   G = n_x² H[i - sign n_x, j] + n_y² H[i, j - sign n_y] + g                            (6, 7)
//   L = mean of the four neighbours                                                         (8)
//
// E: asked height, on plateaus, where alpha = `plateau_weight` (the paper's 0.9) and beta = 0. g:
// asked rise from the neighbour towards the curve, on slopes, where beta = `slope_weight` (0.5) and
// alpha = 0; n: unit vector away from the curve (towards it where the curve asks for no height:
// slopes that hang on nothing have no solution to speak of). gamma: 1 inside curves' envelopes.
// Outside nothing changes, to the bit, and what lies there holds the inside at its rim. Beyond the
// grid's sides L takes the cell itself.
//
// The paper repeats (9) as often as the user waits; here its fixed point is solved, by multigrid
// (five_point.h), to 1e-7 of the tallest change. It takes g from the sine of the slope's angle; a
// slope of that angle needs the tangent, and g = tan(angle) cell (|n_x|³ + |n_y|³), which makes (7)
// exact on a plane.
#pragma once

#include <span>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "inputs/feature_curve.h"
#include "sculpting/feature_constraints.h"

namespace orogen {

struct FeatureParameters {
  double plateau_weight = 0.9;
  double slope_weight = 0.5;
};

constexpr auto parameter_table(const FeatureParameters*) {
  using P = FeatureParameters;
  return std::tuple{
      real("plateau_weight", &P::plateau_weight, 0.0, 1.0, "1",
           "How strictly a feature curve's height is held on its plateau."),
      real("slope_weight", &P::slope_weight, 0.0, 1.0, "1",
           "How strictly the angle of a feature curve's slopes is held."),
  };
}

struct FeatureReport {
  int iterations = 0;
  double residual = 0.0;  // m, the largest of eq. 9
  std::size_t cells = 0;  // inside envelopes
};

/// Bends `elevation` (m). The constraints are on its grid.
FeatureReport apply_features(Raster<float>& elevation, const FeatureConstraints& constraints,
                             const FeatureParameters& parameters, Context& context);

}  // namespace orogen
