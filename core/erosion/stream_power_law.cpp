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

}  // namespace orogen
