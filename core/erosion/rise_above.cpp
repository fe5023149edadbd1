#include "erosion/rise_above.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/power.h"

namespace orogen {

double rise_above(double c, double per_dt, double g, double n, double guess) {
  if (g <= 0.0) return per_dt > 0.0 ? c / per_dt : 0.0;
  if (n == 1.0) return c / (per_dt + g);
  constexpr double room = 1.0 + 1e-9;  // for rounding: a bracket too tight would stop the iteration
  double low = 0.0;
  double high = per_dt > 0.0 ? c / per_dt * room : std::numeric_limits<double>::infinity();
  double x = guess, cutting = guess > 0.0 && guess < high ? g * positive_power(guess, n) : 0.0;
  if (const double sum = per_dt * x + cutting; cutting == 0.0 || sum > 4.0 * c || sum < 0.25 * c) {
    // At `high` one of the two terms is c, at `low` each is at most half of it. Newton's steps
    // never pass the root from the one side for n > 1, from the other for n < 1.
    const double alone = positive_power(c / g, 1.0 / n);  // without the term of time
    if (per_dt <= 0.0) return alone;
    low = std::min(0.5 * high, alone * positive_power(0.5, 1.0 / n));
    high = std::min(high, alone * room);
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
    if (change <= 1e-6 * x) break;  // the next step would change less than the square of that
    cutting = g * positive_power(x, n);
  }
  return x;
}

}  // namespace orogen
