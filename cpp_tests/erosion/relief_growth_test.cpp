#include "erosion/relief_growth.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <thread>

#include "foundation/disc.h"
#include "foundation/gaussian_blur.h"
#include "foundation/resample.h"
#include "hydrology/regional_height.h"
#include "support_island.h"

namespace orogen {
namespace {

ReliefGrowthParameters quick() {
  ReliefGrowthParameters p;
  p.coarsest_cells = 64;
  p.coarse_steps = 30;
  p.fit_radius = 2000.0;
  p.range_reach = 4000.0;
  p.peak_reach = 2000.0;
  return p;
}

struct Grown {
  VectorMap map;
  Grid grid;
  Raster<std::uint8_t> land;
  Raster<float> aim;
  ReliefGrowth relief;
};

Grown grow(int seed, int n, ReliefGrowthParameters parameters = quick(), int threads = 0) {
  Context context({}, threads);
  Grown g;
  g.map = test::island(seed);
  g.grid = test::island_grid(g.map, n);
  g.land = test::island_land(g.map, g.grid);
  g.aim = Raster<float>(g.grid);
  for (int r = 0; r < g.grid.ny; ++r)
    for (int c = 0; c < g.grid.nx; ++c)
      for (const Peak& peak : g.map.peaks) {
        const glm::dvec2 d = g.grid.center(r, c) - peak.position;
        g.aim(r, c) =
            std::max(g.aim(r, c),
                     float(40.0 + 0.6 * *peak.height_m * std::exp(-std::hypot(d.x, d.y) / 4e3)));
      }
  const RiverBeds beds = lay_river_beds(g.map, g.land, 60.0, 2000.0, seed);
  context.run(
      [&] { g.relief = grow_relief(g.map, g.aim, g.land, beds, parameters, seed, context); });
  return g;
}

Raster<float> smooth_on_land(const Raster<float>& field, const Raster<std::uint8_t>& land) {
  Context context;
  Raster<float> masked(field.grid()), share(field.grid());
  for (std::size_t i = 0; i < field.size(); ++i) {
    masked[i] = land[i] ? field[i] : 0.0f;
    share[i] = land[i] ? 1.0f : 0.0f;
  }
  masked = gaussian_blur(masked, 2000.0, context);
  share = gaussian_blur(share, 2000.0, context);
  for (std::size_t i = 0; i < field.size(); ++i) masked[i] /= std::max(share[i], 1e-3f);
  return masked;
}

TEST(ReliefGrowth, FollowsTheRegionalHeightAtLargeScale) {
  for (int seed = 0; seed < 4; ++seed) {
    Context context;
    const Grown g = grow(seed, 128);
    const auto beds = lay_river_beds(g.map, g.land, 60.0, 2000.0, seed);
    const auto got = smooth_on_land(g.relief.elevation, g.land);
    const auto want = smooth_on_land(regional_height(g.map, g.land, beds, context), g.land);
    double error = 0.0, size = 0.0;
    for (std::size_t i = 0; i < g.land.size(); ++i) {
      if (!g.land[i]) {
        EXPECT_EQ(g.relief.elevation[i], 0.0f);
        continue;
      }
      EXPECT_GE(g.relief.elevation[i], 0.0f);
      error += std::pow(got[i] - want[i], 2), size += std::pow(want[i], 2);
    }
    EXPECT_LT(std::sqrt(error / size), 0.35);  // the aim has forms of up to 0.3 on it
  }
}

TEST(ReliefGrowth, HighestGroundAroundAPeakMeetsIt) {
  for (int seed = 0; seed < 4; ++seed) {
    const Grown g = grow(seed, 128);
    for (const Peak& peak : g.map.peaks) {
      float highest = 0.0f;
      for_disc(g.grid, peak.position, 2000.0,
               [&](std::size_t i, double) { highest = std::max(highest, g.relief.elevation[i]); });
      EXPECT_GT(highest, 0.6 * *peak.height_m);
    }
  }
}

TEST(ReliefGrowth, IsASteadyStateOfStreamPower) {
  // Along the flow of a steady state k A^m S = U, or the slope is capped; so erosion never falls
  // short of uplift: the residual of the last step is small against the relief.
  ReliefGrowthParameters p = quick();
  p.finest_steps = 20;
  const Grown once = grow(1, 96, p);
  p.finest_steps = 21;
  const Grown more = grow(1, 96, p);
  double change = 0.0, height = 0.0;
  for (std::size_t i = 0; i < once.land.size(); ++i) {
    change += std::abs(once.relief.elevation[i] - more.relief.elevation[i]);
    height += once.relief.elevation[i];
  }
  EXPECT_LT(change / height, 0.06);
}

TEST(ReliefGrowth, SameBytesForAnyNumberOfThreads) {
  const Grown one = grow(2, 128, quick(), 1);
  for (int threads : {2, 3, 4}) {
    const Grown many = grow(2, 128, quick(), threads);
    EXPECT_EQ(one.relief.elevation, many.relief.elevation);
    EXPECT_EQ(one.relief.drainage_area, many.relief.drainage_area);
  }
}

TEST(ReliefGrowth, TwoResolutionsGrowTheSameLand) {
  Context context;
  const Grown coarse = grow(3, 128), fine = grow(3, 256);
  const auto mean = resample_mean(fine.relief.elevation, coarse.grid, context);
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0, n = 0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    if (!coarse.land[i]) continue;
    const double a = coarse.relief.elevation[i], b = mean[i];
    sa += a, sb += b, saa += a * a, sbb += b * b, sab += a * b, ++n;
  }
  const double correlation =
      (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
  EXPECT_GT(correlation, 0.9);
}

TEST(ReliefGrowth, GrowsWithoutPeaksRiversOrSea) {
  Context context;
  VectorMap map;
  map.frame = {{0, 0}, {5000, 3000}, ""};
  for (int n : {2, 13, 50}) {
    const Grid grid = grid_over(map.frame.origin, map.frame.size, n);
    const Raster<std::uint8_t> land(grid, 1);
    const auto beds = lay_river_beds(map, land, 0.0, 1e3, 1);
    const auto grown =
        grow_relief(map, Raster<float>(grid, 200.0f), land, beds, quick(), 1, context);
    for (const float z : grown.elevation.values()) EXPECT_TRUE(std::isfinite(z) && z >= 0.0f);
  }
}

TEST(ReliefGrowth, StopsWhenCancelled) {
  const VectorMap map = test::island(1);
  const Grid grid = test::island_grid(map, 512);
  const auto land = test::island_land(map, grid);
  const auto beds = lay_river_beds(map, land, 0.0, 1e3, 1);
  std::atomic<int> calls{0};
  Context context([&](std::string_view, double) { return ++calls < 3; });
  EXPECT_THROW(grow_relief(map, Raster<float>(grid, 300.0f), land, beds, quick(), 1, context),
               Cancelled);
}

TEST(ReliefGrowth, RefusesGridsThatDiffer) {
  Context context;
  const VectorMap map = test::island(1);
  const Grid grid = test::island_grid(map, 64), other = test::island_grid(map, 65);
  const auto land = test::island_land(map, grid);
  EXPECT_THROW(grow_relief(map, Raster<float>(other), land, lay_river_beds(map, land, 0, 1e3, 1),
                           quick(), 1, context),
               InputError);
}

}  // namespace
}  // namespace orogen
