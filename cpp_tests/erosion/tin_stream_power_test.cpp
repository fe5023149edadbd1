#include "erosion/tin_stream_power.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "erosion/stream_power.h"
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

TEST(TinStreamPower, RefusesForcingBelowZeroAndNamesThePlace) {
  Ground g(500.0);
  TinFlow flow(g.tin, g.base);
  TinStreamPower solver({});
  const std::vector<double> before = g.z;
  const auto refusal = [&](const TinForcing& forcing) -> std::string {
    try {
      solver.step(flow, g.z, forcing, 1e4, g.context);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  std::vector<float> values(g.z.size(), 1e-6f);
  values[17] = -1.0f;
  values[29] = -2.0f;
  const VertexValues bad{std::span<const float>(values)};
  EXPECT_EQ(refusal({.erodibility = bad}).find("erodibility: -1 at vertex 17"), 0u);
  EXPECT_EQ(refusal({.rain_weight = bad}).find("rain_weight: -1 at vertex 17"), 0u);
  EXPECT_EQ(refusal({.talus_slope = bad}).find("talus_slope: -1 at vertex 17"), 0u);
  EXPECT_EQ(refusal({.erodibility = -1e-6}).find("erodibility: -1e-06 is not allowed"), 0u);
  values[3] = std::nanf("");
  EXPECT_EQ(refusal({.uplift_rate = bad}).find("uplift_rate: nan at vertex 3"), 0u);
  EXPECT_EQ(g.z, before);
  values[3] = values[17] = values[29] = 0.0f;
  EXPECT_EQ(refusal({.erodibility = bad}), "");
}

/// Ground that falls to the south, without pits, on a grid.
struct Slope {
  Context context;
  Grid grid{60, 45, 100.0, {500.0, -300.0}};
  Raster<float> elevation{grid};
  Raster<std::uint8_t> base_cells{grid};
  Tin tin = grid_tin({grid.origin, {grid.width(), grid.height()}}, grid.nx, grid.ny);
  std::vector<std::uint8_t> base = side_mask(tin, kSouthSide);
  std::vector<double> z;

  Slope() {
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const int r = int(i) / grid.nx;
      base_cells[i] = r == 0;
      elevation[i] = r == 0 ? 0.0f : float(5.0 * r + 4.0 * random_uniform(3, 1, i));
    }
    z.assign(elevation.values().begin(), elevation.values().end());
  }
};

TEST(TinStreamPower, OnAGridAStepIsThatOfTheGridsSolver) {
  Slope s;
  TinFlow flow(s.tin, s.base);
  FlowGraph graph(s.base_cells);
  TinStreamPower on_tin({.minimum_drainage_area = 3e4});
  StreamPower on_grid({.minimum_drainage_area = 3e4});
  on_tin.step(flow, s.z, {.uplift_rate = 1e-3, .erodibility = 2e-5}, 1e4, s.context);
  on_grid.step(graph, s.elevation, {.uplift_rate = 1e-3, .erodibility = 2e-5}, 1e4, s.context);
  ASSERT_EQ(flow.pit_count(), 0u);
  for (std::size_t i = 0; i < s.z.size(); ++i) {
    if (s.base[i]) continue;
    ASSERT_EQ(flow.receivers()[i], graph.receiver(std::int32_t(i))) << i;
    ASSERT_EQ(on_tin.drainage_area()[i], on_grid.drainage_area()[i]) << i;
    ASSERT_NEAR(s.z[i], s.elevation[i], 1e-6 * s.z[i]) << i;  // the grid's heights are float
  }
}

TEST(TinStreamPower, OnAGridAStepIsThatOfASlowLoop) {
  Slope s;
  const std::vector<double> start = s.z;
  const double u = 1e-3, k = 2e-5, dt = 1e4;
  TinFlow flow(s.tin, s.base);
  TinStreamPower solver({});
  solver.step(flow, s.z, {.uplift_rate = u, .erodibility = k}, dt, s.context);
  std::vector<std::size_t> down(start.size());
  std::vector<double> length(start.size()), area(start.size(), 1e4), z = start;
  for (std::size_t i = 0; i < start.size(); ++i) {
    double steepest = 0.0;
    for (int south = -1; south <= 1; ++south)
      for (int west = -1; west <= 1; ++west) {
        const int r = int(i) / 60 + south, c = int(i) % 60 + west;
        if (!s.grid.contains(r, c) || (south == 0 && west == 0)) continue;
        const double way = south != 0 && west != 0 ? double(float(100.0 * std::sqrt(2.0))) : 100.0;
        const double slope = (start[i] - start[s.grid.index(r, c)]) / way;
        if (slope <= steepest) continue;
        steepest = slope;
        down[i] = s.grid.index(r, c);
        length[i] = way;
      }
  }
  std::vector<std::size_t> rising(start.size());
  std::iota(rising.begin(), rising.end(), 0u);
  std::ranges::sort(rising, [&](auto a, auto b) { return start[a] < start[b]; });
  for (std::size_t o = rising.size(); o-- > 0;)
    if (!s.base[rising[o]]) area[down[rising[o]]] += area[rising[o]];
  for (const std::size_t i : rising) {
    if (s.base[i]) continue;
    const double pull = k * std::sqrt(area[i]) / length[i] * dt;
    z[i] = (start[i] + u * dt + pull * z[down[i]]) / (1.0 + pull);
    ASSERT_NEAR(s.z[i], z[i], 1e-9 * z[i]);
  }
}

TEST(TinStreamPower, EveryMeshKeepsTheSlopeAreaLaw) {
  Context context;
  const TinDomain domain{{0, 0}, {10e3, 8e3}};
  for (const Tin& tin : {jittered_tin(domain, 200.0, 1, context),
                         poisson_tin(domain, 200.0, 1, context), grid_tin(domain, 50, 40)}) {
    const auto base = side_mask(tin, 15u);
    std::vector<double> z(tin.size(), 0.0);
    for (std::size_t i = 0; i < z.size(); ++i)
      if (!base[i]) z[i] = random_uniform(1, 1, i);
    TinFlow flow(tin, base);
    TinStreamPower solver({});
    const double u = 1e-3, k = 1e-5;
    for (int i = 0; i < 300; ++i)
      solver.step(flow, z, {.uplift_rate = u, .erodibility = k}, i < 200 ? 1e5 : 1e6, context);
    EXPECT_EQ(flow.pit_count(), 0u);
    for (const std::int32_t i : flow.order()) {
      const double slope = (z[i] - z[flow.receivers()[i]]) / flow.distances()[i];
      ASSERT_NEAR(slope * std::sqrt(solver.drainage_area()[i]) * k / u, 1.0, 1e-3) << i;
    }
  }
}

}  // namespace
}  // namespace orogen
