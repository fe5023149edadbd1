#include "erosion/tin_hillslope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "foundation/errors.h"
#include "foundation/random.h"
#include "hydrology/random_tins.h"

namespace orogen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double volume(const Tin& tin, const std::vector<double>& z) {
  double sum = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i) sum += z[i] * tin.cell_areas[i];
  return sum;
}

double steepest_excess(const Tin& tin, const std::vector<double>& z,
                       const std::vector<std::uint8_t>& base, double talus) {
  double worst = -kInfinity;
  for (std::int32_t v = 0; v < std::int32_t(tin.size()); ++v)
    for (std::int32_t e = tin.first_edge[v]; e < tin.first_edge[v + 1] && !base[v]; ++e)
      worst = std::max(worst, z[v] - z[tin.neighbors[e]] - talus * tin.edge_lengths[e]);
  return worst;
}

TEST(TinLandslide, KeepsMassOnRandomGround) {
  Context context;
  for (int number = 0; number < 100; ++number) {
    const RandomTin t = random_tin(number, context);
    std::vector<double> z = t.elevation;
    const double dt = number % 3 ? kInfinity : 1e5;
    const MassBalance b = landslide(t.tin, z, t.base, 0.1 + 0.01 * number, {}, dt, context);
    ASSERT_LE(b.relative_residual(), 1e-12) << number;
    double scale = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      scale += std::fabs(t.elevation[i]) * t.tin.cell_areas[i];
      if (t.base[i]) {
        ASSERT_EQ(z[i], t.elevation[i]);
      }
    }
    ASSERT_NEAR(volume(t.tin, z), volume(t.tin, t.elevation) - b.exported_m3, 1e-12 * scale);
    const auto [low, high] = std::ranges::minmax(t.elevation);
    for (double height : z) ASSERT_TRUE(height >= low - 1e-9 && height <= high + 1e-9);
  }
}

TEST(TinLandslide, ComesToRestAtTheTalusSlope) {
  Context context;
  for (int number = 0; number < 6; ++number) {
    const Tin tin =
        (number % 2 ? poisson_tin : jittered_tin)({{0, 0}, {2e3, 2e3}}, 80.0, number, context);
    std::vector<double> z(tin.size());
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = 150.0 * random_uniform(number, 4, i);
    const std::vector<std::uint8_t> walls(tin.size(), 0);
    const double before = volume(tin, z);
    landslide(tin, z, walls, 0.5, {.rounds = 10000}, kInfinity, context);
    EXPECT_LE(steepest_excess(tin, z, walls, 0.5), 1.1e-3) << number;
    EXPECT_NEAR(volume(tin, z), before, 1e-12 * before);
    const std::vector<double> rested = z;
    landslide(tin, z, walls, 0.6, {}, kInfinity, context);
    EXPECT_EQ(z, rested);
  }
}

TEST(TinLandslide, APileSpreadsToAConeOfTheTalusSlope) {
  Context context;
  const Tin tin = poisson_tin({{-1e3, -1e3}, {2e3, 2e3}}, 25.0, 3, context);
  std::vector<double> z(tin.size(), 0.0);
  for (std::size_t i = 0; i < z.size(); ++i)
    if (std::hypot(tin.points[i].x, tin.points[i].y) < 150.0) z[i] = 300.0;
  const double mass = volume(tin, z), slope = 0.6;
  landslide(tin, z, std::vector<std::uint8_t>(tin.size(), 0), slope, {.rounds = 10000}, kInfinity,
            context);
  // A cone of that volume is slope r high, pi r³ slope / 3 in all. Along edges the ground may be
  // somewhat steeper in between them, never flatter by much.
  const double radius = std::cbrt(3.0 * mass / (std::numbers::pi * slope));
  const double peak = *std::ranges::max_element(z);
  EXPECT_GT(peak, 0.85 * slope * radius);
  EXPECT_LT(peak, 1.25 * slope * radius);
}

TEST(TinLandslide, ASlowSlideFallsAtTheRateOfThePaper) {
  // One steep edge: dz = -l (s - tan θ) dt while that is small.
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {1e3, 1e3}}, 100.0, 1, context);
  std::int32_t peak = 0;
  for (std::int32_t v = 0; v < std::int32_t(tin.size()); ++v)
    if (std::hypot(tin.points[v].x - 500, tin.points[v].y - 500) <
        std::hypot(tin.points[peak].x - 500, tin.points[peak].y - 500))
      peak = v;
  std::vector<double> z(tin.size(), 0.0);
  z[peak] = 200.0;
  float shortest = 1e9f;
  for (std::int32_t e = tin.first_edge[peak]; e < tin.first_edge[peak + 1]; ++e)
    shortest = std::min(shortest, tin.edge_lengths[e]);
  const double fall = 0.01 * 10.0 * (200.0 / shortest - 0.5);
  landslide(tin, z, std::vector<std::uint8_t>(tin.size(), 0), 0.5,
            {.landslide_rate = 0.01, .rounds = 10}, 10.0, context);
  EXPECT_NEAR(200.0 - z[peak], fall, 0.01 * fall);
}

