// Paper B's setting of virtual pipes: its scaling, its must-shows.
#include "erosion/paper_b_setting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "erosion/virtual_pipes_cases.h"

namespace orogen {
namespace {

constexpr double kHeight = 1800.0;  // m

/// A rough cone in a sea, heights within `height`.
Raster<float> cone(int n, double cell, double height, double roughness) {
  const Raster<float> noise = hills(n, n, 90.0, 17);
  Raster<float> z(Grid{n, n, cell});
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) {
      const double x = 2.0 * (c + 0.5) / n - 1.0, y = 2.0 * (r + 0.5) / n - 1.0;
      const double rough = roughness * (noise(r, c) - 150.0) / 180.0;
      z(r, c) = float(height * (0.9 - 1.1 * std::hypot(x, y) + rough));
    }
  return z;
}

TEST(PaperBSetting, IsThePapersAtAnyScale) {
  const int n = 96;
  const auto setting = [](double cell, double height) {
    PipeParameters p = paper_b_setting(cell, height, 4.0);
    p.sea_keeps_sediment = false;  // a coast that moves turns rounding into cells
    return p;
  };
  const PipeErosionResult own = run_double(cone(n, 1.0, 1.0, 0.1), setting(1.0, 1.0));
  // Powers of 2, so that heights are the same to the bit.
  for (const auto& [cell, height] : {std::pair{128.0, 2048.0}, {4.0, 32.0}}) {
    const Raster<float> z = cone(n, cell, height, 0.1);
    const PipeErosionResult scaled = run_double(z, setting(cell, height));
    EXPECT_EQ(scaled.steps, own.steps);
    double most = 0.0, error = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      most = std::max(most, double(own.wear[i]));
      error = std::max(error, std::abs(own.wear[i] - scaled.wear[i] / height));
      error = std::max(error, std::abs(own.water_depth[i] - scaled.water_depth[i] / height));
    }
    EXPECT_GT(most, 1e-3);
    EXPECT_LT(error, 1e-4 * most) << cell;
  }
}

template <class Real>
void run_ten_thousand_steps(double tolerance) {
  const Raster<float> z = cone(72, 90.0, kHeight, 0.15);
  Context context;
  const PipeErosionResult r =
      erode_virtual_pipes<Real>(z, {}, paper_b_setting(90.0, kHeight, 100.0), context);
  EXPECT_EQ(r.steps, 10000);
  EXPECT_LT(r.water_balance.relative_residual(), tolerance);
  EXPECT_LT(r.sediment_balance.relative_residual(), tolerance);
  EXPECT_GT(r.sediment_balance.eroded_m3, 0.0);
  for (std::size_t i = 0; i < z.size(); ++i) {
    ASSERT_TRUE(std::isfinite(r.elevation[i]) && std::abs(r.elevation[i]) < 2.0 * kHeight) << i;
    ASSERT_TRUE(r.water_depth[i] >= 0.0f && r.water_depth[i] < 0.5 * kHeight) << i;
  }
}

TEST(PaperBSetting, StaysStableAndBalancedInFloat) {
  run_ten_thousand_steps<float>(1e-5);
}
TEST(PaperBSetting, StaysStableAndBalancedInDouble) {
  run_ten_thousand_steps<double>(1e-10);
}

TEST(PaperBSetting, SymmetricGroundUnderEvenRainStaysSymmetricToTheBit) {
  const int n = 130;
  const Raster<float> z = cone(n, 90.0, kHeight, 0.0);
  PipeParameters p = paper_b_setting(90.0, kHeight, 10.0);
  p.random_rain = false;
  const PipeErosionResult after = run(z, p);
  EXPECT_NE(after.elevation, z);
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) {
      ASSERT_EQ(after.elevation(r, c), after.elevation(n - 1 - r, c));
      ASSERT_EQ(after.elevation(r, c), after.elevation(r, n - 1 - c));
      ASSERT_EQ(after.elevation(r, c), after.elevation(c, r));
    }
}

