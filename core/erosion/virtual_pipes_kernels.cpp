#include "erosion/virtual_pipes_kernels.h"

#include <algorithm>
#include <cmath>

#include "erosion/virtual_pipes_tiles.h"
#include "foundation/simd.h"

namespace orogen::pipes {

namespace {

// A film thinner than this moves as if it were this thick.
constexpr double kThinnest = 1e-6;  // m
// A cell never gives quite all its water, so that rounding cannot leave it with less than none.
constexpr double kGiveable = 1.0 - 0x1.0p-20;

#define OROGEN_BODY     \
  template <class Real> \
  __attribute__((always_inline)) inline

/// Uniform 24 bits from a cell's number and the step's key (Wellons' lowbias32).
__attribute__((always_inline)) inline std::uint32_t rain_bits(std::uint32_t cell,
                                                              std::uint32_t key) {
  std::uint32_t x = cell * 0x9e3779b9u + key;
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return (x ^ (x >> 16)) >> 8;
}

OROGEN_BODY void flux_body(const FluxRow<Real>& row, const StepConstants<Real>& k, int n) {
  const Real *base_a = row.base_a, *base_b = row.base_b, *rel_a = row.rel_a, *rel_b = row.rel_b;
  const Real *depth_a = row.depth_a, *depth_b = row.depth_b, *old_flux = row.old_flux;
  Real* __restrict flux = row.flux;
  const Real push = k.push, drag = k.drag, thinnest = Real(kThinnest), zero = 0;
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    const Real bed = (base_a[i] - base_b[i]) + (rel_a[i] - rel_b[i]);
    const Real surface = bed + (depth_a[i] - depth_b[i]);
    const Real depth = std::max(depth_a[i] + std::min(bed, zero), depth_b[i] - std::max(bed, zero));
    const Real d = std::max(depth, thinnest), d3 = d * d * d;
    const Real wanted = old_flux[i] + push * surface;
    flux[i] = (wanted + wanted) * d3 / (d3 + std::sqrt(d3 * (d3 + drag * std::abs(wanted))));
  }
}

OROGEN_BODY void limit_body(const LimitRow<Real>& row, const StepConstants<Real>& k, int n) {
  const Real *west = row.west, *east = row.east, *south = row.south, *north = row.north;
  const Real *depth = row.depth, *suspended = row.suspended;
  Real* __restrict scale = row.scale;
  Real* __restrict concentration = row.concentration;
  const Real lambda = k.lambda, giveable = Real(kGiveable), tiny = Real(1e-30), zero = 0, one = 1;
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    const Real out = lambda * ((std::max(-west[i], zero) + std::max(east[i], zero)) +
                               (std::max(-south[i], zero) + std::max(north[i], zero)));
    scale[i] = std::min(one, giveable * depth[i] / std::max(out, tiny));
    concentration[i] = suspended[i] / std::max(depth[i], tiny);
  }
}

OROGEN_BODY void edge_body(const EdgeRow<Real>& row, int n) {
  const Real *wanted = row.wanted, *scale_a = row.scale_a, *scale_b = row.scale_b;
  const Real *concentration_a = row.concentration_a, *concentration_b = row.concentration_b;
  Real* __restrict flux = row.flux;
  Real* __restrict sediment_flux = row.sediment_flux;
  Real* __restrict kept = row.kept;
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    const Real q = wanted[i];
    const Real sa = scale_a[i], sb = scale_b[i], ca = concentration_a[i], cb = concentration_b[i];
    const Real limited = q * (q > 0 ? sa : sb);
    flux[i] = limited;
    kept[i] = limited;
    sediment_flux[i] = limited * (q > 0 ? ca : cb);
  }
}

/// What a step's water wants of a cell's bed and what the neighbours allow.
template <class Real>
struct Demand {
  Real capacity, most_eroded, most_deposited;
};

