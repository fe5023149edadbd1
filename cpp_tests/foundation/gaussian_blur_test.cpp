#include "foundation/gaussian_blur.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

Raster<float> random_field(const Grid& grid, std::uint64_t seed) {
  Raster<float> field(grid);
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = float(random_uniform(seed, 1, i));
  return field;
}

// The kernel summed as it stands, in double, along one axis and then the other.
std::vector<double> direct_blur(const Raster<float>& field, double sigma_cells) {
  const Grid& g = field.grid();
  const int radius = int(std::ceil(8.0 * sigma_cells));
  std::vector<double> w(radius + 1), x(field.values().begin(), field.values().end()), y(x.size());
  double sum = 0.0;
  for (int d = -radius; d <= radius; ++d) {
    w[std::abs(d)] = std::exp(-0.5 * d * d / (sigma_cells * sigma_cells));
    sum += w[std::abs(d)];
  }
  for (int axis = 0; axis < 2; ++axis) {
    for (int r = 0; r < g.ny; ++r)
      for (int c = 0; c < g.nx; ++c) {
        double s = 0.0;
        for (int d = -radius; d <= radius; ++d) {
          const int rr = axis ? std::clamp(r + d, 0, g.ny - 1) : r;
          const int cc = axis ? c : std::clamp(c + d, 0, g.nx - 1);
          s += w[std::abs(d)] * x[g.index(rr, cc)];
        }
        y[g.index(r, c)] = s / sum;
      }
    std::swap(x, y);
  }
  return x;
}

TEST(GaussianBlur, AgreesWithTheKernelSummedDirectly) {
  const Context context;
  const std::pair<int, int> sizes[] = {{1, 1}, {1, 37}, {53, 1}, {16, 17}, {61, 97}};
  for (auto [nx, ny] : sizes)
    for (double sigma : {0.4, 1.0, 2.9, 3.1, 5.0, 12.0, 40.0}) {
      const Grid grid{nx, ny, 250.0, {0.0, 0.0}};
      Raster<float> field = random_field(grid, 7 + nx);
      for (int r = 0; r < ny / 2; ++r)
        for (int c = 0; c < nx; ++c) field(r, c) += 10.0f;  // a step, as between plates
      const auto expected = direct_blur(field, sigma);
      const auto blurred = gaussian_blur(field, sigma * grid.cell_size, context);
      double worst = 0.0;
      for (std::size_t i = 0; i < field.size(); ++i)
        worst = std::max(worst, std::fabs(blurred[i] - expected[i]));
      EXPECT_LT(worst, 11.0 * 1e-4) << nx << "x" << ny << " sigma " << sigma;
    }
}

TEST(GaussianBlur, KeepsConstantsAndSmallWidthsGiveTheFieldBack) {
  const Context context;
  const Grid grid{90, 70, 100.0, {0.0, 0.0}};
  for (double sigma : {50.0, 300.0, 2000.0, 1e5}) {
    const auto blurred = gaussian_blur(Raster<float>(grid, 3.0f), sigma, context);
    for (float v : blurred.values()) ASSERT_NEAR(v, 3.0f, 3e-4f) << sigma;
  }
  const auto field = random_field(grid, 3);
  EXPECT_EQ(gaussian_blur(field, 0.0, context), field);
  EXPECT_TRUE(gaussian_blur(Raster<float>(), 100.0, context).empty());
}

TEST(GaussianBlur, IsStableAtHundredsOfCells) {
  const Context context;
  const Grid grid{1500, 3, 10.0, {0.0, 0.0}};
  Raster<float> field(grid);
  for (int r = 0; r < 3; ++r)
    for (int c = 750; c < 1500; ++c) field(r, c) = 1.0f;
  const auto blurred = gaussian_blur(field, 2000.0, context);
  for (int c = 0; c < 1500; ++c) {
    const double x = (c + 0.5 - 750.0) / 200.0;
    ASSERT_NEAR(blurred(1, c), 0.5 * std::erfc(-x / std::sqrt(2.0)), 2e-3) << c;
  }
}

TEST(GaussianBlur, IsTheSameForAnyNumberOfThreads) {
  const auto field = random_field({211, 157, 30.0, {0.0, 0.0}}, 5);
  for (double sigma : {45.0, 600.0}) {
    Raster<float> first;
    for (int threads : {1, 2, 4}) {
      Context context({}, threads);
      context.run([&] {
        const auto blurred = gaussian_blur(field, sigma, context);
        if (first.empty()) first = blurred;
        EXPECT_EQ(blurred, first);
      });
    }
  }
}

TEST(GaussianBlur, RefusesWidthsThatAreNone) {
  const Context context;
  const Raster<float> field({3, 3, 1.0, {0.0, 0.0}});
  EXPECT_THROW(gaussian_blur(field, -1.0, context), InputError);
  EXPECT_THROW(gaussian_blur(field, std::nan(""), context), InputError);
  EXPECT_THROW(gaussian_blur(field, std::numeric_limits<double>::infinity(), context), InputError);
}

}  // namespace
}  // namespace orogen
