#include "erosion/stream_power.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/random.h"
#include "hydrology/depressions.h"
#include "hydrology/random_terrains.h"

namespace orogen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Raster<std::uint8_t> four_sides(const Grid& g) {
  Raster<std::uint8_t> base(g);
  for (int c = 0; c < g.nx; ++c) base(0, c) = base(g.ny - 1, c) = 1;
  for (int r = 0; r < g.ny; ++r) base(r, 0) = base(r, g.nx - 1) = 1;
  return base;
}

/// Low rough ground between four sides at sea level.
struct Plateau {
  Grid grid;
  Raster<std::uint8_t> base;
  Raster<float> z;
  Context context;

  explicit Plateau(int nx, int ny, double cell = 100.0, double relief = 10.0)
      : grid{nx, ny, cell, {}}, base(four_sides(grid)), z(grid) {
    for (std::size_t i = 0; i < z.size(); ++i)
      if (!base[i]) z[i] = float(relief * random_uniform(1, 1, i));
  }
};

/// The implicit step written down plainly: bisection in double for each cell after its receiver.
std::vector<double> step_by_bisection(const FlowGraph& flow, const std::vector<double>& area,
                                      const Raster<float>& start, double uplift, double k, double m,
                                      double n, double dt) {
  std::vector<double> z(start.values().begin(), start.values().end());
  for (std::int32_t i : flow.order()) {
    const double below = z[flow.receiver(i)], risen = start[i] + uplift * dt;
    double low = std::min(below, risen), high = std::max(below, risen);
    for (int b = 0; b < 200; ++b) {
      const double middle = 0.5 * (low + high);
      const double slope = std::max(0.0, (middle - below) / flow.distance(i));
      const double excess = middle - risen + dt * k * std::pow(area[i], m) * std::pow(slope, n);
      (excess > 0 ? high : low) = middle;
    }
    z[i] = risen <= below ? risen : 0.5 * (low + high);
  }
  return z;
}

TEST(StreamPower, AStepAgreesWithBisectionForEverySlopeExponent) {
  for (double n : {0.5, 0.8, 1.0, 1.5, 2.0, 4.0})
    for (double dt : {10.0, 1e4, 1e6, 1e9}) {
      SCOPED_TRACE(n);
      Plateau p(60, 53, 100.0, 300.0);
      FlowGraph flow(p.base);
      const Raster<float> start = p.z;
      StreamPower solver({.area_exponent = 0.5, .slope_exponent = n});
      const double k = 2e-5, uplift = 1e-3;
      solver.step(flow, p.z, {.uplift_rate = uplift, .erodibility = k}, dt, p.context);
      const auto expected =
          step_by_bisection(flow, solver.drainage_area(), start, uplift, k, 0.5, n, dt);
      for (std::size_t i = 0; i < p.z.size(); ++i)
        ASSERT_NEAR(p.z[i], expected[i], 2e-5 + 2e-6 * std::fabs(expected[i])) << "dt " << dt;
    }
}

TEST(StreamPower, AnyAreaExponentAndFloor) {
  for (double m : {0.0, 0.3, 0.5, 1.0})
    for (AreaFloor floor : {AreaFloor::Maximum, AreaFloor::Sum}) {
      Plateau p(40, 41);
      FlowGraph flow(p.base);
      StreamPower solver({.area_exponent = m, .minimum_drainage_area = 5e4, .area_floor = floor});
      const StreamPowerForcing forcing{.uplift_rate = 1e-3, .erodibility = 1e-5};
      solver.step(flow, p.z, forcing, kInfinity, p.context);
      for (std::int32_t i : flow.order()) {
        const double a = solver.drainage_area()[i];
        const double area = floor == AreaFloor::Sum ? a + 5e4 : std::max(a, 5e4);
        const double rise = 1e-3 / (1e-5 * std::pow(area, m)) * flow.distance(i);
        ASSERT_NEAR(double(p.z[i]) - p.z[flow.receiver(i)], rise, 1e-5 * rise + 1e-6 * p.z[i]);
      }
    }
}

TEST(StreamPower, ChannelReachesItsAnalyticProfileLinearInChi) {
  const Grid g{1, 200, 100.0, {}};
  Raster<std::uint8_t> base(g);
  base(0, 0) = 1;
  Raster<float> z(g);
  for (int r = 0; r < 200; ++r) z(r, 0) = float(r);
  Context context;
  FlowGraph flow(base);
  const double u = 1e-3, k = 1e-5, m = 0.4;
  for (double dt : {2e5, 1e9}) {
    StreamPower solver({.area_exponent = m});
    for (int i = 0; i < 400; ++i)
      solver.step(flow, z, {.uplift_rate = u, .erodibility = k}, dt, context);
    const Raster<float> area = drainage_area(flow, context);
    const Raster<float> chi = chi_transform(flow, area, 1e6, m, context);
    double height = 0.0;
    for (int r = 1; r < 200; ++r) {
      height += 100.0 * u / (k * std::pow(1e4 * (200 - r), m));
      ASSERT_NEAR(z(r, 0), height, 1e-4 * height);
      ASSERT_NEAR(z(r, 0), u / k * std::pow(1e6, -m) * chi(r, 0), 1e-4 * height);
    }
  }
}

