// TinStreamPower with sediment.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "erosion/tin_stream_power.h"
#include "foundation/errors.h"
#include "foundation/random.h"
#include "hydrology/random_tins.h"

namespace orogen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Ground {
  Context context;
  Tin tin;
  std::vector<std::uint8_t> base;
  std::vector<double> z;

  explicit Ground(double spacing, double relief = 10.0, unsigned sides = 15u)
      : tin(jittered_tin({{0, 0}, {10e3, 8e3}}, spacing, 1, context)),
        base(side_mask(tin, sides)),
        z(tin.size(), 0.0) {
    for (std::size_t i = 0; i < z.size(); ++i)
      if (!base[i]) z[i] = relief * random_uniform(1, 1, i);
  }
};

/// Mean of s (A^m k / u)^(1/n), which is (1 + G)^(1/n) in the steady state.
double mean_steepness(const TinFlow& flow, const std::vector<double>& z,
                      std::span<const double> area, double m, double n, double u, double k) {
  double sum = 0.0, count = 0.0;
  for (const std::int32_t i : flow.order()) {
    const double slope = (z[i] - z[flow.receivers()[i]]) / flow.distances()[i];
    sum += slope * std::pow(std::pow(area[i], m) * k / u, 1.0 / n);
    count += 1.0;
  }
  return sum / count;
}

TEST(TinDeposition, SteadySlopesAreSteeperAsTheLawSays) {
  const double u = 1e-3, k = 1e-5;
  for (const auto& [m, n] : {std::pair{0.5, 1.0}, {0.4, 0.8}, {0.5, 2.0}})
    for (const double g : {0.5, 2.0}) {
      Ground ground(250.0);
      TinFlow flow(ground.tin, ground.base);
      TinStreamPower solver({.area_exponent = m, .slope_exponent = n, .deposition_coefficient = g});
      for (int i = 0; i < 400; ++i)
        solver.step(flow, ground.z, {.uplift_rate = u, .erodibility = k}, i < 200 ? 2e4 : 1e5,
                    ground.context);
      const double steepness = mean_steepness(flow, ground.z, solver.drainage_area(), m, n, u, k);
      EXPECT_NEAR(steepness, std::pow(1.0 + g, 1.0 / n), 0.01 * steepness) << n << " " << g;
    }
}

TEST(TinDeposition, AnInfiniteStepIsTheSteadyStateOfItsDrainage) {
  for (const double n : {0.7, 1.0, 2.0}) {
    Ground ground(200.0);
    TinFlow flow(ground.tin, ground.base);
    TinStreamPower solver({.slope_exponent = n, .deposition_coefficient = 1.0});
    const double u = 1e-3, k = 1e-5;
    solver.step(flow, ground.z, {.uplift_rate = u, .erodibility = k}, kInfinity, ground.context);
    for (const std::int32_t i : flow.order()) {
      const double area = solver.drainage_area()[i];
      const double rise = std::pow(2.0 * u / (k * std::sqrt(area)), 1.0 / n) * flow.distances()[i];
      ASSERT_NEAR(ground.z[i] - ground.z[flow.receivers()[i]], rise, 1e-8 * rise);
    }
  }
}

TEST(TinDeposition, ManyRoundsAgreeWithTheLawVertexByVertex) {
  // (z - z0) / dt = u - k A^m s^n + G q / A, with q summed here from what was eroded above.
  Ground ground(200.0, 0.0);
  for (std::size_t i = 0; i < ground.z.size(); ++i) {
    const glm::dvec2 p = ground.tin.points[i];
    if (!ground.base[i]) ground.z[i] = 0.1 * std::min(p.y, 8e3 - p.y) * (1.0 + 1e-4 * p.x);
  }
  for (const double n : {1.0, 1.5}) {
    const std::vector<double> start = ground.z;
    std::vector<double> z = start;
    TinFlow flow(ground.tin, ground.base);
    TinStreamPower solver({.slope_exponent = n,
                           .deposition_coefficient = 0.7,
                           .deposition_iterations = 40,
                           .fill_lakes = false});
    const double u = 1e-3, k = 2e-5, dt = 2e4;
    solver.step(flow, z, {.uplift_rate = u, .erodibility = k}, dt, ground.context);
    std::vector<double> flux(z.size(), 0.0);
    const auto order = flow.order();
    for (std::size_t o = order.size(); o-- > 0;) {
      const std::int32_t i = order[o];
      flux[i] += ground.tin.cell_areas[i] * (u - (z[i] - start[i]) / dt);
      flux[flow.receivers()[i]] += flux[i];
      const double area = solver.drainage_area()[i];
      const double slope = std::max(0.0, z[i] - z[flow.receivers()[i]]) / flow.distances()[i];
      const double rate = u - k * std::sqrt(area) * std::pow(slope, n) + 0.7 * flux[i] / area;
      ASSERT_NEAR((z[i] - start[i]) / dt, rate, 1e-9) << i;
    }
  }
}

