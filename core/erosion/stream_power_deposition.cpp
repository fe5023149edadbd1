// StreamPower with sediment: rivers lay down what they carry, lakes fill.
//
// In rates, with f = G * cell area / A and q what comes from the donors (m³/yr):
//   (z - z0) / dt * (1 + f) + k A'^m S^n = U (1 + f) + G q / A
// which is the law with q as it leaves the cell, the cell's own part taken implicitly.
//
// A lake is a set of cells under one spill level that drain through one exit. A cell of it stays
// lake floor where its rock lies below the new height of the sill; there it is not cut, and takes
// its share of what the lake traps until it is full.
#include <algorithm>
#include <cmath>

#include "erosion/rise_above.h"
#include "erosion/stream_power_step.h"

namespace orogen {

namespace {

constexpr std::size_t kChunk = 1 << 14;

}  // namespace

/// Indices are places in the order of the flow graph.
struct StreamPower::Deposition {
  const StreamPowerParameters& parameters;
  const Step& step;
  const FlowGraph& flow;
  Ordered& o;
  const std::size_t land, all;  // cells that are not base level; with the shore
  const bool has_lakes;
  const double cell_area;

  Deposition(const StreamPowerParameters& p, const Step& s, Ordered& ordered)
      : parameters(p),
        step(s),
        flow(s.flow),
        o(ordered),
        land(s.flow.order().size()),
        all(land + s.flow.shore().size()),
        has_lakes(p.fill_lakes && s.per_dt > 0.0),
        cell_area(s.flow.grid().cell_area()) {}

  void allocate() {
    o.place.resize(flow.grid().size());
    o.receiver.resize(land);
    for (auto* field : {&o.start, &o.z, &o.uplift, &o.rise_cap, &o.incision, &o.per_area})
      field->resize(all);
    o.flux.resize(all);
    if (!has_lakes) return;
    for (auto* field : {&o.lake_level, &o.sill, &o.fill}) field->resize(all);
    o.room.resize(all);
  }

