// Lakes: hollows that are full to their lowest way out, of a size worth the name.
//
// A hollow's water stands at its spill level (hydrology/depressions.h), so that every lake is level
// and its outlet dry. Hollows whose water covers less than `least_lake_area` or is nowhere as deep
// as `least_lake_depth` stay dry; so do, where it is known which ground had water before, those
// that had none, unless `new_lakes`. Limits: as much flows in as evaporates from any lake; none is
// lower than its way out.
#pragma once

#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"

namespace orogen {

struct LakeParameters {
  double least_lake_area = 0.1;   // km²
  double least_lake_depth = 1.0;  // m
  bool new_lakes = false;
};

constexpr auto parameter_table(const LakeParameters*) {
  using P = LakeParameters;
  return std::tuple{
      real("least_lake_area", &P::least_lake_area, 0.0, 1e6, "km2",
           "Water that covers less than this is left out."),
      real("least_lake_depth", &P::least_lake_depth, 0.0, 1e3, "m",
           "Water that is nowhere as deep as this is left out."),
      boolean("new_lakes", &P::new_lakes,
              "Whether lakes form in hollows that had none; otherwise they do only on ground of "
              "which no stage has said where its lakes are."),
  };
}

/// Depth of lakes in m. `outside`: not 0 where water leaves; water runs off the grid's sides too.
/// `before`: depths of lakes that there were, nullptr if nothing is known of them.
Raster<float> lake_depth(const Raster<float>& elevation, const Raster<std::uint8_t>& outside,
                         const Raster<float>* before, const LakeParameters& parameters,
                         const Context& context);

}  // namespace orogen
