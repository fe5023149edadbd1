#include "erosion/slippage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/random.h"

namespace orogen {
namespace {

constexpr double kTan33 = 0.6494075931975106;

/// Largest slope above repose from a cell with sediment to one of its eight neighbours.
double excess(const SlippageResult& r, double tan_repose,
              const Raster<std::uint8_t>* pinned = nullptr) {
  const Grid& g = r.elevation.grid();
  double worst = 0.0;
  for (int row = 0; row < g.ny; ++row)
    for (int c = 0; c < g.nx; ++c) {
      if (!(r.sediment_thickness(row, c) > 0.0f) || (pinned && (*pinned)(row, c))) continue;
      for (int a = std::max(0, row - 1); a <= std::min(g.ny - 1, row + 1); ++a)
        for (int b = std::max(0, c - 1); b <= std::min(g.nx - 1, c + 1); ++b) {
          if ((a == row && b == c) || (pinned && (*pinned)(a, b))) continue;
          const double l = g.cell_size * std::hypot(a - row, b - c);
          const double drop = double(r.elevation(row, c)) - double(r.elevation(a, b));
          worst = std::max(worst, drop / l - tan_repose);
        }
    }
  return worst;
}

double volume(const Raster<float>& field) {
  double sum = 0.0;
  for (const float v : field.values()) sum += double(v);
  return sum * field.grid().cell_area();
}

TEST(Slippage, NothingIsLeftSteeperThanReposeOnRandomTerrains) {
  const int sizes[] = {1, 2, 3, 5, 17, 31, 64, 97};
  int slid = 0;
  for (std::uint64_t k = 0; k < 100; ++k) {
    SCOPED_TRACE(k);
    const Grid grid{sizes[random_bits(1, k, 0) % 8], sizes[random_bits(1, k, 1) % 8],
                    20.0 + 300.0 * random_uniform(1, k, 2)};
    Context context;
    FbmParameters noise;
    noise.seed = std::uint32_t(k);
    noise.wavelength = 12.0 * grid.cell_size;
    Raster<float> rock = fbm(noise, grid, context);
    Raster<float> loose(grid);
    const double steepness = grid.cell_size * 4.0 * random_uniform(1, k, 3);
    for (std::size_t i = 0; i < rock.size(); ++i) {
      rock[i] = float(1500.0 + steepness * double(rock[i]));
      if (k % 5 == 1) rock[i] = (i + i / std::size_t(grid.nx)) % 2 ? 900.0f : 1700.0f;
      if (k % 5 == 2 && random_uniform(2, k, i) < 0.03) rock[i] += 2500.0f;
      loose[i] = float(30.0 * random_uniform(3, k, i));
      if (k % 5 == 3) loose[i] = random_uniform(3, k, i) < 0.05 ? 800.0f : 0.0f;
    }
    const SlippageResult r = slip_sediment(rock, loose, {}, context);
    EXPECT_LE(excess(r, kTan33), 1e-3);
    EXPECT_LE(r.steepest_excess, 1e-3);
    for (const float v : r.sediment_thickness.values()) ASSERT_GE(v, 0.0f);
    EXPECT_NEAR(volume(r.sediment_thickness), volume(loose), 1e-6 * volume(loose));
    EXPECT_NEAR(r.residual_m3, volume(r.sediment_thickness) - volume(loose),
                1e-9 * volume(loose) + 1e-12);
    slid += r.sweeps > 0;
  }
  EXPECT_GT(slid, 60);
}

TEST(Slippage, APileBecomesAConeAtItsAngle) {
  Context context;
  const Grid grid{101, 101, 10.0};
  const Raster<float> rock(grid, 100.0f);
  Raster<float> loose(grid);
  loose(50, 50) = 20000.0f;
  for (const double angle : {20.0, 33.0, 45.0}) {
    SlippageParameters p;
    p.sediment_talus_angle_deg = angle;
    const SlippageResult r = slip_sediment(rock, loose, p, context);
    EXPECT_LE(r.steepest_excess, 1e-3);
    const double slope = (double(r.elevation(50, 50)) - double(r.elevation(50, 60))) / 100.0;
    EXPECT_NEAR(slope, std::tan(angle * std::acos(-1.0) / 180.0), 0.02);
    // The same to all sides.
    EXPECT_FLOAT_EQ(r.elevation(50, 56), r.elevation(56, 50));
    EXPECT_FLOAT_EQ(r.elevation(50, 56), r.elevation(44, 50));
    EXPECT_FLOAT_EQ(r.elevation(54, 54), r.elevation(46, 54));
  }
}

TEST(Slippage, LeavesGentleGroundAlone) {
  Context context;
  const Grid grid{40, 30, 10.0};
  Raster<float> rock(grid);
  for (int r = 0; r < 30; ++r)
    for (int c = 0; c < 40; ++c) rock(r, c) = 3.0f * float(r + c);  // at most 0.42
  const Raster<float> loose(grid, 2.0f);
  const SlippageResult r = slip_sediment(rock, loose, {}, context);
  EXPECT_EQ(r.sediment_thickness, loose);
  EXPECT_EQ(r.sweeps, 0);
}

TEST(Slippage, SteepRockKeepsNothing) {
  Context context;
  const Grid grid{60, 8, 10.0};
  Raster<float> rock(grid);
  for (int r = 0; r < 8; ++r)
    for (int c = 0; c < 60; ++c) rock(r, c) = c < 30 ? 20.0f * float(30 - c) : 0.0f;
  const Raster<float> loose(grid, 1.0f);
  const SlippageResult r = slip_sediment(rock, loose, {}, context);
  for (int row = 0; row < 8; ++row)
    for (int c = 0; c < 24; ++c) EXPECT_EQ(r.sediment_thickness(row, c), 0.0f) << c;
}

TEST(Slippage, PinnedCellsNeitherGiveNorTake) {
  Context context;
  const Grid grid{50, 50, 20.0};
  FbmParameters noise;
  noise.wavelength = 200.0;
  Raster<float> rock = fbm(noise, grid, context);
  Raster<float> loose(grid, 25.0f);
  Raster<std::uint8_t> pinned(grid);
  for (std::size_t i = 0; i < rock.size(); ++i) {
    rock[i] = 500.0f + 60.0f * rock[i];
    pinned[i] = random_uniform(4, 4, i) < 0.1;
  }
  const SlippageResult r = slip_sediment(rock, loose, {}, context, &pinned);
  EXPECT_LE(excess(r, kTan33, &pinned), 1e-3);
  int moved = 0;
  for (std::size_t i = 0; i < rock.size(); ++i) {
    if (pinned[i]) {
      ASSERT_EQ(r.sediment_thickness[i], 25.0f);
    }
    moved += r.sediment_thickness[i] != 25.0f;
  }
  EXPECT_GT(moved, 500);
}

TEST(Slippage, SameBytesForAnyNumberOfThreads) {
  Context first({}, 1);
  const Grid grid{540, 70, 25.0};
  FbmParameters noise;
  noise.wavelength = 800.0;
  Raster<float> rock = fbm(noise, grid, first);
  for (float& v : rock.values()) v *= 150.0f;
  const Raster<float> loose(grid, 3.0f);
  const SlippageResult one = slip_sediment(rock, loose, {}, first);
  EXPECT_GT(one.sweeps, 10);
  for (const int threads : {2, 3, 4, 8}) {
    Context context({}, threads);
    const SlippageResult many = slip_sediment(rock, loose, {}, context);
    EXPECT_EQ(many.sediment_thickness, one.sediment_thickness);
    EXPECT_EQ(many.sweeps, one.sweeps);
  }
}

TEST(Slippage, RefusesWhatItCannotUse) {
  Context context;
  const Raster<float> rock(Grid{4, 4, 10.0}, 1.0f);
  Raster<float> loose(rock.grid(), 1.0f);
  loose(2, 1) = -1.0f;
  EXPECT_THROW(slip_sediment(rock, loose, {}, context), InputError);
  EXPECT_THROW(slip_sediment(rock, Raster<float>(Grid{3, 3, 10.0}), {}, context), InputError);
}

}  // namespace
}  // namespace orogen
