#include "island/coast_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/noise.h"

namespace orogen {
namespace {

TEST(CoastFit, PutsTheCoastWhereItIsDrawn) {
  const Grid grid{200, 150, 100.0, {0.0, 0.0}};
  Raster<float> elevation = fbm({.seed = 1, .wavelength = 5000.0}, grid, Context());
  for (float& h : elevation.values()) h *= 300.0f;
  Raster<std::uint8_t> land(grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) land(r, c) = std::hypot(c - 100.0, r - 75.0) < 60.0;
  const Raster<float> before = elevation;
  fit_coast(elevation, land, 1500.0, 0.01, Context());
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      const double inland = 100.0 * (60.0 - std::hypot(c - 100.0, r - 75.0));
      const float h = elevation(r, c);
      ASSERT_EQ(h > 0.0f, land(r, c) != 0) << r << ' ' << c;
      ASSERT_GE(std::fabs(h), 0.01 * (std::fabs(inland) - 150.0));
      if (std::fabs(inland) < 100.0) ASSERT_LT(std::fabs(h), 30.0f);
      if (inland > 1700.0) ASSERT_EQ(h, std::max(before(r, c), h));
      if (inland > 1700.0 && before(r, c) > 100.0f) ASSERT_EQ(h, before(r, c));
    }
}

TEST(CoastFit, LeavesGroundWithoutACoastAlone) {
  const Grid grid{20, 20, 100.0, {0.0, 0.0}};
  Raster<float> elevation(grid, 50.0f);
  fit_coast(elevation, Raster<std::uint8_t>(grid, 1), 500.0, 0.0, Context());
  for (const float h : elevation.values()) EXPECT_EQ(h, 50.0f);
}

}  // namespace
}  // namespace orogen
