// Sediment slippage: loose material slides until it lies nowhere steeper than its angle of repose.
//
// For a cell i and each of its eight neighbours j at distance l, with bed heights b and the angle
// of repose theta, the excess is
//   x_ij = max(0, b_i - b_j - l tan theta)
// In one sweep cell i gives f_ij = x_ij / 8 to each neighbour, all scaled down together if their
// sum is more than the loose material there is. Every cell gathers what it is given (Jacobi), so
// the order of cells and the number of threads do not matter and the volume is conserved. Sweeps go
// on, only where something still moves, until
//   b_i - b_j <= l (tan theta + tolerance)   wherever loose material lies.
// Rock with an angle of repose of its own is loosened where it stands steeper (Stava et al. 2008,
// slippage per material): the excess over its lowest neighbour becomes sediment in place.
// Cells whose height is pinned neither give nor receive; a slope towards one of them is exempt.
#pragma once

#include <cstdint>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"

namespace orogen {

struct SlippageParameters {
  double sediment_talus_angle_deg = 33.0;
  int max_sweeps = 20000;
};

constexpr auto parameter_table(const SlippageParameters*) {
  return std::tuple{
      real("sediment_talus_angle_deg", &SlippageParameters::sediment_talus_angle_deg, 1.0, 89.0,
           "deg", "Steepest slope at which loose sediment stays (angle of repose)."),
      integer("max_sweeps", &SlippageParameters::max_sweeps, 0, 1000000, "",
              "Sweeps after which slippage stops even if some sediment still slides."),
  };
}

struct SlippageResult {
  Raster<float> sediment_thickness;  // m, after
  Raster<float> elevation;           // m, rock + sediment
  int sweeps = 0;
  double steepest_excess = 0.0;  // slope above tan theta that is left where sediment lies
  double residual_m3 = 0.0;      // volume after - volume before
};

/// Lets `sediment_thickness` (m, >= 0) slide on `rock_elevation` (m). The grid's sides are walls.
/// `pinned`: cells that neither give nor receive (nonzero), or null.
SlippageResult slip_sediment(const Raster<float>& rock_elevation,
                             const Raster<float>& sediment_thickness,
                             const SlippageParameters& parameters, Context& context,
                             const Raster<std::uint8_t>* pinned = nullptr);

}  // namespace orogen
