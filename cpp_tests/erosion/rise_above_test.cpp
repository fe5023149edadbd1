#include "erosion/rise_above.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/random.h"

namespace orogen {
namespace {

TEST(RiseAbove, AgreesWithBisectionFromAnyGuess) {
  for (double n : {0.2, 0.5, 0.8, 1.0, 1.5, 2.0, 5.0})
    for (int i = 0; i < 5000; ++i) {
      const auto power_of_ten = [&](int what, double low, double high) {
        return std::pow(10.0, low + (high - low) * random_uniform(1, std::uint64_t(what), i));
      };
      const double c = power_of_ten(1, -12, -1), per_dt = power_of_ten(2, -9, -1);
      const double g = power_of_ten(3, -8, -2);
      double low = 0.0, high = c / per_dt;
      for (int b = 0; b < 400; ++b) {
        const double middle = 0.5 * (low + high);
        (per_dt * middle + g * std::pow(middle, n) > c ? high : low) = middle;
      }
      // Far off, near, and so near that what is left is rounding.
      const double spread = power_of_ten(4, -7, 1);
      const double near = low * std::pow(10.0, spread * (random_uniform(1, 5, i) - 0.5));
      for (double guess : {-1.0, 0.0, near, 2.0 * c / per_dt})
        ASSERT_NEAR(rise_above(c, per_dt, g, n, guess), low, 1e-9 * low)
            << "n " << n << ", c " << c << ", per_dt " << per_dt << ", g " << g << ", " << guess;
    }
}

TEST(RiseAbove, WithoutIncisionOrTime) {
  EXPECT_DOUBLE_EQ(rise_above(1e-3, 1e-4, 0.0, 1.5, 0.0), 10.0);
  EXPECT_NEAR(rise_above(1e-3, 0.0, 1e-5, 2.0, 0.0), 10.0, 1e-8);
  EXPECT_NEAR(rise_above(1e-3, 0.0, 1e-5, 2.0, 9.99), 10.0, 1e-8);
}

}  // namespace
}  // namespace orogen
