#include "hydrology/flow_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <queue>

#include "foundation/errors.h"
#include "hydrology/depressions.h"
#include "hydrology/drainage.h"
#include "hydrology/random_terrains.h"

namespace orogen {
namespace {

constexpr int kTerrains = 120;

/// Each cell that is not base level once, after its receiver.
void expect_order(const FlowGraph& flow) {
  std::vector<int> position(flow.grid().size(), -1);
  int k = 0;
  for (std::int32_t i : flow.order()) {
    ASSERT_FALSE(flow.is_base(i));
    ASSERT_EQ(position[i], -1);
    const std::int32_t r = flow.receiver(i);
    ASSERT_TRUE(flow.is_base(r) || position[r] >= 0);
    position[i] = k++;
  }
  for (std::size_t i = 0; i < position.size(); ++i)
    ASSERT_EQ(position[i] < 0, flow.is_base(std::int32_t(i)));
}

/// Blocks cover the order; those of a round depend on earlier rounds only.
void expect_rounds(const FlowGraph& flow) {
  std::vector<int> done(flow.grid().size(), -1);  // block
  int block = 0, next = 0;
  for (std::size_t r = 0; r < flow.rounds(); ++r) {
    const int first = block;
    for (const FlowBlock& b : flow.round(r)) {
      ASSERT_EQ(b.begin, next);
      next = b.end;
      for (int k = b.begin; k < b.end; ++k) {
        const std::int32_t i = flow.order()[k], to = flow.receiver(i);
        if (k < b.heads_end)
          ASSERT_TRUE(flow.is_base(to) || (done[to] >= 0 && done[to] < first));
        else
          ASSERT_EQ(done[to], block);
        done[i] = block;
      }
      ++block;
    }
  }
  ASSERT_EQ(next, int(flow.order().size()));
}

/// Spill levels by flooding from base level, the slow way.
std::vector<float> flooded(const Raster<float>& z, const Raster<std::uint8_t>& base) {
  const Grid& g = z.grid();
  std::vector<float> level(z.size(), std::numeric_limits<float>::infinity());
  using Entry = std::pair<float, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t i = 0; i < z.size(); ++i)
    if (base[i]) open.push({level[i] = z[i], int(i)});
  while (!open.empty()) {
    const auto [h, i] = open.top();
    open.pop();
    if (h > level[i]) continue;
    const int r = i / g.nx, c = i % g.nx;
    for (int dr = -1; dr <= 1; ++dr)
      for (int dc = -1; dc <= 1; ++dc) {
        if (!g.contains(r + dr, c + dc)) continue;
        const std::size_t j = g.index(r + dr, c + dc);
        const float up = std::max(h, z[j]);
        if (!base[j] && up < level[j]) open.push({level[j] = up, int(j)});
      }
  }
  return level;
}

TEST(FlowGraph, EveryCellDrainsOnceAndInOrderOnAnyTerrain) {
  Context context;
  for (int t = 0; t < kTerrains; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    FlowGraph flow(terrain.base);
    flow.route(terrain.elevation, context);
    expect_order(flow);
    expect_rounds(flow);
  }
}

TEST(FlowGraph, WaterCrossesNoHigherPassThanItMust) {
  Context context;
  for (int t = 0; t < kTerrains; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    FlowGraph flow(terrain.base);
    flow.route(terrain.elevation, context);
    Raster<float> level;
    filled_level(flow, terrain.elevation, level, context);
    const std::vector<float> expected = flooded(terrain.elevation, terrain.base);
    for (std::size_t i = 0; i < level.size(); ++i)
      if (!terrain.base[i]) {
        ASSERT_EQ(level[i], expected[i]) << "cell " << i;
      }
  }
}

TEST(FlowGraph, FollowsSteepestDescentWhereThereIsOne) {
  Context context;
  std::size_t steep = 0, turned = 0;
  for (int t = 0; t < kTerrains; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    const Grid& g = terrain.elevation.grid();
    FlowGraph flow(terrain.base);
    flow.route(terrain.elevation, context);
    Raster<float> level;
    filled_level(flow, terrain.elevation, level, context);
    for (int r = 0; r < g.ny; ++r)
      for (int c = 0; c < g.nx; ++c) {
        const std::size_t i = g.index(r, c);
        if (terrain.base[i]) continue;
        double best = 0.0;
        for (int dr = -1; dr <= 1; ++dr)
          for (int dc = -1; dc <= 1; ++dc)
            if (g.contains(r + dr, c + dc) && (dr || dc))
              best = std::max(best,
                              (double(terrain.elevation[i]) - terrain.elevation(r + dr, c + dc)) /
                                  (g.cell_size * std::hypot(dr, dc)));
        const std::int32_t to = flow.receiver(std::int32_t(i));
        const double taken =
            (double(terrain.elevation[i]) - terrain.elevation[to]) / flow.distance(std::int32_t(i));
        // Under water the way out may lead uphill; on dry land it is the steepest.
        if (level[i] > terrain.elevation[i]) {
          turned += taken < best;
          continue;
        }
        if (best > 0.0 && level[to] == terrain.elevation[to]) {
          // A dry cell at a pass may have been turned, as part of the way out of a hollow.
          if (taken < best * (1 - 1e-6)) {
            ++turned;
            continue;
          }
          ++steep;
        }
      }
  }
  EXPECT_GT(steep, 20000u);
  EXPECT_GT(turned, 0u);
}

TEST(FlowGraph, OnATerrainWithoutHollowsEveryReceiverIsTheSteepest) {
  Context context;
  const Grid g{61, 47, 10.0, {}};
  Raster<float> z(g);
  Raster<std::uint8_t> base(g);
  for (int r = 0; r < g.ny; ++r)
    for (int c = 0; c < g.nx; ++c) {
      z(r, c) = float(1000.0 - std::hypot(r - 20.3, 1.7 * (c - 33.1)));  // a cone: no pits
      base(r, c) = r == 0 || c == 0 || r == g.ny - 1 || c == g.nx - 1;
    }
  FlowGraph flow(base);
  flow.route(z, context);
  EXPECT_EQ(flow.pit_count(), 0u);
  for (int r = 1; r + 1 < g.ny; ++r)
    for (int c = 1; c + 1 < g.nx; ++c) {
      double best = -1e9;
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc)
          if (dr || dc)
            best = std::max(best, (double(z(r, c)) - z(r + dr, c + dc)) / std::hypot(dr, dc));
      const std::int32_t i = std::int32_t(g.index(r, c));
      const double taken = (double(z[i]) - z[flow.receiver(i)]) / (flow.distance(i) / 10.0);
      EXPECT_NEAR(taken, best, 1e-6 * best);
    }
}

