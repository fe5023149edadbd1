#include "climate/climate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "climate/seasons.h"
#include "foundation/noise.h"

namespace orogen {
namespace {

const Grid kGrid{60, 50, 2000.0};

/// A ridge from south to north, of 4000 m, with the sea on both sides.
Raster<float> ridge() {
  const Grid& grid = kGrid;
  Raster<float> ground(grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      const double x = (grid.center(r, c).x - 60e3) / 20e3;
      ground(r, c) = float(4200.0 * std::exp(-x * x) - 200.0);
    }
  return ground;
}

Climate of(const Raster<float>& ground, const ClimateParameters& parameters = {},
           const OrographicRainParameters& rain = {}) {
  return make_climate({ground}, parameters, rain, Context());
}

TEST(Climate, FallsByTheLapseRateFromTheSea) {
  const Raster<float> ground = ridge();
  const Climate made = of(ground, {.sea_level_temperature = 20.0, .lapse_rate = 5.0});
  for (std::size_t i = 0; i < ground.size(); ++i) {
    ASSERT_NEAR(made.air_temperature[i], 20.0 - 0.005 * std::max(ground[i], 0.0f), 1e-4);
    ASSERT_FLOAT_EQ(made.temperature[i], float(warmth(made.air_temperature[i])));
    ASSERT_NEAR(made.biotemperature[i], biotemperature(made.air_temperature[i], 8.0), 1e-4);
  }
}

TEST(Climate, IsWetterWhereTheWindComesFrom) {
  const Climate west = of(ridge()), east = of(ridge(), {}, {.wind_from_deg = 90.0});
  const int before = 23, behind = 36;  // columns on either side of the crest
  EXPECT_GT(west.rainfall(25, before), 1.5f * west.rainfall(25, behind));
  EXPECT_GT(east.rainfall(25, behind), 1.5f * east.rainfall(25, before));
  EXPECT_GT(west.moisture(25, before), west.moisture(25, behind));
}

TEST(Climate, RainIsTheMeanOfItsWinds) {
  const Raster<float> ground = ridge();
  Raster<float> sum(kGrid);
  for (const double from : {200.0, 290.0, 20.0, 110.0}) {
    const Raster<float> rain = orographic_rain(ground, {.wind_from_deg = from}, Context());
    const float share = from == 200.0 ? 0.7f : 0.1f;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * rain[i];
  }
  const Climate made = of(ground, {.wind_steadiness = 0.7}, {.wind_from_deg = 200.0});
  for (std::size_t i = 0; i < sum.size(); ++i) ASSERT_NEAR(made.rainfall[i], sum[i], 1e-4);
  EXPECT_EQ(of(ground, {.wind_steadiness = 1.0}).rainfall, orographic_rain(ground, {}, Context()));
}

TEST(Climate, SnowOutlastsSummerAboveTheSnowLine) {
  const Climate made = of(ridge(), {}, {.background_rain = 1.0, .uplift_sensitivity = 0.0});
  double low = -60.0, high = 40.0;  // the mean at which as much falls as melts, by halving
  for (int i = 0; i < 100; ++i) {
    const double mean = 0.5 * (low + high);
    const double frost = 1.0 - std::acos(std::clamp(-mean / 8.0, -1.0, 1.0)) / M_PI;
    const double melts = 4.5e-3 * 365.25 * mean_above(0.0, mean, 8.0);
    (frost >= melts ? low : high) = mean;
  }
  const double line = (15.0 - low) / 6.5 * 1000.0;
  EXPECT_GT(line, 2400.0);
  EXPECT_LT(line, 3600.0);  // as in the Alps
  const Raster<float> ground = ridge();
  for (std::size_t i = 0; i < ground.size(); ++i)
    if (std::fabs(ground[i] - line) > 1.0) {
      ASSERT_EQ(made.snow_cover[i] == 1.0f, ground[i] > line) << ground[i];
    }
}

TEST(Climate, WaterMoistensItsBanks) {
  const Raster<float> ground = ridge();
  Raster<float> lakes(kGrid), drainage(kGrid, 1e6f);
  lakes(25, 20) = 30.0f;
  drainage(10, 40) = 30e6f;
  const Climate plain = of(ground);
  const Climate wet = make_climate({ground, &lakes, &drainage}, {}, {}, Context());
  EXPECT_EQ(wet.moisture(25, 20), 1.0f);
  EXPECT_EQ(wet.moisture(10, 40), 1.0f);
  const double m = plain.moisture(25, 22);
  EXPECT_NEAR(wet.moisture(25, 22), m + (1.0 - m) * std::exp(-4000.0 / 400.0), 1e-5);
  EXPECT_EQ(wet.moisture(49, 0), plain.moisture(49, 0));
  EXPECT_EQ(wet.rainfall, plain.rainfall);
}

TEST(Climate, ChangesByHandReachDegreesAndRain) {
  const Raster<float> ground = ridge();
  const Climate plain = of(ground);
  Raster<float> warmer(kGrid, 0.1f), wetter(kGrid, -0.2f);
  wetter(3, 3) = 0.0f;
  const Climate made = make_climate({ground, nullptr, nullptr, warmer, wetter}, {}, {}, Context());
  for (std::size_t i = 0; i < ground.size(); ++i) {
    ASSERT_NEAR(made.air_temperature[i], plain.air_temperature[i] + 5.0, 1e-4);
    ASSERT_NEAR(wetness(made.rainfall[i], evapotranspiration(made.biotemperature[i])),
                made.moisture[i], 1e-5);
  }
  EXPECT_EQ(made.rainfall(3, 3), plain.rainfall(3, 3));
  EXPECT_LT(made.rainfall(4, 4), plain.rainfall(4, 4));
}

TEST(Climate, IsWithinItsRangesOnAnyGround) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Grid grid{1 + int(seed % 17), 1 + int(seed % 13), 300.0};
    Raster<float> ground = fbm({.seed = seed, .wavelength = 3000.0}, grid, Context());
    for (float& z : ground.values()) z *= 3000.0f;
    const ClimateParameters parameters{.sea_level_temperature = -40.0 + 0.8 * seed,
                                       .seasonal_swing = double(seed % 41)};
    const Climate made = of(ground, parameters,
                            {.wind_speed = 2.0, .conversion_time = 200.0, .fallout_time = 100.0});
    for (std::size_t i = 0; i < ground.size(); ++i) {
      for (const auto* share : {&made.snow_cover, &made.temperature, &made.moisture}) {
        ASSERT_GE((*share)[i], 0.0f);
        ASSERT_LE((*share)[i], 1.0f);
      }
      ASSERT_GE(made.biotemperature[i], -1e-6f);
      ASSERT_LE(made.biotemperature[i], 30.0001f);
      ASSERT_GE(made.rainfall[i], 0.0f);
    }
  }
}

}  // namespace
}  // namespace orogen
