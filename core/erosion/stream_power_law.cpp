#include <algorithm>
#include <cmath>
#include <limits>

#include "erosion/stream_power_step.h"
#include "foundation/power.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

template <class Power>
[[gnu::always_inline]] inline void unit_rates(const IncisionLaw& law, const float* erodibility,
                                              const double* area, const std::uint8_t* direction,
                                              int count, float* out, Power&& power) {
  const double least = law.least_area, added = law.add_area ? law.least_area : 0.0;
  const float straight = law.per_straight, diagonal = law.per_diagonal;
  for (int c = 0; c < count; ++c) {
    const double a = area[c] + added;
    const float per_length = direction[c] & 1 ? diagonal : straight;
    out[c] = erodibility[c] * float(power(a > least ? a : least)) * per_length;
  }
}

OROGEN_CLONES void rates_by_root(const IncisionLaw& law, const float* __restrict erodibility,
                                 const double* __restrict area,
                                 const std::uint8_t* __restrict direction, int count,
                                 float* __restrict out) {
  unit_rates(law, erodibility, area, direction, count, out, [](double a) { return std::sqrt(a); });
}

OROGEN_CLONES void rates_by_power(const IncisionLaw& law, const float* __restrict erodibility,
                                  const double* __restrict area,
                                  const std::uint8_t* __restrict direction, int count,
                                  float* __restrict out) {
  const double m = law.area_exponent;
  unit_rates(law, erodibility, area, direction, count, out,
             [m](double a) { return positive_power(a, m); });
}

}  // namespace

IncisionLaw::IncisionLaw(const StreamPowerParameters& p, double cell_size)
    : area_exponent(p.area_exponent),
      slope_exponent(p.slope_exponent),
      least_area(p.minimum_drainage_area),
      add_area(p.area_floor == AreaFloor::Sum),
      per_straight(float(positive_power(cell_size, -p.slope_exponent))),
      per_diagonal(float(positive_power(cell_size * std::sqrt(2.0), -p.slope_exponent))) {}

void IncisionLaw::rates(const float* erodibility, const double* area, const std::uint8_t* direction,
                        int count, float* out) const {
  (area_exponent == 0.5 ? rates_by_root : rates_by_power)(*this, erodibility, area, direction,
                                                          count, out);
}

double rise_above(double c, double per_dt, double g, double n, double guess) {
  if (g <= 0.0) return per_dt > 0.0 ? c / per_dt : 0.0;
  if (n == 1.0) return c / (per_dt + g);
  double low = 0.0, high = per_dt > 0.0 ? c / per_dt : std::numeric_limits<double>::infinity();
  double x = guess, cutting = guess > 0.0 && guess < high ? g * positive_power(guess, n) : 0.0;
  if (const double sum = per_dt * x + cutting; cutting == 0.0 || sum > 4.0 * c || sum < 0.25 * c) {
    // At `high` one of the two terms is c, at `low` each is at most half of it. Newton's steps
    // never pass the root from the one side for n > 1, from the other for n < 1.
    const double alone = positive_power(c / g, 1.0 / n);  // without the term of time
    if (per_dt <= 0.0) return alone;
    low = std::min(0.5 * high, alone * positive_power(0.5, 1.0 / n));
    high = std::min(high, alone);
    x = n > 1.0 ? high : low;
    cutting = g * positive_power(x, n);
  }
  for (int i = 0; i < 60; ++i) {
    const double excess = per_dt * x + cutting - c;
    (excess > 0.0 ? high : low) = x;
    double next = x - excess / (per_dt + n * cutting / x);
    if (!(next >= low && next <= high)) next = 0.5 * (low + std::min(high, 4.0 * x));
    const double change = std::fabs(next - x);
    x = next;
    if (change <= 1e-5 * x) break;  // the next step would change less than the square of that
    cutting = g * positive_power(x, n);
  }
  return x;
}

}  // namespace orogen
