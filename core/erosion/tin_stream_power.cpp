#include "erosion/tin_stream_power.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "erosion/rise_above.h"
#include "foundation/errors.h"
#include "foundation/power.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

constexpr int kStretch = 1024;  // vertices of a part that are looked at together

template <class T>
void gather(const T* from, const std::int32_t* vertices, int count, double* to) {
  for (int k = 0; k < count; ++k) to[k] = double(from[vertices[k]]);
}

void gather(const VertexValues& from, const std::int32_t* vertices, int count, double* to) {
  if (from.values.empty())
    std::fill_n(to, count, from.value);
  else
    gather(from.values.data(), vertices, count, to);
}

/// Vertices side by side.
struct Stretch {
  double start[kStretch], uplift[kStretch], erodibility[kStretch], rise_cap[kStretch];
  double length[kStretch], cell_area[kStretch];
  double factor[kStretch];

  void fill(const TinFlow& flow, const TinForcing& forcing, const double* z,
            const std::int32_t* vertices, int count) {
    gather(z, vertices, count, start);
    gather(forcing.uplift_rate, vertices, count, uplift);
    gather(forcing.erodibility, vertices, count, erodibility);
    gather(forcing.talus_slope, vertices, count, rise_cap);
    gather(flow.distances().data(), vertices, count, length);
    gather(flow.tin().cell_areas.data(), vertices, count, cell_area);
    for (int k = 0; k < count; ++k) rise_cap[k] *= length[k];
  }
};

// k A'^m / length^n: the rate of incision (m/yr) at a rise of 1 m.
OROGEN_CLONES void rates_by_root(const double* __restrict area, double least,
                                 const double* __restrict erodibility,
                                 const double* __restrict length, int count,
                                 double* __restrict rate) {
  for (int k = 0; k < count; ++k)
    rate[k] = erodibility[k] * std::sqrt(area[k] > least ? area[k] : least) / length[k];
}

OROGEN_CLONES void rates_by_powers(const double* __restrict area, double least, double m, double n,
                                   const double* __restrict erodibility,
                                   const double* __restrict length, int count,
                                   double* __restrict rate) {
  for (int k = 0; k < count; ++k)
    rate[k] = erodibility[k] * positive_power(area[k] > least ? area[k] : least, m) *
              positive_power(length[k], -n);
}

OROGEN_CLONES void invert_sum(double per_dt, double* rate, int count) {
  for (int k = 0; k < count; ++k) rate[k] = 1.0 / (per_dt + rate[k]);
}

}  // namespace

TinStreamPower::TinStreamPower(const TinStreamPowerParameters& parameters)
    : parameters_(parameters) {
  check_parameters(parameters);
}

MassBalance TinStreamPower::step(TinFlow& flow, std::span<double> elevation,
                                 const TinForcing& forcing, double dt_years,
                                 const Context& context) {
  const std::size_t n = flow.tin().size();
  if (!(dt_years > 0.0))
    throw InputError("dt_years: " + std::to_string(dt_years) + " yr is not above 0");
  forcing.uplift_rate.check(n, "uplift_rate");
  forcing.erodibility.check(n, "erodibility");
  forcing.rain_weight.check(n, "rain_weight");
  forcing.talus_slope.check(n, "talus_slope");
  flow.route(elevation, context);
  area_.resize(n, 0.0);
  buffers_.resize(flow.part_count());
  std::vector<VolumeSum> sums(flow.part_count());
  flow.visit(context, [&](const FlowTrees& part, std::size_t p) {
    sums[p] = solve_part(flow, part, buffers_[p], elevation.data(), forcing, dt_years);
  });
  MassBalance result;
  double change = 0.0;
  for (const VolumeSum& sum : sums) {
    result.eroded_m3 += sum.eroded;
    result.deposited_m3 += sum.deposited;
    result.supplied_m3 += sum.supplied;
    change += sum.change;
  }
  result.exported_m3 = result.eroded_m3 - result.deposited_m3;
  result.residual_m3 = result.supplied_m3 - result.exported_m3 - change;
  return result;
}

TinStreamPower::VolumeSum TinStreamPower::solve_part(const TinFlow& flow, const FlowTrees& part,
                                                     Buffers& buffers, double* z,
                                                     const TinForcing& forcing, double dt_years) {
  const int total = int(part.vertices.size());
  const double m = parameters_.area_exponent, n = parameters_.slope_exponent;
  const bool infinite = std::isinf(dt_years), linear = n == 1.0;
  const double per_dt = infinite ? 0.0 : 1.0 / dt_years, dt = infinite ? 0.0 : dt_years;
  buffers.area.resize(total);
  buffers.z.resize(total);
  sum_drainage_area(flow.tin(), part, forcing.rain_weight, buffers.area);
  for (int k = 0; k < part.roots; ++k) {
    buffers.z[k] = z[part.vertices[k]];
    area_[part.vertices[k]] = buffers.area[k];
  }
  VolumeSum sum;
  Stretch s;
  for (int begin = part.roots; begin < total; begin += kStretch) {
    const int count = std::min(kStretch, total - begin);
    const std::int32_t* vertices = part.vertices.data() + begin;
    const std::int32_t* parents = part.parents.data() + begin;
    const double* area = buffers.area.data() + begin;
    s.fill(flow, forcing, z, vertices, count);
    const double least = parameters_.minimum_drainage_area;
    if (linear && m == 0.5)
      rates_by_root(area, least, s.erodibility, s.length, count, s.factor);
    else
      rates_by_powers(area, least, m, n, s.erodibility, s.length, count, s.factor);
    if (linear) invert_sum(per_dt, s.factor, count);

    // Below its receiver a vertex is not cut: it only rises.
    const auto solve_all = [&](auto&& rise) {
      for (int k = 0; k < count; ++k) {
        const double below = buffers.z[parents[k]], above = s.start[k] - below;
        const double drive = s.uplift[k] + above * per_dt;
        const double risen = drive > 0.0 ? rise(k, drive, above) : drive * dt;
        buffers.z[begin + k] = below + std::min(risen, s.rise_cap[k]);
      }
    };
    if (linear)
      solve_all([&](int k, double drive, double) { return drive * s.factor[k]; });
    else
      solve_all([&](int k, double drive, double above) {
        return rise_above(drive, per_dt, s.factor[k], n, above);
      });

    for (int k = 0; k < count; ++k) {
      const double end = buffers.z[begin + k], change = end - s.start[k];
      const double supply = infinite ? std::max(0.0, change) : s.uplift[k] * dt;
      const double lost = supply - change;
      sum.eroded += std::max(0.0, lost) * s.cell_area[k];
      sum.deposited += std::max(0.0, -lost) * s.cell_area[k];
      sum.supplied += supply * s.cell_area[k];
      sum.change += change * s.cell_area[k];
      z[vertices[k]] = end;
      area_[vertices[k]] = area[k];
    }
  }
  return sum;
}

}  // namespace orogen