TEST(StreamPower, SteadyStateKeepsTheSlopeAreaLaw) {
  for (double n : {1.0, 1.5, 0.8})
    for (double deposition : {0.0, 0.7}) {
      Plateau p(101, 89);
      FlowGraph flow(p.base);
      StreamPower solver({.slope_exponent = n, .deposition_coefficient = deposition});
      const double u = 1e-3, k = 3e-7 / std::pow(0.1, n);
      for (int i = 0; i < 30; ++i)
        solver.step(flow, p.z, {.uplift_rate = u, .erodibility = k}, i < 20 ? 1e9 : kInfinity,
                    p.context);
      for (std::int32_t i : flow.order()) {
        const double d = flow.distance(i), slope = (double(p.z[i]) - p.z[flow.receiver(i)]) / d;
        const double rate = k * std::sqrt(solver.drainage_area()[i]) * std::pow(slope, n);
        const double rounding = n * 1e-7 * p.z[i] / (slope * d);  // heights are float32
        ASSERT_NEAR(rate / (u * (1.0 + deposition)), 1.0, 1e-4 + rounding);
      }
    }
}

TEST(StreamPower, InfiniteStepIsTheLimitOfLongOnes) {
  Plateau a(64, 64), b(64, 64);
  FlowGraph flow(a.base);
  StreamPower solver({});
  const StreamPowerForcing forcing{.uplift_rate = 1e-3, .erodibility = 1e-5};
  solver.step(flow, a.z, forcing, kInfinity, a.context);
  solver.step(flow, b.z, forcing, 1e12, b.context);
  for (std::size_t i = 0; i < a.z.size(); ++i) ASSERT_NEAR(a.z[i], b.z[i], 1e-4 * (1 + a.z[i]));
}

TEST(StreamPower, MassIsBalancedOnAnyTerrain) {
  Context context;
  for (int t = 0; t < 100; ++t)
    for (double deposition : {0.0, 0.5})
      for (double dt : {1e3, 1e6, kInfinity}) {
        SCOPED_TRACE(t);
        RandomTerrain terrain = random_terrain(t);
        const Raster<float> start = terrain.elevation;
        const double cell = start.grid().cell_area();
        Raster<float> uplift(start.grid());
        for (std::size_t i = 0; i < uplift.size(); ++i)
          uplift[i] = float(1e-3 * random_uniform(t, 8, i));
        FlowGraph flow(terrain.base);
        StreamPower solver({.deposition_coefficient = deposition});
        const MassBalance m = solver.step(
            flow, terrain.elevation, {.uplift_rate = uplift, .erodibility = 1e-5}, dt, context);
        EXPECT_LE(m.relative_residual(), 1e-12);
        double change = 0.0, reaching = 0.0;
        for (std::size_t i = 0; i < start.size(); ++i) {
          ASSERT_TRUE(std::isfinite(terrain.elevation[i]));
          change += cell * (double(terrain.elevation[i]) - start[i]);
          if (terrain.base[i]) {
            ASSERT_EQ(terrain.elevation[i], start[i]);
            if (deposition > 0.0) reaching += solver.sediment_flux()[i];
          }
        }
        const double throughput = std::max({m.eroded_m3, m.supplied_m3, 1e-9});
        EXPECT_NEAR(m.supplied_m3 - m.exported_m3, change, 1e-9 * throughput);
        EXPECT_NEAR(m.exported_m3, m.eroded_m3 - m.deposited_m3, 1e-12 * throughput);
        // What the rivers carry to base level is what the heights have lost, but for float32.
        if (deposition > 0.0 && std::isfinite(dt)) {
          EXPECT_NEAR(reaching * dt, m.exported_m3,
                      1e-4 * throughput + 1e-4 * cell * double(start.size()));
        }
      }
}

TEST(StreamPower, SameBytesForAnyThreads) {
  Raster<float> first[3];
  for (int threads : {1, 2, 4}) {
    int k = 0;
    for (double deposition : {0.0, 1.0, 1.0}) {
      Plateau p(301, 211, 100.0, 50.0);
      Context context({}, threads);
      FlowGraph flow(p.base);
      StreamPower solver(
          {.slope_exponent = k == 2 ? 1.4 : 1.0, .deposition_coefficient = deposition});
      context.run([&] {
        for (int i = 0; i < 5; ++i)
          solver.step(flow, p.z, {.uplift_rate = 1e-3, .erodibility = 1e-5}, 1e5, context);
      });
      if (threads == 1) first[k] = p.z;
      EXPECT_EQ(p.z, first[k]) << threads;
      ++k;
    }
  }
}

