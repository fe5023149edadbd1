#include "hydrology/tin_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "foundation/errors.h"
#include "hydrology/random_tins.h"

namespace orogen {
namespace {

/// Height of the lowest way out of each vertex, by priority flood.
std::vector<double> spill_levels(const RandomTin& t) {
  using Item = std::pair<double, std::int32_t>;
  std::vector<double> level(t.tin.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  for (std::int32_t v = 0; v < std::int32_t(level.size()); ++v)
    if (t.base[v]) open.push({level[v] = t.elevation[v], v});
  while (!open.empty()) {
    const auto [height, v] = open.top();
    open.pop();
    if (height > level[v]) continue;
    for (std::int32_t n : t.tin.neighbors_of(v)) {
      const double reached = std::max(height, t.elevation[n]);
      if (reached < level[n] && !t.base[n]) open.push({level[n] = reached, n});
    }
  }
  return level;
}

TEST(TinFlow, EveryVertexDrainsOverNoHigherPassThanItMust) {
  Context context;
  for (int number = 0; number < 200; ++number) {
    SCOPED_TRACE(number);
    const RandomTin t = random_tin(number, context);
    TinFlow flow(t.tin, t.base);
    flow.route(t.elevation, context);
    const auto level = spill_levels(t);
    for (std::int32_t v = 0; v < std::int32_t(t.tin.size()); ++v) {
      double highest = t.elevation[v];
      std::int32_t at = v;
      std::size_t steps = 0;
      for (; !t.base[at]; at = flow.receivers()[at]) {
        ASSERT_LT(steps++, t.tin.size());
        highest = std::max(highest, t.elevation[flow.receivers()[at]]);
      }
      ASSERT_EQ(flow.receivers()[at], at);
      if (!t.base[v]) {
        ASSERT_EQ(highest, level[v]) << v;
      }
    }
  }
}

TEST(TinFlow, WithoutHollowsReceiversAreTheSteepestNeighbors) {
  Context context;
  for (int number = 0; number < 100; ++number) {
    RandomTin t = random_tin(number, context);
    const glm::dvec2 slope{random_uniform(number, 1, 1) - 0.5, random_uniform(number, 1, 2) - 0.5};
    for (std::size_t i = 0; i < t.tin.size(); ++i)
      t.elevation[i] = slope.x * t.tin.points[i].x + slope.y * t.tin.points[i].y;
    t.base = side_mask(t.tin, 15u);
    TinFlow flow(t.tin, t.base);
    flow.route(t.elevation, context);
    EXPECT_EQ(flow.pit_count(), 0u);
    for (std::int32_t v = 0; v < std::int32_t(t.tin.size()); ++v) {
      const std::int32_t r = flow.receivers()[v];
      if (t.base[v]) continue;
      const auto fall = [&](std::int32_t to) {
        const glm::dvec2 way = t.tin.points[v] - t.tin.points[to];
        return (t.elevation[v] - t.elevation[to]) / std::hypot(way.x, way.y);
      };
      for (std::int32_t n : t.tin.neighbors_of(v)) ASSERT_LE(fall(n), fall(r) * (1.0 + 1e-6));
    }
  }
}

TEST(TinFlow, OrderHoldsEachVertexOnceAfterItsReceiverAndDistancesAreTrue) {
  Context context;
  for (int number = 0; number < 100; ++number) {
    const RandomTin t = random_tin(number, context);
    TinFlow flow(t.tin, t.base);
    for (int again = 0; again < 2; ++again) flow.route(t.elevation, context);
    const auto receivers = flow.receivers();
    std::vector<std::uint8_t> seen = t.base;
    for (std::int32_t v : flow.order()) {
      ASSERT_FALSE(seen[v]);
      ASSERT_TRUE(seen[receivers[v]]);
      seen[v] = 1;
      const glm::dvec2 way = t.tin.points[v] - t.tin.points[receivers[v]];
      ASSERT_FLOAT_EQ(flow.distances()[v], float(std::hypot(way.x, way.y)));
    }
    ASSERT_TRUE(std::ranges::all_of(seen, [](std::uint8_t s) { return s != 0; }));
    flow.visit(context, [&](const FlowTrees& part, std::size_t) {
      for (std::size_t k = part.roots; k < part.vertices.size(); ++k)
        ASSERT_EQ(part.vertices[part.parents[k]], receivers[part.vertices[k]]);
    });
  }
}

TEST(TinFlow, AllWaterReachesBaseLevel) {
  Context context;
  for (int number = 0; number < 100; ++number) {
    const RandomTin t = random_tin(number, context);
    TinFlow flow(t.tin, t.base);
    flow.route(t.elevation, context);
    std::vector<float> rain(t.tin.size());
    for (std::size_t i = 0; i < rain.size(); ++i) rain[i] = float(random_uniform(number, 2, i));
    const auto area = drainage_area(flow, context), wet = drainage_area(flow, context, {rain});
    std::vector<double> expected(t.tin.size(), 0.0);  // each vertex walks its water down
    double fallen = 0.0, arrived = 0.0, rained = 0.0, rain_arrived = 0.0;
    for (std::int32_t v = 0; v < std::int32_t(t.tin.size()); ++v) {
      if (t.base[v]) {
        arrived += area[v];
        rain_arrived += wet[v];
        continue;
      }
      fallen += t.tin.cell_areas[v];
      rained += t.tin.cell_areas[v] * rain[v];
      std::int32_t at = v;
      for (; !t.base[at]; at = flow.receivers()[at]) expected[at] += t.tin.cell_areas[v];
      expected[at] += t.tin.cell_areas[v];
    }
    ASSERT_NEAR(arrived, fallen, 1e-12 * fallen);
    ASSERT_NEAR(rain_arrived, rained, 1e-12 * rained + 1e-12);
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_NEAR(area[i], expected[i], 1e-12 * expected[i]);
  }
}

TEST(TinFlow, AFlatIsCrossedByTheFewestEdges) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {3000, 3000}}, 100.0, 3, context);
  const auto base = side_mask(tin, kWestSide);
  TinFlow flow(tin, base);
  flow.route(std::vector<double>(tin.size(), 7.0), context);
  EXPECT_EQ(flow.pit_count(), 0u);
  std::vector<int> edges(tin.size(), -1);
  std::vector<std::int32_t> queue;
  for (std::int32_t v = 0; v < std::int32_t(tin.size()); ++v)
    if (base[v]) {
      edges[v] = 0;
      queue.push_back(v);
    }
  for (std::size_t done = 0; done < queue.size(); ++done)
    for (std::int32_t n : tin.neighbors_of(queue[done]))
      if (edges[n] < 0) {
        edges[n] = edges[queue[done]] + 1;
        queue.push_back(n);
      }
  for (std::int32_t v : flow.order()) ASSERT_EQ(edges[flow.receivers()[v]], edges[v] - 1);
}