/// Cells that are worn by `depth` and joined, by sides or corners, to the cell at `start`.
std::vector<int> bed_from(const PipeErosionResult& after, int start, float depth) {
  const Grid& grid = after.wear.grid();
  std::vector<char> seen(grid.size(), 0);
  std::vector<int> bed{start};
  seen[start] = 1;
  for (std::size_t k = 0; k < bed.size(); ++k)
    for (int dr = -1; dr <= 1; ++dr)
      for (int dc = -1; dc <= 1; ++dc) {
        const int r = bed[k] / grid.nx + dr, c = bed[k] % grid.nx + dc;
        if (!grid.contains(r, c)) continue;
        const int i = int(grid.index(r, c));
        if (seen[i] || after.wear[i] < depth) continue;
        seen[i] = 1;
        bed.push_back(i);
      }
  return bed;
}

TEST(PaperBSetting, ARiverSourceCarvesAContinuousBedToTheSea) {
  const int n = 160, row = 80, column = 92;
  const double cell = 90.0;
  const Raster<float> z = cone(n, cell, kHeight, 0.02);
  PipeForcing forcing;
  forcing.sources = {{z.grid().center(row, column), 2000.0}};
  const auto at_sea = [&](int i) {
    for (const int side : {i - 1, i + 1, i - n, i + n})
      if (z[side] <= 0.0f) return true;
    return false;
  };
  PipeParameters own = {};  // the project's
  own.duration = 20.0 * 3600.0;
  for (PipeParameters p : {paper_b_setting(cell, kHeight, 60.0), own}) {
    p.rain_rate_mm_per_h = 0.0;
    p.evaporation_rate = std::min(p.evaporation_rate, 1e-3);
    const PipeErosionResult after = run(z, p, forcing);
    const int start = int(z.grid().index(row, column));
    const std::vector<int> bed = bed_from(after, start, 0.5f);
    EXPECT_TRUE(std::any_of(bed.begin(), bed.end(), at_sea));
    EXPECT_GT(bed.size(), 40u);            // some 50 cells lie between the spring and the sea
    EXPECT_LT(bed.size(), z.size() / 8u);  // and the rest of the slope is left alone
  }
}

TEST(PaperBSetting, LandGrowsWhereSedimentFillsTheSea) {
  const int n = 150;
  const Raster<float> z = cone(n, 90.0, kHeight, 0.1);
  PipeParameters p = paper_b_setting(90.0, kHeight, 15.0);
  const PipeErosionResult after = run(z, p);
  int grown = 0;
  double high = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (z[i] > 0.0f || after.elevation[i] == z[i]) continue;
    ASSERT_GT(after.elevation[i], z[i]);
    ASSERT_NEAR(after.deposition[i], after.sediment_thickness[i], 1e-3);
    grown += after.elevation[i] > 0.0f;
    high = std::max(high, double(after.elevation[i]));
  }
  EXPECT_GT(grown, 50);
  EXPECT_LE(high, p.max_change * 1.001);  // it spreads rather than piles up
  EXPECT_LT(after.sediment_balance.relative_residual(), 1e-5);
  EXPECT_LT(after.water_balance.relative_residual(), 1e-5);
  EXPECT_EQ(run(z, p, {}, 1).elevation, after.elevation);
  p.sea_keeps_sediment = false;
  const PipeErosionResult clean = run(z, p);
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (z[i] <= 0.0f) {
      ASSERT_EQ(clean.elevation[i], z[i]);
    }
  }
}

TEST(PaperBSetting, RefusesScalesThatAreNone) {
  EXPECT_THROW(paper_b_setting(0.0, 1.0, 1.0), InputError);
  EXPECT_THROW(paper_b_setting(1.0, -1.0, 1.0), InputError);
  EXPECT_THROW(paper_b_setting(1.0, 1.0, std::nan("")), InputError);
}

}  // namespace
}  // namespace orogen
