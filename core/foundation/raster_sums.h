// Sums of rasters.
#pragma once

#include <cstddef>

#include "foundation/raster.h"

namespace orogen {

/// to += weight * from, cell by cell; both lie on one grid.
inline void add_weighted(Raster<float>& to, const Raster<float>& from, double weight) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += float(weight * from[i]);
}

}  // namespace orogen
