#include "sculpting/map_law.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "foundation/parallel.h"
#include "hydrology/base_level.h"
#include "hydrology/depressions.h"
#include "hydrology/drainage.h"
#include "hydrology/flow_graph.h"
#include "sculpting/summits.h"

namespace orogen {

namespace {

constexpr int kBeside = 2;  // cells
constexpr int kBedRounds = 20;
constexpr float kCapSoftness = 0.01f;  // share of the cap over which heights are pressed

/// Heights above the cap are pressed below it: identity up to cap - k, then towards the cap.
float press(float z, float cap, float k) {
  const float start = cap - k;
  return z <= start ? z : start + k * (1.0f - std::exp(-(z - start) / k));
}

/// What stands above the cap is pressed below it, but not below its receiver, so that no hollows
/// come of it. Where water would run from under the cap to ground above it, the cap counts.
void press_below(const Raster<float>& cap, Raster<float>& elevation, const FlowGraph& flow,
                 const Context& context) {
  flow.sweep_upstream(context, [&](std::int32_t i) {
    const float z = elevation[i], pressed = press(z, cap[i], std::min(kCapSoftness * cap[i], 100.0f));
    elevation[i] = std::max(pressed, std::min(z, elevation[flow.receiver(i)]));
  });
  flow.sweep_upstream(context,
                      [&](std::int32_t i) { elevation[i] = std::min(elevation[i], cap[i]); });
}

/// The lowest ground that a river passes at a cell of its bed: beside it, and in its own next bend.
float lowest_beside(const Raster<float>& elevation, const RiverBeds& beds,
                    const Raster<std::uint8_t>& base_level, std::int32_t cell) {
  const Grid& grid = elevation.grid();
  const int row = cell / grid.nx, column = cell % grid.nx;
  float low = elevation[cell];
  for (int r = std::max(row - kBeside, 0); r <= std::min(row + kBeside, grid.ny - 1); ++r)
    for (int c = std::max(column - kBeside, 0); c <= std::min(column + kBeside, grid.nx - 1); ++c) {
      const bool far_bed = beds.river(r, c) && std::max(std::abs(r - row), std::abs(c - column)) > 1;
      if (!base_level(r, c) && !far_bed) low = std::min(low, elevation(r, c));
    }
  return low;
}

/// From the sources down: no bed lies higher than the ground that its river has passed.
void lower_beds(Raster<float>& elevation, const RiverBeds& beds,
                const Raster<std::uint8_t>& base_level) {
  bool changed = true;
  for (int round = 0; changed && round < kBedRounds; ++round) {
    changed = false;
    for (std::size_t i = beds.cells.size(); i-- > 0;) {
      const std::int32_t cell = beds.cells[i], below = beds.receivers[i];
      if (below < 0 || base_level[below]) continue;
      const float low = lowest_beside(elevation, beds, base_level, cell);
      changed |= low < elevation[below];
      elevation[below] = std::min(elevation[below], low);
    }
  }
}

}  // namespace

MapLawResult enforce_map(Raster<float>& elevation, const VectorMap& map,
                         const Raster<std::uint8_t>& land, const RiverBeds& beds,
                         const MapLawParameters& parameters, Context& context) {
  check_parameters(parameters);
  if (elevation.grid() != land.grid())
    throw InputError("land: must lie on the same grid as the elevation");
  const BaseLevel base = base_level(map, land, beds);
  for (std::size_t i = 0; i < elevation.size(); ++i)
    elevation[i] =
        base.cells[i] ? base.height[i] : std::max(elevation[i], float(parameters.least_height));
  const auto summits = collect_summits(map, land);
  Raster<std::uint8_t> keep(elevation.grid());
  std::vector<std::int32_t> receivers = forced_receivers(beds);
  const auto crown = [&] {
    for (const Summit& s : summits) elevation[s.cell] = float(s.height);
  };
  for (const Summit& s : summits) {
    keep[s.cell] = 1;
    receivers[s.cell] = -1;  // a spring yields to its peak
  }
  FlowGraph flow(base.cells);
  flow.force_receivers(receivers);
  flow.route(elevation, context);
  std::vector<double> area;
  accumulate_drainage_area(flow, area, context);
  Raster<float> least = summit_pyramids(summits, beds);
  cut_gullies(least, area, summits, beds, context);
  for (std::size_t i = 0; i < elevation.size(); ++i)
    if (!base.cells[i]) elevation[i] = std::max(elevation[i], least[i]);
  crown();
  flow.route(elevation, context);
  context.report(0.3);
  press_below(summit_cap(summits, elevation.grid(), parameters.summit_reach, context), elevation,
              flow, context);
  crown();
  lower_beds(elevation, beds, base.cells);
  context.report(0.6);
  flow.route(elevation, context);
  const CarveResult carved = carve_to_drain(elevation, flow, parameters.least_fall, context, &keep);

  MapLawResult result;
  result.drainage_area = drainage_area(flow, context);
  result.deepest_cut_m = carved.deepest_cut_m;
  for (const Summit& s : summits) {
    const double error = std::abs(elevation[s.cell] - s.height);
    result.largest_peak_error_m = std::max(result.largest_peak_error_m, error);
    result.peaks_met += error < 1.0;
  }
  return result;
}

}  // namespace orogen
