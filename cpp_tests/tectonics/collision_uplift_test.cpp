#include "tectonics/collision_uplift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "gestures.h"

namespace orogen {
namespace {

struct Run {
  TransportField transport;
  CompressionField field;
  CollisionUplift uplift;
};

Run run(const std::vector<PlateGesture>& gestures, const Grid& grid,
        const CollisionParameters& parameters = {}, int threads = 0) {
  Context context({}, threads);
  Run result{TransportField(rigid_plates(gestures)), {}, {}};
  context.run([&] {
    result.field = compression_field(result.transport, grid, context);
    const auto meet =
        plate_convergence(result.transport, grid, parameters.crust_smoothing, context);
    result.uplift = collision_uplift(result.transport, result.field, meet, parameters, context);
  });
  return result;
}

float most(const Raster<float>& field) {
  return *std::max_element(field.values().begin(), field.values().end());
}

// The western plate comes 10 km, the eastern one stays: hulls end at 45 and at 65 km.
std::vector<PlateGesture> ram() {
  return {test::box({15e3, 20e3}, {35e3, 80e3}, {10e3, 0.0}),
          test::box({65e3, 20e3}, {85e3, 80e3}, {0.0, 0.0})};
}
const Grid kGrid{120, 100, 1e3, {-10e3, 0.0}};

TEST(CollisionUplift, MeanOfTheUpliftedGroundIsTheTarget) {
  int rising = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const double target = 1e-4 + 1e-3 * random_uniform(seed, 1, 0);
    CollisionParameters p{.target_uplift_rate = target};
    p.fault = seed % 2;
    p.crust_smoothing = seed % 3 ? 4e3 : 0.0;
    const auto u = run(test::random_plates(seed), kGrid, p).uplift.uplift_rate;
    double sum = 0.0, count = 0.0;
    const float greatest = most(u);
    for (float v : u.values()) {
      ASSERT_TRUE(std::isfinite(v) && v >= 0.0f);
      if (v > 0.01f * greatest) {
        sum += v;
        count += 1.0;
      }
    }
    if (greatest == 0.0f) continue;
    ++rising;
    EXPECT_NEAR(sum / count, target, 1e-3 * target);
  }
  EXPECT_GT(rising, 20);
}

TEST(CollisionUplift, NothingRisesWithoutCompression) {
  const std::vector<std::vector<PlateGesture>> scenes{
      {},
      {ram()[0]},
      {test::random_gesture(5, {50e3, 45e3}, 15e3, 9, 0.4, {8e3, 3e3})},
      test::facing_pair(-8e3),
      test::facing_pair(0.0),
      {test::box({20e3, 20e3}, {38e3, 80e3}, {-8e3, 0.0}),
       test::box({62e3, 20e3}, {80e3, 80e3}, {8e3, 0.0})}};
  for (const auto& scene : scenes) {
    const auto u = run(scene, kGrid).uplift;
    for (float v : u.uplift_rate.values()) EXPECT_EQ(v, 0.0f);
    for (float d : u.fault.values()) EXPECT_EQ(d, 220e3f);
    EXPECT_TRUE(u.fault_lines.empty());
    EXPECT_EQ(u.stable_plate, scene.empty() ? -1 : 0);
  }
}

// Figure 15: between long facing plates the ground rises alike.
TEST(CollisionUplift, BetweenLongPlatesItIsNearlyUniformInTheMiddle) {
  CollisionParameters p{.crust_smoothing = 0.0, .fault = false};
  const auto u = run(test::facing_pair(8e3), kGrid, p).uplift.uplift_rate;
  const float middle = u(50, 60);
  EXPECT_GT(middle, 0.5f * most(u));
  for (int r = 10; r < 90; ++r)
    for (int c = 53; c <= 66; ++c) EXPECT_NEAR(u(r, c), middle, 0.1f * middle);
}

TEST(CollisionUplift, FaultRunsOnTheStableSideWithASharpStep) {
  const auto u = run(ram(), kGrid).uplift;
  EXPECT_EQ(u.stable_plate, 1);
  ASSERT_EQ(u.fault_lines.size(), 1u);
  // Beside the middle of the plates: near the border of the stable hull, 65 km.
  int crossed = 0;
  for (const glm::dvec2 p : u.fault_lines[0])
    if (p.y > 30e3 && p.y < 70e3) {
      EXPECT_NEAR(p.x, 65e3, 4e3);
      ++crossed;
    }
  EXPECT_GT(crossed, 35);
  for (int c = 0; c < kGrid.nx; ++c) {
    const bool stable = u.fault(50, c) < 0.0f;
    EXPECT_EQ(stable, kGrid.center(50, c).x > u.fault_lines[0][u.fault_lines[0].size() / 2].x);
    if (stable) {
      EXPECT_EQ(u.uplift_rate(50, c), 0.0f);
    }
  }
  int edge = 0;
  while (u.fault(50, edge) >= 0.0f) ++edge;
  EXPECT_GT(u.uplift_rate(50, edge - 1), 0.3f * most(u.uplift_rate));
  // The moving side lies on the lines' left: here they run north.
  EXPECT_GT(u.fault_lines[0].back().y, u.fault_lines[0].front().y);
}

TEST(CollisionUplift, FaultFollowsTheStablePlateAndItsOffset) {
  const auto at = [&](const CollisionParameters& p) {
    const auto u = run(ram(), kGrid, p).uplift;
    double sum = 0.0, count = 0.0;
    for (const Polyline& line : u.fault_lines)
      for (const glm::dvec2 q : line)
        if (q.y > 40e3 && q.y < 60e3) {
          sum += q.x;
          count += 1.0;
        }
    return sum / count;
  };
  const double east = at({}), west = at({.stable_plate = 0});
  EXPECT_NEAR(west, 45e3, 4e3);
  EXPECT_NEAR(at({.fault_offset = 6e3}), east + 6e3, 100.0);
  EXPECT_NEAR(at({.fault_offset = -6e3}), east - 6e3, 100.0);
  EXPECT_NEAR(at({.stable_plate = 0, .fault_offset = 6e3}), west - 6e3, 100.0);
  EXPECT_GT(at({.fault_level = 0.2}), east + 1e3);
  EXPECT_LT(at({.fault_level = 0.8}), east - 1e3);
}

TEST(CollisionUplift, WithoutAFaultBothSidesRise) {
  const auto u = run(ram(), kGrid, {.fault = false}).uplift;
  EXPECT_TRUE(u.fault_lines.empty());
  EXPECT_GT(u.uplift_rate(50, 77), 0.0f);  // 67 km, within the stable hull
  EXPECT_GT(u.uplift_rate(50, 53), 0.0f);
}

TEST(CollisionUplift, OceanicPlatesDoNotThicken) {
  auto plates = ram();
  plates[1].crust = PlateCrust::Oceanic;
  const auto one = run(plates, kGrid, {.fault = false});
  int continental = 0;
  for (std::size_t i = 0; i < kGrid.size(); ++i) {
    if (one.field.plate[i] == 1) {
      EXPECT_EQ(one.uplift.uplift_rate[i], 0.0f);
    }
    continental += one.uplift.uplift_rate[i] > 0.0f;
  }
  EXPECT_GT(continental, 100);
  plates[0].crust = PlateCrust::Oceanic;
  EXPECT_EQ(most(run(plates, kGrid).uplift.uplift_rate), 0.0f);
}

TEST(CollisionUplift, StablePlateIsTheSlowestUnlessNamed) {
  auto plates = ram();
  for (auto& arrow : plates[1].arrows) arrow = {-9.9e3, 0.0};
  EXPECT_EQ(run(plates, kGrid).uplift.stable_plate, 1);
  for (auto& arrow : plates[1].arrows) arrow = {-10e3, 0.0};
  EXPECT_EQ(run(plates, kGrid).uplift.stable_plate, 0);  // alike: the first
  EXPECT_EQ(run(plates, kGrid, {.stable_plate = 1}).uplift.stable_plate, 1);
  EXPECT_THROW(run(plates, kGrid, {.stable_plate = 2}), InputError);
  EXPECT_THROW(run(plates, kGrid, {.stable_plate = -2}), InputError);
  EXPECT_THROW(run(plates, kGrid, {.target_uplift_rate = 0.0}), InputError);
}

TEST(CollisionUplift, DegenerateGridsAndThreadsGiveTheSameBytes) {
  for (const Grid& grid : {Grid{1, 1, 10e3, {50e3, 45e3}}, Grid{1, 53, 2e3, {50e3, 0.0}},
                           Grid{101, 1, 1e3, {0.0, 50e3}}, Grid{211, 173, 500.0, {0.0, 0.0}}}) {
    const auto one = run(ram(), grid, {.fault_offset = 2e3}, 1).uplift;
    for (int threads : {2, 4}) {
      const auto many = run(ram(), grid, {.fault_offset = 2e3}, threads).uplift;
      EXPECT_EQ(one.uplift_rate, many.uplift_rate);
      EXPECT_EQ(one.fault, many.fault);
      EXPECT_EQ(one.fault_lines, many.fault_lines);
    }
  }
}

}  // namespace
}  // namespace orogen