TEST(StreamPower, TalusCapsTheSlopeToTheReceiver) {
  Plateau p(80, 70);
  FlowGraph flow(p.base);
  StreamPower solver({});
  Raster<float> talus(p.grid);
  for (std::size_t i = 0; i < talus.size(); ++i) talus[i] = i % 2 ? 0.3f : 0.6f;
  for (int i = 0; i < 20; ++i)
    solver.step(flow, p.z, {.uplift_rate = 5e-3, .erodibility = 1e-6, .talus_slope = talus}, 1e6,
                p.context);
  int capped = 0;
  for (std::int32_t i : flow.order()) {
    const double slope = (double(p.z[i]) - p.z[flow.receiver(i)]) / flow.distance(i);
    EXPECT_LE(slope, talus[i] + 1e-4);
    capped += slope > talus[i] - 1e-4;
  }
  EXPECT_GT(capped, 1000);
}

TEST(StreamPower, PinnedCellsKeepTheirHeight) {
  for (double deposition : {0.0, 0.5}) {
    Plateau p(60, 60);
    Raster<std::uint8_t> pinned(p.grid);
    pinned(20, 20) = pinned(41, 33) = 1;
    p.z(20, 20) = 1234.5f;
    p.z(41, 33) = 777.25f;
    FlowGraph flow(p.base);
    StreamPower solver({.deposition_coefficient = deposition});
    for (int i = 0; i < 10; ++i)
      solver.step(flow, p.z, {.uplift_rate = 1e-3, .erodibility = 1e-5, .pinned = &pinned}, 1e5,
                  p.context);
    EXPECT_EQ(p.z(20, 20), 1234.5f);
    EXPECT_EQ(p.z(41, 33), 777.25f);
  }
}

TEST(StreamPower, HeightsStayBetweenLeastAndGreatestAndAboveTheirReceivers) {
  for (double deposition : {0.0, 0.5})
    for (double n : {1.0, 1.5}) {
      Plateau p(60, 50);
      Raster<float> least(p.grid), greatest(p.grid);
      for (std::size_t i = 0; i < least.size(); ++i) {
        least[i] = i % 7 ? 0.0f : float(300.0 * random_uniform(1, 2, i));
        greatest[i] = float(350.0 + 200.0 * random_uniform(1, 3, i));
      }
      FlowGraph flow(p.base);
      StreamPower solver({.slope_exponent = n, .deposition_coefficient = deposition});
      for (int i = 0; i < 6; ++i)
        solver.step(flow, p.z,
                    {.uplift_rate = 1e-3,
                     .erodibility = 1e-6,
                     .least_height = least,
                     .greatest_height = greatest},
                    1e6, p.context);
      for (const std::int32_t i : flow.order()) {
        const float below = p.z[flow.receiver(i)];
        EXPECT_GE(p.z[i], std::min(least[i], greatest[i]));
        if (deposition == 0.0) {
          EXPECT_GE(p.z[i], below);
        }
        EXPECT_LE(p.z[i], std::max(greatest[i], below) + 1e-3f);
      }
    }
}

TEST(StreamPower, WithoutUpliftNothingRisesAndReliefOnlyFalls) {
  Plateau p(90, 90, 100.0, 800.0);
  FlowGraph flow(p.base);
  StreamPower solver({});
  for (int i = 0; i < 5; ++i) {
    const Raster<float> before = p.z;
    solver.step(flow, p.z, {.uplift_rate = 0.0, .erodibility = 1e-5}, 1e5, p.context);
    for (std::size_t k = 0; k < p.z.size(); ++k) ASSERT_LE(p.z[k], before[k] + 1e-4f);
  }
}

TEST(StreamPower, ErosionAfterErosionHasNoPits) {
  Plateau p(200, 150, 50.0, 200.0);
  FlowGraph flow(p.base);
  StreamPower solver({});
  for (int i = 0; i < 3; ++i)
    solver.step(flow, p.z, {.uplift_rate = 1e-3, .erodibility = 1e-5}, kInfinity, p.context);
  flow.route(p.z, p.context);
  EXPECT_EQ(flow.pit_count(), 0u);
}

