#include "erosion/stream_power.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "erosion/rise_above.h"
#include "erosion/stream_power_step.h"
#include "foundation/errors.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

constexpr int kBlock = FlowGraph::kBlockCells;

/// The cells of a block, side by side.
struct Gathered {
  alignas(64) float start[kBlock], z[kBlock], factor[kBlock], uplift[kBlock], rise_cap[kBlock];
  alignas(64) float least[kBlock], greatest[kBlock];
  alignas(64) double area[kBlock];
  alignas(64) float erodibility[kBlock];
  alignas(64) std::uint8_t direction[kBlock];
};

/// to[k] = from[cells[k]]
template <class T>
void gather(const T* from, const std::int32_t* cells, int count, T* to) {
  for (int k = 0; k < count; ++k) to[k] = from[cells[k]];
}

void gather(const Varying& from, const std::int32_t* cells, int count, float* to) {
  if (from.raster)
    gather(from.raster->data(), cells, count, to);
  else
    std::fill_n(to, count, float(from.value));
}

OROGEN_CLONES void invert_sum(float per_dt, float* rate, int count) {
  for (int k = 0; k < count; ++k) rate[k] = 1.0f / (per_dt + rate[k]);
}

/// Talus slope to the largest rise above the receiver.
OROGEN_CLONES void slope_to_rise(const std::uint8_t* direction, float straight, float diagonal,
                                 float* slope, int count) {
  for (int k = 0; k < count; ++k) slope[k] *= direction[k] & 1 ? diagonal : straight;
}

}  // namespace

StreamPower::StreamPower(const StreamPowerParameters& parameters) : parameters_(parameters) {
  check_parameters(parameters);
}

MassBalance StreamPower::step(FlowGraph& flow, Raster<float>& elevation,
                              const StreamPowerForcing& forcing, double dt_years,
                              const Context& context) {
  flow.route(elevation, context);
  accumulate_drainage_area(flow, area_, context, forcing.rain_weight, forcing.sources);
  return solve(flow, area_, elevation, forcing, dt_years, context);
}

MassBalance StreamPower::solve(const FlowGraph& flow, const std::vector<double>& drainage_area,
                               Raster<float>& elevation, const StreamPowerForcing& forcing,
                               double dt_years, const Context& context) {
  const Grid& grid = flow.grid();
  if (!(dt_years > 0.0))
    throw InputError("dt_years: " + std::to_string(dt_years) + " yr is not above 0");
  if (elevation.grid() != grid || drainage_area.size() != grid.size() ||
      (forcing.pinned && forcing.pinned->grid() != grid))
    throw InputError("elevation, drainage_area and pinned: must lie on the grid of the flow graph");
  forcing.uplift_rate.check(grid, "uplift_rate");
  forcing.erodibility.check(grid, "erodibility");
  forcing.talus_slope.check(grid, "talus_slope");
  forcing.least_height.check(grid, "least_height");
  forcing.greatest_height.check(grid, "greatest_height");
  const bool infinite = std::isinf(dt_years);
  const Step step{flow,
                  forcing,
                  IncisionLaw(parameters_, grid.cell_size),
                  drainage_area.data(),
                  elevation.data(),
                  infinite ? 0.0 : 1.0 / dt_years,
                  infinite ? 0.0 : dt_years};
  return parameters_.deposition_coefficient > 0.0 ? cut_and_lay_down(step, context)
                                                  : cut(step, context);
}

