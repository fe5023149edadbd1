// Stream-power erosion on a TIN: rivers cut into rising rock (paper C, eq. 5 and section 6.1), and
// lay down what they carry.
//
//   dz/dt = u - k A'^m s^n + G q / A      A' = max(A, A_min),  s ≤ tan(talus angle)
//
// z (m); t (yr); u uplift rate (m/yr); k erodibility (m^(1-2m)/yr, 1/yr at m = 0.5); A drainage
// area (m²), weighted by rain; s slope to the receiver (0 where the receiver is higher); q (m³/yr)
// sediment that passes: all that was eroded upstream and not laid down; G deposition coefficient
// (Davy and Lague 2009; Yuan et al. 2019, doi:10.1029/2018JF004867). In a steady state
// k A'^m s^n = (1 + G) u.
//
// One step: water is routed, then heights are solved backward in time, each vertex after its
// receiver (Braun and Willett 2013, doi:10.1016/j.geomorph.2012.10.008). A step may be of any
// length; an infinite one gives the steady state for the drainage it starts from. In the same pass
// the slope to the receiver is capped: what stands steeper is taken away by the river. Landslides
// that keep mass, and the paper's own, are in tin_hillslope.h.
//
// With G = 0 all that is eroded leaves. With G > 0 the flux q is iterated (Gauss-Seidel) within
// each part of the flow; lakes fill with what reaches them and pass on the rest; no vertex lays
// down more than reaches it. Loose sediment (`TinSediment`) lies on the rock and is eroded first:
// k is that of the sediment where a step ends above the rock's top, that of the rock where it ends
// below; where sediment would be cut through and rock would not, it ends on the top.
//
// Heights are double: at 1e-3 m/yr a step of a few years changes them by less than float32 can tell
// at 2000 m. Mass is balanced to rounding.
// Cost, with routing: on one core some 25 ns a vertex at n = 1 for a hundred thousand vertices, 130
// for a million with twenty thousand pits; on two cores a little more than half. G > 0 adds some
// 150 ns a vertex. Limits: nothing is laid down below base level; sediment is as dense as rock.
#pragma once

#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "erosion/river_parameters.h"
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
  double deposition_coefficient = 0.0;
  int deposition_iterations = 4;
  bool fill_lakes = true;
};

constexpr auto parameter_table(const TinStreamPowerParameters*) {
  using P = TinStreamPowerParameters;
  return std::tuple_cat(incision_parameters<P>(), deposition_parameters<P>());
}

/// What drives the erosion.
struct TinForcing {
  VertexValues uplift_rate = 5e-4;                                     // u, m/yr
  VertexValues erodibility = 5.5e-7;                                   // k, m^(1-2m)/yr
  VertexValues rain_weight = 1.0;                                      // 1: mean rain
  VertexValues talus_slope = std::numeric_limits<double>::infinity();  // tan(talus angle)
};

/// Loose sediment on the rock, where G > 0.
struct TinSediment {
  std::span<double> bedrock{};  // m, top of the rock: risen and cut by a step; empty: all is rock
  double erodibility = 0.0;     // m^(1-2m)/yr, of what lies on it
  std::span<const double> supply{};  // m³/yr, debris that falls into rivers on land; empty: none
};

/// The solver keeps its buffers between steps.
class TinStreamPower {
 public:
  /// InputError for a parameter out of range.
  explicit TinStreamPower(const TinStreamPowerParameters& parameters);

  /// Routes water, sums drainage area, solves one step of `dt_years` (> 0; infinity: steady state).
  /// Base level keeps its height. InputError, before anything has changed, for values that are too
  /// few, not finite, or below 0 where that makes no sense.
  MassBalance step(TinFlow& flow, std::span<double> elevation, const TinForcing& forcing,
                   double dt_years, const Context& context, const TinSediment& sediment = {});

  /// The last part of `step` alone, for a flow that was routed over a surface with this drainage.
  MassBalance solve(const TinFlow& flow, std::span<double> elevation, const TinForcing& forcing,
                    double dt_years, const Context& context, const TinSediment& sediment = {});

  /// Of the last step, at each vertex (m²).
  std::span<const double> drainage_area() const { return area_; }
  bool lays_down() const { return parameters_.deposition_coefficient > 0.0; }

 private:
  struct VolumeSum {
    double eroded = 0.0, deposited = 0.0, supplied = 0.0, change = 0.0;  // m³
    double taken_on = 0.0, exported = 0.0;                               // of sediment

    void add(double start, double end, double supply, double cell_area);
  };
  struct Deposition;  // the sweeps that carry sediment through a part
  struct Buffers {    // in the part's order
    std::vector<double> area, z;
    std::vector<double> start, uplift, rise_cap, cell_area,
        per_area;  // where sediment is laid down
    std::vector<double> rock_rate, sediment_rate, bedrock;
    std::vector<double> supply, flux;      // m³/yr
    std::vector<double> lake_level, sill;  // m, spill level at the start; the sill at the end
    std::vector<double> fill, room;        // part of the room that gets filled; m³
  };

  VolumeSum cut(const TinFlow& flow, const FlowTrees& part, Buffers& buffers, double* z,
                const TinForcing& forcing, double dt_years);
  VolumeSum cut_and_lay_down(const TinFlow& flow, const FlowTrees& part, Buffers& buffers,
                             double* z, const TinForcing& forcing, double dt_years,
                             const TinSediment& sediment);

  TinStreamPowerParameters parameters_;
  std::vector<double> area_;
  std::vector<Buffers> buffers_;  // by part
};

}  // namespace orogen