/// A wide valley behind a sill: mountains shed sediment into a hollow.
TEST(StreamPower, LakesFillWithSedimentAndNeverAboveTheirSill) {
  const Grid g{80, 40, 100.0, {}};
  Raster<std::uint8_t> base(g);
  Raster<float> z(g), rock(g);
  for (int r = 0; r < g.ny; ++r)
    for (int c = 0; c < g.nx; ++c) {
      z(r, c) = c < 5 ? 60.0f + float(std::abs(r - 20)) : c < 30 ? 20.0f : 20.0f + 25.0f * (c - 29);
      z(r, c) += 0.5f * float(random_uniform(2, 2, g.index(r, c)));
      base(r, c) = c == 0;
      if (c == 0) z(r, c) = 55.0f;
    }
  Context context;
  FlowGraph flow(base);
  flow.route(z, context);
  Raster<float> level;
  filled_level(flow, z, level, context);
  const auto water = [&](const Raster<float>& ground, const Raster<float>& surface) {
    double v = 0.0;
    for (std::size_t i = 0; i < ground.size(); ++i)
      v += std::max(0.0f, surface[i] - ground[i]) * g.cell_area();
    return v;
  };
  const double before = water(z, level);
  ASSERT_GT(before, 1e8);
  const StreamPowerForcing forcing{.uplift_rate = 0.0, .erodibility = 2e-6};
  StreamPower solver({.deposition_coefficient = 0.3});
  double laid = 0.0;
  for (int i = 0; i < 40; ++i) {
    const Raster<float> start = z;
    laid += solver.step(flow, z, forcing, 2e4, context).deposited_m3;
    for (int r = 0; r < g.ny; ++r)
      for (int c = 6; c < 29; ++c)
        ASSERT_TRUE(z(r, c) < 75.0f || z(r, c) <= start(r, c) || start(r, c) >= 55.0f);
    if (i == 0) {
      // A closed lake passes nothing on while it has room.
      double out = 0.0;
      for (int r = 0; r < g.ny; ++r) out += solver.sediment_flux()[g.index(r, 0)] * 2e4;
      EXPECT_LT(out, 0.3 * laid);
    }
  }
  flow.route(z, context);
  filled_level(flow, z, level, context);
  EXPECT_LT(water(z, level), 0.05 * before);
  EXPECT_GT(laid, 0.5 * before);
  // The floor has become a plain: far flatter than the range behind it.
  int low = 0;
  for (int r = 5; r < 35; ++r)
    for (int c = 8; c < 28; ++c) low += std::fabs(z(r, c + 1) - z(r, c)) / 100.0 < 0.03;
  EXPECT_GT(low, 500);
}

TEST(StreamPower, DepositionSteepensRiversAndMakesPlains) {
  Plateau cutting(100, 100), laying(100, 100);
  FlowGraph flow(cutting.base);
  StreamPower one({}), two({.deposition_coefficient = 1.0});
  const StreamPowerForcing forcing{.uplift_rate = 1e-3, .erodibility = 1e-5};
  for (int i = 0; i < 30; ++i) {
    one.step(flow, cutting.z, forcing, 1e6, cutting.context);
    two.step(flow, laying.z, forcing, 1e6, laying.context);
  }
  EXPECT_GT(laying.z(50, 50), 1.3f * cutting.z(50, 50));
}

TEST(StreamPower, StageRunsItsStepsAndGivesTheArea) {
  Plateau p(50, 50);
  Raster<float> area;
  const StreamPowerForcing forcing{.uplift_rate = 1e-3, .erodibility = 1e-5};
  const MassBalance m = erode_stream_power(p.z, p.base, forcing, {.steps = 5}, p.context, &area);
  EXPECT_LE(m.relative_residual(), 1e-12);
  EXPECT_NEAR(m.supplied_m3, 1e-3 * 5e5 * 48 * 48 * 1e4, 1e-6 * m.supplied_m3);
  double out = 0.0;
  for (std::size_t i = 0; i < area.size(); ++i)
    if (p.base[i]) out += area[i];
  EXPECT_NEAR(out, 48 * 48 * 1e4, 1.0);
}

TEST(StreamPower, RefusesBadInput) {
  EXPECT_THROW(StreamPower({.slope_exponent = 0.0}), InputError);
  EXPECT_THROW(StreamPower({.area_exponent = NAN}), InputError);
  Plateau p(10, 10);
  FlowGraph flow(p.base);
  StreamPower solver({});
  EXPECT_THROW(solver.step(flow, p.z, {}, 0.0, p.context), InputError);
  EXPECT_THROW(solver.step(flow, p.z, {}, NAN, p.context), InputError);
  const Raster<float> elsewhere(Grid{3, 3, 1.0, {}});
  EXPECT_THROW(solver.step(flow, p.z, {.uplift_rate = elsewhere}, 1.0, p.context), InputError);
  EXPECT_THROW(solver.step(flow, p.z, {.erodibility = elsewhere}, 1.0, p.context), InputError);
}

}  // namespace
}  // namespace orogen
