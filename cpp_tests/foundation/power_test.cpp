#include "foundation/power.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/random.h"

namespace orogen {
namespace {

TEST(PositivePower, IsThatOfTheLibraryInLongDouble) {
  for (int i = 0; i < 200000; ++i) {
    const double x = std::exp(-40.0 + 80.0 * random_uniform(1, 0, i));
    const double y = -3.0 + 6.0 * random_uniform(1, 1, i);
    const long double expected = std::pow((long double)x, (long double)y);
    if (std::fabs(std::log10(expected)) > 60.0L) continue;
    ASSERT_NEAR(double(positive_power(x, y) / expected - 1.0L), 0.0, 2e-13) << x << "^" << y;
  }
}

TEST(PositivePower, IsExactWhereNothingIsToDo) {
  for (double v : {-2.5, -1.0, 0.0, 0.3, 1.0, 7.0}) EXPECT_EQ(positive_power(1.0, v), 1.0);
  for (double v : {1e-30, 0.7, 3.0, 1e12}) EXPECT_EQ(positive_power(v, 0.0), 1.0);
  for (int k = -60; k <= 60; ++k)
    EXPECT_EQ(positive_power(std::ldexp(1.0, k), 1.0), std::ldexp(1.0, k));
}

}  // namespace
}  // namespace orogen
