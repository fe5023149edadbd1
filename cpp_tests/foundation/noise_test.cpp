#include "foundation/noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/parallel.h"
#include "foundation/random.h"

namespace orogen {
namespace {

TEST(Noise, SamePlaceGivesSameValueOnAnyGrid) {
  const FbmParameters p{.seed = 7, .wavelength = 5000.0, .octaves = 6};
  Context context;
  const Grid coarse{20, 15, 300.0, {1000.0, -2000.0}};
  const Grid fine{60, 45, 100.0, {1000.0, -2000.0}};
  const auto a = fbm(p, coarse, context), b = fbm(p, fine, context);
  for (int r = 0; r < coarse.ny; ++r)
    for (int c = 0; c < coarse.nx; ++c) {
      EXPECT_NEAR(a(r, c), b(3 * r + 1, 3 * c + 1), 1e-5f);
      EXPECT_EQ(a(r, c), fbm(p, coarse.center(r, c).x, coarse.center(r, c).y));
    }
}

TEST(Noise, HasUnitVarianceAndNoMean) {
  Context context;
  for (std::uint32_t seed = 0; seed < 5; ++seed)
    for (int octaves : {1, 4, 8}) {
      const Grid grid{700, 700, 613.0, {0.0, 0.0}};
      const auto z = fbm({.seed = seed, .wavelength = 2000.0, .octaves = octaves}, grid, context);
      const double mean = parallel_sum(context, z.size(), [&](auto i) { return z[i]; }) / z.size();
      const double square =
          parallel_sum(context, z.size(), [&](auto i) { return double(z[i]) * z[i]; }) / z.size();
      EXPECT_NEAR(mean, 0.0, 0.02);
      EXPECT_NEAR(square, 1.0, 0.03);
    }
}

TEST(Noise, IsContinuousAndLooksTheSameInEveryDirection) {
  const FbmParameters p{.seed = 3, .wavelength = 1000.0, .octaves = 8};
  double along[4] = {};
  for (int i = 0; i < 20000; ++i) {
    const double x = 1e6 * random_uniform(1, 0, i), y = 1e6 * random_uniform(1, 1, i);
    EXPECT_NEAR(fbm(p, x, y), fbm(p, x + 1e-3, y), 1e-3);
    for (int k = 0; k < 4; ++k) {
      const double angle = k * std::numbers::pi / 4.0;
      const double d = fbm(p, x, y) - fbm(p, x + 400 * std::cos(angle), y + 400 * std::sin(angle));
      along[k] += d * d;
    }
  }
  for (double variance : along) EXPECT_NEAR(variance / along[0], 1.0, 0.05);
}

TEST(Noise, RefusesNonsense) {
  EXPECT_THROW(fbm({.wavelength = 0.0}, 0, 0), std::invalid_argument);
  EXPECT_THROW(fbm({.octaves = 0}, 0, 0), std::invalid_argument);
}

TEST(Random, IsUniformAndNormalAndDependsOnEveryKey) {
  double mean = 0, square = 0, normal = 0, normal_square = 0;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double u = random_uniform(42, 1, i), g = random_normal(42, 2, i);
    ASSERT_TRUE(u >= 0 && u < 1 && std::isfinite(g));
    mean += u, square += u * u, normal += g, normal_square += g * g;
  }
  EXPECT_NEAR(mean / n, 0.5, 0.003);
  EXPECT_NEAR(square / n, 1.0 / 3.0, 0.003);
  EXPECT_NEAR(normal / n, 0.0, 0.01);
  EXPECT_NEAR(normal_square / n, 1.0, 0.015);
  EXPECT_NE(random_bits(1, 2, 3), random_bits(2, 2, 3));
  EXPECT_NE(random_bits(1, 2, 3), random_bits(1, 3, 3));
  EXPECT_NE(random_bits(1, 2, 3), random_bits(1, 2, 4));
}

}  // namespace
}  // namespace orogen
