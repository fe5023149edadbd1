// Parameters of hydraulic erosion by virtual pipes (virtual_pipes.h), and the reasons for their
// defaults.
//
// The defaults are an hour of heavy rain on a drained terrain of 20 to 400 m cells; on 90 m
// cells of a smoothed Sierra Nevada they wear 3 m in the mean (20 m in gullies) and lay up to tens
// of metres on valley floors. drag_coefficient 0.05 is rough ground; pipe_depth 1 m the depth of
// its larger streams, and the longest step in which they still level; capacity above 1000 cuts
// gullies along the grid's axes; max_change keeps canyons and fills within a cell's usual fall.
// Paper B has a setting of its own: paper_b_setting.h.
#pragma once

#include <string_view>
#include <tuple>

#include "foundation/parameters.h"

namespace orogen {

enum class TransportScheme { Conservative, SemiLagrangian };
enum class CapacityLaw { StreamPower, Discharge, Velocity };
enum class BedSlope { Gradient, Steepest };

inline constexpr std::string_view kTransportSchemes[] = {"conservative", "semi_lagrangian"};
inline constexpr std::string_view kCapacityLaws[] = {"stream_power", "discharge", "velocity"};
inline constexpr std::string_view kBedSlopes[] = {"gradient", "steepest"};

struct PipeParameters {
  double duration = 3600.0;        // s
  double time_step = 0.0;          // s; 0: the largest stable one
  double pipe_depth = 1.0;         // m
  double drag_coefficient = 0.05;  // cf, of Chezy's law
  double gravity = 9.80665;        // m/s²
  double rain_rate_mm_per_h = 30.0;
  bool random_rain = true;
  double drop_probability = 0.1;     // a cell and step, where moisture is 1
  double evaporation_rate = 1e-4;    // 1/s
  double sediment_capacity = 200.0;  // Kc, see virtual_pipes.h
  CapacityLaw capacity_law = CapacityLaw::StreamPower;
  BedSlope bed_slope = BedSlope::Gradient;
  double min_slope = 0.005, max_slope = 1.0;
  double sediment_dissolution_rate = 2e-3;  // 1/s
  double rock_dissolution_rate = 2e-4;      // 1/s
  double deposition_rate = 5e-3;            // 1/s
  double erosion_halving_depth = 0.0;       // m (paper B, eq. 24); 0: off
  double deposition_halving_depth = 0.0;    // m; 0: off
  double max_change = 50.0;                 // m
  bool limit_to_neighbours = true;
  double sediment_talus_angle_deg = 33.0;
  double rock_talus_angle_deg = 90.0;
  int slippage_interval = 8;  // steps
  TransportScheme transport = TransportScheme::Conservative;
  bool open_sides = true;
  bool sea_keeps_sediment = false;
  bool settle_at_end = false;
  int seed = 0;
};

constexpr auto parameter_table(const PipeParameters*) {
  using P = PipeParameters;
  return std::tuple{
      real("duration", &P::duration, 0.0, 1e7, "s", "How long water runs."),
      real("time_step", &P::time_step, 0.0, 1e5, "s",
           "Length of a step; 0 takes the longest stable one."),
      real("pipe_depth", &P::pipe_depth, 1e-6, 1e4, "m",
           "Depth of the virtual pipes, which sets how fast waves run and so the time step."),
      real("drag_coefficient", &P::drag_coefficient, 0.0, 100.0, "",
           "Drag of the bed on the water; 0 is the frictionless flow of the original pipes."),
      real("gravity", &P::gravity, 0.0, 1e3, "m/s2", "Acceleration of gravity."),
      real("rain_rate_mm_per_h", &P::rain_rate_mm_per_h, 0.0, 1e7, "mm/h",
           "Mean rain where moisture is 1."),
      boolean("random_rain", &P::random_rain,
              "Rain falls as random drops, one cell wide, rather than evenly."),
      real("drop_probability", &P::drop_probability, 1e-6, 1.0, "",
           "Chance that a drop falls on a cell in a step where moisture is 1."),
      real("evaporation_rate", &P::evaporation_rate, 0.0, 1e3, "1/s",
           "Share of the water that dries up or seeps away in a second where temperature is 1."),
      real("sediment_capacity", &P::sediment_capacity, 0.0, 1e9, "",
           "How much sediment the flow can carry (SI, see capacity_law), sped up many times."),
      choice("capacity_law", &P::capacity_law, kCapacityLaws,
             "Capacity is slope times the root of discharge, discharge, or velocity."),
      choice("bed_slope", &P::bed_slope, kBedSlopes,
             "Slope of the bed by central differences, or towards the most different neighbour."),
      real("min_slope", &P::min_slope, 0.0, 10.0, "1",
           "Gentler slopes carry as much sediment as this one."),
      real("max_slope", &P::max_slope, 0.0, 100.0, "1",
           "Steeper slopes carry no more sediment than this one."),
      real("sediment_dissolution_rate", &P::sediment_dissolution_rate, 1e-12, 1e3, "1/s",
           "How fast water takes up loose sediment."),
      real("rock_dissolution_rate", &P::rock_dissolution_rate, 0.0, 1e3, "1/s",
           "How fast water takes up the bedrock."),
      real("deposition_rate", &P::deposition_rate, 0.0, 1e3, "1/s",
           "How fast sediment that the water cannot carry is laid down."),
      real("erosion_halving_depth", &P::erosion_halving_depth, 0.0, 1e6, "m",
           "Depth of erosion over which dissolution slows to half; 0 turns this off."),
      real("deposition_halving_depth", &P::deposition_halving_depth, 0.0, 1e6, "m",
           "Height of deposits over which deposition slows to half; 0 turns this off."),
      real("max_change", &P::max_change, 0.0, 1e6, "m",
           "Water changes no cell's height by more than this."),
      boolean("limit_to_neighbours", &P::limit_to_neighbours,
              "Water digs no cell below its lowest neighbour, rather than the sea, and builds none "
              "above its highest."),
      real("sediment_talus_angle_deg", &P::sediment_talus_angle_deg, 1.0, 89.0, "deg",
           "Steepest slope at which loose sediment stays (angle of repose)."),
      real("rock_talus_angle_deg", &P::rock_talus_angle_deg, 1.0, 90.0, "deg",
           "Steepest slope at which bedrock stands; at 90 it never breaks."),
      integer("slippage_interval", &P::slippage_interval, 0, 1000000, "",
              "Steps from one sweep of sediment slippage to the next; 0: only at the end."),
      choice("transport", &P::transport, kTransportSchemes,
             "Sediment moves as fluxes, which conserves it, or is traced back along the flow."),
      boolean("open_sides", &P::open_sides, "Water leaves through the map's sides."),
      boolean(
          "sea_keeps_sediment", &P::sea_keeps_sediment,
          "Sediment that reaches the sea is laid down at its rim, where land may grow, instead of "
          "leaving."),
      boolean("settle_at_end", &P::settle_at_end,
              "What is still suspended at the end is laid down where it is."),
      integer("seed", &P::seed, 0, 2147483647, "", "Seed of the random rain."),
  };
}

}  // namespace orogen
