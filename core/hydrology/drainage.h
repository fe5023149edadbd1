// What follows from a flow graph: drainage area, stream order, watersheds, distance to the outlet.
//
//   drainage_area(i) = w_i * cell area + sources at i + sum of drainage_area over the donors of i
//
// w: weight of rain (1: everywhere alike, so that the sum is an area in m²; with weights it is the
// area that at weight 1 would give the same water). A base-level cell holds what reaches it.
// Summed in double, in a fixed order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "foundation/varying.h"
#include "hydrology/flow_graph.h"

namespace orogen {

/// A river that comes from outside: area (m²) that drains into a cell.
struct AreaSource {
  std::int32_t cell;
  double area_m2;
};

inline const StageInfo& drainage_stage() {
  static const StageInfo info{"drainage",
                              "Routes water over the ground and sums the area it drains.",
                              "Cordonnier, Bovy and Braun 2019; O'Callaghan and Mark 1984",
                              {"elevation", "land"},
                              {"drainage_area"}};
  return info;
}

/// Drainage area (m²).
Raster<float> drainage_area(const FlowGraph& flow, const Context& context,
                            const Varying& rain_weight = 1.0,
                            std::span<const AreaSource> sources = {});

/// The same in double into a buffer that is kept: `area` is resized to the grid.
void accumulate_drainage_area(const FlowGraph& flow, std::vector<double>& area,
                              const Context& context, const Varying& rain_weight = 1.0,
                              std::span<const AreaSource> sources = {});

/// Horton-Strahler order of the stream through each cell with at least `least_area_m2` of `area`
/// (m²); 0 elsewhere and in base-level cells.
Raster<std::int32_t> strahler_order(const FlowGraph& flow, const Raster<float>& area,
                                    double least_area_m2, const Context& context);

/// Number of the watershed of each cell: outlets (base-level cells that water reaches) count from 0
/// in row-major order. An outlet has its watershed's number; other base-level cells have -1.
Raster<std::int32_t> watershed_labels(const FlowGraph& flow, const Context& context);

/// Distance along the flow to base level (m).
Raster<float> flow_length(const FlowGraph& flow, const Context& context);

/// chi = integral upstream of (reference_area / A)^concavity dx (m): in a steady landscape of
/// uniform rock and uplift, height is a straight line in chi (Perron and Royden 2013).
Raster<float> chi_transform(const FlowGraph& flow, const Raster<float>& area,
                            double reference_area_m2, double concavity, const Context& context);

/// The cells water passes from `cell` down to base level, both included.
std::vector<std::int32_t> trace_downstream(const FlowGraph& flow, std::int32_t cell);

/// From `cell` up to the divide, always to the donor with the largest drainage area.
std::vector<std::int32_t> trace_main_stem(const FlowGraph& flow, const Raster<float>& area,
                                          std::int32_t cell);

}  // namespace orogen
