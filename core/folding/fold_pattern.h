// Folds of layers as a pattern for the relief of a map's folds (warped_folds.h).
//
//   pattern = (u − mean u) / deviation u, held within ±3
//
// u: fold speed (m/yr). Mean and deviation are those of the cells that fold: with more than 2% of
// the greatest speed. So the pattern has mean 0 and variance 1 there, but for what is cut off.
#pragma once

#include "foundation/raster.h"

namespace orogen {

/// 0 everywhere if nothing folds.
Raster<float> fold_pattern(const Raster<float>& fold_speed);

}  // namespace orogen
