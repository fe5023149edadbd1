// Stream-power erosion on a TIN: rivers cut into rising rock (paper C, eq. 5 and section 6.1).
//
//   dz/dt = u - k A'^m s^n        A' = max(A, A_min),  s ≤ tan(talus angle)
//
// z (m); t (yr); u uplift rate (m/yr); k erodibility (m^(1-2m)/yr, 1/yr at m = 0.5); A drainage
// area (m²), weighted by rain; s slope to the receiver (0 where the receiver is higher).
//
// One step: water is routed, then heights are solved backward in time, each vertex after its
// receiver (Braun and Willett 2013, doi:10.1016/j.geomorph.2012.10.008). A step may be of any
// length; an infinite one gives the steady state for the drainage it starts from. In the same pass
// the slope to the receiver is capped: what stands steeper is taken away by the river. Landslides
// that keep mass, and the paper's own, are in tin_hillslope.h.
//
// All that is eroded leaves (no deposition). Heights are double: at 1e-3 m/yr a step of a few years
// changes them by less than float32 can tell at 2000 m. Mass is balanced to rounding.
// Cost, with routing: on one core some 25 ns a vertex at n = 1 for a hundred thousand vertices, 130
// for a million with twenty thousand pits; on two cores a little more than half.
#pragma once

#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "foundation/context.h"
#include "foundation/mass_balance.h"
#include "foundation/parameters.h"
#include "foundation/vertex_values.h"
#include "hydrology/tin_flow.h"

namespace orogen {

struct TinStreamPowerParameters {
  double area_exponent = 0.5;
  double slope_exponent = 1.0;
  double minimum_drainage_area = 0.0;
};

constexpr auto parameter_table(const TinStreamPowerParameters*) {
  using P = TinStreamPowerParameters;
  return std::tuple{
      real("area_exponent", &P::area_exponent, 0.0, 2.0, "1",
           "Exponent m of the drainage area in the rate of incision."),
      real("slope_exponent", &P::slope_exponent, 0.2, 5.0, "1",
           "Exponent n of the slope in the rate of incision."),
      real("minimum_drainage_area", &P::minimum_drainage_area, 0.0, 1e9, "m2",
           "Drainage area of hillslopes, below which incision does not fall off."),
  };
}

/// What drives the erosion.
struct TinForcing {
  VertexValues uplift_rate = 5e-4;                                     // u, m/yr
  VertexValues erodibility = 5.5e-7;                                   // k, m^(1-2m)/yr
  VertexValues rain_weight = 1.0;                                      // 1: mean rain
  VertexValues talus_slope = std::numeric_limits<double>::infinity();  // tan(talus angle)
};

/// The solver keeps its buffers between steps.
class TinStreamPower {
 public:
  /// InputError for a parameter out of range.
  explicit TinStreamPower(const TinStreamPowerParameters& parameters);

  /// Routes water, sums drainage area, solves one step of `dt_years` (> 0; infinity: steady state).
  /// Base level keeps its height.
  MassBalance step(TinFlow& flow, std::span<double> elevation, const TinForcing& forcing,
                   double dt_years, const Context& context);

  /// Of the last step, at each vertex (m²).
  std::span<const double> drainage_area() const { return area_; }

 private:
  struct VolumeSum {
    double eroded = 0.0, deposited = 0.0, supplied = 0.0, change = 0.0;  // m³
  };
  struct Buffers {
    std::vector<double> area, z;  // in the part's order
  };

  VolumeSum solve_part(const TinFlow& flow, const FlowTrees& part, Buffers& buffers, double* z,
                       const TinForcing& forcing, double dt_years);

  TinStreamPowerParameters parameters_;
  std::vector<double> area_;
  std::vector<Buffers> buffers_;  // by part
};

}  // namespace orogen