TEST(TinShedLandslides, AgreesWithThePlainImplicitStepAndOnlyLowers) {
  Context context;
  for (int number = 0; number < 100; ++number) {
    const RandomTin t = random_tin(number, context);
    TinFlow flow(t.tin, t.base);
    flow.route(t.elevation, context);
    for (double dt : {1e2, 1e5, kInfinity}) {
      std::vector<double> z = t.elevation;
      const MassBalance b = shed_landslides(flow, z, 0.2, 0.01, dt, context);
      double lost = 0.0;
      for (std::int32_t v = 0; v < std::int32_t(z.size()); ++v) {
        lost += (t.elevation[v] - z[v]) * t.tin.cell_areas[v];
        if (t.base[v]) {
          ASSERT_EQ(z[v], t.elevation[v]);
          continue;
        }
        // z' = z - dt l max(0, s' - tan θ), by its residual.
        const double length = flow.distances()[v];
        const double slope = (z[v] - z[flow.receivers()[v]]) / length;
        ASSERT_LE(z[v], t.elevation[v]);
        if (std::isinf(dt)) {
          ASSERT_LE(slope, 0.2 * (1.0 + 1e-9) + 1e-9);
        } else {
          const double fall = dt * 0.01 * std::max(0.0, slope - 0.2);
          ASSERT_NEAR(t.elevation[v] - z[v], fall,
                      1e-9 * (1.0 + fall) * std::max(1.0, dt / length));
        }
      }
      ASSERT_NEAR(b.eroded_m3, lost, 1e-9 * (lost + 1.0));
      ASSERT_EQ(b.exported_m3, b.eroded_m3);
    }
  }
}

TEST(TinCreep, KeepsMassAndRangeOnRandomGround) {
  Context context;
  for (int number = 0; number < 60; ++number) {
    const RandomTin t = random_tin(number, context);
    const auto [low, high] = std::ranges::minmax(t.elevation);
    const double area = t.tin.domain.area() / double(t.tin.size());
    for (double slope : {0.0, 0.7})
      for (double number_of_step : {0.1, 20.0}) {
        std::vector<double> z = t.elevation;
        TinCreep creep(t.tin, t.base, {.diffusivity = 0.02, .critical_slope = slope});
        const MassBalance b = creep.step(z, number_of_step * area / 0.02, context);
        ASSERT_LE(std::fabs(b.residual_m3),
                  1e-12 * (b.eroded_m3 + b.deposited_m3 + (high - low) * t.tin.domain.area()));
        for (std::size_t i = 0; i < z.size(); ++i) {
          ASSERT_TRUE(z[i] >= low - 1e-6 && z[i] <= high + 1e-6) << number;
          if (t.base[i]) {
            ASSERT_EQ(z[i], t.elevation[i]);
          }
        }
      }
  }
}

TEST(TinCreep, ACosineDecaysAsItShould) {
  // z = cos(π x / L) between closed sides decays as exp(-D (π / L)² t).
  Context context;
  const double length = 1e4, d = 0.05;
  const Tin tin = jittered_tin({{0, 0}, {length, 3e3}}, 100.0, 3, context);
  std::vector<double> z(tin.size());
  const auto wave = [&](std::size_t i) {
    return std::cos(std::numbers::pi * tin.points[i].x / length);
  };
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = wave(i);
  TinCreep creep(tin, std::vector<std::uint8_t>(tin.size(), 0), {.diffusivity = d});
  const double rate = d * std::pow(std::numbers::pi / length, 2), time = 1.0 / rate;
  for (int i = 0; i < 100; ++i) creep.step(z, time / 100, context);
  const double implicit = std::pow(1.0 + 0.01, -100);  // of time alone
  for (std::size_t i = 0; i < z.size(); ++i) ASSERT_NEAR(z[i], implicit * wave(i), 3e-3);
}

