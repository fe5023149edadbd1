// TinStreamPower with sediment: rivers lay down what they carry, lakes fill. As on the grid
// (stream_power_deposition.cpp), with f = G * cell area / A and q what comes from the donors:
//
//   (z - z0) / dt * (1 + f) + k A'^m s^n = u (1 + f) + G q / A
//
// A part of the flow is solved by itself, in its own order; places below count in that order.
// A lake is a set of vertices under one spill level that drain through one exit. A vertex of it
// stays lake floor where its ground lies below the new height of the sill; there it is not cut, and
// takes its share of what the lake traps until it is full.
#include <algorithm>
#include <cmath>

#include "erosion/rise_above.h"
#include "erosion/tin_stream_power_step.h"

namespace orogen {

struct TinStreamPower::Deposition {
  const TinStreamPowerParameters& parameters;
  const FlowTrees& part;
  Buffers& o;
  const std::int32_t roots, all;
  const double per_dt, dt;  // both 0 for an infinite step
  const bool has_lakes, has_sediment;

  Deposition(const TinStreamPowerParameters& p, const FlowTrees& trees, Buffers& buffers,
             double dt_years, const TinSediment& sediment)
      : parameters(p),
        part(trees),
        o(buffers),
        roots(trees.roots),
        all(std::int32_t(trees.vertices.size())),
        per_dt(std::isinf(dt_years) ? 0.0 : 1.0 / dt_years),
        dt(std::isinf(dt_years) ? 0.0 : dt_years),
        has_lakes(p.fill_lakes && per_dt > 0.0),
        has_sediment(!sediment.bedrock.empty() && per_dt > 0.0) {}

  void gather_part(const TinFlow& flow, const double* z, const TinForcing& forcing,
                   const TinSediment& sediment) {
    for (auto* field : {&o.area, &o.z, &o.start, &o.uplift, &o.rise_cap, &o.cell_area, &o.per_area,
                        &o.rock_rate, &o.flux})
      field->resize(all);
    o.supply.assign(all, 0.0);
    const std::int32_t* vertices = part.vertices.data();
    sum_drainage_area(flow.tin(), part, forcing.rain_weight, o.area);
    gather(z, vertices, all, o.start.data());
    o.z = o.start;
    gather(forcing.uplift_rate, vertices, all, o.uplift.data());
    gather(flow.tin().cell_areas.data(), vertices, all, o.cell_area.data());
    if (!sediment.supply.empty()) gather(sediment.supply.data(), vertices, all, o.supply.data());
    // Steepest rises and rates of incision; those of roots are not used.
    std::vector<double>& length = o.flux;
    gather(flow.distances().data(), vertices, all, length.data());
    gather(forcing.talus_slope, vertices, all, o.rise_cap.data());
    for (std::int32_t k = roots; k < all; ++k) {
      o.rise_cap[k] *= length[k];
      o.per_area[k] = o.area[k] > 0.0 ? parameters.deposition_coefficient / o.area[k] : 0.0;
    }
    const auto rates = [&](const VertexValues& erodibility, std::vector<double>& rate) {
      rate.resize(all);
      std::vector<double> k(all - roots);
      gather(erodibility, vertices + roots, all - roots, k.data());
      incision_rates(parameters, o.area.data() + roots, k.data(), length.data() + roots,
                     all - roots, rate.data() + roots);
    };
    rates(forcing.erodibility, o.rock_rate);
    if (has_sediment) {
      o.bedrock.resize(all);
      gather(sediment.bedrock.data(), vertices, all, o.bedrock.data());
      rates(sediment.erodibility, o.sediment_rate);
    }
    if (!has_lakes) return;
    for (auto* field : {&o.lake_level, &o.sill, &o.fill, &o.room}) field->resize(all);
    find_lakes();
  }

  /// Height without cutting.
  double risen(std::int32_t k) const { return o.start[k] + o.uplift[k] * dt; }
  bool in_hollow(std::int32_t k) const { return o.lake_level[k] > o.start[k]; }
  bool drains_within(std::int32_t k, std::int32_t receiver) const {
    return receiver >= roots && in_hollow(receiver) && o.lake_level[receiver] == o.lake_level[k];
  }
  bool is_floor(std::int32_t k) const { return in_hollow(k) && risen(k) < o.sill[k]; }
  double floor_height(std::int32_t k) const {
    return risen(k) + o.fill[k] * (o.sill[k] - risen(k));
  }

  void find_lakes() {
    std::copy_n(o.z.begin(), roots, o.lake_level.begin());
    for (std::int32_t k = roots; k < all; ++k)
      o.sill[k] = o.lake_level[k] = std::max(o.start[k], o.lake_level[part.parents[k]]);
  }

  /// What the lake that ends at `k` holds back of the flux `out` (m³/yr).
  double trap(std::int32_t k, double out) {
    const double room = o.room[k] * per_dt;
    const double held = std::min(out, room);
    o.fill[k] = room > 0.0 ? held / room : 0.0;
    return held;
  }

