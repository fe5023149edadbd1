#include "hydrology/drainage.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr std::size_t kChunk = 1 << 15;

void check_field(const FlowGraph& flow, const Grid& grid, const char* name) {
  if (grid != flow.grid())
    throw InputError(std::string(name) + ": must lie on the grid of the flow graph");
}

void check_sources(const FlowGraph& flow, std::span<const AreaSource> sources) {
  for (const AreaSource& source : sources)
    if (source.cell < 0 || std::size_t(source.cell) >= flow.grid().size() ||
        !(source.area_m2 >= 0.0 && std::isfinite(source.area_m2)))
      throw InputError("sources: cell " + std::to_string(source.cell) + " with an area of " +
                       std::to_string(source.area_m2) +
                       " m2; the cell must be on the grid, the area finite and not negative");
}

}  // namespace

void accumulate_drainage_area(const FlowGraph& flow, std::vector<double>& area,
                              const Context& context, const Varying& rain_weight,
                              std::span<const AreaSource> sources) {
  rain_weight.check(flow.grid(), "rain_weight");
  check_sources(flow, sources);
  const double cell_area = flow.grid().cell_area();
  area.resize(flow.grid().size());
  parallel_chunks(context, area.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    std::fill(area.begin() + begin, area.begin() + end, 0.0);
  });
  for (const AreaSource& source : sources) area[source.cell] += source.area_m2;
  const float* weight = rain_weight.raster ? rain_weight.raster->data() : nullptr;
  const double even = cell_area * rain_weight.value;
  double* a = area.data();
  const auto sum_block = [&](const FlowBlock& block, std::size_t) {
    std::array<double, FlowGraph::kBlockCells> sum;
    const std::int32_t* cells = flow.order().data() + block.begin;
    const std::uint16_t* parents = flow.parents().data() + block.begin;
    const std::int32_t count = block.end - block.begin, heads = block.heads_end - block.begin;
    for (std::int32_t k = 0; k < count; ++k)
      sum[k] = a[cells[k]] + (weight ? cell_area * weight[cells[k]] : even);
    for (std::int32_t k = count; k-- > heads;) sum[parents[k]] += sum[k];
    for (std::int32_t k = 0; k < count; ++k) a[cells[k]] = sum[k];
  };
  flow.visit_downstream(context, sum_block, [&](std::int32_t k) {
    const std::int32_t head = flow.order()[k];
    a[flow.receiver(head)] += a[head];
  });
}

Raster<float> drainage_area(const FlowGraph& flow, const Context& context,
                            const Varying& rain_weight, std::span<const AreaSource> sources) {
  std::vector<double> area;
  accumulate_drainage_area(flow, area, context, rain_weight, sources);
  Raster<float> result(flow.grid());
  parallel_chunks(context, area.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = float(area[i]);
  });
  return result;
}

Raster<std::int32_t> strahler_order(const FlowGraph& flow, const Raster<float>& area,
                                    double least_area_m2, const Context& context) {
  check_field(flow, area.grid(), "area");
  // While donors arrive: 2 * (highest order so far) + 1 if it came more than once.
  Raster<std::int32_t> order(flow.grid());
  flow.sweep_downstream(context, [&](std::int32_t i) {
    if (area[i] < least_area_m2) return;
    const std::int32_t own = std::max(1, order[i] / 2 + order[i] % 2);
    order[i] = own;
    const std::int32_t receiver = flow.receiver(i);
    if (flow.is_base(receiver)) return;
    std::int32_t& next = order[receiver];
    if (own > next / 2)
      next = 2 * own;
    else if (own == next / 2)
      next = 2 * own + 1;
  });
  return order;
}

Raster<std::int32_t> watershed_labels(const FlowGraph& flow, const Context& context) {
  Raster<std::int32_t> label(flow.grid(), -1);
  std::vector<std::int32_t> outlets;
  for (std::int32_t i : flow.order())
    if (flow.is_base(flow.receiver(i))) outlets.push_back(flow.receiver(i));
  std::sort(outlets.begin(), outlets.end());
  outlets.erase(std::unique(outlets.begin(), outlets.end()), outlets.end());
  for (std::size_t k = 0; k < outlets.size(); ++k) label[outlets[k]] = std::int32_t(k);
  flow.sweep_upstream(context, [&](std::int32_t i) { label[i] = label[flow.receiver(i)]; });
  return label;
}

Raster<float> flow_length(const FlowGraph& flow, const Context& context) {
  Raster<float> length(flow.grid());
  flow.sweep_upstream(
      context, [&](std::int32_t i) { length[i] = length[flow.receiver(i)] + flow.distance(i); });
  return length;
}

Raster<float> chi_transform(const FlowGraph& flow, const Raster<float>& area,
                            double reference_area_m2, double concavity, const Context& context) {
  check_field(flow, area.grid(), "area");
  Raster<float> chi(flow.grid());
  flow.sweep_upstream(context, [&](std::int32_t i) {
    const double ratio = std::pow(reference_area_m2 / double(area[i]), concavity);
    chi[i] = chi[flow.receiver(i)] + float(ratio * flow.distance(i));
  });
  return chi;
}

std::vector<std::int32_t> trace_downstream(const FlowGraph& flow, std::int32_t cell) {
  std::vector<std::int32_t> cells{cell};
  while (!flow.is_base(cell)) cells.push_back(cell = flow.receiver(cell));
  return cells;
}

std::vector<std::int32_t> trace_main_stem(const FlowGraph& flow, const Raster<float>& area,
                                          std::int32_t cell) {
  check_field(flow, area.grid(), "area");
  std::vector<std::int32_t> cells{cell};
  while (true) {
    std::int32_t best = -1;
    for (std::uint8_t mask = flow.donors(cell); mask; mask &= std::uint8_t(mask - 1)) {
      const std::int32_t donor = flow.neighbor(cell, std::countr_zero(mask));
      if (best < 0 || area[donor] > area[best]) best = donor;
    }
    if (best < 0) return cells;
    cells.push_back(cell = best);
  }
}

}  // namespace orogen
