// All the layers of rock that fold, each at its own wavelength (paper C, eqs. 3 and 4, Table 2).
//
//   u = u_0 + Σ u_i      u_i = σ_i |C| s_i    (m/yr; fold_relief.h),  σ_i = speed_share ·
//   uplift_rate
//
// Heights are those after `folding_time` Δt: f_i = u_i Δt (heights set by hand, fold_edits.h).
// A layer's mesh is drawn by the seed and the layer's number, so that layers do not fold at the
// same places. In a preview only large folds are seen (section 5.3): layers of a wavelength shorter
// than `shortest_wavelength` are left flat.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "folding/fold_skeleton.h"
#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "tectonics/compression.h"

namespace orogen {

struct FoldLayer {
  double fold_wavelength = 7000.0;                // m
  double speed_share = 0.25;                      // σ over the uplift rate
  const Raster<float>* wavelength_map = nullptr;  // m; if set, it counts; not owned
  std::vector<FoldEdit> edits;
};

constexpr auto parameter_table(const FoldLayer*) {
  using P = FoldLayer;
  return std::tuple{
      real("fold_wavelength", &P::fold_wavelength, 50.0, 200e3, "m",
           "Distance from crest to crest of the layer's folds."),
      real("speed_share", &P::speed_share, 0.01, 0.5, "",
           "Speed at which the layer's folds grow, over the uplift rate."),
  };
}

struct FoldLayersParameters {
  double uplift_rate = 5e-4;         // m/yr
  double folding_time = 5e6;         // yr
  double shortest_wavelength = 0.0;  // m
};

constexpr auto parameter_table(const FoldLayersParameters*) {
  using P = FoldLayersParameters;
  return std::tuple{
      real("uplift_rate", &P::uplift_rate, 1e-6, 0.1, "m/yr",
           "Mean uplift rate that the layers' shares are taken of."),
      real("folding_time", &P::folding_time, 1e3, 100e6, "yr",
           "Time after which heights set by hand are reached."),
      real("shortest_wavelength", &P::shortest_wavelength, 0.0, 200e3, "m",
           "Layers with shorter folds are left flat, as in a preview."),
  };
}

struct FoldedLayer {
  FoldSkeleton skeleton;
  Raster<float> speed;                    // u_i, m/yr
  std::vector<int> edits_without_effect;  // numbers of all such edits
};

/// One result a layer, in order. InputError names the layer.
std::vector<FoldedLayer> fold_layers(const CompressionField& field,
                                     std::span<const FoldLayer> layers,
                                     const FoldLayersParameters& parameters, std::uint32_t seed,
                                     const Context& context);

}  // namespace orogen