  /// Sums the sediment downstream for the heights as they are. `settle`: a vertex that lays down
  /// more than reaches it is lowered. Afterwards `flux` is what reaches each vertex.
  void sum_flux(bool settle) {
    o.flux = o.supply;
    if (has_lakes) std::fill(o.room.begin(), o.room.end(), 0.0);
    for (std::int32_t k = all; k-- > roots;) {
      const std::int32_t receiver = part.parents[k];
      const bool hollow = has_lakes && in_hollow(k), floor = hollow && is_floor(k);
      double out = o.flux[k];
      if (!floor) {
        const double rise = (o.z[k] - o.start[k]) * per_dt;
        out += o.cell_area[k] * (o.uplift[k] - rise);
        if (out < 0.0) {
          if (settle) o.z[k] = o.start[k] + (o.uplift[k] + o.flux[k] / o.cell_area[k]) * dt;
          out = 0.0;
        }
      }
      if (hollow) {
        if (floor) o.room[k] += o.cell_area[k] * (o.sill[k] - risen(k));
        if (drains_within(k, receiver))
          o.room[receiver] += o.room[k];
        else
          out -= trap(k, out);
      }
      o.flux[receiver] += out;
    }
  }

  /// How far `k` rises above its receiver, at `below`.
  double rise(std::int32_t k, double below) const {
    const double own = 1.0 + o.per_area[k] * o.cell_area[k], over_time = per_dt * own;
    const double drive =
        o.uplift[k] * own + o.per_area[k] * o.flux[k] + (o.start[k] - below) * over_time;
    if (!(drive > 0.0)) return per_dt > 0.0 ? drive / over_time : 0.0;
    const double n = parameters.slope_exponent;
    const auto solved = [&](double rate) {
      return n == 1.0 ? drive / (over_time + rate)
                      : rise_above(drive, over_time, rate, n, o.z[k] - below);
    };
    if (!has_sediment) return solved(o.rock_rate[k]);
    const double top = o.bedrock[k] + o.uplift[k] * dt - below;
    const bool covered = o.start[k] > o.bedrock[k];
    const double first = solved(covered ? o.sediment_rate[k] : o.rock_rate[k]);
    if (covered ? first >= top : first <= top) return first;
    return covered ? std::min(solved(o.rock_rate[k]), top)
                   : std::max(solved(o.sediment_rate[k]), top);
  }

  void solve() {
    for (std::int32_t k = roots; k < all; ++k) {
      const std::int32_t receiver = part.parents[k];
      const double below = o.z[receiver];
      if (has_lakes && in_hollow(k)) {
        const bool within = drains_within(k, receiver);
        o.sill[k] = within ? o.sill[receiver] : below;
        if (within) o.fill[k] = o.fill[receiver];
        if (is_floor(k)) {
          o.z[k] = floor_height(k);
          continue;
        }
      }
      o.z[k] = below + std::min(rise(k, below), o.rise_cap[k]);
    }
  }

  void fill_lakes() {
    for (std::int32_t k = roots; k < all; ++k) {
      if (!in_hollow(k)) continue;
      const std::int32_t receiver = part.parents[k];
      if (drains_within(k, receiver)) o.fill[k] = o.fill[receiver];
      if (is_floor(k)) o.z[k] = floor_height(k);
    }
  }

  VolumeSum scatter(double* z, double* area, const TinSediment& sediment) const {
    VolumeSum sum;
    for (std::int32_t k = 0; k < all; ++k) {
      area[part.vertices[k]] = o.area[k];
      sum.taken_on += o.supply[k] * dt;
    }
    for (std::int32_t k = 0; k < roots; ++k) sum.exported += o.flux[k] * dt;
    for (std::int32_t k = roots; k < all; ++k) {
      const std::int32_t v = part.vertices[k];
      const double supply = per_dt > 0.0 ? o.uplift[k] * dt : std::max(0.0, o.z[k] - o.start[k]);
      sum.add(o.start[k], o.z[k], supply, o.cell_area[k]);
      z[v] = o.z[k];
      if (has_sediment)
        sediment.bedrock[v] = std::min(o.bedrock[k] + o.uplift[k] * dt, o.z[k]);
      else if (!sediment.bedrock.empty())
        sediment.bedrock[v] = o.z[k];  // time without end leaves no loose sediment
    }
    return sum;
  }
};

TinStreamPower::VolumeSum TinStreamPower::cut_and_lay_down(const TinFlow& flow,
                                                           const FlowTrees& part, Buffers& buffers,
                                                           double* z, const TinForcing& forcing,
                                                           double dt_years,
                                                           const TinSediment& sediment) {
  Deposition deposition(parameters_, part, buffers, dt_years, sediment);
  deposition.gather_part(flow, z, forcing, sediment);
  for (int i = 0; i < parameters_.deposition_iterations; ++i) {
    deposition.sum_flux(false);
    deposition.solve();
  }
  deposition.sum_flux(true);
  if (deposition.has_lakes) deposition.fill_lakes();
  return deposition.scatter(z, area_.data(), sediment);
}

}  // namespace orogen