TEST(TinDeposition, PropertiesHoldOnRandomGround) {
  Context context;
  for (int number = 0; number < 100; ++number) {
    const RandomTin t = random_tin(number, context);
    const std::size_t count = t.tin.size();
    std::vector<double> z = t.elevation, bedrock = z, supply(count);
    for (std::size_t i = 0; i < count; ++i) {
      bedrock[i] -= std::max(0.0, 4.0 * random_uniform(2, 1, i) - 2.0);
      supply[i] = number % 2 && !t.base[i] ? 0.1 * random_uniform(2, 2, i) : 0.0;
    }
    const std::vector<double> rock = bedrock;
    TinFlow flow(t.tin, t.base);
    TinStreamPower solver({.slope_exponent = number % 3 == 0 ? 1.0 : 0.5 + 0.5 * (number % 5),
                           .deposition_coefficient = 0.1 + number % 4,
                           .fill_lakes = number % 5 != 0});
    const double dt = 1e4, u = number % 7 == 0 ? -1e-3 : 1e-3;
    const MassBalance b = solver.step(flow, z, {.uplift_rate = u, .erodibility = 1e-5}, dt, context,
                                      {.bedrock = bedrock, .erodibility = 3e-5, .supply = supply});
    double change = 0.0, given = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(std::isfinite(z[i]));
      ASSERT_LE(bedrock[i], z[i]) << number;
      given += supply[i] * dt;
      if (t.base[i]) {
        ASSERT_EQ(z[i], t.elevation[i]);
        ASSERT_EQ(bedrock[i], rock[i]);
        continue;
      }
      ASSERT_LE(bedrock[i], rock[i] + u * dt + 1e-9);  // rock is not made
      change += (z[i] - t.elevation[i]) * t.tin.cell_areas[i];
      moved += std::fabs(z[i] - t.elevation[i]) * t.tin.cell_areas[i];
    }
    const double throughput = given + moved + std::fabs(b.supplied_m3) + b.eroded_m3;
    ASSERT_LE(std::fabs(b.residual_m3), 1e-12 * throughput) << number;
    ASSERT_NEAR(change, b.supplied_m3 + given - b.exported_m3, 1e-11 * throughput) << number;
    ASSERT_GE(b.exported_m3, 0.0);
  }
}

TEST(TinDeposition, SedimentIsErodedFirstAndRockWithItsOwnErodibility) {
  // Weak sediment, hard rock: thick sediment ends where a run on sediment alone ends, bare rock
  // where one on rock alone does, and what lies between ends on the rock's top.
  Ground ground(250.0, 0.0, 4u);
  for (std::size_t i = 0; i < ground.z.size(); ++i) ground.z[i] = 0.05 * ground.tin.points[i].y;
  const double weak = 1e-4, hard = 3e-6, dt = 1e4;
  TinFlow flow(ground.tin, ground.base);
  TinStreamPower solver({.deposition_coefficient = 1e-9});
  const auto end = [&](double rock, double depth, std::vector<double>& bedrock) {
    std::vector<double> z = ground.z;
    bedrock = z;
    for (double& b : bedrock) b -= depth;
    solver.step(flow, z, {.uplift_rate = 0.0, .erodibility = rock}, dt, ground.context,
                {.bedrock = bedrock, .erodibility = weak});
    return z;
  };
  std::vector<double> bedrock, unused;
  const auto soft = end(weak, 0.0, unused), firm = end(hard, 0.0, unused);
  EXPECT_EQ(end(hard, 1e4, bedrock), soft);
  int held = 0, cut = 0;
  const auto thin = end(hard, 0.5, bedrock);
  for (std::size_t i = 0; i < thin.size(); ++i) {
    if (ground.base[i]) continue;
    const double top = ground.z[i] - 0.5;
    held += thin[i] == top;
    cut += thin[i] < top;
    ASSERT_EQ(bedrock[i], std::min(top, thin[i]));
    ASSERT_GE(thin[i], soft[i] - 1e-9);
    ASSERT_LE(thin[i], firm[i] + 1e-9);
  }
  EXPECT_GT(held, 100);
  EXPECT_GT(cut, 10);
}

