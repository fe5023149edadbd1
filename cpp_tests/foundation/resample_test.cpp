#include "foundation/resample.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

Raster<float> plane(const Grid& g, double a, double b) {
  Raster<float> z(g);
  for (int r = 0; r < g.ny; ++r)
    for (int c = 0; c < g.nx; ++c)
      z(r, c) = float(a * g.center(r, c).x + b * g.center(r, c).y + 7.0);
  return z;
}

const Grid kSource{37, 29, 100.0, {500.0, -300.0}};

TEST(Resample, APlaneStaysWhereItIsAtAnyRatio) {
  const Context context;
  const Raster<float> z = plane(kSource, 0.3, -0.2);
  for (double cell : {17.0, 50.0, 100.0, 130.0, 410.0}) {
    const Grid target{int(2000 / cell), int(1500 / cell), cell, {900.0, 100.0}};
    const Raster<float> expected = plane(target, 0.3, -0.2);
    const Raster<float> linear = resample_bilinear(z, target, context);
    const Raster<float> cubic = resample_bicubic(z, target, context);
    const Raster<float> mean = resample_mean(z, target, context);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_NEAR(linear[i], expected[i], 0.01);
      ASSERT_NEAR(cubic[i], expected[i], 0.01);
      // The source is a stair of cells: their mean may be off by half a step.
      ASSERT_NEAR(mean[i], expected[i], 0.5 * (0.3 + 0.2) * 100.0 + 0.01);
    }
  }
}

TEST(Resample, BicubicFollowsASmoothFieldCloserThanBilinear) {
  const Context context;
  const auto wave = [](const Grid& g) {
    Raster<float> z(g);
    for (int r = 0; r < g.ny; ++r)
      for (int c = 0; c < g.nx; ++c)
        z(r, c) = float(std::sin(g.center(r, c).x / 200.0) * std::cos(g.center(r, c).y / 250.0));
    return z;
  };
  const Grid target{100, 80, 20.0, {1000.0, 200.0}};
  const Raster<float> coarse = wave(kSource), fine = wave(target);
  const Raster<float> linear = resample_bilinear(coarse, target, context);
  const Raster<float> cubic = resample_bicubic(coarse, target, context);
  double worst_linear = 0.0, worst_cubic = 0.0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    worst_linear = std::max(worst_linear, double(std::fabs(linear[i] - fine[i])));
    worst_cubic = std::max(worst_cubic, double(std::fabs(cubic[i] - fine[i])));
  }
  EXPECT_LT(worst_cubic, 0.3 * worst_linear);
}

TEST(Resample, MeanKeepsTheVolume) {
  const Context context;
  for (int t = 0; t < 100; ++t) {
    SCOPED_TRACE(t);
    const Grid source{
        1 + int(random_bits(t, 1, 1) % 60), 1 + int(random_bits(t, 1, 2) % 60), 10.0, {}};
    Raster<float> z(source);
    double volume = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i)
      volume += z[i] = float(1000.0 * random_uniform(t, 2, i));
    // A target that covers the source whole, in cells of any size that divide neither side.
    const int k = 1 + int(random_bits(t, 1, 3) % 7);
    const Grid target{(source.nx + k - 1) / k, (source.ny + k - 1) / k, 10.0 * k, {}};
    const Raster<float> mean = resample_mean(z, target, context);
    double sum = 0.0;
    for (int r = 0; r < target.ny; ++r)
      for (int c = 0; c < target.nx; ++c)
        sum += double(mean(r, c)) * std::min(k, source.nx - c * k) * std::min(k, source.ny - r * k);
    EXPECT_NEAR(sum, volume, 1e-6 * volume);
  }
}

TEST(Resample, BeyondTheSourceItsEdgeGoesOn) {
  const Context context;
  Raster<float> z(Grid{2, 2, 1.0, {}});
  z(0, 0) = 1, z(0, 1) = 2, z(1, 0) = 3, z(1, 1) = 4;
  const Grid target{6, 6, 1.0, {-2.0, -2.0}};
  Raster<std::uint8_t> mask(z.grid());
  mask(1, 1) = 9;
  for (const auto& far :
       {resample_bilinear(z, target, context), resample_bicubic(z, target, context),
        resample_mean(z, target, context)}) {
    EXPECT_EQ(far(0, 0), 1.0f);
    EXPECT_EQ(far(0, 5), 2.0f);
    EXPECT_EQ(far(5, 0), 3.0f);
    EXPECT_EQ(far(5, 5), 4.0f);
    EXPECT_EQ(far(2, 3), 2.0f);
  }
  const Raster<std::uint8_t> near = resample_nearest(mask, target, context);
  EXPECT_EQ(near(5, 5), 9);
  EXPECT_EQ(near(2, 2), 0);
}

TEST(Resample, SameGridIsACopyAndAnEmptySourceIsRefused) {
  const Context context;
  const Raster<float> z = plane(kSource, 1.0, 1.0);
  EXPECT_EQ(resample_bicubic(z, kSource, context), z);
  EXPECT_THROW(resample_bilinear(Raster<float>(), kSource, context), InputError);
  EXPECT_THROW(resample_mean(z, Grid{3, 3, 0.0, {}}, context), InputError);
}

}  // namespace
}  // namespace orogen
