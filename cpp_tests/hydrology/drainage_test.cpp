#include "hydrology/drainage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "foundation/errors.h"
#include "hydrology/random_terrains.h"

namespace orogen {
namespace {

constexpr int kTerrains = 120;

TEST(Drainage, AreaAddsUpToRainAndSources) {
  Context context;
  for (int t = 0; t < kTerrains; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    FlowGraph flow(terrain.base);
    flow.route(terrain.elevation, context);
    Raster<float> rain(flow.grid());
    double total = 0.0;
    for (std::size_t i = 0; i < rain.size(); ++i) {
      rain[i] = float(random_uniform(t, 3, i));
      if (!terrain.base[i]) total += flow.grid().cell_area() * rain[i];
    }
    std::vector<AreaSource> sources;
    for (int k = 0; k < 3 && !flow.order().empty(); ++k)
      sources.push_back({flow.order()[flow.order().size() * k / 3], 1000.0 * k});
    for (const AreaSource& s : sources) total += s.area_m2;
    std::vector<double> area(7, 1e30);
    accumulate_drainage_area(flow, area, context, rain, sources);
    double out = 0.0;
    for (std::size_t i = 0; i < area.size(); ++i)
      if (terrain.base[i]) out += area[i];
    EXPECT_NEAR(out, total, 1e-12 * total);
  }
}

TEST(Drainage, AreaIsTheCountOfCellsUpstream) {
  Context context;
  for (int t = 0; t < kTerrains; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    FlowGraph flow(terrain.base);
    flow.route(terrain.elevation, context);
    const Raster<float> area = drainage_area(flow, context);
    std::vector<int> count(area.size());
    for (std::size_t i = 0; i < area.size(); ++i)  // the slow way: walk down from every cell
      if (!terrain.base[i])
        for (std::int32_t at : trace_downstream(flow, std::int32_t(i))) ++count[at];
    for (std::size_t i = 0; i < area.size(); ++i)
      ASSERT_NEAR(area[i], count[i] * flow.grid().cell_area(), 1e-6 * area[i]);
  }
}

TEST(Drainage, SameBytesForAnyThreads) {
  const RandomTerrain terrain = random_terrain(4, {431, 389, 10.0, {}});
  std::vector<double> first;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    FlowGraph flow(terrain.base);
    std::vector<double> area;
    Raster<float> rain(flow.grid());
    for (std::size_t i = 0; i < rain.size(); ++i) rain[i] = float(random_uniform(1, 3, i));
    context.run([&] {
      flow.route(terrain.elevation, context);
      accumulate_drainage_area(flow, area, context, rain);
    });
    if (threads == 1) first = area;
    EXPECT_EQ(area, first);
  }
}

/// Receivers of a small valley network, drawn:
///   five springs; two join twice to order 2, these join to order 3; the fifth joins order 3.
struct Valley {
  Grid grid{7, 6, 10.0, {}};
  Raster<float> z{grid, 100.0f};
  Raster<std::uint8_t> base{grid};
  std::vector<std::int32_t> forced = std::vector<std::int32_t>(42, -1);
  Context context;

  Valley() {
    base(0, 3) = 1;
    z(0, 3) = 0.0f;
    flows(1, 3, 0, 3);
    flows(2, 3, 1, 3);
    flows(3, 2, 2, 3);
    flows(3, 4, 2, 3);
    flows(4, 1, 3, 2);
    flows(4, 3, 3, 2);
    flows(4, 5, 3, 4);
    flows(5, 4, 3, 4 + 0);
    flows(2, 1, 1, 2);
    flows(1, 2, 1, 3);
  }
  void flows(int r, int c, int to_r, int to_c) {
    if (std::abs(r - to_r) > 1 || std::abs(c - to_c) > 1) return;
    forced[grid.index(r, c)] = std::int32_t(grid.index(to_r, to_c));
    z(r, c) = float(r);
  }
};

TEST(Drainage, StrahlerOrderMatchesItsDefinitionOnRandomTerrains) {
  Context context;
  for (int t = 0; t < kTerrains; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    FlowGraph flow(terrain.base);
    flow.route(terrain.elevation, context);
    const Raster<float> area = drainage_area(flow, context);
    const double least = 3.0 * flow.grid().cell_area();
    const Raster<std::int32_t> order = strahler_order(flow, area, least, context);
    for (std::int32_t i : flow.order()) {
      int highest = 0, times = 0;
      for (std::size_t d = 0; d < area.size(); ++d)
        if (!terrain.base[d] && flow.receiver(std::int32_t(d)) == i && order[d] > 0) {
          if (order[d] > highest) highest = order[d], times = 0;
          times += order[d] == highest;
        }
      const int expected = area[i] < least ? 0 : highest == 0 ? 1 : highest + (times > 1);
      ASSERT_EQ(order[i], expected);
      if (flow.order().size() > 2000) break;
    }
  }
}

TEST(Drainage, WatershedsAreTheCellsOfOneOutlet) {
  Context context;
  for (int t = 0; t < kTerrains; ++t) {
    const RandomTerrain terrain = random_terrain(t);
    FlowGraph flow(terrain.base);
    flow.route(terrain.elevation, context);
    const Raster<std::int32_t> label = watershed_labels(flow, context);
    for (std::int32_t i : flow.order())
      ASSERT_EQ(label[i], label[trace_downstream(flow, i).back()]);
    for (std::size_t i = 0; i < label.size(); ++i)
      ASSERT_EQ(label[i] >= 0, !terrain.base[i] || flow.donors(std::int32_t(i)) != 0);
  }
}

TEST(Drainage, LengthChiAndMainStem) {
  Valley v;
  FlowGraph flow(v.base);
  flow.force_receivers(v.forced);
  flow.route(v.z, v.context);
  const Raster<float> area = drainage_area(flow, v.context);
  const Raster<float> length = flow_length(flow, v.context);
  EXPECT_NEAR(length(1, 3), 10.0, 1e-4);
  EXPECT_NEAR(length(4, 1), 20.0 + 20.0 * std::sqrt(2.0), 1e-4);
  const Raster<float> chi = chi_transform(flow, area, 100.0, 0.0, v.context);
  for (std::size_t i = 0; i < chi.size(); ++i) EXPECT_FLOAT_EQ(chi[i], length[i]);
  const auto stem = trace_main_stem(flow, area, std::int32_t(v.grid.index(0, 3)));
  EXPECT_EQ(stem[1], std::int32_t(v.grid.index(1, 3)));
  for (std::size_t k = 1; k < stem.size(); ++k) {
    EXPECT_EQ(flow.receiver(stem[k]), stem[k - 1]);
    EXPECT_LT(area[stem[k]], area[stem[k - 1]]);
  }
  EXPECT_EQ(flow.donors(stem.back()), 0);
}

TEST(Drainage, RefusesBadSources) {
  Valley v;
  FlowGraph flow(v.base);
  flow.route(v.z, v.context);
  const AreaSource outside[] = {{42, 1.0}}, negative[] = {{3, -1.0}};
  EXPECT_THROW(drainage_area(flow, v.context, 1.0, outside), InputError);
  EXPECT_THROW(drainage_area(flow, v.context, 1.0, negative), InputError);
  EXPECT_THROW(drainage_area(flow, v.context, Raster<float>(Grid{2, 2, 1.0, {}})), InputError);
}

}  // namespace
}  // namespace orogen