TEST(FlowGraph, ReceiversDoNotDependOnThreads) {
  for (int t : {0, 4, 7}) {
    const RandomTerrain terrain = random_terrain(t, {431, 389, 10.0, {}});
    std::vector<std::int32_t> order, receivers;
    for (int threads : {1, 2, 4}) {
      Context context({}, threads);
      FlowGraph flow(terrain.base);
      context.run([&] { flow.route(terrain.elevation, context); });
      const auto r = flow.receivers(context);
      if (threads == 1) {
        order.assign(flow.order().begin(), flow.order().end());
        receivers.assign(r.values().begin(), r.values().end());
      }
      EXPECT_TRUE(std::equal(order.begin(), order.end(), flow.order().begin()));
      EXPECT_TRUE(std::equal(receivers.begin(), receivers.end(), r.values().begin()));
    }
  }
}

TEST(FlowGraph, ARouteLeavesNothingBehindForTheNext) {
  Context context;
  const RandomTerrain a = random_terrain(8);
  RandomTerrain b = a;
  for (std::size_t i = 0; i < b.elevation.size(); ++i)
    b.elevation[i] = float(random_uniform(77, 1, i));
  FlowGraph used(a.base), fresh(a.base);
  used.route(a.elevation, context);
  used.route(b.elevation, context);
  fresh.route(b.elevation, context);
  EXPECT_EQ(used.receivers(context), fresh.receivers(context));
}

TEST(FlowGraph, FlatsDrainWithoutAFavouredDirection) {
  Context context;
  const Grid g{201, 201, 1.0, {}};
  Raster<float> z(g, 1.0f);
  Raster<std::uint8_t> base(g);
  for (int k = 0; k < 201; ++k) base(0, k) = base(200, k) = base(k, 0) = base(k, 200) = 1;
  for (std::size_t i = 0; i < z.size(); ++i)
    if (base[i]) z[i] = 0.0f;
  FlowGraph flow(base);
  flow.route(z, context);
  expect_order(flow);
  const Raster<float> length = flow_length(flow, context);
  EXPECT_LT(length(100, 100), 135.0f);  // not far from the shortest way, 100
  int count[8] = {};
  for (std::int32_t i : flow.order()) ++count[flow.direction(i)];
  for (int k = 0; k < 4; ++k)  // the plate is symmetric: opposite directions are as frequent
    EXPECT_NEAR(count[k], count[k + 4], 0.06 * (count[k] + count[k + 4])) << k;
}