template <CapacityLaw law, class Real>
__attribute__((always_inline)) inline Demand<Real> demand_at(const UpdateRow<Real>& row,
                                                             const StepConstants<Real>& k, int i,
                                                             Real mean_depth, Real new_depth) {
  const Real zero = 0, half = Real(0.5);
  const Real base = row.base[i], rel = row.rel[i];
  const Real west = (base - row.base[i - 1]) + (rel - row.rel[i - 1]);
  const Real east = (base - row.base[i + 1]) + (rel - row.rel[i + 1]);
  const Real south = (base - row.base_south[i]) + (rel - row.rel_south[i]);
  const Real north = (base - row.base_north[i]) + (rel - row.rel_north[i]);
  const Real above = std::max(std::max(west, east), std::max(south, north));  // lowest neighbour
  const Real below = std::min(std::min(west, east), std::min(south, north));  // highest
  const Real gx = west - east, gy = south - north, steepest = std::max(above, -below);
  const Real rise2 = k.steepest * (steepest * steepest) + (1 - k.steepest) * (gx * gx + gy * gy);
  const Real slope2 = std::min(std::max(rise2 * k.inverse_cell2, k.min_slope2), k.max_slope2);
  const Real qx = half * (row.west[i] + row.east[i]), qy = half * (row.south[i] + row.north[i]);
  const Real q2 = qx * qx + qy * qy;
  const Real power2 = slope2 * (law == CapacityLaw::StreamPower ? std::sqrt(q2) : q2);
  Real capacity = k.capacity * std::sqrt(power2);
  if constexpr (law == CapacityLaw::Velocity) capacity /= std::max(mean_depth, Real(kThinnest));
  const Real change = (row.sediment[i] - row.original_sediment[i]) - row.wear[i];
  const Real to_sea = std::min(k.unlimited, std::max(base + rel, zero));
  const Real down = std::max(half * std::max(above - k.least_fall, zero), to_sea);
  const Real up = half * std::max(-below, zero) + new_depth + k.unlimited;
  return {capacity, std::min(down, std::max(k.max_change + change, zero)),
          std::min(up, std::max(k.max_change - change, zero))};
}

template <CapacityLaw law, class Real>
__attribute__((always_inline)) inline void update_body(const UpdateRow<Real>& given,
                                                       const StepConstants<Real>& k, int n) {
  const UpdateRow<Real> row = given;
  Real* __restrict out_depth = row.new_depth;
  Real* __restrict carry = row.carry;
  Real* __restrict out_suspended = row.new_suspended;
  Real* __restrict out_sediment = row.new_sediment;
  Real* __restrict out_wear = row.new_wear;
  Real* __restrict out_rain = row.rain;
  Real* __restrict out_evaporated = row.evaporated;
  const Real zero = 0, one = 1, half = Real(0.5);
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    // Water, with what rounding left out of the last sum carried over (Kahan).
    const Real old_depth = row.depth[i];
    const Real gain =
        k.lambda * ((row.west[i] - row.east[i]) + (row.south[i] - row.north[i])) + carry[i];
    const Real depth = std::max(old_depth + gain, zero);
    const Real left = gain - (depth - old_depth);
    const Real gained_sediment =
        k.lambda * ((row.s_west[i] - row.s_east[i]) + (row.s_south[i] - row.s_north[i]));
    const Real suspended = std::max(row.suspended[i] + gained_sediment, zero);

    const Real mean_depth = half * (old_depth + depth);
    const Demand<Real> demand = demand_at<law>(row, k, i, mean_depth, depth);
    const Real code = row.code[i], sediment = row.sediment[i], wear = row.wear[i];
    const bool mobile = code >= 0;
    const Real deficit = std::max(demand.capacity - suspended, zero);
    const Real excess = std::max(suspended - demand.capacity, zero);
    const Real ease = row.ease_erosion[i], hold = row.hold_erosion[i];
    const Real wish = std::min(sediment, k.dissolve_sediment * ease * deficit);
    const Real loose = std::min(wish, demand.most_eroded);
    const Real still = std::max(deficit - loose * (k.sediment_cost * hold), zero);
    const Real room = std::min(row.floor[i] - wear, demand.most_eroded - loose);
    const Real rock = std::min(std::min(code * ease, one) * still, room);
    const Real laid =
        std::min(std::min(k.deposit * row.ease_deposition[i], one) * excess, demand.most_deposited);
    // What the bed's rounding really took or got is what the water gets or loses.
    const Real wanted_sediment = mobile ? (sediment - loose) + laid : sediment;
    const Real wanted_wear = mobile ? wear + std::max(rock, zero) : wear;
    const bool affordable = wanted_sediment - sediment <= suspended;
    const Real new_sediment = affordable ? wanted_sediment : sediment;
    out_sediment[i] = new_sediment;
    out_wear[i] = wanted_wear;
    out_suspended[i] = (suspended + (sediment - new_sediment)) + (wanted_wear - wear);

    const Real dried = depth * (k.evaporate * row.temperature[i]);
    const Real after = depth - dried;
    const Real moisture = row.moisture[i];
    const std::uint32_t bits = rain_bits(row.first_cell + std::uint32_t(i), row.rain_key);
    const Real drop = Real(std::int32_t(bits)) < k.drop_chance * moisture ? k.drop : zero;
    const Real rain = code > Real(-1.5) ? drop + k.even_rain * moisture : zero;
    const Real more = rain + left;
    const Real wet = std::max(after + more, zero);
    out_depth[i] = wet;
    carry[i] = more - (wet - after);
    out_rain[i] = rain;
    out_evaporated[i] = depth - after;
  }
}