  void gather(const Context& context) {
    const auto order = flow.order();
    const auto shore = flow.shore();
    parallel_chunks(context, land, kChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) o.place[order[k]] = std::int32_t(k);
    });
    for (std::size_t k = 0; k < shore.size(); ++k) {
      o.place[shore[k]] = std::int32_t(land + k);
      o.z[land + k] = step.z[shore[k]];
    }
    parallel_chunks(context, land, kChunk, [&](std::size_t begin, std::size_t end) {
      std::vector<double> area(end - begin);
      std::vector<float> erodibility(end - begin);
      std::vector<std::uint8_t> direction(end - begin);
      for (std::size_t k = begin; k < end; ++k) {
        const std::int32_t cell = order[k];
        o.receiver[k] = o.place[flow.receiver(cell)];
        o.start[k] = o.z[k] = step.z[cell];
        o.uplift[k] = step.forcing.uplift_rate.at(cell);
        o.rise_cap[k] = step.forcing.talus_slope.at(cell) * flow.distance(cell);
        area[k - begin] = step.area[cell];
        erodibility[k - begin] = step.forcing.erodibility.at(cell);
        direction[k - begin] = flow.direction(cell);
        o.per_area[k] = step.area[cell] > 0.0
                            ? float(parameters.deposition_coefficient / step.area[cell])
                            : 0.0f;
      }
      step.law.rates(erodibility.data(), area.data(), direction.data(), int(end - begin),
                     o.incision.data() + begin);
      if (const auto* pinned = step.forcing.pinned)
        for (std::size_t k = begin; k < end; ++k)
          if ((*pinned)[order[k]]) o.incision[k] = kPinned;
    });
  }

  template <class Body>
  void upstream(const Context& context, Body&& body) const {
    flow.visit_upstream(context, [&](const FlowBlock& block, std::size_t) {
      for (std::int32_t k = block.begin; k < block.end; ++k) body(k, o.receiver[k]);
    });
  }

  template <class Body>
  void downstream(const Context& context, Body&& body) const {
    flow.visit_downstream(
        context,
        [&](const FlowBlock& block, std::size_t) {
          for (std::int32_t k = block.end; k-- > block.heads_end;) body(k, o.receiver[k]);
        },
        [&](std::int32_t k) { body(k, o.receiver[k]); });
  }

  /// Height without cutting.
  float risen(std::int32_t k) const { return o.start[k] + float(o.uplift[k] * step.dt); }
  bool in_hollow(std::int32_t k) const { return o.lake_level[k] > o.start[k]; }
  bool drains_within(std::int32_t k, std::int32_t receiver) const {
    return receiver < std::int32_t(land) && in_hollow(receiver) &&
           o.lake_level[receiver] == o.lake_level[k];
  }
  bool is_floor(std::int32_t k) const {
    return in_hollow(k) && risen(k) < o.sill[k] && o.incision[k] != kPinned;
  }
  float floor_height(std::int32_t k) const { return risen(k) + o.fill[k] * (o.sill[k] - risen(k)); }

  void find_lakes(const Context& context) {
    std::copy(o.z.begin() + land, o.z.end(), o.lake_level.begin() + land);
    upstream(context, [this](std::int32_t k, std::int32_t receiver) {
      o.sill[k] = o.lake_level[k] = std::max(o.start[k], o.lake_level[receiver]);
    });
  }

  /// What the lake that ends at `k` holds back of the flux `out` (m³/yr).
  double trap(std::int32_t k, double out) {
    const double room = o.room[k] * step.per_dt;
    const double held = std::min(out, room);
    o.fill[k] = room > 0.0 ? float(held / room) : 0.0f;
    return held;
  }

  /// Sums the sediment downstream for the heights as they are. `settle`: a cell that lays down more
  /// than reaches it is lowered, and what leaves is kept in `flux`.
  void sum_flux(bool settle, const Context& context) {
    parallel_chunks(context, all, kChunk, [&](std::size_t begin, std::size_t end) {
      std::fill(o.flux.begin() + begin, o.flux.begin() + end, 0.0);
      if (has_lakes) std::fill(o.room.begin() + begin, o.room.begin() + end, 0.0);
    });
    downstream(context, [this, settle](std::int32_t k, std::int32_t receiver) {
      const bool hollow = has_lakes && in_hollow(k), floor = hollow && is_floor(k);
      double out = o.flux[k];
      if (!floor) {
        const double rise = (double(o.z[k]) - o.start[k]) * step.per_dt;
        out += cell_area * (o.uplift[k] - rise);
        if (out < 0.0) {
          if (settle && o.incision[k] != kPinned)
            o.z[k] = float(o.start[k] + (o.uplift[k] + o.flux[k] / cell_area) * step.dt);
          out = 0.0;
        }
      }
      if (hollow) {
        if (floor) o.room[k] += cell_area * (o.sill[k] - risen(k));
        if (drains_within(k, receiver))
          o.room[receiver] += o.room[k];
        else
          out -= trap(k, out);
      }
      if (settle) o.flux[k] = out;
      o.flux[receiver] += out;
    });
  }

  void solve(const Context& context) {
    const double n = parameters.slope_exponent;
    upstream(context, [this, n](std::int32_t k, std::int32_t receiver) {
      const float below = o.z[receiver];
      if (has_lakes && in_hollow(k)) {
        const bool within = drains_within(k, receiver);
        o.sill[k] = within ? o.sill[receiver] : below;
        if (within) o.fill[k] = o.fill[receiver];
        if (is_floor(k)) {
          o.z[k] = floor_height(k);
          return;
        }
      }
      if (o.incision[k] == kPinned) return;
      const double own = 1.0 + double(o.per_area[k]) * cell_area, per_dt = step.per_dt * own;
      const double drive =
          o.uplift[k] * own + o.per_area[k] * o.flux[k] + (double(o.start[k]) - below) * per_dt;
      double rise = 0.0;
      if (drive > 0.0)
        rise = n == 1.0 ? drive / (per_dt + o.incision[k])
                        : rise_above(drive, per_dt, o.incision[k], n, o.z[k] - below);
      else if (per_dt > 0.0)
        rise = drive / per_dt;
      const std::int32_t cell = flow.order()[k];
      o.z[k] =
          held_within(float(below + std::min(rise, double(o.rise_cap[k]))), below,
                      step.forcing.least_height.at(cell), step.forcing.greatest_height.at(cell));
    });
  }

  void fill_lakes(const Context& context) {
    upstream(context, [this](std::int32_t k, std::int32_t receiver) {
      if (!in_hollow(k)) return;
      if (drains_within(k, receiver)) o.fill[k] = o.fill[receiver];
      if (is_floor(k)) o.z[k] = floor_height(k);
    });
  }

  void scatter(std::vector<double>& flux, std::vector<VolumeSum>& sums, const Context& context) {
    flux.resize(flow.grid().size());
    sums.assign((land + kChunk - 1) / kChunk, {});
    parallel_chunks(context, sums.size(), 1, [&](std::size_t chunk, std::size_t) {
      for (std::size_t k = chunk * kChunk; k < std::min(land, (chunk + 1) * kChunk); ++k) {
        const std::int32_t cell = flow.order()[k];
        step.z[cell] = o.z[k];
        flux[cell] = o.flux[k];
        step.add(o.start[k], o.z[k], o.uplift[k], sums[chunk]);
      }
    });
    for (std::size_t k = land; k < all; ++k) flux[flow.shore()[k - land]] = o.flux[k];
  }
};

MassBalance StreamPower::cut_and_lay_down(const Step& step, const Context& context) {
  Deposition deposition(parameters_, step, ordered_);
  deposition.allocate();
  deposition.gather(context);
  if (deposition.has_lakes) deposition.find_lakes(context);
  for (int i = 0; i < parameters_.deposition_iterations; ++i) {
    deposition.sum_flux(false, context);
    deposition.solve(context);
  }
  deposition.sum_flux(true, context);
  if (deposition.has_lakes) deposition.fill_lakes(context);
  deposition.scatter(flux_, sums_, context);
  return step.balance(sums_);
}

}  // namespace orogen
