// Growth's options: meshes, sea, rain, sediment.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "erosion/range.h"
#include "foundation/errors.h"
#include "hydrology/tin_flow.h"

namespace orogen {
namespace {

double mean(const Raster<float>& field, int row_begin, int row_end, int column_begin,
            int column_end) {
  double sum = 0.0;
  for (int r = row_begin; r < row_end; ++r)
    for (int c = column_begin; c < column_end; ++c) sum += field(r, c);
  return sum / ((row_end - row_begin) * (column_end - column_begin));
}
double mean(const Raster<float>& field) {
  return mean(field, 0, field.grid().ny, 0, field.grid().nx);
}

constexpr GrowthMesh kMeshes[] = {GrowthMesh::Jittered, GrowthMesh::PoissonDisc, GrowthMesh::Grid};

TEST(MountainOptions, EveryMeshGrowsAboutTheSameRange) {
  double jittered = 0.0;
  for (const GrowthMesh mesh : kMeshes) {
    Range range;
    range.parameters.mesh = mesh;
    range.parameters.coarse_levels = 2;
    const MountainGrowth made = range.grow();
    EXPECT_LT(made.balance.relative_residual(), 1e-9);
    EXPECT_NEAR(double(made.tin.size()), 6400.0, 650.0);
    for (const float z : made.elevation.values()) ASSERT_GE(z, -1e-3f);
    EXPECT_GT(std::ranges::max(made.drainage_area.values()), 1e7f);
    TinFlow flow(made.tin, side_mask(made.tin, 15u));
    flow.route(made.tin.elevation, range.context);  // it throws if a vertex does not drain
    EXPECT_LT(double(flow.pit_count()), 0.01 * double(made.tin.size()));
    if (mesh == GrowthMesh::Jittered) jittered = mean(made.elevation);
    EXPECT_NEAR(mean(made.elevation), jittered, 0.08 * jittered);
  }
}

TEST(MountainOptions, AGridsCellsAreTheTerrains) {
  Range range;
  range.parameters.mesh = GrowthMesh::Grid;
  const MountainGrowth made = range.grow();
  ASSERT_EQ(made.tin.columns, 80);
  for (std::size_t i = 0; i < made.elevation.size(); ++i)
    ASSERT_EQ(made.elevation[i], float(made.tin.elevation[i]));
  range.parameters.vertices_per_cell = 0.25;
  EXPECT_EQ(range.grow().tin.size(), 1600u);
}

TEST(MountainOptions, SameBytesForAnyNumberOfThreads) {
  for (const GrowthMesh mesh : kMeshes)
    for (const double deposition : {0.0, 1.0}) {
      std::vector<MountainGrowth> made;
      for (const int threads : {1, 2, 4}) {
        Range range;
        Raster<float> rain(range.grid, 1.0f);
        rain(30, 30) = 5.0f;
        range.input.rain = &rain;
        range.parameters.mesh = mesh;
        range.parameters.deposition_coefficient = deposition;
        range.parameters.diffusivity = 0.02;
        Context context({}, threads);
        context.run(
            [&] { made.push_back(grow_mountains(range.input, range.parameters, 7, context)); });
        EXPECT_EQ(made.back().elevation, made.front().elevation);
        EXPECT_EQ(made.back().sediment_thickness, made.front().sediment_thickness);
        EXPECT_EQ(made.back().tin.elevation, made.front().tin.elevation);
      }
    }
}

TEST(MountainOptions, RiversEndAtADrawnCoast) {
  Range range;  // a sea in the west, closed sides: water has no other way out
  Raster<std::uint8_t> sea(range.grid);
  for (int r = 0; r < range.grid.ny; ++r)
    for (int c = 0; c < 30; ++c) sea(r, c) = 1;
  range.input.sea = &sea;
  MountainGrowthParameters& p = range.parameters;
  p.west_side = p.east_side = p.south_side = p.north_side = MapSide::Closed;
  const MountainGrowth made = range.grow();
  for (int r = 0; r < range.grid.ny; ++r)
    for (int c = 0; c < 28; ++c) ASSERT_NEAR(made.elevation(r, c), 0.0, 1e-3);
  for (int r = 25; r < 55; ++r) EXPECT_GT(made.elevation(r, 79), 100.0f);  // a watershed
  std::vector<std::uint8_t> base(made.tin.size());
  for (std::size_t i = 0; i < base.size(); ++i)
    base[i] = made.tin.points[i].x < range.grid.origin.x + 30 * 250.0;
  TinFlow flow(made.tin, base);
  flow.route(made.tin.elevation, range.context);
  const auto area = drainage_area(flow, range.context);
  double to_sea = 0.0;
  for (std::size_t i = 0; i < base.size(); ++i)
    if (base[i]) to_sea += area[i];
  EXPECT_NEAR(to_sea, 50 * 80 * 250.0 * 250.0, 0.02 * 50 * 80 * 250.0 * 250.0);
  EXPECT_GT(made.balance.exported_m3, 0.1 * made.balance.supplied_m3);
}

TEST(MountainOptions, SeaAndRainAreChecked) {
  Range range;
  const Raster<std::uint8_t> everywhere(range.grid, 1), elsewhere(Grid{5, 5, 250.0, {0, 0}});
  const Raster<float> dry(range.grid, -1.0f), small(Grid{5, 5, 250.0, {0, 0}}, 1.0f);
  range.input.sea = &everywhere;
  EXPECT_THROW(range.grow(), InputError);
  range.input.sea = &elsewhere;
  EXPECT_THROW(range.grow(), InputError);
  range.input.sea = nullptr;
  range.input.rain = &small;
  EXPECT_THROW(range.grow(), InputError);
  range.input.rain = &dry;
  EXPECT_THROW(range.grow(), InputError);
}

TEST(MountainOptions, WhereItRainsMoreMoreIsCut) {
  Range even, uneven;
  Raster<float> rain(even.grid), ones(even.grid, 1.0f);
  for (int r = 0; r < rain.grid().ny; ++r)
    for (int c = 0; c < rain.grid().nx; ++c) rain(r, c) = c < 40 ? 0.2f : 1.8f;
  const MountainGrowth without = even.grow();
  even.input.rain = &ones;
  EXPECT_EQ(even.grow().elevation, without.elevation);
  uneven.input.rain = &rain;
  uneven.input.phases[0].years = 1e6;
  uneven.input.phases.push_back(uneven.input.phases[0]);  // rain lasts through phases
  const MountainGrowth made = uneven.grow();
  const double dry = mean(made.elevation, 20, 60, 2, 36),
               wet = mean(made.elevation, 20, 60, 44, 78);
  EXPECT_GT(dry, 1.2 * wet);
  EXPECT_GT(dry, 1.05 * mean(without.elevation, 20, 60, 2, 36));
  EXPECT_LT(wet, 0.97 * mean(without.elevation, 20, 60, 44, 78));
}

TEST(MountainOptions, SedimentFillsTheForeland) {
  Range plain, filling;
  filling.parameters.deposition_coefficient = 1.0;
  filling.parameters.frames = plain.parameters.frames = 2;
  const MountainGrowth without = plain.grow(), with = filling.grow();
  EXPECT_LT(with.balance.relative_residual(), 1e-12);
  EXPECT_GT(with.balance.deposited_m3, 0.02 * with.balance.eroded_m3);
  EXPECT_LT(std::ranges::max(without.sediment_thickness.values()), 20.0f);
  const double foreland = mean(with.sediment_thickness, 8, 18, 10, 70);
  const double range = mean(with.sediment_thickness, 30, 50, 10, 70);
  EXPECT_GT(foreland, 10.0);
  EXPECT_LT(range, 0.3 * foreland);
  EXPECT_GT(mean(with.elevation, 8, 18, 10, 70), mean(without.elevation, 8, 18, 10, 70) + 5.0);
  const int loose = filling.rocks.number(loose_sediment(filling.rocks));
  int hidden = 0;
  for (int c = 10; c < 70; ++c) {
    hidden += with.frames.back().rock(16, c) == loose;
    EXPECT_EQ(with.frames.back().rock(16, c) == loose, with.sediment_thickness(16, c) >= 1.0f);
  }
  EXPECT_GT(hidden, 40);
  for (std::size_t i = 0; i < with.exhumation.size(); ++i) {
    ASSERT_GE(with.sediment_thickness[i], 0.0f);
    const float bedrock = with.elevation[i] - with.sediment_thickness[i];
    ASSERT_NEAR(with.exhumation[i], std::max(with.horizons.heights.back()[i] - bedrock, 0.0f),
                0.11f);
  }
}

TEST(MountainOptions, SedimentIsCarriedWithTheRockBelow) {
  // A step of sediment before a front moves with rock that a fault carries, and rises with rebound.
  Range range;
  range.parameters.deposition_coefficient = 1.0;
  range.input.isostasy.isostasy = Isostasy::Flexure;
  Raster<float> still(range.grid), north(range.grid, 1e-3f);
  range.input.phases[0].velocity_x = &still;
  range.input.phases[0].velocity_y = &north;
  const MountainGrowth made = range.grow();
  EXPECT_GT(mean(made.sediment_thickness), 0.5);
  for (std::size_t i = 0; i < made.tin.size(); ++i) {
    ASSERT_GE(made.tin.sediment_thickness[i], 0.0);
    if (made.tin.sides[i]) {
      ASSERT_LT(made.tin.sediment_thickness[i], 1e-9);
    }
  }
}

}  // namespace
}  // namespace orogen