/// Sixteen partial sums whatever the width of the vectors, then double.
OROGEN_BODY double sum_body(const Real* values, int n) {
  Real lanes[16] = {};
  int i = 0;
  for (; i + 16 <= n; i += 16)
    for (int j = 0; j < 16; ++j) lanes[j] += values[i + j];
  double sum = 0.0;
  for (; i < n; ++i) sum += double(values[i]);
  for (const Real lane : lanes) sum += double(lane);
  return sum;
}

OROGEN_BODY void subtract_body(const Real* a, const Real* b, Real* __restrict out, int n) {
  for (int i = 0; i < n; ++i) out[i] = a[i] - b[i];
}

}  // namespace

#define OROGEN_PIPE_KERNELS(Real)                                                                  \
  OROGEN_CLONES void subtract_row(const Real* a, const Real* b, Real* out, int n) {                \
    subtract_body(a, b, out, n);                                                                   \
  }                                                                                                \
  OROGEN_CLONES void flux_row(const FluxRow<Real>& row, const StepConstants<Real>& k, int n) {     \
    flux_body(row, k, n);                                                                          \
  }                                                                                                \
  OROGEN_CLONES void limit_row(const LimitRow<Real>& row, const StepConstants<Real>& k, int n) {   \
    limit_body(row, k, n);                                                                         \
  }                                                                                                \
  OROGEN_CLONES void edge_row(const EdgeRow<Real>& row, int n) {                                   \
    edge_body(row, n);                                                                             \
  }                                                                                                \
  OROGEN_CLONES void update_row(const UpdateRow<Real>& row, const StepConstants<Real>& k, int n) { \
    switch (k.law) {                                                                               \
      case CapacityLaw::StreamPower:                                                               \
        return update_body<CapacityLaw::StreamPower>(row, k, n);                                   \
      case CapacityLaw::Discharge:                                                                 \
        return update_body<CapacityLaw::Discharge>(row, k, n);                                     \
      case CapacityLaw::Velocity:                                                                  \
        return update_body<CapacityLaw::Velocity>(row, k, n);                                      \
    }                                                                                              \
  }                                                                                                \
  OROGEN_CLONES double sum_row(const Real* values, int n) {                                        \
    return sum_body(values, n);                                                                    \
  }

OROGEN_PIPE_KERNELS(float)
OROGEN_PIPE_KERNELS(double)

}  // namespace orogen::pipes
