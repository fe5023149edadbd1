#include "erosion/mountain_growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "erosion/range.h"
#include "foundation/errors.h"

namespace orogen {
namespace {

TEST(MountainGrowth, HorizonsRiseByTheirRates) {
  Range range;
  range.parameters.initial_relief = 0.0;
  const MountainGrowth made = range.grow();
  ASSERT_EQ(made.horizons.layers(), 2);
  EXPECT_EQ(made.years, 2e6);
  for (int r = 2; r + 2 < range.grid.ny; ++r) {
    const double y = (r + 0.5) / range.grid.ny;
    if (std::fabs(y - 0.25) < 0.05 || std::fabs(y - 0.75) < 0.05) continue;  // the rates' steps
    const double lift = 2e6 * range.crust(r, 40), folded = lift + 2e6 * range.fold(r, 40);
    EXPECT_NEAR(made.horizons.heights[0](r, 40), lift - 800.0, 3.0);
    EXPECT_NEAR(made.horizons.heights[1](r, 40), lift - 300.0, 3.0);
    EXPECT_NEAR(made.horizons.heights[2](r, 40), folded, 15.0);  // linear in triangles
  }
}

TEST(MountainGrowth, WithoutErosionTheGroundIsTheTopHorizon) {
  Range range;
  range.strength.soft_erodibility = range.strength.hard_erodibility = 1e-12;
  range.rocks = RockTable(range.column, range.strength, StrataPalette::Map);
  range.parameters.landslide_rate = 0.0;
  const MountainGrowth made = range.grow();
  for (int r = 6; r + 6 < range.grid.ny; ++r)  // sides are outlets
    for (int c = 6; c + 6 < range.grid.nx; ++c) {
      ASSERT_NEAR(made.elevation(r, c), made.horizons.heights[2](r, c), 0.5);
      ASSERT_LT(made.exhumation(r, c), 0.5f);
    }
}

TEST(MountainGrowth, ErosionCutsDownAndTheBooksBalance) {
  Range range;
  const MountainGrowth made = range.grow();
  EXPECT_LT(made.balance.relative_residual(), 1e-9);
  EXPECT_GT(made.balance.exported_m3, 0.1 * made.balance.supplied_m3);
  const auto cut = made.exhumation.values();
  EXPECT_GT(*std::max_element(cut.begin(), cut.end()), 300.0f);
  for (const float z : made.elevation.values()) EXPECT_GE(z, -1e-3f);
  const auto area = made.drainage_area.values();
  EXPECT_GT(*std::max_element(area.begin(), area.end()), 5e6f);
}

TEST(MountainGrowth, HarderRockStandsHigher) {
  Range soft, hard;
  hard.strength.soft_erodibility /= 3.0;
  hard.strength.hard_erodibility /= 3.0;
  hard.rocks = RockTable(hard.column, hard.strength, StrataPalette::Map);
  const auto mean = [](const Raster<float>& z) {
    double sum = 0.0;
    for (const float v : z.values()) sum += v;
    return sum / double(z.size());
  };
  EXPECT_GT(mean(hard.grow().elevation), 1.15 * mean(soft.grow().elevation));
}

TEST(MountainGrowth, SameBytesForAnyNumberOfThreads) {
  std::vector<MountainGrowth> made;
  for (const int threads : {1, 2, 4}) {
    Range range;
    range.parameters.diffusivity = 0.02;
    range.input.isostasy.isostasy = Isostasy::Flexure;
    Context context({}, threads);
    context.run([&] { made.push_back(grow_mountains(range.input, range.parameters, 7, context)); });
  }
  for (std::size_t i = 1; i < made.size(); ++i) {
    EXPECT_EQ(made[i].elevation, made[0].elevation);
    EXPECT_EQ(made[i].drainage_area, made[0].drainage_area);
    EXPECT_EQ(made[i].horizons.heights, made[0].horizons.heights);
  }
}

TEST(MountainGrowth, TheLastFrameIsTheEnd) {
  Range range;
  range.parameters.frames = 5;
  const MountainGrowth made = range.grow();
  ASSERT_EQ(made.frames.size(), 5u);
  for (int f = 0; f < 5; ++f) EXPECT_NEAR(made.frames[f].years, 4e5 * (f + 1), 1.0);
  EXPECT_EQ(made.frames.back().elevation, made.elevation);
  const auto highest = [](const Raster<float>& z) {
    return *std::max_element(z.values().begin(), z.values().end());
  };
  for (int f = 1; f < 5; ++f)
    EXPECT_GT(highest(made.frames[f].elevation), highest(made.frames[f - 1].elevation));
}

TEST(MountainGrowth, AWatchSeesItGrowAndChangesNothing) {
  Range alone, watched;
  std::vector<double> years;
  std::vector<float> highest;
  GrowthWatch watch([&](double now, const WatchedGround& ground) {
    EXPECT_EQ(ground.elevation.grid(), GrowthWatch::grid(watched.grid));
    years.push_back(now);
    const auto& z = ground.elevation.values();
    highest.push_back(*std::max_element(z.begin(), z.end()));
  });
  watched.input.watch = &watch;
  EXPECT_EQ(watched.grow().elevation, alone.grow().elevation);
  ASSERT_FALSE(years.empty());
  EXPECT_TRUE(std::is_sorted(years.begin(), years.end()));
  EXPECT_LE(years.back(), 2e6);
  EXPECT_GT(highest.back(), 20.0f);
}

TEST(MountainGrowth, PhasesFollowEachOther) {
  Range once, twice, other;
  for (Range* range : {&once, &twice, &other}) range->parameters.coarse_levels = 0;
  twice.input.phases[0].years = 1e6;
  twice.input.phases.push_back(twice.input.phases[0]);
  const MountainGrowth a = once.grow(), b = twice.grow();
  for (int r = 4; r < 76; ++r)
    EXPECT_NEAR(a.horizons.heights[2](r, 40), b.horizons.heights[2](r, 40), 1.0);
  Raster<float> none(other.grid);  // what lifts nothing leaves the folds of the first phase
  other.input.phases.push_back({.years = 1e6, .crust = &none, .folds = {nullptr, nullptr}});
  const MountainGrowth c = other.grow();
  EXPECT_EQ(c.years, 3e6);
  for (int r = 4; r < 76; ++r)
    EXPECT_NEAR(a.horizons.heights[2](r, 40), c.horizons.heights[2](r, 40), 1.0);
}

TEST(MountainGrowth, ClosedSidesHoldWaterBack) {
  Range range;
  range.parameters.west_side = range.parameters.east_side = MapSide::Closed;
  const MountainGrowth made = range.grow();
  double side = 0.0;
  for (int r = 30; r < 50; ++r) side = std::max<double>(side, made.elevation(r, 0));
  EXPECT_GT(side, 100.0);
  range.parameters.south_side = range.parameters.north_side = MapSide::Closed;
  EXPECT_THROW(range.grow(), InputError);
}

TEST(MountainGrowth, GroundBelowTheSeaSinksAndIsNotCut) {
  Range range;
  for (int r = 0; r < range.grid.ny; ++r)
    for (int c = 0; c < range.grid.nx; ++c)
      if (r < 20) range.crust(r, c) = -1e-3f;
  const MountainGrowth made = range.grow();
  for (int r = 3; r < 15; ++r)
    EXPECT_NEAR(made.elevation(r, 40), -2000.0, 30.0);  // less the hollows that it began with
  for (int r = 26; r < 54; ++r) EXPECT_GE(made.elevation(r, 40), 0.0f);
}

TEST(MountainGrowth, ADippingFaultCarriesAStep) {
  Range range;
  range.strength.soft_erodibility = range.strength.hard_erodibility = 1e-12;
  range.rocks = RockTable(range.column, range.strength, StrataPalette::Map);
  range.parameters.landslide_rate = 0.0;
  range.parameters.coarse_levels = 0;
  Raster<float> still(range.grid), north(range.grid, 2e-3f);
  // First a step is raised at the middle, then it is carried 4 km to the north.
  for (int r = 0; r < range.grid.ny; ++r)
    for (int c = 0; c < range.grid.nx; ++c) range.crust(r, c) = r < 30 ? 5e-4f : 0.0f;
  range.input.phases = {{.years = 2e6, .crust = &range.crust, .folds = {nullptr, nullptr}},
                        {.years = 2e6,
                         .crust = &still,
                         .folds = {nullptr, nullptr},
                         .velocity_x = &still,
                         .velocity_y = &north}};
  const MountainGrowth made = range.grow();
  const auto crossing = [&](const Raster<float>& z) {  // row where it falls below 500 m
    int r = 20;
    while (z(r, 40) > 500.0f) ++r;
    return r - 1 + (z(r - 1, 40) - 500.0f) / (z(r - 1, 40) - z(r, 40));
  };
  EXPECT_NEAR(crossing(made.elevation) - 29.5, 16.0, 0.5);  // 4 km in cells of 250 m
  EXPECT_NEAR(crossing(made.horizons.heights[2]) - 29.5, 16.0, 0.5);
}

TEST(MountainGrowth, ErodedGroundReboundsByArchimedes) {
  Range still, floating;  // without folds, whose growth above the ground is no load
  still.input.phases[0].folds[1] = floating.input.phases[0].folds[1] = nullptr;
  floating.input.isostasy.isostasy = Isostasy::Airy;
  const MountainGrowth a = still.grow(), b = floating.grow();
  double lift = 0.0, cut = 0.0;  // of the basement; what erosion took
  for (int r = 8; r < 72; ++r)   // what leaves by an outlet is not eroded
    for (int c = 8; c < 72; ++c) {
      lift += b.horizons.heights[0](r, c) - a.horizons.heights[0](r, c);
      cut += b.horizons.heights[2](r, c) - b.elevation(r, c);
    }
  EXPECT_NEAR(lift / cut, 2800.0 / 3300.0, 0.06);
}

TEST(MountainGrowth, RefusesWhatCannotGrow) {
  Range range;
  range.input.phases.clear();
  EXPECT_THROW(range.grow(), InputError);
  Range other;
  other.input.phases[0].folds.pop_back();
  EXPECT_THROW(other.grow(), InputError);
  Range third;
  third.parameters.steps = 0;
  EXPECT_THROW(third.grow(), InputError);
}

}  // namespace
}  // namespace orogen
