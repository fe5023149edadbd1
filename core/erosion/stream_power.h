// Stream-power erosion: rivers cut into rising rock (paper C, eq. 5), and lay down what they carry.
//
//   dz/dt = U - k A'^m S^n + D        D = G q / A  (Yuan, Braun, Guerit, Rouby, Cordonnier 2019)
//
// z (m); t (yr); U uplift rate (m/yr); k erodibility (m^(1-2m)/yr, 1/yr at m = 0.5); A drainage
// area (m²), weighted by rain; A' = max(A, A_min) or A + A_min; S slope to the receiver (0 where
// the receiver is higher); q (m³/yr) sediment that passes: all that was eroded upstream and not
// laid down; G deposition coefficient. In a steady state k A'^m S^n = (1 + G) U.
//
// One step: water is routed, then heights are solved backward in time, each cell after its receiver
// (Braun and Willett 2013, doi:10.1016/j.geomorph.2012.10.008): closed form for n = 1, else a
// Newton iteration that starts inside a bracket on the convex side. The step may be of any length;
// an infinite one gives the steady state for the drainage it starts from. In the same pass the
// slope to the receiver is capped at tan(talus angle), heights are held between the least and the
// greatest allowed, but never below the receiver, and pinned cells keep their height.
// With G > 0 the flux q is iterated (Gauss-Seidel); lakes fill with what reaches them and pass on
// the rest; no cell lays down more than reaches it.
//
// Mass: `eroded`, `deposited` and `exported` are volumes of rock; residual is at rounding of
// double. In an infinite step volumes are those of the change of height alone. Limits: heights are
// float32, so that changes under some 0.1 mm a step at 2000 m are lost; one receiver a cell; no
// density difference between rock and sediment.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "erosion/river_parameters.h"
#include "foundation/context.h"
#include "foundation/mass_balance.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "foundation/varying.h"
#include "hydrology/drainage.h"
#include "hydrology/flow_graph.h"

namespace orogen {

enum class AreaFloor { Maximum, Sum };
inline constexpr std::string_view kAreaFloors[] = {"maximum", "sum"};

struct StreamPowerParameters {
  double area_exponent = 0.5;
  double slope_exponent = 1.0;
  double minimum_drainage_area = 0.0;
  AreaFloor area_floor = AreaFloor::Maximum;
  double deposition_coefficient = 0.0;
  int deposition_iterations = 4;
  bool fill_lakes = true;
  double step_years = 1e5;
  int steps = 20;
};

constexpr auto parameter_table(const StreamPowerParameters*) {
  using P = StreamPowerParameters;
  return std::tuple_cat(
      incision_parameters<P>(),
      std::tuple{choice(
          "area_floor", &P::area_floor, kAreaFloors,
          "Whether the minimum drainage area bounds the area from below or is added to it.")},
      deposition_parameters<P>(),
      std::tuple{
          real("step_years", &P::step_years, 1.0, 1e12, "yr", "Length of a time step."),
          integer("steps", &P::steps, 0, 100000, "1", "Number of time steps."),
      });
}

inline const StageInfo& stream_power_stage() {
  static const StageInfo info{"stream_power",
                              "Lets rivers cut into rising rock and lay down sediment.",
                              "Paper C, eq. 5; Braun and Willett 2013; Yuan et al. 2019",
                              {"elevation", "land", "uplift_rate", "erodibility"},
                              {"elevation", "drainage_area"}};
  return info;
}

/// What drives the erosion. Rasters are not owned and lie on the flow graph's grid.
struct StreamPowerForcing {
  Varying uplift_rate = 5e-4;                                     // U, m/yr
  Varying erodibility = 5.5e-7;                                   // k, m^(1-2m)/yr
  Varying rain_weight = 1.0;                                      // 1: mean rain
  std::span<const AreaSource> sources{};                          // rivers from outside
  Varying talus_slope = std::numeric_limits<double>::infinity();  // tan(talus angle): largest slope
  const Raster<std::uint8_t>* pinned = nullptr;  // not 0: the cell keeps its height
  Varying least_height = -std::numeric_limits<double>::infinity();  // m
  Varying greatest_height =
      std::numeric_limits<double>::infinity();  // m, above the receiver anyway
};

/// The solver keeps its buffers between steps.
class StreamPower {
 public:
  /// InputError for a parameter out of range.
  explicit StreamPower(const StreamPowerParameters& parameters);

  /// Routes water, sums drainage area, solves one step of `dt_years` (> 0; infinity: steady state).
  MassBalance step(FlowGraph& flow, Raster<float>& elevation, const StreamPowerForcing& forcing,
                   double dt_years, const Context& context);

  /// The last part of `step` alone: heights solved for a flow graph that was routed over
  /// `elevation` and the drainage area (m²) given.
  MassBalance solve(const FlowGraph& flow, const std::vector<double>& drainage_area,
                    Raster<float>& elevation, const StreamPowerForcing& forcing, double dt_years,
                    const Context& context);

  /// Of the last step (m²).
  const std::vector<double>& drainage_area() const { return area_; }
  /// Sediment that leaves each cell, of the last step with G > 0 (m³/yr).
  const std::vector<double>& sediment_flux() const { return flux_; }

 private:
  struct VolumeSum {
    double eroded = 0.0, deposited = 0.0, supplied = 0.0, change = 0.0;  // m, over cells
  };
  struct Step;        // one solve's constants and pointers
  struct Deposition;  // the sweeps that carry sediment
  /// Per cell in the order of the flow graph, so that sweeps stream; then base-level cells.
  struct Ordered {
    std::vector<std::int32_t> place;     // of each cell of the grid
    std::vector<std::int32_t> receiver;  // place of the receiver
    std::vector<float> start, z, uplift, rise_cap, incision, per_area;
    std::vector<double> flux;       // m³/yr
    std::vector<float> lake_level;  // spill level at the start of the step (m)
    std::vector<float> sill;        // height of the lake's sill at its end (m)
    std::vector<float> fill;        // part of the room that gets filled
    std::vector<double> room;       // between rock and sill, summed towards the exit (m³)
  };

  MassBalance cut(const Step&, const Context&);
  MassBalance cut_and_lay_down(const Step&, const Context&);

  StreamPowerParameters parameters_;
  std::vector<double> area_, flux_;
  std::vector<VolumeSum> sums_;
  Ordered ordered_;
};

/// The stage: `parameters.steps` steps over the ground beside `base_level`. Returns the sum of the
/// steps' balances; `area` (optional) receives the drainage area (m²) of the result.
MassBalance erode_stream_power(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                               const StreamPowerForcing& forcing,
                               const StreamPowerParameters& parameters, Context& context,
                               Raster<float>* area = nullptr);

}  // namespace orogen
