// Ground that stays while the rest of a terrain grows anew.
//
//   z = w z_kept + (1 - w) z_new      w = 1 where `kept` is at least one half,
//                                     else 1 - smoothstep(d / margin), d the distance from there
//
// Inside, heights are the kept ones to the bit. Limits: rivers of the new ground do not know the
// kept one; where they meet in the margin, hollows may be left.
#pragma once

#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"

namespace orogen {

struct KeptRegionParameters {
  double margin = 2000.0;
};

constexpr auto parameter_table(const KeptRegionParameters*) {
  using P = KeptRegionParameters;
  return std::tuple{real("margin", &P::margin, 0.0, 100e3, "m",
                         "Width around kept ground over which new ground leads up to it.")};
}

inline const StageInfo& keep_region_stage() {
  static const StageInfo info{"keep_region",
                              "Puts back the ground of a region that is to stay.",
                              "Orogen: a blend over a margin",
                              {"elevation"},
                              {"elevation"},
                              {"rasters.kept", "rasters.kept_elevation"}};
  return info;
}

/// `kept` from 0 to 1, `kept_elevation` in metres; all on the grid of `elevation`.
void keep_region(Raster<float>& elevation, const Raster<float>& kept,
                 const Raster<float>& kept_elevation, const KeptRegionParameters& parameters,
                 const Context& context);

}  // namespace orogen
