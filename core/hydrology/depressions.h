// Depressions: closed hollows, filled up to their spill level or drained by a cut.
//
//   spill level(i) = min over paths from i to base level of the highest ground on the path
//
// `fill_depressions` raises ground: to the spill level (epsilon 0), or so that each cell stands at
// least epsilon above its receiver (Barnes, Lehman and Mulla 2014, priority-flood+epsilon).
// `carve_to_drain` lowers ground along the paths of a flow graph so that water falls at least at
// `least_slope`, less where the outlet is not low enough for that.
// Neither touches base-level cells.
#pragma once

#include <cstdint>

#include "foundation/context.h"
#include "foundation/mass_balance.h"
#include "foundation/raster.h"
#include "hydrology/flow_graph.h"

namespace orogen {

/// Height of the water surface if every depression were full (m): the spill level, over the paths
/// of `flow` (exact where no receivers are forced). `flow` was routed over `elevation`.
void filled_level(const FlowGraph& flow, const Raster<float>& elevation, Raster<float>& level,
                  const Context& context);

/// deposited_m3: volume filled. epsilon in m, 0 leaves lakes level.
MassBalance fill_depressions(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                             double epsilon, const Context& context);

struct CarveResult {
  MassBalance balance;         // eroded_m3 = exported_m3: volume cut
  std::size_t lowered = 0;     // cells
  std::size_t level = 0;       // cells left level with their receiver
  std::size_t unresolved = 0;  // cells left below their receiver: lower than their own base level
  double deepest_cut_m = 0.0;
};

/// Lowers cells, never raises any. `flow` was routed over `elevation`, and its paths stay.
/// `keep` (optional): cells not to be lowered (drawn peaks); what drains uphill over one counts as
/// unresolved.
CarveResult carve_to_drain(Raster<float>& elevation, const FlowGraph& flow, double least_slope,
                           const Context& context, const Raster<std::uint8_t>* keep = nullptr);

/// The same, with a flow graph of its own.
CarveResult carve_to_drain(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                           double least_slope, const Context& context);

}  // namespace orogen
