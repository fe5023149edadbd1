#include "climate/orographic_rain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "foundation/units.h"

namespace orogen {
namespace {

const Grid kGrid{500, 500, 800.0, {-200e3, -200e3}};
constexpr double kHeight = 1000.0, kWidth = 15e3;  // of the ridge: h = kHeight exp(-(x / kWidth)²)

/// The ridge stands across the direction `angle` (radians from east).
Raster<float> ridge(double angle = 0.0) {
  Raster<float> ground(kGrid);
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c) {
      const glm::dvec2 p = kGrid.center(r, c);
      const double x = (p.x * std::cos(angle) + p.y * std::sin(angle)) / kWidth;
      ground(r, c) = float(kHeight * std::exp(-x * x));
    }
  return ground;
}

/// The model's solution for an endless ridge, by quadrature over wavenumbers, in m/yr.
double analytic(double x, const OrographicRainParameters& p) {
  using Complex = std::complex<double>;
  const Complex i(0.0, 1.0);
  const double dk = 2e-3 / kWidth;
  double sum = 0.0;
  for (int n = 0; n < 8000; ++n) {
    const double k = (n + 0.5) * dk, s = p.wind_speed * k;
    const double wave =
        kHeight * kWidth * std::sqrt(M_PI) * std::exp(-0.25 * k * k * kWidth * kWidth);
    const double stable = p.moist_stability;
    const Complex m = stable > s ? Complex(std::sqrt(stable * stable - s * s) / s * k)
                                 : Complex(0.0, std::sqrt(s * s - stable * stable) / s * k);
    const Complex rain = p.uplift_sensitivity * i * s * wave /
                         ((1.0 - i * m * p.moist_layer) * (1.0 + i * s * p.conversion_time) *
                          (1.0 + i * s * p.fallout_time));
    sum += (rain * std::exp(i * k * x)).real() * dk / M_PI;
  }
  return std::max(0.0, p.background_rain + p.storm_share * kSecondsPerYear / 1000.0 * sum);
}

void expect_solution(const OrographicRainParameters& parameters) {
  const Raster<float> rain = orographic_rain(ridge(), parameters, Context());
  double most = 0.0;
  for (int c = 0; c < kGrid.nx; ++c)
    most = std::max(most, analytic(kGrid.center(0, c).x, parameters));
  for (int c = 100; c < 400; c += 3)
    ASSERT_NEAR(rain(250, c), analytic(kGrid.center(0, c).x, parameters), 0.02 * most) << c;
  EXPECT_GT(most, 1.3 * parameters.background_rain);
}

TEST(OrographicRain, IsTheLinearSolutionForAGaussianRidge) {
  expect_solution({});
  expect_solution({.moist_layer = 0.0, .conversion_time = 0.0, .fallout_time = 0.0});
  expect_solution({.wind_speed = 20.0, .moist_stability = 0.0});
  expect_solution({.wind_speed = 6.0, .background_rain = 0.3, .moist_stability = 0.01});
}

TEST(OrographicRain, WithoutDelaysFollowsTheSlope) {
  const OrographicRainParameters plain{
      .background_rain = 12.0, .moist_layer = 0.0, .conversion_time = 0.0, .fallout_time = 0.0};
  const Raster<float> ground = ridge(), rain = orographic_rain(ground, plain, Context());
  const double scale = 12.0 * 0.005 * 0.05 * kSecondsPerYear / 1000.0;  // m/yr a slope of 1
  for (int c = 150; c < 350; ++c) {
    const double slope = (ground(250, c + 1) - ground(250, c - 1)) / 1600.0;
    ASSERT_NEAR(rain(250, c), 12.0 + scale * slope, 0.01 * scale * 0.06);
  }
}

TEST(OrographicRain, TurnsWithTheWind) {
  const auto wettest = [](double from, double angle) {
    const Raster<float> rain = orographic_rain(ridge(angle), {.wind_from_deg = from}, Context());
    glm::dvec2 place(0.0, 0.0);
    float most = 0.0f;
    for (int r = 150; r < 350; ++r)
      for (int c = 150; c < 350; ++c)
        if (rain(r, c) > most) {
          most = rain(r, c);
          place = kGrid.center(r, c);
        }
    return std::cos(angle) * place.x + std::sin(angle) * place.y;
  };
  const double west = wettest(270.0, 0.0);
  EXPECT_LT(west, 0.0);  // before the crest
  EXPECT_NEAR(wettest(90.0, 0.0), -west, 1700.0);
  EXPECT_NEAR(wettest(180.0, M_PI / 2), west, 1700.0);
  EXPECT_NEAR(wettest(0.0, M_PI / 2), -west, 1700.0);
  EXPECT_NEAR(wettest(225.0, M_PI / 4), west, 1700.0);
}

TEST(OrographicRain, RainsEvenlyOnFlatGroundAndAtSea) {
  const Grid grid{60, 40, 500.0};
  for (const float height : {0.0f, -800.0f}) {
    const Raster<float> rain = orographic_rain(Raster<float>(grid, height), {}, Context());
    for (const float v : rain.values()) ASSERT_NEAR(v, 0.8f, 1e-6f);
  }
  const Raster<float> shadow = orographic_rain(ridge(), {.background_rain = 0.0}, Context());
  EXPECT_GE(*std::ranges::min_element(shadow.values()), 0.0f);
}

TEST(OrographicRain, IsTheSameOnAFinerGrid) {
  const auto hill = [](int n) {
    const Grid grid = grid_over({0.0, 0.0}, {60e3, 60e3}, n);
    Raster<float> ground(grid);
    for (int r = 0; r < n; ++r)
      for (int c = 0; c < n; ++c) {
        const glm::dvec2 p = (grid.center(r, c) - 30e3) / 9e3;
        ground(r, c) = float(2000.0 * std::exp(-p.x * p.x - p.y * p.y));
      }
    return orographic_rain(ground, {}, Context());
  };
  const Raster<float> coarse = hill(256), fine = hill(1024);
  for (int r = 0; r < 256; r += 5)
    for (int c = 0; c < 256; c += 5)
      ASSERT_NEAR(coarse(r, c),
                  0.25f * (fine(4 * r + 1, 4 * c + 1) + fine(4 * r + 2, 4 * c + 1) +
                           fine(4 * r + 1, 4 * c + 2) + fine(4 * r + 2, 4 * c + 2)),
                  0.02);
}

}  // namespace
}  // namespace orogen