TEST(TinFlow, ThreadsDoNotMatter) {
  Context maker;
  const Tin tin = poisson_tin({{0, 0}, {9000, 7000}}, 60.0, 5, maker);
  std::vector<double> z(tin.size());
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = std::floor(50.0 * random_uniform(3, 3, i));
  std::vector<std::int32_t> receivers, order;
  std::vector<double> area;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      TinFlow flow(tin, side_mask(tin, 15u));
      flow.route(z, context);
      const std::vector<std::int32_t> r(flow.receivers().begin(), flow.receivers().end());
      if (threads == 1) {
        receivers = r;
        order = flow.order();
        area = drainage_area(flow, context);
      }
      EXPECT_EQ(r, receivers);
      EXPECT_EQ(flow.order(), order);
      EXPECT_EQ(drainage_area(flow, context), area);
    });
  }
}

TEST(TinFlow, RefusesWhatItCannotRoute) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {1000, 1000}}, 200.0, 3, context);
  std::vector<std::uint8_t> base(tin.size(), 0);
  EXPECT_THROW(TinFlow(tin, base), InputError);
  base[0] = 1;
  EXPECT_THROW(TinFlow(tin, std::span(base).first(3)), InputError);
  TinFlow flow(tin, base);
  std::vector<double> z(tin.size(), 1.0);
  EXPECT_THROW(flow.route(std::span(z).first(3), context), InputError);
  const std::vector<float> rain(3);
  flow.route(z, context);
  EXPECT_THROW(drainage_area(flow, context, {rain}), InputError);
  z[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(flow.route(z, context), InputError);
  z[4] = 1.0;
  z[0] = -std::numeric_limits<double>::infinity();
  EXPECT_THROW(flow.route(z, context), InputError);
  EXPECT_NO_THROW(TinFlow(tin, std::vector<std::uint8_t>(tin.size(), 1))
                      .route(std::vector<double>(tin.size(), 0.0), context));
}

}  // namespace
}  // namespace orogen
