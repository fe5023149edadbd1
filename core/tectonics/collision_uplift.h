// Uplift of colliding plates, and the fault that bounds it (paper C, section 4.3).
//
//   dq/dt = (q − 1) / Δt,   u0 = α dq/dt where it is positive,   u0 = 0 beyond the fault
//
// q: crust of compression.h. α is set so that the mean of u0 over all cells with more than 1% of
// the greatest is `target_uplift_rate`; Δt falls out. Three things are added to the text:
// - q − 1 is smoothed by a Gaussian of `crust_smoothing` metres. With e = 0.9 q is nearly uniform
//   between two hulls with a step at each; a range must taper away from its fault. 0 leaves q.
// - Where the two nearest plates part, q > 1 counts as none: eq. 2 squeezes the ground behind
//   parting plates, because far away their motions cancel.
// - Oceanic plates do not thicken.
// The fault: within the influence region of the stable plate, the line where the smoothed q − 1 is
// `fault_level` of its greatest value; where that line ends, the border of the region. It lies
// `fault_offset` metres farther out onto the stable plate. `fault` is the signed distance to it (m,
// positive on the moving side); `fault_lines` are its stretches with uplift beside them, with the
// moving side on their left.
//
// Limits: one fault system, on one plate; q − 1 under 1e-5 is no compression. An offset line is the
// distance field's, so that its corners are rounded.
#pragma once

#include <tuple>
#include <vector>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "inputs/vector_map.h"
#include "tectonics/compression.h"
#include "tectonics/transport_field.h"

namespace orogen {

struct CollisionParameters {
  double crust_smoothing = 5000.0;   // m
  double target_uplift_rate = 5e-4;  // m/yr
  bool fault = true;
  int stable_plate = -1;
  double fault_level = 0.5;
  double fault_offset = 0.0;  // m
};

constexpr auto parameter_table(const CollisionParameters*) {
  using P = CollisionParameters;
  return std::tuple{
      real("crust_smoothing", &P::crust_smoothing, 0.0, 100e3, "m",
           "Standard deviation of the blur of the thickened crust."),
      real("target_uplift_rate", &P::target_uplift_rate, 1e-6, 0.05, "m/yr",
           "Mean rate of uplift where the crust thickens."),
      boolean("fault", &P::fault,
              "Whether a fault cuts the uplift off on the stable plate's side."),
      integer("stable_plate", &P::stable_plate, -1, 999, "",
              "Number of the plate that the fault lies on; -1 is the slowest."),
      real("fault_level", &P::fault_level, 0.01, 0.99, "",
           "Thickening along the fault over the greatest."),
      real("fault_offset", &P::fault_offset, -50e3, 50e3, "m",
           "How much farther out onto the stable plate the fault lies."),
  };
}

struct CollisionUplift {
  Raster<float> uplift_rate;  // u0, m/yr
  Raster<float> fault;        // m; the grid's width + height without a fault
  std::vector<Polyline> fault_lines;
  int stable_plate = -1;  // -1: there are no plates
};

/// 1 where the two nearest plates come together, 0 where they part, between where they slide.
/// Sampled every half of `smoothing` metres, but no coarser than 16 cells: what it weighs is
/// smoothed by that much afterwards.
Raster<float> plate_convergence(const TransportField& transport, const Grid& grid, double smoothing,
                                const Context& context);

/// `convergence`: plate_convergence at `crust_smoothing`. InputError for a parameter out of range,
/// a stable plate that is none or another grid.
CollisionUplift collision_uplift(const TransportField& transport, const CompressionField& field,
                                 const Raster<float>& convergence,
                                 const CollisionParameters& parameters, const Context& context);

/// q − 1 as uplift sees it: 0 where plates part, smoothed by `smoothing` (m).
Raster<float> smoothed_thickening(const CompressionField& field, const Raster<float>& convergence,
                                  double smoothing, const Context& context);

/// The plate whose arrows are shortest (root mean square), the first of several; -1: none.
int slowest_plate(const TransportField& transport);

}  // namespace orogen
