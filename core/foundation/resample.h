// A field carried to another grid over the same ground.
//
// Values stand at cell centres; both grids are placed by their origin and cell size, so any ratio
// works and nothing is shifted. Beyond the centres of the outermost cells the source's edge value
// goes on.
//   bilinear  continuous; keeps the range of values
//   bicubic   Catmull-Rom, continuous slope; may overshoot by some 7% of a step
//   nearest   for labels and masks
//   mean      area-weighted mean over each target cell (fine to coarse); where a target cell does
//             not touch the source, the nearest value
#pragma once

#include <cstdint>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

Raster<float> resample_bilinear(const Raster<float>& source, const Grid& target,
                                const Context& context);
Raster<float> resample_bicubic(const Raster<float>& source, const Grid& target,
                               const Context& context);
Raster<float> resample_mean(const Raster<float>& source, const Grid& target,
                            const Context& context);
/// Multiplies a field by another, carried to its grid as a mean; nullptr: by 1.
void multiply(Raster<float>& field, const Raster<float>* factor, const Context& context);
Raster<std::uint8_t> resample_nearest(const Raster<std::uint8_t>& source, const Grid& target,
                                      const Context& context);

}  // namespace orogen
