#include "erosion/tin_stream_power.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "foundation/random.h"
#include "hydrology/random_tins.h"

namespace orogen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Rough ground between four sides at sea level.
struct Ground {
  Context context;
  Tin tin;
  std::vector<std::uint8_t> base;
  std::vector<double> z;

  explicit Ground(double spacing, double relief = 10.0, std::uint32_t seed = 1)
      : tin(jittered_tin({{0, 0}, {10e3, 8e3}}, spacing, seed, context)),
        base(side_mask(tin, 15u)),
        z(tin.size(), 0.0) {
    for (std::size_t i = 0; i < z.size(); ++i)
      if (!base[i]) z[i] = relief * random_uniform(seed, 1, i);
  }
};

std::vector<float> random_values(std::size_t count, int stream, double low, double high) {
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = float(low + (high - low) * random_uniform(5, std::uint64_t(stream), i));
  return values;
}

/// The implicit step written down plainly: bisection for each vertex after its receiver.
std::vector<double> step_by_bisection(const TinFlow& flow, std::span<const double> area,
                                      const std::vector<double>& start, const TinForcing& forcing,
                                      double m, double n, double dt) {
  std::vector<double> z = start;
  for (std::int32_t i : flow.order()) {
    const std::int32_t receiver = flow.receivers()[i];
    const double below = z[receiver], risen = start[i] + forcing.uplift_rate.at(i) * dt;
    const double length = flow.distances()[i], k = forcing.erodibility.at(i);
    double low = std::min(below, risen), high = std::max(below, risen);
    for (int b = 0; b < 200; ++b) {
      const double middle = 0.5 * (low + high);
      const double slope = std::max(0.0, (middle - below) / length);
      const double excess = middle - risen + dt * k * std::pow(area[i], m) * std::pow(slope, n);
      (excess > 0 ? high : low) = middle;
    }
    z[i] = risen <= below ? risen : 0.5 * (low + high);
    z[i] = std::min(z[i], below + forcing.talus_slope.at(i) * length);
  }
  return z;
}

TEST(TinStreamPower, AStepAgreesWithBisectionForEverySlopeExponent) {
  for (double n : {0.5, 0.8, 1.0, 1.5, 2.0})
    for (double m : {0.5, 0.35})
      for (double dt : {10.0, 1e4, 1e6, 1e9}) {
        Ground g(200.0, 300.0);
        TinFlow flow(g.tin, g.base);
        const std::vector<double> start = g.z;
        const auto uplift = random_values(g.z.size(), 1, -2e-4, 1e-3);
        const auto k = random_values(g.z.size(), 2, 1e-6, 4e-5);
        const auto talus = random_values(g.z.size(), 3, 0.05, 2.0);
        const TinForcing forcing{
            .uplift_rate = {uplift}, .erodibility = {k}, .talus_slope = {talus}};
        TinStreamPower solver({.area_exponent = m, .slope_exponent = n});
        solver.step(flow, g.z, forcing, dt, g.context);
        const auto expected =
            step_by_bisection(flow, solver.drainage_area(), start, forcing, m, n, dt);
        for (std::size_t i = 0; i < g.z.size(); ++i)
          ASSERT_NEAR(g.z[i], expected[i], 1e-10 * std::max(1.0, std::fabs(expected[i])))
              << "n " << n << ", m " << m << ", dt " << dt;
      }
}

TEST(TinStreamPower, PropertiesHoldOnRandomGround) {
  Context context;
  for (int number = 0; number < 100; ++number) {
    const RandomTin t = random_tin(number, context);
    std::vector<double> z = t.elevation;
    TinFlow flow(t.tin, t.base);
    const double n = number % 3 == 0 ? 1.0 : 0.5 + 0.5 * (number % 5);
    TinStreamPower solver({.slope_exponent = n});
    const MassBalance balance =
        solver.step(flow, z, {.uplift_rate = 1e-3, .erodibility = 1e-5}, 1e4, context);
    ASSERT_LE(balance.relative_residual(), 1e-12) << number;
    double change = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      ASSERT_TRUE(std::isfinite(z[i]));
      change += (z[i] - t.elevation[i]) * t.tin.cell_areas[i];
      const std::int32_t r = flow.receivers()[i];
      if (t.base[i]) {
        ASSERT_EQ(z[i], t.elevation[i]);
        continue;
      }
      ASSERT_LE(z[i], t.elevation[i] + 10.0 + 1e-9);  // no higher than it was lifted
      if (t.elevation[i] + 10.0 > z[r]) {
        ASSERT_GE(z[i], z[r]);  // and not cut below its receiver
      }
    }
    ASSERT_NEAR(balance.supplied_m3 - balance.exported_m3, change,
                1e-12 * (balance.supplied_m3 + balance.eroded_m3));
  }
}

TEST(TinStreamPower, BooksBalanceOverManySteps) {
  Ground g(150.0, 100.0);
  TinFlow flow(g.tin, g.base);
  TinStreamPower solver({.slope_exponent = 1.5});
  double residual = 0.0, supplied = 0.0, exported = 0.0, before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < g.z.size(); ++i) before += g.z[i] * g.tin.cell_areas[i];
  for (int i = 0; i < 300; ++i) {
    const MassBalance b =
        solver.step(flow, g.z, {.uplift_rate = 1e-3, .erodibility = 2e-5}, 1e3, g.context);
    residual += b.residual_m3;
    supplied += b.supplied_m3;
    exported += b.exported_m3;
  }
  for (std::size_t i = 0; i < g.z.size(); ++i) after += g.z[i] * g.tin.cell_areas[i];
  EXPECT_LE(std::fabs(residual), 1e-12 * supplied);
  EXPECT_NEAR(after - before, supplied - exported, 1e-11 * supplied);
}

