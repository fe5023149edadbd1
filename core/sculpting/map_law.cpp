#include "sculpting/map_law.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "hydrology/base_level.h"
#include "hydrology/depressions.h"
#include "hydrology/drainage.h"
#include "hydrology/flow_graph.h"
#include "sculpting/summits.h"

namespace orogen {

namespace {

constexpr int kRiverRounds = 20;
constexpr double kLookEvery = 0.05;    // cells: lines that cut a corner are seen, too
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
    const float z = elevation[i],
                pressed = press(z, cap[i], std::min(kCapSoftness * cap[i], 100.0f));
    elevation[i] = std::max(pressed, std::min(z, elevation[flow.receiver(i)]));
  });
  for (std::size_t i = 0; i < elevation.size(); ++i) elevation[i] = std::min(elevation[i], cap[i]);
}

/// What a river shows at one place of its drawn line: the lowest cell within one cell, and the
/// lowest cell of a bed there; -1 where there is none.
struct Sight {
  std::int32_t lowest = -1, bed = -1;
};

Sight look_around(const Raster<float>& elevation, const RiverBeds& beds,
                  const Raster<std::uint8_t>& base_level, int row, int column) {
  const Grid& grid = elevation.grid();
  Sight sight;
  for (int r = row - 1; r <= row + 1; ++r)
    for (int c = column - 1; c <= column + 1; ++c) {
      if (!grid.contains(r, c) || base_level(r, c)) continue;
      const auto cell = std::int32_t(grid.index(r, c));
      const auto take_lower = [&](std::int32_t& best) {
        if (best < 0 || elevation[cell] < elevation[best]) best = cell;
      };
      take_lower(sight.lowest);
      if (beds.river[cell]) take_lower(sight.bed);
    }
  return sight;
}

/// Along a drawn line the bed (the ground, where the bed keeps off a peak) nowhere lies higher than
/// ground that the river has passed. True if it had to be lowered.
bool lower_along(const Polyline& line, Raster<float>& elevation, const RiverBeds& beds,
                 const Raster<std::uint8_t>& base_level) {
  const Grid& grid = elevation.grid();
  float passed = INFINITY;
  bool changed = false;
  std::pair<int, int> seen(INT_MIN, INT_MIN);  // row and column
  const double step = kLookEvery * grid.cell_size;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const int pieces = int(std::ceil(glm::distance(line[i], line[i + 1]) / step));
    const bool last = i + 2 == line.size();
    for (int k = 0; k < pieces + last; ++k) {
      const glm::dvec2 place = glm::mix(line[i], line[i + 1], double(k) / pieces);
      const std::pair<int, int> here(grid.row_of(place.y), grid.column_of(place.x));
      if (std::exchange(seen, here) == here) continue;
      const Sight sight = look_around(elevation, beds, base_level, here.first, here.second);
      if (sight.lowest < 0) continue;
      if (elevation[sight.lowest] > passed) {
        elevation[sight.bed >= 0 ? sight.bed : sight.lowest] = passed;
        changed = true;
      }
      passed = std::min(passed, elevation[sight.lowest]);
    }
  }
  return changed;
}

void let_rivers_fall(Raster<float>& elevation, const VectorMap& map, const RiverBeds& beds,
                     const Raster<std::uint8_t>& base_level) {
  bool changed = true;
  for (int round = 0; changed && round < kRiverRounds; ++round) {
    changed = false;
    for (const River& river : map.rivers)
      changed |= lower_along(river.points, elevation, beds, base_level);
    for (std::size_t i = beds.cells.size(); i-- > 0;) {
      const std::int32_t cell = beds.cells[i], below = beds.receivers[i];
      if (below >= 0 && !base_level[below])
        elevation[below] = std::min(elevation[below], elevation[cell]);
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
  const Raster<float> least = summit_pyramids(summits, beds, context);
  for (std::size_t i = 0; i < elevation.size(); ++i)
    if (!base.cells[i]) elevation[i] = std::max(elevation[i], least[i]);
  crown();
  flow.route(elevation, context);
  context.report(0.3);
  press_below(summit_cap(summits, elevation.grid(), parameters.summit_reach, context), elevation,
              flow, context);
  crown();
  let_rivers_fall(elevation, map, beds, base.cells);
  context.report(0.6);
  flow.route(elevation, context);
  double deepest_cut = 0.0;
  for (int round = 0; round < 2; ++round) {  // cut side valleys may lie below later bends
    const auto carved = carve_to_drain(elevation, flow, parameters.least_fall, context, &keep);
    deepest_cut = std::max(deepest_cut, carved.deepest_cut_m);
    let_rivers_fall(elevation, map, beds, base.cells);
  }

  MapLawResult result;
  result.drainage_area = drainage_area(flow, context);
  result.deepest_cut_m = deepest_cut;
  for (const Summit& s : summits) {
    const double error = std::abs(elevation[s.cell] - s.height);
    result.largest_peak_error_m = std::max(result.largest_peak_error_m, error);
    result.peaks_met += error < 1.0;
  }
  return result;
}

}  // namespace orogen