TEST(TinDeposition, ALakeFillsAndPassesOnTheRest) {
  Ground ground(250.0, 0.0, 4u);
  const auto in_hollow = [&](std::size_t i) {
    const glm::dvec2 p = ground.tin.points[i];
    return std::hypot(p.x - 5e3, p.y - 3e3) < 1200.0;
  };
  for (std::size_t i = 0; i < ground.z.size(); ++i)
    ground.z[i] = 0.02 * ground.tin.points[i].y - (in_hollow(i) ? 60.0 : 0.0);
  TinFlow flow(ground.tin, ground.base);
  TinStreamPower solver({.deposition_coefficient = 0.5});
  const TinForcing forcing{.uplift_rate = 0.0, .erodibility = 1e-5};
  double last = 0.0;
  for (int i = 0; i < 40; ++i) {
    flow.route(ground.z, ground.context);
    const double pits = double(flow.pit_count());
    const MassBalance b = solver.step(flow, ground.z, forcing, 1e4, ground.context);
    if (i == 0) {
      EXPECT_GT(pits, 0.0);
      EXPECT_LT(b.exported_m3, 0.8 * b.eroded_m3);
    }
    last = b.exported_m3 / b.eroded_m3;
  }
  flow.route(ground.z, ground.context);
  EXPECT_EQ(flow.pit_count(), 0u);
  EXPECT_GT(last, 0.5);
}

TEST(TinDeposition, AFanGrowsBeforeAMountainFront) {
  // The north rises, the south is flat and still: sediment is laid down there, thickest at the
  // front, and the fans' slope falls away from it.
  Ground ground(200.0, 1.0, 4u);
  std::vector<float> uplift(ground.z.size());
  for (std::size_t i = 0; i < uplift.size(); ++i)
    uplift[i] = ground.tin.points[i].y > 4e3 ? 1e-3f : 0.0f;
  std::vector<double> bedrock = ground.z;
  TinFlow flow(ground.tin, ground.base);
  TinStreamPower solver({.minimum_drainage_area = 1e5, .deposition_coefficient = 1.0});
  for (int i = 0; i < 100; ++i)
    solver.step(flow, ground.z,
                {.uplift_rate = std::span<const float>(uplift), .erodibility = 4e-6}, 2e4,
                ground.context, {.bedrock = bedrock, .erodibility = 8e-6});
  const auto mean_depth = [&](double from, double to) {
    double sum = 0.0, area = 0.0;
    for (std::size_t i = 0; i < bedrock.size(); ++i) {
      const double y = ground.tin.points[i].y;
      if (y < from || y > to) continue;
      sum += (ground.z[i] - bedrock[i]) * ground.tin.cell_areas[i];
      area += ground.tin.cell_areas[i];
    }
    return sum / area;
  };
  const double near = mean_depth(2.8e3, 3.8e3), far = mean_depth(0.3e3, 1.3e3);
  EXPECT_GT(near, 20.0);
  EXPECT_GT(near, 1.5 * far);
  EXPECT_GT(far, 1.0);
  EXPECT_LT(mean_depth(4.5e3, 8e3), 0.3 * near);  // the mountains are rock
}

TEST(TinDeposition, ThreadsDoNotMatter) {
  std::vector<double> z, rock;
  for (const int threads : {1, 2, 4}) {
    Ground ground(70.0, 500.0);
    Context context({}, threads);
    context.run([&] {
      std::vector<double> bedrock = ground.z;
      TinFlow flow(ground.tin, ground.base);
      TinStreamPower solver({.slope_exponent = 1.2, .deposition_coefficient = 1.0});
      for (int i = 0; i < 5; ++i)
        solver.step(flow, ground.z, {}, 1e5, context, {.bedrock = bedrock, .erodibility = 1e-6});
      if (threads == 1) {
        z = ground.z;
        rock = bedrock;
      }
      EXPECT_EQ(ground.z, z);
      EXPECT_EQ(bedrock, rock);
    });
  }
}

TEST(TinDeposition, RefusesBadInput) {
  Ground ground(500.0);
  TinFlow flow(ground.tin, ground.base);
  EXPECT_THROW(TinStreamPower({.deposition_coefficient = -1.0}), InputError);
  TinStreamPower solver({.deposition_coefficient = 1.0});
  const std::vector<double> before = ground.z;
  std::vector<double> few(3);
  const auto step = [&](const TinSediment& sediment) {
    solver.step(flow, ground.z, {}, 1e4, ground.context, sediment);
  };
  EXPECT_THROW(step({.bedrock = few}), InputError);
  EXPECT_THROW(step({.supply = few}), InputError);
  EXPECT_THROW(step({.erodibility = -1.0}), InputError);
  EXPECT_EQ(ground.z, before);
}

}  // namespace
}  // namespace orogen
