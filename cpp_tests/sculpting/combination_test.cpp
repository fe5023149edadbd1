#include "sculpting/combination.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/distance_transform.h"
#include "foundation/errors.h"
#include "foundation/noise.h"
#include "hydrology/river_beds.h"

namespace orogen {
namespace {

// Land with the sea in the west, a river from east to west through its middle, and noise as folds.
struct Case {
  VectorMap map;
  Raster<std::uint8_t> land;
  Raster<float> folds;
  WatershedMap watershed;
};

Case make_case(std::uint32_t seed, int resolution, double level, const Context& context) {
  Case c;
  c.map.frame.size = glm::dvec2(40e3);
  c.map.rivers.push_back({{{36e3, 20e3}, {1e3, 20e3}}, RiverEnd::Sea, -1, {}, 0, "", -1});
  const Grid grid = grid_over({0.0, 0.0}, c.map.frame.size, resolution);
  c.land = Raster<std::uint8_t>(grid, 1);
  for (int r = 0; r < grid.ny; ++r)
    for (int k = 0; grid.center(r, k).x < 2e3; ++k) c.land(r, k) = 0;
  c.folds = fbm({.seed = seed, .wavelength = 9e3}, grid, context);
  for (float& z : c.folds.values()) z = float(level) + 250.0f * z;
  const auto beds = lay_river_beds(c.map, c.land, 0.0, 1e3, seed);
  c.watershed = watershed_map(c.map, beds, c.land, Raster<float>(grid, 40e3f), {}, context);
  return c;
}

TEST(Combination, IsTheWatershedMapAtRiversAndTheFoldsFarFromThem) {
  const Context context;
  const Case c = make_case(3, 200, 900.0, context);
  CombinationParameters plain;
  plain.reconcile = false;
  const auto h = combine_relief(c.folds, c.watershed, c.land, plain, context);
  for (std::size_t i = 0; i < h.size(); ++i) {
    const float d = c.watershed.river_distance[i];
    if (!c.land[i]) {
      ASSERT_EQ(h[i], 0.0f);
    } else if (d == 0.0f) {
      ASSERT_EQ(h[i], c.watershed.elevation[i]);
    } else if (d >= plain.blend_distance) {
      ASSERT_EQ(h[i], c.folds[i]);
    } else {
      ASSERT_GE(h[i], std::min(c.folds[i], c.watershed.elevation[i]) - 1e-2f);
      ASSERT_LE(h[i], std::max(c.folds[i], c.watershed.elevation[i]) + 1e-2f);
    }
  }
}

// Ground beside the river, 1 to 6 km from it: how often it is lower than the bed.
double share_below_bed(const Case& c, const Raster<float>& h) {
  const Grid& g = h.grid();
  int below = 0, all = 0;
  for (int r = 0; r < g.ny; ++r)
    for (int k = 0; k < g.nx; ++k) {
      const glm::dvec2 p = g.center(r, k);
      const double d = std::fabs(p.y - 20e3);
      if (p.x < 9e3 || p.x > 34e3 || d < 1e3 || d > 6e3) continue;
      ++all;
      below += h(r, k) < c.watershed.elevation(g.row_of(20e3), k);
    }
  return double(below) / all;
}

TEST(Combination, ReconcilingLeavesNoRiverOnADam) {
  const Context context;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Case c = make_case(seed, 160, 100.0, context);  // folds below the river's upper course
    CombinationParameters plain;
    plain.reconcile = false;
    const auto mixed = combine_relief(c.folds, c.watershed, c.land, plain, context);
    const auto agreed = combine_relief(c.folds, c.watershed, c.land, {}, context);
    EXPECT_LT(share_below_bed(c, agreed), 0.02);
    EXPECT_GT(share_below_bed(c, mixed), 5.0 * share_below_bed(c, agreed));
    for (std::size_t i = 0; i < agreed.size(); ++i)
      if (c.watershed.river_distance[i] == 0.0f) {
        ASSERT_NEAR(agreed[i], c.watershed.elevation[i], 0.2f);
      }
  }
}

TEST(Combination, HasNoStepAtTheBlend) {
  const Context context;
  for (bool reconcile : {false, true}) {
    const Case c = make_case(5, 400, 700.0, context);  // cells of 100 m
    CombinationParameters parameters;
    parameters.reconcile = reconcile;
    const auto h = combine_relief(c.folds, c.watershed, c.land, parameters, context);
    float steepest = 0.0f, folds = 0.0f;
    for (int r = 1; r < 400; ++r)
      for (int k = 30; k < 400; ++k) {
        steepest = std::max(steepest, std::fabs(h(r, k) - h(r - 1, k)) / 100.0f);
        folds = std::max(folds, std::fabs(c.folds(r, k) - c.folds(r - 1, k)) / 100.0f);
      }
    EXPECT_LT(steepest, folds + 1.0f);
  }
}

TEST(Combination, SameForAnyNumberOfThreads) {
  Raster<float> first;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      const Case c = make_case(2, 150, 400.0, context);
      const auto h = combine_relief(c.folds, c.watershed, c.land, {}, context);
      if (first.empty()) first = h;
      EXPECT_EQ(h, first);
    });
  }
}

TEST(Combination, SmallGridsAndBadParameters) {
  const Context context;
  for (int resolution : {1, 2, 3, 7}) {
    const Case c = make_case(1, resolution, 300.0, context);
    const auto combined = combine_relief(c.folds, c.watershed, c.land, {}, context);
    for (float z : combined.values()) EXPECT_TRUE(std::isfinite(z));
  }
  const Case c = make_case(1, 20, 300.0, context);
  CombinationParameters bad;
  bad.blend_distance = 0.0;
  EXPECT_THROW(combine_relief(c.folds, c.watershed, c.land, bad, context), InputError);
}

}  // namespace
}  // namespace orogen