TEST(FlowGraph, ForcedReceiversHoldAlsoUphill) {
  Context context;
  const Grid g{9, 5, 1.0, {}};
  Raster<float> z(g);
  Raster<std::uint8_t> base(g);
  for (int r = 0; r < 5; ++r) base(r, 8) = 1;
  for (int r = 0; r < 5; ++r)
    for (int c = 0; c < 9; ++c)
      z(r, c) = float(c == 8 ? 0 : 2 + c);  // falls to the west: no outlet
  std::vector<std::int32_t> forced(g.size(), -1);
  for (int c = 0; c < 8; ++c) forced[g.index(2, c)] = std::int32_t(g.index(2, c + 1));
  FlowGraph flow(base);
  flow.force_receivers(forced);
  flow.route(z, context);
  expect_order(flow);
  for (int c = 0; c < 8; ++c)
    EXPECT_EQ(flow.receiver(std::int32_t(g.index(2, c))), forced[g.index(2, c)]);
  EXPECT_EQ(flow.cut_ring_count(), 0u);
  const Raster<float> area = drainage_area(flow, context);
  EXPECT_GE(area(2, 7), 30.0f);  // nearly all of the land takes the drawn river
  flow.force_receivers({});
  flow.route(z, context);
  expect_order(flow);
}

TEST(FlowGraph, RingsAndRandomForcedReceiversStillDrain) {
  Context context;
  std::size_t cut = 0;
  for (int t = 0; t < kTerrains; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    const Grid& g = terrain.elevation.grid();
    std::vector<std::int32_t> forced(g.size(), -1);
    for (std::size_t i = 0; i < g.size(); ++i) {
      if (random_uniform(t, 5, i) > 0.4) continue;
      const int r = int(i) / g.nx + int(random_uniform(t, 6, i) * 3) - 1;
      const int c = int(i) % g.nx + int(random_uniform(t, 7, i) * 3) - 1;
      if (g.contains(r, c) && g.index(r, c) != i) forced[i] = std::int32_t(g.index(r, c));
    }
    FlowGraph flow(terrain.base);
    flow.force_receivers(forced);
    flow.route(terrain.elevation, context);
    expect_order(flow);
    expect_rounds(flow);
    cut += flow.cut_ring_count();
  }
  EXPECT_GT(cut, 100u);
}

TEST(FlowGraph, RandomnessTurnsParallelFlowAside) {
  Context context;
  const Grid g{100, 100, 1.0, {}};
  Raster<float> z(g);
  Raster<std::uint8_t> base(g);
  for (int r = 0; r < 100; ++r)
    for (int c = 0; c < 100; ++c) {
      z(r, c) = float(r + 0.35 * c);
      base(r, c) = r == 0;
    }
  FlowGraph flow(base);
  flow.route(z, context);
  const Raster<std::int32_t> plain = flow.receivers(context);
  flow.set_randomness(1.0, 3);
  flow.route(z, context);
  expect_order(flow);
  int diagonal = 0, inside = 0;
  for (int r = 1; r < 100; ++r)
    for (int c = 1; c < 99; ++c, ++inside) {
      EXPECT_EQ(plain(r, c), std::int32_t(g.index(r - 1, c)) - 0 * c);
      diagonal += flow.receiver(std::int32_t(g.index(r, c))) != plain(r, c);
    }
  EXPECT_NEAR(double(diagonal) / inside, 0.35, 0.05);  // Rho8: the share that the aspect asks for
}

TEST(FlowGraph, SeaAloneIsFineAndNoSeaIsRefused) {
  Context context;
  const Grid g{4, 3, 1.0, {}};
  FlowGraph sea(Raster<std::uint8_t>(g, 1));
  sea.route(Raster<float>(g), context);
  EXPECT_TRUE(sea.order().empty());
  EXPECT_THROW(FlowGraph(Raster<std::uint8_t>(g, 0)), InputError);
}

TEST(FlowGraph, RefusesBadInputAndNamesThePlace) {
  Context context;
  const Grid g{4, 3, 1.0, {}};
  Raster<std::uint8_t> base(g);
  base(0, 0) = 1;
  FlowGraph flow(base);
  Raster<float> z(g);
  z(2, 3) = std::numeric_limits<float>::quiet_NaN();
  try {
    flow.route(z, context);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("row 2, column 3"), std::string::npos);
  }
  EXPECT_THROW(flow.route(Raster<float>(Grid{3, 3, 1.0, {}}), context), InputError);
  std::vector<std::int32_t> forced(g.size(), -1);
  forced[5] = 7;
  EXPECT_THROW(flow.force_receivers(forced), InputError);
  forced[5] = 3;  // beside it in memory, not on the ground
  EXPECT_THROW(flow.force_receivers(forced), InputError);
  forced[5] = 5;
  EXPECT_THROW(flow.force_receivers(forced), InputError);
  EXPECT_THROW(flow.force_receivers(std::vector<std::int32_t>(3, -1)), InputError);
  EXPECT_THROW(flow.set_randomness(1.5), InputError);
}

TEST(FlowGraph, CancelStopsARoute) {
  const RandomTerrain terrain = random_terrain(16);
  Context context;
  FlowGraph flow(terrain.base);
  context.cancel();
  EXPECT_THROW(flow.route(terrain.elevation, context), Cancelled);
}

}  // namespace
}  // namespace orogen
