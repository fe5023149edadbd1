#include "erosion/river_erosion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "foundation/noise.h"

namespace orogen {
namespace {

const Grid kGrid{80, 60, 100.0, {0.0, 0.0}};

struct Ground {
  Raster<float> elevation{kGrid}, uplift_rate{kGrid}, erodibility{kGrid, 1e-6f};
  Raster<std::int32_t> land{kGrid, 1};

  Ground() {
    Context context;
    elevation = fbm({.seed = 3, .wavelength = 3000.0, .octaves = 6}, kGrid, context);
    for (int r = 0; r < kGrid.ny; ++r)
      for (int c = 0; c < kGrid.nx; ++c) {
        elevation(r, c) = c < 10 ? -50.0f : 20.0f * c + 60.0f * (elevation(r, c) + 3.0f);
        land(r, c) = c >= 10;
      }
  }
  RiverErosion erode(const RiverErosionParameters& parameters) const {
    Context context;
    return erode_by_rivers(elevation, land, uplift_rate, erodibility, parameters, context);
  }
};

TEST(RiverErosion, WearsLandAndLeavesSeaAndSidesAlone) {
  const Ground ground;
  const RiverErosion made = ground.erode({});
  double worn = 0.0;
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c) {
      const bool base = c < 10 || r == 0 || r == kGrid.ny - 1 || c == kGrid.nx - 1;
      if (base) {
        EXPECT_EQ(made.elevation(r, c), ground.elevation(r, c));
      } else {
        worn += ground.elevation(r, c) - made.elevation(r, c);
      }
    }
  EXPECT_GT(worn, 0.0);
}

TEST(RiverErosion, MoreTimeWearsMore) {
  const Ground ground;
  double last = 1e30;
  for (const double years : {0.0, 1e5, 1e6}) {
    double sum = 0.0;
    const RiverErosion made = ground.erode({.years = years, .creep_length = 0.0});
    for (const float z : made.elevation.values()) sum += z;
    EXPECT_LT(sum, last);
    last = sum;
  }
}

TEST(RiverErosion, WithoutTimeAndCreepNothingMoves) {
  const Ground ground;
  EXPECT_EQ(ground.erode({.years = 0.0, .talus_angle_deg = 80.0, .creep_length = 0.0}).elevation,
            ground.elevation);
}

TEST(RiverErosion, NothingIsSteeperThanTalus) {
  Ground ground;
  for (float& rate : ground.uplift_rate.values()) rate = 0.05f;
  const RiverErosion made =
      ground.erode({.years = 1e6, .talus_angle_deg = 30.0, .creep_length = 0.0});
  const double steepest = std::tan(30.0 * M_PI / 180.0) * 100.0 * std::sqrt(2.0);
  for (int r = 1; r + 1 < kGrid.ny; ++r)
    for (int c = 11; c + 1 < kGrid.nx; ++c) {
      float lowest = 1e30f;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) lowest = std::min(lowest, made.elevation(r + j, c + i));
      EXPECT_LE(made.elevation(r, c) - lowest, steepest * 1.01);
    }
}

TEST(RiverErosion, TheSameBytesForAnyNumberOfThreads) {
  const Ground ground;
  Raster<float> one, two;
  Context single({}, 1), pair({}, 2);
  single.run([&] {
    one = erode_by_rivers(ground.elevation, ground.land, ground.uplift_rate, ground.erodibility, {},
                          single)
              .elevation;
  });
  pair.run([&] {
    two = erode_by_rivers(ground.elevation, ground.land, ground.uplift_rate, ground.erodibility, {},
                          pair)
              .elevation;
  });
  EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace orogen
