#include "sculpting/kept_region.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "foundation/noise.h"

namespace orogen {
namespace {

const Grid kGrid{60, 50, 100.0, {0.0, 0.0}};

Raster<float> ground(std::uint32_t seed) {
  Context context;
  Raster<float> z = fbm({.seed = seed, .wavelength = 2000.0, .octaves = 4}, kGrid, context);
  for (float& height : z.values()) height = 500.0f + 300.0f * height;
  return z;
}

Raster<float> disc() {
  Raster<float> kept(kGrid);
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c) kept(r, c) = std::hypot(r - 25, c - 30) < 8.0 ? 1.0f : 0.0f;
  return kept;
}

TEST(KeptRegion, StaysToTheBitAndTheRestIsNew) {
  const Raster<float> fresh = ground(1), old = ground(2), kept = disc();
  Raster<float> z = fresh;
  keep_region(z, kept, old, {.margin = 600.0}, Context());
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c) {
      if (kept(r, c) == 1.0f) {
        EXPECT_EQ(z(r, c), old(r, c));
      } else if (std::hypot(r - 25, c - 30) > 15.0) {
        EXPECT_EQ(z(r, c), fresh(r, c));
      }
      EXPECT_LE(z(r, c), std::max(old(r, c), fresh(r, c)) + 1e-3f);
      EXPECT_GE(z(r, c), std::min(old(r, c), fresh(r, c)) - 1e-3f);
    }
}

TEST(KeptRegion, HasNoStepAtItsBorder) {
  Raster<float> z(kGrid, 0.0f);
  keep_region(z, disc(), Raster<float>(kGrid, 100.0f), {.margin = 1000.0}, Context());
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 1; c < kGrid.nx; ++c)  // the steepest part of a smoothstep: 1.5 over its width
      EXPECT_LE(std::abs(z(r, c) - z(r, c - 1)), 1.5f * 100.0f * 100.0f / 1000.0f * 1.01f);
}

TEST(KeptRegion, WithoutARegionNothingChanges) {
  const Raster<float> fresh = ground(1);
  Raster<float> z = fresh;
  keep_region(z, Raster<float>(kGrid), ground(2), {}, Context());
  EXPECT_EQ(z, fresh);
}

}  // namespace
}  // namespace orogen
