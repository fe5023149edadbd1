// What hillslopes moved: heights that were worked out in double go back to float32.
#pragma once

#include <cmath>
#include <vector>

#include "foundation/mass_balance.h"
#include "foundation/raster.h"

namespace orogen {

/// Sets the elevation to `heights` (m) and tells what that moved. `exported`: m, summed over cells.
inline MassBalance set_heights(Raster<float>& elevation, const std::vector<double>& heights,
                               double exported) {
  const double cell = elevation.grid().cell_area();
  MassBalance result;
  double change = 0.0;
  for (std::size_t i = 0; i < elevation.size(); ++i) {
    const double d = heights[i] - elevation[i];
    (d < 0.0 ? result.eroded_m3 : result.deposited_m3) += std::fabs(d) * cell;
    change += d * cell;
    elevation[i] = float(heights[i]);
  }
  result.exported_m3 = exported * cell;
  result.residual_m3 = change + result.exported_m3;
  return result;
}

}  // namespace orogen
