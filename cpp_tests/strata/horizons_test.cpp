#include "strata/horizons.h"

#include <gtest/gtest.h>

#include "foundation/random.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

const Grid kGrid{21, 17, 100.0, {500.0, -300.0}};

TEST(Horizons, StackUpToTheSurface) {
  Context context;
  const auto column = test::three_layers();
  const HorizonStack stack = initial_horizons(column, kGrid, context);
  ASSERT_EQ(stack.layers(), 3);
  const float expected[] = {-1400.0f, -800.0f, -500.0f, 0.0f};
  for (int k = 0; k <= 3; ++k)
    for (const float h : stack.heights[k].values()) ASSERT_FLOAT_EQ(h, expected[k]);
}

TEST(Horizons, SurfaceOfAnUntouchedBlockIsTheTopLayer) {
  Context context;
  const auto column = test::three_layers();
  const RockTable rocks(column, {}, StrataPalette::Map);
  const float h[] = {-1400.0f, -800.0f, -500.0f, 0.0f};
  EXPECT_EQ(rocks.rock_at(h, 0.0f).layer, 3);
  EXPECT_EQ(rocks.rock_at(h, 0.0f).sub_layer, 1);
  EXPECT_EQ(rocks.rock_at(h, 0.01f).layer, 3);  // rounding
  EXPECT_EQ(rocks.rock_at(h, 5.0f).layer, 4);   // laid down later
  EXPECT_EQ(rocks.lithology(rocks.rock_at(h, 5.0f)), Lithology::Sediment);
}

/// The same by walking up through every sub-layer.
Rock rock_by_walking(const StratigraphicColumn& column, const float* h, double z) {
  const int n = int(column.layers.size());
  if (z > h[n] + kSedimentGap) return {n + 1, 0, 0.0f};
  for (int k = n; k >= 0; --k) {
    const Layer& layer = k == 0 ? column.basement : column.layers[k - 1];
    const double bottom = k == 0 ? h[0] - layer.thickness : h[k - 1];
    if (k > 0 && z <= bottom) continue;
    double whole = 0.0, below = 0.0;
    for (const SubLayer& s : layer.sub_layers) whole += s.share;
    for (int s = 0; s < int(layer.sub_layers.size()); ++s) {
      below += layer.sub_layers[s].share / whole;
      if (z <= bottom + (h[k] - bottom) * below || s + 1 == int(layer.sub_layers.size()))
        return {k, s, float((h[k] - z) / (h[k] - bottom))};
    }
  }
  return {};
}

TEST(Horizons, RockAtAnyHeightIsThatFoundByWalkingUp) {
  for (const auto name : column_names()) {
    const auto column = preset_column(name);
    const RockTable rocks(column, {}, StrataPalette::Map);
    std::vector<float> h(column.layers.size() + 1);
    for (int t = 0; t < 2000; ++t) {
      h[0] = float(-3000.0 + 2000.0 * random_uniform(1, 1, t));
      for (std::size_t k = 1; k < h.size(); ++k)
        h[k] = h[k - 1] + float(1.0 + 900.0 * random_uniform(2, k, t));
      const float z = float(h[0] - 500.0 + (h.back() - h[0] + 700.0) * random_uniform(3, 1, t));
      const Rock rock = rocks.rock_at(h.data(), z), expected = rock_by_walking(column, h.data(), z);
      ASSERT_EQ(rock.layer, expected.layer);
      ASSERT_EQ(rock.sub_layer, expected.sub_layer) << "layer " << rock.layer;
      if (rock.layer > 0 && rock.layer <= rocks.layers()) {
        ASSERT_NEAR(rock.gamma, std::max(expected.gamma, 0.0f), 1e-3);
      }
    }
  }
}

TEST(Horizons, AHorizontalCutShowsOldRockInAnticlinesAndYoungInSynclines) {
  Context context;
  const auto column = test::three_layers();
  const RockTable rocks(column, {}, StrataPalette::Map);
  const Grid grid{81, 3, 50.0, {-2025.0, 0.0}};  // centres from -2000 to 2000
  const HorizonStack stack = test::folded(column, grid, 4000.0, 400.0, context);
  std::vector<float> h(4);
  const auto layer_at = [&](double x, float z) {
    stack.at({x, 75.0}, h.data());
    return rocks.rock_at(h.data(), z).layer;
  };
  const float cut = 500.0f;
  for (double x = 0.0; x < 2000.0; x += 25.0) {
    EXPECT_LE(layer_at(x, cut), layer_at(x + 25.0, cut)) << x;  // from the crest outwards: younger
    EXPECT_EQ(layer_at(x, cut), layer_at(-x, cut)) << x;
  }
  EXPECT_LT(layer_at(0.0, cut), layer_at(2000.0, cut));
}

TEST(Horizons, OlderRockIsDeeper) {
  const RockTable rocks(test::three_layers(), {}, StrataPalette::Map);
  const float h[] = {-1400.0f, -800.0f, -500.0f, 0.0f};
  double last = 0.0;
  for (float z = -1.0f; z > -3000.0f; z -= 7.0f) {
    const double age = rocks.age(rocks.rock_at(h, z), 1e-4);
    EXPECT_GT(age, last);
    last = age;
  }
  EXPECT_NEAR(rocks.age(rocks.rock_at(h, -650.0f), 1e-4), 650.0 / 1e-4, 650.0);
}

TEST(Horizons, ThicknessMapsAreInterpolatedOverTheExtent) {
  Context context;
  auto column = test::three_layers();
  column.layers[1].thickness_map = CornerMap{2, 3, {0, 100, 200, 200, 300, 400}};
  const Raster<float> t = thickness_raster(column.layers[1], kGrid, context);
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c)
      ASSERT_NEAR(t(r, c), 200.0 * (c + 0.5) / 21 + 200.0 * (r + 0.5) / 17, 1e-3);
  const HorizonStack stack = initial_horizons(column, kGrid, context);
  EXPECT_NEAR(stack.heights[2](3, 4) - stack.heights[1](3, 4), t(3, 4), 1e-3);
  EXPECT_NEAR(stack.heights[1](3, 4) - stack.heights[0](3, 4), 600.0, 1e-3);
}

TEST(Horizons, AreInterpolatedBetweenCellsAndHeldAtTheBorder) {
  Context context;
  HorizonStack stack = initial_horizons(test::three_layers(), kGrid, context);
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c) {
      const glm::dvec2 p = kGrid.center(r, c);
      stack.heights[2](r, c) = float(2.0 * p.x - 3.0 * p.y);
    }
  float h[4];
  stack.at({1234.5, 678.9}, h);
  EXPECT_NEAR(h[2], 2.0 * 1234.5 - 3.0 * 678.9, 1e-2);
  EXPECT_FLOAT_EQ(h[3], 0.0f);
  stack.at({-1e6, 1e6}, h);
  EXPECT_FLOAT_EQ(h[2], stack.heights[2](kGrid.ny - 1, 0));
}

}  // namespace
}  // namespace orogen