/// Nothing is laid down: one sweep.
MassBalance StreamPower::cut(const Step& step, const Context& context) {
  const FlowGraph& flow = step.flow;
  const double n = parameters_.slope_exponent, per_dt = step.per_dt, dt = step.dt;
  const float straight = float(flow.grid().cell_size);
  const float diagonal = float(flow.grid().cell_size * std::sqrt(2.0));
  sums_.assign(flow.blocks().size(), {});
  flow.visit_upstream(context, [&](const FlowBlock& block, std::size_t number) {
    const std::int32_t* cells = flow.order().data() + block.begin;
    const std::uint16_t* parents = flow.parents().data() + block.begin;
    const int count = block.end - block.begin, heads = block.heads_end - block.begin;
    Gathered g;
    gather(step.z, cells, count, g.start);
    gather(step.area, cells, count, g.area);
    gather(flow.directions(), cells, count, g.direction);
    gather(step.forcing.uplift_rate, cells, count, g.uplift);
    gather(step.forcing.talus_slope, cells, count, g.rise_cap);
    gather(step.forcing.erodibility, cells, count, g.erodibility);
    step.law.rates(g.erodibility, g.area, g.direction, count, g.factor);
    slope_to_rise(g.direction, straight, diagonal, g.rise_cap, count);
    gather(step.forcing.least_height, cells, count, g.least);
    gather(step.forcing.greatest_height, cells, count, g.greatest);
    if (n == 1.0) invert_sum(float(per_dt), g.factor, count);
    if (const auto* pinned = step.forcing.pinned)
      for (int k = 0; k < count; ++k)
        if ((*pinned)[cells[k]]) g.factor[k] = kPinned;

    const auto settle = [&](int k, float below, float z) {
      z = held_within(z, below, g.least[k], g.greatest[k]);
      g.z[k] = g.factor[k] < 0.0f ? g.start[k] : z;
    };
    // Below its receiver a cell is not cut: it only rises.
    const auto solve_linear = [&, per_dt = float(per_dt), dt = float(dt)](int k, float below) {
      const float drive = g.uplift[k] + (g.start[k] - below) * per_dt;
      const float rise = std::min(drive * (drive > 0.0f ? g.factor[k] : dt), g.rise_cap[k]);
      settle(k, below, below + rise);
    };
    const auto solve_power = [&](int k, float below) {
      const double drive = g.uplift[k] + (double(g.start[k]) - below) * per_dt;
      const double rise =
          drive > 0.0 ? rise_above(drive, per_dt, g.factor[k], n, g.start[k] - below) : drive * dt;
      settle(k, below, float(below + std::min(rise, double(g.rise_cap[k]))));
    };
    const auto solve_all = [&](auto&& solve) {
      for (int k = 0; k < heads; ++k) solve(k, step.z[flow.receiver(cells[k])]);
      for (int k = heads; k < count; ++k) solve(k, g.z[parents[k]]);
    };
    if (n == 1.0)
      solve_all(solve_linear);
    else
      solve_all(solve_power);

    VolumeSum sum;
    for (int k = 0; k < count; ++k) step.z[cells[k]] = g.z[k];
    for (int k = 0; k < count; ++k) step.add(g.start[k], g.z[k], g.uplift[k], sum);
    sums_[number] = sum;
  });
  return step.balance(sums_);
}

MassBalance StreamPower::Step::balance(const std::vector<VolumeSum>& sums) const {
  VolumeSum sum;
  for (const VolumeSum& s : sums) {
    sum.eroded += s.eroded;
    sum.deposited += s.deposited;
    sum.supplied += s.supplied;
    sum.change += s.change;
  }
  const double cell = flow.grid().cell_area();
  MassBalance result{.eroded_m3 = sum.eroded * cell,
                     .deposited_m3 = sum.deposited * cell,
                     .exported_m3 = (sum.eroded - sum.deposited) * cell,
                     .supplied_m3 = sum.supplied * cell};
  result.residual_m3 = result.supplied_m3 - result.exported_m3 - sum.change * cell;
  return result;
}

MassBalance erode_stream_power(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                               const StreamPowerForcing& forcing,
                               const StreamPowerParameters& parameters, Context& context,
                               Raster<float>* area) {
  if (base_level.grid() != elevation.grid())
    throw InputError("base_level: must lie on the same grid as the elevation");
  StreamPower solver(parameters);
  FlowGraph flow(base_level);
  MassBalance total;
  for (int i = 0; i < parameters.steps; ++i) {
    total += solver.step(flow, elevation, forcing, parameters.step_years, context);
    context.report(double(i + 1) / parameters.steps);
  }
  if (area) {
    flow.route(elevation, context);
    *area = drainage_area(flow, context, forcing.rain_weight, forcing.sources);
  }
  return total;
}

}  // namespace orogen
