#include "erosion/tin_stream_power.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "erosion/rise_above.h"
#include "erosion/tin_stream_power_step.h"
#include "foundation/errors.h"
#include "foundation/power.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

constexpr std::size_t kCheckGrain = 65536;
constexpr int kStretch = 1024;  // vertices of a part that are looked at together

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

void incision_rates(const TinStreamPowerParameters& parameters, const double* area,
                    const double* erodibility, const double* length, int count, double* rate) {
  const double least = parameters.minimum_drainage_area;
  if (parameters.slope_exponent == 1.0 && parameters.area_exponent == 0.5)
    rates_by_root(area, least, erodibility, length, count, rate);
  else
    rates_by_powers(area, least, parameters.area_exponent, parameters.slope_exponent, erodibility,
                    length, count, rate);
}

namespace {

constexpr double kMost = std::numeric_limits<double>::max();

/// InputError at the first value outside [low, high].
void check_values(const VertexValues& values, std::size_t vertices, const char* name, double low,
                  double high, const Context& context) {
  values.check(vertices, name);
  const std::size_t count = values.values.empty() ? 1 : vertices;
  const auto bad = [&](std::size_t i) {
    const double v = values.at(std::int32_t(i));
    return !(v >= low && v <= high);
  };
  const std::size_t first = parallel_reduce(
      context, count, kCheckGrain, count,
      [&](std::size_t begin, std::size_t end) {
        bool any = false;  // looked for without a way out of the loop, which is quicker
        for (std::size_t i = begin; i < end; ++i) any |= bad(i);
        for (std::size_t i = begin; any && i < end; ++i)
          if (bad(i)) return i;
        return count;
      },
      [](std::size_t a, std::size_t b) { return std::min(a, b); });
  if (first == count) return;
  const std::string at = values.values.empty() ? "" : " at vertex " + std::to_string(first);
  throw InputError(
      std::string(name) + ": " + detail::format_number(values.at(std::int32_t(first))) + at +
      " is not allowed; " + (low < 0.0 ? "a finite number is wanted" : "0 or more is wanted"));
}

void check_sediment(const TinSediment& sediment, std::size_t vertices) {
  const auto wanted = [&](std::size_t count, const char* name) {
    if (count != 0 && count != vertices)
      throw InputError(std::string(name) + ": " + std::to_string(count) + " values, the TIN has " +
                       std::to_string(vertices) + " vertices");
  };
  wanted(sediment.bedrock.size(), "bedrock");
  wanted(sediment.supply.size(), "supply");
  if (!(sediment.erodibility >= 0.0))
    throw InputError("sediment: erodibility " + detail::format_number(sediment.erodibility) +
                     " is not allowed; 0 or more is wanted");
}

}  // namespace

TinStreamPower::TinStreamPower(const TinStreamPowerParameters& parameters)
    : parameters_(parameters) {
  check_parameters(parameters);
}

MassBalance TinStreamPower::step(TinFlow& flow, std::span<double> elevation,
                                 const TinForcing& forcing, double dt_years, const Context& context,
                                 const TinSediment& sediment) {
  flow.route(elevation, context);
  return solve(flow, elevation, forcing, dt_years, context, sediment);
}

MassBalance TinStreamPower::solve(const TinFlow& flow, std::span<double> elevation,
                                  const TinForcing& forcing, double dt_years,
                                  const Context& context, const TinSediment& sediment) {
  const std::size_t n = flow.tin().size();
  if (!(dt_years > 0.0))
    throw InputError("dt_years: " + std::to_string(dt_years) + " yr is not above 0");
  if (elevation.size() != n)
    throw InputError("elevation: " + std::to_string(elevation.size()) + " values, the TIN has " +
                     std::to_string(n) + " vertices");
  check_values(forcing.uplift_rate, n, "uplift_rate", -kMost, kMost, context);
  check_values(forcing.erodibility, n, "erodibility", 0.0, kMost, context);
  check_values(forcing.rain_weight, n, "rain_weight", 0.0, kMost, context);
  check_values(forcing.talus_slope, n, "talus_slope", 0.0, std::numeric_limits<double>::infinity(),
               context);
  check_sediment(sediment, n);
  area_.resize(n, 0.0);
  buffers_.resize(flow.part_count());
  std::vector<VolumeSum> sums(flow.part_count());
  double* z = elevation.data();
  flow.visit(context, [&](const FlowTrees& part, std::size_t p) {
    sums[p] = lays_down()
                  ? cut_and_lay_down(flow, part, buffers_[p], z, forcing, dt_years, sediment)
                  : cut(flow, part, buffers_[p], z, forcing, dt_years);
  });
  MassBalance result;
  double change = 0.0, exported = 0.0;
  for (const VolumeSum& sum : sums) {
    result.eroded_m3 += sum.eroded;
    result.deposited_m3 += sum.deposited;
    result.supplied_m3 += sum.supplied;
    change += sum.change;
    exported += sum.exported;
    result.stored_m3 -= sum.taken_on;
  }
  const bool counted = lays_down() && std::isfinite(dt_years);  // as it reached base level
  result.exported_m3 = counted ? exported : result.eroded_m3 - result.deposited_m3;
  result.residual_m3 = result.supplied_m3 - result.exported_m3 - change - result.stored_m3;
  return result;
}

void TinStreamPower::VolumeSum::add(double start, double end, double supply, double cell_area) {
  const double moved = end - start, lost = supply - moved;
  eroded += std::max(0.0, lost) * cell_area;
  deposited += std::max(0.0, -lost) * cell_area;
  supplied += supply * cell_area;
  change += moved * cell_area;
}

TinStreamPower::VolumeSum TinStreamPower::cut(const TinFlow& flow, const FlowTrees& part,
                                              Buffers& buffers, double* z,
                                              const TinForcing& forcing, double dt_years) {
  const int total = int(part.vertices.size());
  const double n = parameters_.slope_exponent;
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
    incision_rates(parameters_, area, s.erodibility, s.length, count, s.factor);
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
      const double end = buffers.z[begin + k];
      sum.add(s.start[k], end, infinite ? std::max(0.0, end - s.start[k]) : s.uplift[k] * dt,
              s.cell_area[k]);
      z[vertices[k]] = end;
      area_[vertices[k]] = area[k];
    }
  }
  return sum;
}

}  // namespace orogen