TEST(TinStreamPower, SteadyStateKeepsTheSlopeAreaLaw) {
  // log s = log(u / k) / n - (m / n) log A, fitted over all vertices.
  for (const auto& [m, n] : {std::pair{0.5, 1.0}, {0.4, 0.8}, {0.6, 1.5}, {0.5, 2.0}}) {
    Ground g(150.0);
    TinFlow flow(g.tin, g.base);
    TinStreamPower solver({.area_exponent = m, .slope_exponent = n});
    const double u = 1e-3, k = 1e-5;
    const TinForcing forcing{.uplift_rate = u, .erodibility = k};
    for (int i = 0; i < 400; ++i) solver.step(flow, g.z, forcing, i < 200 ? 1e5 : 1e6, g.context);
    double count = 0, x1 = 0, y1 = 0, xx = 0, xy = 0;
    for (std::int32_t i : flow.order()) {
      const double rise = g.z[i] - g.z[flow.receivers()[i]];
      const double x = std::log(solver.drainage_area()[i]);
      const double y = std::log(rise / flow.distances()[i]);
      count += 1;
      x1 += x;
      y1 += y;
      xx += x * x;
      xy += x * y;
    }
    const double concavity = -(count * xy - x1 * y1) / (count * xx - x1 * x1);
    EXPECT_NEAR(concavity, m / n, 0.01 * m / n) << n;
    const double steepness = std::exp((y1 + m / n * x1) / count);
    EXPECT_NEAR(steepness, std::pow(u / k, 1.0 / n), 0.01 * std::pow(u / k, 1.0 / n)) << n;
  }
}

TEST(TinStreamPower, AnInfiniteStepIsTheSteadyStateOfItsDrainage) {
  for (double n : {0.7, 1.0, 2.0}) {
    Ground g(200.0);
    TinFlow flow(g.tin, g.base);
    TinStreamPower solver({.slope_exponent = n, .minimum_drainage_area = 1e5});
    const double u = 1e-3, k = 1e-5;
    const MassBalance balance =
        solver.step(flow, g.z, {.uplift_rate = u, .erodibility = k}, kInfinity, g.context);
    EXPECT_LE(balance.relative_residual(), 1e-12);
    for (std::int32_t i : flow.order()) {
      const double area = std::max(1e5, solver.drainage_area()[i]);
      const double slope = std::pow(u / (k * std::sqrt(area)), 1.0 / n);
      const double rise = slope * flow.distances()[i];
      ASSERT_NEAR(g.z[i] - g.z[flow.receivers()[i]], rise, 1e-10 * rise);
    }
  }
}

TEST(TinStreamPower, SlopesStayBelowTheTalusSlope) {
  Ground g(150.0, 3000.0);
  TinFlow flow(g.tin, g.base);
  TinStreamPower solver({});
  const auto talus = random_values(g.z.size(), 3, 0.2, 0.8);
  for (int i = 0; i < 5; ++i) {
    solver.step(flow, g.z, {.uplift_rate = 1e-2, .talus_slope = {talus}}, 1e5, g.context);
    for (std::int32_t v : flow.order())
      ASSERT_LE(g.z[v] - g.z[flow.receivers()[v]],
                double(talus[v]) * flow.distances()[v] * (1.0 + 1e-9) + 1e-9);
  }
}

TEST(TinStreamPower, ThreadsDoNotMatter) {
  std::vector<double> z, area;
  for (int threads : {1, 2, 4}) {
    Ground g(70.0, 500.0, 3);
    Context context({}, threads);
    context.run([&] {
      TinFlow flow(g.tin, g.base);
      TinStreamPower solver({.slope_exponent = 1.2});
      for (int i = 0; i < 5; ++i) solver.step(flow, g.z, {}, 1e5, context);
      const std::vector<double> a(solver.drainage_area().begin(), solver.drainage_area().end());
      if (threads == 1) {
        z = g.z;
        area = a;
      }
      EXPECT_EQ(g.z, z);
      EXPECT_EQ(a, area);
    });
  }
}

TEST(TinStreamPower, RefusesBadInput) {
  Ground g(500.0);
  TinFlow flow(g.tin, g.base);
  EXPECT_THROW(TinStreamPower({.slope_exponent = 0.1}), InputError);
  EXPECT_THROW(TinStreamPower({.area_exponent = -1.0}), InputError);
  TinStreamPower solver({});
  const std::vector<double> before = g.z;
  const std::vector<float> few(3);
  EXPECT_THROW(solver.step(flow, g.z, {}, 0.0, g.context), InputError);
  EXPECT_THROW(solver.step(flow, g.z, {}, std::nan(""), g.context), InputError);
  EXPECT_THROW(solver.step(flow, g.z, {.uplift_rate = {few}}, 1.0, g.context), InputError);
  EXPECT_THROW(solver.step(flow, g.z, {.talus_slope = {few}}, 1.0, g.context), InputError);
  EXPECT_THROW(solver.step(flow, std::span(g.z).first(5), {}, 1.0, g.context), InputError);
  EXPECT_EQ(g.z, before);
}

}  // namespace
}  // namespace orogen
