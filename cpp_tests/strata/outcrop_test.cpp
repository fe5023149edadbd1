#include "strata/outcrop.h"

#include <gtest/gtest.h>

#include "foundation/errors.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

TEST(Outcrop, GivesWhatTheTableSaysOfTheRockThere) {
  Context context;
  const auto column = test::three_layers();
  const RockTable rocks(column, {}, StrataPalette::Natural);
  const Grid grid{64, 5, 100.0, {}};
  const HorizonStack stack = test::folded(column, grid, 3000.0, 500.0, context);
  Raster<float> ground(grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) ground(r, c) = float(1600.0 - 500.0 * r);
  const OutcropMap map = outcrop_map(stack, rocks, ground, 5e6, {}, context);
  std::set<int> met;
  std::vector<float> h(4);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      stack.at(grid.center(r, c), h.data());
      const Rock rock = rocks.rock_at(h.data(), ground(r, c));
      ASSERT_EQ(map.rock_layer(r, c), rock.layer);
      ASSERT_EQ(map.rock_sublayer(r, c), rock.sub_layer);
      ASSERT_EQ(map.erodibility(r, c), rocks.erodibility(rock));
      ASSERT_EQ(std::uint32_t(map.strata_color(r, c)), rocks.color(rock));
      ASSERT_EQ(map.age(r, c), rock.layer > 3 ? 0.0f : float(5e6 + rocks.age(rock, 1e-4)));
      met.insert(rock.layer);
    }
  EXPECT_EQ(met.size(), 5u);  // basement, three layers, and sediment above them
}

TEST(Outcrop, OfAnotherGridIsInterpolated) {
  Context context;
  const auto column = test::three_layers();
  const RockTable rocks(column, {}, StrataPalette::Natural);
  const HorizonStack stack = initial_horizons(column, Grid{4, 4, 400.0, {}}, context);
  const Raster<float> ground(Grid{16, 16, 100.0, {}}, -600.0f);
  const OutcropMap map = outcrop_map(stack, rocks, ground, 0.0, {}, context);
  for (const int layer : map.rock_layer.values()) EXPECT_EQ(layer, 2);
}

TEST(Outcrop, RefusesHorizonsOfAnotherColumn) {
  Context context;
  auto column = test::three_layers();
  const HorizonStack stack = initial_horizons(column, Grid{4, 4, 400.0, {}}, context);
  column.layers.pop_back();
  const RockTable rocks(column, {}, StrataPalette::Natural);
  EXPECT_THROW(outcrop_map(stack, rocks, Raster<float>(stack.grid()), 0.0, {}, context),
               InputError);
}

}  // namespace
}  // namespace orogen
