// Hydraulic erosion by running water: shallow water in virtual pipes (Mei, Decaudin and Hu 2007)
// over layers of materials (Stava, Benes, Brisbin and Krivanek 2008), in metres and seconds.
//
// Per cell: bed b = rock + sediment m, water depth d, suspended sediment s (all m). Between two
// cells a distance l apart one flux q (m²/s a unit width; Mei's two opposite outflows, joined).
// One step dt:
//   flow      r = q + dt g D (h_i - h_j) / l,  h = b + d;   q' + dt cf D q'|q'| / d_f³ = r (solved)
//             d_f = max(h_i, h_j) - max(b_i, b_j); D the pipes' depth: it sets how fast waves run,
//             sqrt(g D). Steady flow on a slope S is Chezy's, v = sqrt(g S d / cf), whatever D.
//   limit     a cell's outflow is scaled so that it never gives more water than it has
//   water     d' = d + dt / l (inflow - outflow) + rain + sources - evaporation
//   transport s' = s + dt / l (inflow - outflow of q s / d, upwind): conserves sediment
//   capacity  C = Kc S |q|^(1/2)  (StreamPower: the law of channels and gullies, m = 1/2, n = 1),
//             C = Kc S |q|        (Discharge: Yang's unit stream power times depth), or
//             C = Kc S |v|        (Velocity: Mei's);    S the bed's slope, clamped
//   exchange  C > s: dissolve (1 - exp(-k dt)) (C - s), sediment first, then rock
//   (material_layers.h)
//             C < s: lay down (1 - exp(-k_d dt)) (s - C) as sediment
// Every few steps sediment slips towards its angle of repose (slippage.h), at the end to the end.
// Sea: level held at 0; water and sediment that reach it are exported. With sea_keeps_sediment the
// sediment stays where it arrives, up to the level of the sea; what is full is land from then on.
//
// Scaling: a real flood moves some 1e-4 of its volume as sediment. Kc is thousands of times a real
// one, so that a storm of an hour does the work of many (a morphological factor, as in
// morphodynamics): heights of s are heights of bed, not of grains in the water.
// Every field is read and written once a step (some 100 bytes a cell and step in float).
// Not guaranteed: real flood depths or travel times; |v| stays below one cell a step.
#pragma once

#include <cstdint>
#include <vector>

#include "erosion/growth_watch.h"
#include "erosion/material_layers.h"
#include "erosion/virtual_pipes_parameters.h"
#include "foundation/context.h"
#include "foundation/mass_balance.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "inputs/river_source.h"

namespace orogen {

/// Where water and materials come from. Null pointers mean the default; rasters must share the
/// elevation's grid and outlive the call.
struct PipeForcing {
  const Raster<float>* moisture = nullptr;            // [0, 1], scales rain; default 1
  const Raster<float>* temperature = nullptr;         // [0, 1], scales evaporation; default 1
  const Raster<std::uint8_t>* land = nullptr;         // 0: sea; default: elevation > 0
  const Raster<std::uint8_t>* pinned = nullptr;       // nonzero: the height must not change
  const Raster<float>* sediment_thickness = nullptr;  // m, loose from the start; default 0
  const Raster<float>* water_depth = nullptr;         // m, from the start; default 0
  const Raster<float>* erodibility = nullptr;         // scales rock dissolution; default 1
  std::vector<RockLayer> layers;                      // above the bedrock, from the top down
  std::vector<RiverSource> sources;
  GrowthWatch* watch = nullptr;  // nullptr: nobody looks on
};

struct PipeErosionResult {
  Raster<float> elevation;           // m
  Raster<float> wear;                // m, how far the ground fell
  Raster<float> deposition;          // m, how far it rose
  Raster<float> sediment_thickness;  // m, loose
  Raster<float> water_depth;         // m, at the end; 0 at sea
  MassBalance sediment_balance;      // exported: through sea and sides; stored: suspended
  MassBalance water_balance;         // supplied: rain and sources; exported also evaporated
  double evaporated_m3 = 0.0;
  double time_step = 0.0;  // s, as taken
  int steps = 0;
  std::int64_t cells_at_max_change = 0;  // cells whose change was held at max_change
  double steepest_excess = 0.0;          // slope above repose that is left where sediment lies
};

const StageInfo& hydraulic_erosion_stage();

/// Longest stable step, 0.7 cell / sqrt(2 g D), in seconds.
double stable_time_step(double cell_size, const PipeParameters& parameters);

/// Bytes a run takes at its peak, beside its inputs.
template <class Real = float>
std::size_t pipe_erosion_memory(const Grid& grid);

/// Runs the storm. Real: the type of the solver's fields, float or double.
template <class Real = float>
PipeErosionResult erode_virtual_pipes(const Raster<float>& elevation, const PipeForcing& forcing,
                                      const PipeParameters& parameters, Context& context);

}  // namespace orogen
