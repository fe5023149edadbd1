#include "climate/seasons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/random.h"

namespace orogen {
namespace {

constexpr int kSteps = 20000;  // of a year

double of_year(double mean, double swing, auto&& value) {
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i)
    sum += value(mean + swing * std::cos(2.0 * M_PI * (i + 0.5) / kSteps));
  return sum / kSteps;
}

double uniform(std::uint64_t stream, std::uint64_t i, double low, double high) {
  return low + (high - low) * random_uniform(7, stream, i);
}

TEST(Seasons, AreThoseOfAYearDayByDay) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const double mean = uniform(0, i, -30.0, 40.0), swing = i % 9 ? uniform(1, i, 0.0, 30.0) : 0.0;
    const double rain = uniform(2, i, 0.0, 4.0), melt = uniform(3, i, 0.1, 3.0);
    EXPECT_NEAR(mean_above(3.0, mean, swing),
                of_year(mean, swing, [](double t) { return std::max(t - 3.0, 0.0); }), 1e-3);
    EXPECT_NEAR(biotemperature(mean, swing),
                of_year(mean, swing, [](double t) { return std::clamp(t, 0.0, 30.0); }), 1e-3);
    const double frost = of_year(mean, swing, [](double t) { return t <= 0.0; });
    const double melted = melt * mean_above(0.0, mean, swing);
    const double lies = melted > 0.0 ? std::min(1.0, rain * frost / melted) : 1.0;
    EXPECT_NEAR(snow_cover(mean, swing, rain, melt), frost + (1.0 - frost) * lies, 2e-3) << i;
  }
}

TEST(Seasons, SnowGrowsWithColdAndRain) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const double mean = uniform(0, i, -15.0, 15.0), swing = uniform(1, i, 0.0, 20.0);
    const double rain = uniform(2, i, 0.0, 3.0), cover = snow_cover(mean, swing, rain, 1.6);
    EXPECT_GE(snow_cover(mean - 1.0, swing, rain, 1.6), cover);
    EXPECT_GE(snow_cover(mean, swing, rain + 0.1, 1.6), cover);
    EXPECT_GE(cover, 0.0);
    EXPECT_LE(cover, 1.0);
  }
  EXPECT_EQ(snow_cover(-30.0, 5.0, 0.0, 1.6), 0.0);
  EXPECT_EQ(snow_cover(-30.0, 5.0, 0.1, 1.6), 1.0);
  EXPECT_EQ(snow_cover(20.0, 5.0, 3.0, 1.6), 0.0);
}

TEST(Seasons, WarmthHasTheLimitsOfBelts) {
  EXPECT_NEAR(warmth(-5.0), 0.2, 1e-12);
  EXPECT_NEAR(warmth(5.0), 0.4, 1e-12);
  EXPECT_NEAR(warmth(20.0), 0.7, 1e-12);
  EXPECT_EQ(warmth(-40.0), 0.0);
  EXPECT_EQ(warmth(50.0), 1.0);
}

TEST(Seasons, WetnessIsHalfWhereRainIsWhatCouldBeGivenOff) {
  for (const double b : {5.0, 15.0, 25.0}) {
    const double e = evapotranspiration(b);
    EXPECT_NEAR(e, 0.05893 * b, 1e-12);
    EXPECT_NEAR(wetness(e, e), 0.5, 1e-12);
    for (const double rain : {0.0, 0.1, 1.0, 6.0})
      EXPECT_NEAR(rain_of_wetness(wetness(rain, e), e), rain, 1e-9);
  }
  EXPECT_EQ(wetness(0.0, 0.0), 0.0);
}

}  // namespace
}  // namespace orogen
