#include "inputs/given_raster.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orogen {
namespace {

GivenRaster ramp(int rows, int columns) {
  GivenRaster given{rows, columns, {}};
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      given.values.push_back(float(100.0 * (r + 0.5) / rows + 10.0 * (c + 0.5) / columns));
  return given;
}

TEST(GivenRaster, IsItselfOnAGridOfItsShape) {
  const GivenRaster given = ramp(7, 11);
  const Raster<float> raster = on_grid(given, {11, 7, 30.0, {5.0, 6.0}}, Context());
  for (std::size_t i = 0; i < raster.size(); ++i) EXPECT_FLOAT_EQ(raster[i], given.values[i]);
}

TEST(GivenRaster, KeepsARampAtAnyResolution) {
  for (const int n : {5, 16, 40, 200}) {
    const Raster<float> raster = on_grid(ramp(40, 40), {n, n, 100.0 / n}, Context());
    const int edge = n / 40 + 1;  // there values are held
    for (int r = edge; r < n - edge; ++r)
      for (int c = edge; c < n - edge; ++c)
        ASSERT_NEAR(raster(r, c), 100.0 * (r + 0.5) / n + 10.0 * (c + 0.5) / n, 1e-4) << n;
  }
}

TEST(GivenRaster, ACoarseCellIsTheMeanOfWhatItCovers) {
  GivenRaster given{4, 4, std::vector<float>(16, 0.0f)};
  for (const int i : {0, 1, 4, 5}) given.values[i] = 8.0f;
  const Raster<float> raster = on_grid(given, {2, 2, 1.0}, Context());
  EXPECT_FLOAT_EQ(raster[0], 8.0f);
  EXPECT_FLOAT_EQ(raster[3], 0.0f);
}

}  // namespace
}  // namespace orogen
