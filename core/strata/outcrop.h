// The outcrop: which rock lies at the surface, and what that means to erosion.
#pragma once

#include <cstdint>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "strata/horizons.h"

namespace orogen {

/// How rocks are shown.
struct OutcropParameters {
  StrataPalette palette = StrataPalette::Natural;
  double deposition_rate = 1e-4;  // m/yr
};

constexpr auto parameter_table(const OutcropParameters*) {
  using P = OutcropParameters;
  return std::tuple{
      choice("palette", &P::palette, kStrataPaletteNames,
             "Colours of rocks: map as geological maps have them, natural as weathered rock has."),
      real("deposition_rate", &P::deposition_rate, 1e-7, 1.0, "m/yr",
           "Rate at which the column was laid down before folding, which gives rocks their age."),
  };
}

struct OutcropMap {
  Raster<std::int32_t> rock_layer, rock_sublayer, strata_color;
  Raster<float> erodibility;  // m^(1-2m)/yr
  Raster<float> age;          // yr, deposition to the end of the growth
};

/// `elapsed_years`: since the column was complete.
OutcropMap outcrop_map(const HorizonStack& horizons, const RockTable& rocks,
                       const Raster<float>& elevation, double elapsed_years,
                       const OutcropParameters& parameters, const Context& context);

const StageInfo& outcrop_stage();

}  // namespace orogen
