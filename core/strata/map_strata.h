// Strata under a ground that a map has shaped: horizons of a folded column of which erosion has
// taken the more the higher the ground stands.
//
//   h_n = (1 + e) G z + Σ_i (f_i - G f_i),   h_{k-1} = h_k - max(τ_k + f_k - G f_k, τ_k / 5)
//
// z: ground (m, the sea floor too); G: Gaussian of `smoothing` metres; f_i: height of the folds of
// layer i (m); τ_k: thickness of layer k (m); e: `exhumation_share`. Plains thus keep the youngest
// rock and ranges show the oldest, folded as the layers fold.
// Limits: the ground's shape follows the folds only as far as its own making did.
#pragma once

#include <span>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/stage.h"
#include "strata/horizons.h"

namespace orogen {

struct MapStrataParameters {
  double exhumation_share = 1.0;
  double smoothing = 6000.0;  // m
};

constexpr auto parameter_table(const MapStrataParameters*) {
  using P = MapStrataParameters;
  return std::tuple{
      real("exhumation_share", &P::exhumation_share, 0.0, 10.0, "",
           "Height of rock that erosion has taken off over the height of the ground."),
      real("smoothing", &P::smoothing, 100.0, 200e3, "m",
           "Standard deviation of the blur that gives the lie of the layers at large."),
  };
}

/// `folds`: f_i of each layer, all on the grid of the ground.
HorizonStack map_horizons(const StratigraphicColumn& column, const Raster<float>& ground,
                          std::span<const Raster<float>> folds,
                          const MapStrataParameters& parameters, const Context& context);

const StageInfo& map_strata_stage();

}  // namespace orogen
