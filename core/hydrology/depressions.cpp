#include "hydrology/depressions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "foundation/errors.h"

namespace orogen {

namespace {

struct Change {
  double raised = 0.0, lowered = 0.0, deepest = 0.0;  // sums and maximum, m
  std::size_t cells = 0;
};

/// What was raised and lowered between two states.
Change compare(const std::vector<float>& before, const Raster<float>& after,
               const Context& context) {
  return parallel_reduce(
      context, before.size(), 1 << 15, Change{},
      [&](std::size_t begin, std::size_t end) {
        Change sum;
        for (std::size_t i = begin; i < end; ++i) {
          const double d = double(after[i]) - double(before[i]);
          (d > 0.0 ? sum.raised : sum.lowered) += std::fabs(d);
          sum.deepest = std::max(sum.deepest, -d);
          sum.cells += d != 0.0;
        }
        return sum;
      },
      [](const Change& a, const Change& b) {
        return Change{a.raised + b.raised, a.lowered + b.lowered, std::max(a.deepest, b.deepest),
                      a.cells + b.cells};
      });
}

float next_above(float value) {
  return std::nextafter(value, std::numeric_limits<float>::infinity());
}

}  // namespace

void filled_level(const FlowGraph& flow, const Raster<float>& elevation, Raster<float>& level,
                  const Context& context) {
  level = elevation;
  flow.sweep_upstream(
      context, [&](std::int32_t i) { level[i] = std::max(level[i], level[flow.receiver(i)]); });
}

MassBalance fill_depressions(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                             double epsilon, const Context& context) {
  if (!(epsilon >= 0.0 && epsilon <= 1000.0))
    throw InputError("epsilon: " + std::to_string(epsilon) + " m is not within 0 to 1000 m");
  FlowGraph flow(base_level);
  flow.route(elevation, context);
  const std::vector<float> before(elevation.values().begin(), elevation.values().end());
  if (epsilon == 0.0) {
    flow.sweep_upstream(context, [&](std::int32_t i) {
      elevation[i] = std::max(elevation[i], elevation[flow.receiver(i)]);
    });
  } else {
    flow.sweep_upstream(context, [&](std::int32_t i) {
      const float below = elevation[flow.receiver(i)];
      elevation[i] = std::max({elevation[i], float(below + epsilon), next_above(below)});
    });
  }
  const Change change = compare(before, elevation, context);
  const double volume = change.raised * elevation.grid().cell_area();
  return {.deposited_m3 = volume, .supplied_m3 = volume};
}

CarveResult carve_to_drain(Raster<float>& elevation, const FlowGraph& flow, double least_slope,
                           const Context& context, const Raster<std::uint8_t>* keep) {
  if (!(least_slope >= 0.0 && least_slope <= 1.0))
    throw InputError("least_slope: " + std::to_string(least_slope) + " is not within 0 to 1");
  if (elevation.grid() != flow.grid() || (keep && keep->grid() != flow.grid()))
    throw InputError("elevation and keep: must lie on the grid of the flow graph");
  // `cut`: each cell below its donors by the least slope. `bound`: not above any of its donors.
  // The result rises from base level at the least slope where the cut would go below that, and
  // nowhere above the bound.
  const std::vector<float> before(elevation.values().begin(), elevation.values().end());
  std::vector<float> cut(before), bound(before);
  const auto kept = [&](std::int32_t i) { return keep && (*keep)[i]; };
  flow.sweep_downstream(context, [&](std::int32_t i) {
    const std::int32_t r = flow.receiver(i);
    if (flow.is_base(r) || kept(r)) return;
    bound[r] = std::min(bound[r], bound[i]);
    cut[r] = std::min(cut[r], cut[i] - float(least_slope * flow.distance(i)));
  });
  flow.sweep_upstream(context, [&](std::int32_t i) {
    if (kept(i)) return;
    const float wanted = elevation[flow.receiver(i)] + float(least_slope * flow.distance(i));
    elevation[i] = std::min(bound[i], std::max(cut[i], wanted));
  });
  CarveResult result;
  for (std::int32_t i : flow.order()) {
    const float below = elevation[flow.receiver(i)];
    result.level += elevation[i] == below;
    result.unresolved += elevation[i] < below;
  }
  const Change change = compare(before, elevation, context);
  result.lowered = change.cells;
  result.deepest_cut_m = change.deepest;
  result.balance.eroded_m3 = change.lowered * flow.grid().cell_area();
  result.balance.exported_m3 = result.balance.eroded_m3;
  return result;
}

CarveResult carve_to_drain(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                           double least_slope, const Context& context) {
  FlowGraph flow(base_level);
  flow.route(elevation, context);
  return carve_to_drain(elevation, flow, least_slope, context);
}

}  // namespace orogen
