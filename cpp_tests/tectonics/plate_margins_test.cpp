#include "tectonics/plate_margins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "gestures.h"

namespace orogen {
namespace {

constexpr auto kOceanic = PlateCrust::Oceanic;
const Grid kGrid{200, 160, 1e3, {-50e3, -30e3}};
const MarginParameters kNear{.arc_distance = 40e3, .arc_width = 6e3};

PlateMargins run(const std::vector<PlateGesture>& gestures, const MarginParameters& parameters,
                 const Grid& grid = kGrid, int threads = 0, std::uint32_t seed = 1) {
  Context context({}, threads);
  PlateMargins result;
  context.run([&] {
    const TransportField transport(rigid_plates(gestures));
    const auto field = compression_field(transport, grid, context);
    result = plate_margins(transport, field, parameters, seed, context);
  });
  return result;
}

// Two plates beside x = 50 km; each comes `push` (m) towards it. Positive x first: the western one.
std::vector<PlateGesture> pair(double west_push, double east_push, PlateCrust west,
                               PlateCrust east) {
  return {test::box({15e3, 10e3}, {35e3, 90e3}, {west_push, 0.0}, west),
          test::box({65e3, 10e3}, {85e3, 90e3}, {-east_push, 0.0}, east)};
}

double rate_at(const Raster<float>& field, double x, double y) {
  const Grid& grid = field.grid();
  return field(grid.row_of(y), grid.column_of(x));
}

int row_of_least(const Raster<float>& field, int column) {
  int least = 0;
  for (int r = 1; r < field.grid().ny; ++r)
    if (field(r, column) < field(least, column)) least = r;
  return least;
}

TEST(PlateMargins, PartingPlatesSinkAGrabenBetweenShoulders) {
  MarginParameters p;
  p.volcano_height = 0.0;
  const auto rate = run(pair(-6e3, -6e3, {}, {}), p).uplift_rate;
  const double deepest = *std::min_element(rate.values().begin(), rate.values().end());
  EXPECT_NEAR(deepest, -p.rift_depth / p.growth_time, 0.02 * p.rift_depth / p.growth_time);
  // Its middle is the border, its floor flat, its shoulders 12 km off, and there is nothing far
  // out.
  EXPECT_NEAR(rate_at(rate, 50.4e3, 50e3), deepest, 0.1 * std::fabs(deepest));
  for (double side : {-1.0, 1.0}) {
    EXPECT_NEAR(rate_at(rate, 50e3 + side * 3e3, 50e3), deepest, 0.1 * std::fabs(deepest));
    EXPECT_NEAR(rate_at(rate, 50e3 + side * 12e3, 50e3), -0.2 * deepest, 0.06 * -deepest);
    EXPECT_NEAR(rate_at(rate, 50e3 + side * 45e3, 50e3), 0.0, 0.01 * -deepest);
  }
  // Beyond the plates' ends there is less to it.
  EXPECT_GT(rate_at(rate, 50.4e3, 125e3), 0.7 * deepest);
}

TEST(PlateMargins, CollisionOfContinentsAddsNothing) {
  for (const auto& scene : {pair(6e3, 4e3, {}, {}), pair(0.0, 0.0, {}, kOceanic),
                            std::vector{pair(5e3, 0.0, {}, {})[0]}, std::vector<PlateGesture>{}}) {
    const auto margins = run(scene, kNear);
    for (float v : margins.uplift_rate.values()) EXPECT_EQ(v, 0.0f);
  }
}

void expect_subduction(const PlateMargins& margins, const MarginParameters& p, double lower_side) {
  const auto& rate = margins.uplift_rate;
  const double trench = p.trench_depth / p.growth_time;
  const double deepest = *std::min_element(rate.values().begin(), rate.values().end());
  EXPECT_NEAR(deepest, -trench, 0.05 * trench);
  EXPECT_LT(rate_at(rate, 50e3 + lower_side * 1.5e3, 50e3), -0.8 * trench);
  // The swell: cos x + sin x < 0 beyond 3π/4 a; e^(−π) of the depth at π a.
  EXPECT_NEAR(rate_at(rate, 50e3 + lower_side * 3.14159 * p.trench_width, 50e3),
              trench * std::exp(-3.14159), 0.01 * trench);
  // Nothing is left of the trench under the arc, which stands behind it on the upper plate.
  double sum = 0.0, moment = 0.0;
  for (double d = p.arc_distance - 15e3; d < p.arc_distance + 15e3; d += 1e3) {
    double mean = 0.0;
    for (double y = 30e3; y < 70e3; y += 1e3)
      mean += std::max(0.0, rate_at(rate, 50e3 - lower_side * d, y)) / 40.0;
    sum += mean;
    moment += mean * d;
  }
  EXPECT_NEAR(moment / sum, p.arc_distance, 3e3);
  EXPECT_GT(sum / 30.0, 0.2 * p.arc_height / p.growth_time);
  ASSERT_GE(margins.volcanoes.size(), 3u);
  for (const glm::dvec2 v : margins.volcanoes) {
    EXPECT_GT(rate_at(rate, v.x, v.y), 0.05 * p.volcano_height / p.growth_time);
    if (v.y > 20e3 && v.y < 80e3) {
      EXPECT_NEAR((50e3 - v.x) * lower_side, p.arc_distance, 0.4 * p.arc_width + 1.5e3);
    }
    for (const glm::dvec2 u : margins.volcanoes)
      if (u != v) {
        EXPECT_GE(std::hypot(u.x - v.x, u.y - v.y), 0.75 * p.volcano_spacing);
      }
  }
}

TEST(PlateMargins, OceanicPlatesDiveUnderOthers) {
  MarginParameters p = kNear;
  p.trench_width = 12e3;
  p.volcano_spacing = 20e3;
  p.volcano_radius = 6e3;
  expect_subduction(run(pair(6e3, 6e3, kOceanic, {}), p), p, -1.0);
  expect_subduction(run(pair(6e3, 6e3, {}, kOceanic), p), p, 1.0);
  // Of two oceanic plates the faster dives; if alike, the later.
  expect_subduction(run(pair(7e3, 5e3, kOceanic, kOceanic), p), p, -1.0);
  expect_subduction(run(pair(5e3, 7e3, kOceanic, kOceanic), p), p, 1.0);
  expect_subduction(run(pair(6e3, 6e3, kOceanic, kOceanic), p), p, 1.0);
}

TEST(PlateMargins, TheTrenchLiesOnTheDivingPlatesSide) {
  MarginParameters p = kNear;
  p.arc_height = p.volcano_height = 0.0;
  const auto rate = run(pair(6e3, 6e3, kOceanic, {}), p).uplift_rate;
  for (double d : {4e3, 8e3, 16e3})
    EXPECT_LT(rate_at(rate, 50e3 - d, 50e3), rate_at(rate, 50e3 + d, 50e3));
  EXPECT_NEAR(kGrid.center(row_of_least(rate, kGrid.column_of(50.4e3)), 0).y, 50e3, 40e3);
}

TEST(PlateMargins, PartingOceanicPlatesDoNotSubduct) {
  const auto rate = run(pair(-6e3, -6e3, kOceanic, {}), kNear);
  EXPECT_TRUE(rate.volcanoes.empty());
  EXPECT_GT(*std::min_element(rate.uplift_rate.values().begin(), rate.uplift_rate.values().end()),
            -1.02 * kNear.rift_depth / kNear.growth_time);
}

TEST(PlateMargins, RandomPlatesKeepWithinTheirDepths) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    auto plates = test::random_plates(seed);
    for (std::size_t i = 0; i < plates.size(); ++i)
      if (random_bits(seed, 31, i) % 2) plates[i].crust = kOceanic;
    const auto margins = run(plates, kNear, {61, 53, 2e3, {-10e3, -5e3}});
    for (float v : margins.uplift_rate.values()) {
      ASSERT_TRUE(std::isfinite(v));
      EXPECT_GT(v * kNear.growth_time, -1.01 * (kNear.rift_depth + kNear.trench_depth));
    }
  }
}

TEST(PlateMargins, DegenerateGridsAndThreadsGiveTheSameBytes) {
  for (const Grid& grid : {Grid{1, 1, 10e3, {50e3, 45e3}}, Grid{1, 53, 2e3, {50e3, 0.0}},
                           Grid{101, 1, 1e3, {0.0, 50e3}}, Grid{173, 131, 900.0, {-20e3, 0.0}}}) {
    const auto plates = pair(6e3, 4e3, kOceanic, {});
    const auto one = run(plates, kNear, grid, 1);
    for (int threads : {2, 4}) {
      const auto many = run(plates, kNear, grid, threads);
      EXPECT_EQ(one.uplift_rate, many.uplift_rate);
      EXPECT_EQ(one.volcanoes, many.volcanoes);
    }
  }
}

TEST(PlateMargins, RefusesParametersOutOfRange) {
  EXPECT_THROW(run({}, {.arc_width = -1.0}), InputError);
}

}  // namespace
}  // namespace orogen