TEST(TinCreep, AnotherBaseLevelIsAsIfItHadAlwaysBeenThere) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {2e3, 1e3}}, 60.0, 3, context);
  const auto west = side_mask(tin, kWestSide), east = side_mask(tin, kEastSide);
  std::vector<double> fresh(tin.size()), moved;
  for (std::size_t i = 0; i < fresh.size(); ++i) fresh[i] = random_uniform(1, 1, i);
  moved = fresh;
  const CreepParameters parameters{.diffusivity = 0.1, .critical_slope = 0.5};
  TinCreep creep(tin, west, parameters);
  creep.set_base_level(east);
  const MassBalance a = creep.step(moved, 1e5, context);
  const MassBalance b = TinCreep(tin, east, parameters).step(fresh, 1e5, context);
  EXPECT_EQ(moved, fresh);
  EXPECT_EQ(a.exported_m3, b.exported_m3);
}

TEST(TinCreep, SteadyStateOfTwoHeldSidesIsAPlane) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {2e3, 1e3}}, 60.0, 3, context);
  std::vector<double> z(tin.size(), 0.0);
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = tin.sides[i] & kEastSide ? 20.0 : 0.0;
  for (double slope : {0.0, 0.05}) {
    TinCreep creep(tin, side_mask(tin, kWestSide | kEastSide),
                   {.diffusivity = 1.0, .critical_slope = slope});
    for (int i = 0; i < 4; ++i) creep.step(z, slope > 0.0 ? 1e7 : 1e8, context);
    for (std::size_t i = 0; i < z.size(); ++i)
      ASSERT_NEAR(z[i], 0.01 * tin.points[i].x, 1e-4) << slope;
  }
}

TEST(TinCreep, SteepGroundCreepsFasterAsRoeringSays) {
  // Over one short step a plane of slope s between a held foot and closed ground loses
  // D s / (1 - (s / S_c)²) through its foot.
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {2e3, 1e3}}, 50.0, 3, context);
  for (double slope : {0.0, 0.3, 0.6}) {
    std::vector<double> z(tin.size());
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = slope * tin.points[i].x;
    TinCreep creep(tin, side_mask(tin, kWestSide), {.diffusivity = 0.01, .critical_slope = 0.8});
    const MassBalance b = creep.step(z, 1.0, context);
    const double expected = 0.01 * slope / (1.0 - slope * slope / 0.64) * 1e3;
    EXPECT_NEAR(b.exported_m3, expected, 1e-3 * expected + 1e-9);
  }
}

TEST(TinHillslope, ThreadsDoNotMatter) {
  Context maker;
  const Tin tin = jittered_tin({{0, 0}, {8e3, 8e3}}, 80.0, 3, maker);
  const auto base = side_mask(tin, 15u);
  std::vector<double> slid, crept;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      std::vector<double> z(tin.size());
      for (std::size_t i = 0; i < z.size(); ++i)
        z[i] = base[i] ? 0.0 : 200 * random_uniform(1, 1, i);
      landslide(tin, z, base, 0.6, {}, kInfinity, context);
      if (threads == 1) slid = z;
      EXPECT_EQ(z, slid);
      TinCreep creep(tin, base, {.diffusivity = 0.05, .critical_slope = 1.0});
      creep.step(z, 1e5, context);
      if (threads == 1) crept = z;
      EXPECT_EQ(z, crept);
    });
  }
}

TEST(TinHillslope, RefusesBadInput) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {1e3, 1e3}}, 200.0, 3, context);
  const std::vector<std::uint8_t> base = side_mask(tin, 15u), few(3);
  std::vector<double> z(tin.size(), 1.0);
  const std::vector<float> talus(3);
  EXPECT_THROW(landslide(tin, z, few, 0.5, {}, 1.0, context), InputError);
  EXPECT_THROW(landslide(tin, z, base, {talus}, {}, 1.0, context), InputError);
  EXPECT_THROW(landslide(tin, z, base, 0.5, {.rounds = 0}, 1.0, context), InputError);
  EXPECT_THROW(landslide(tin, z, base, 0.5, {}, -1.0, context), InputError);
  TinFlow flow(tin, base);
  flow.route(z, context);
  EXPECT_THROW(shed_landslides(flow, z, 0.5, -1.0, 1.0, context), InputError);
  EXPECT_THROW(TinCreep(tin, few, {}), InputError);
  EXPECT_THROW(TinCreep(tin, base, {.diffusivity = -1.0}), InputError);
  TinCreep creep(tin, base, {});
  EXPECT_THROW(creep.step(z, kInfinity, context), InputError);
  EXPECT_THROW(creep.set_base_level(few), InputError);
  z[3] = std::nan("");
  EXPECT_THROW(creep.step(z, 1.0, context), InputError);
}

}  // namespace
}  // namespace orogen
