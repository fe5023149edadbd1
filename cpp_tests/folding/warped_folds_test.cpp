#include "folding/warped_folds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "foundation/units.h"
#include "tectonics/plate_pair.h"

namespace orogen {
namespace {

const Grid kGrid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 400);  // cells of 250 m
constexpr int kMiddle = 200;                                       // column of the boundary

Raster<float> folds_of(const test::Pair& pair, const VectorMap& map, const Context& context,
                       const FoldParameters& parameters = {}, std::uint32_t seed = 3) {
  return warped_folds(map, pair.plates, pair.boundaries, pair.velocity, parameters, seed, context);
}

// Mean of a column's heights over rows [r0, r1).
double mean_of(const Raster<float>& z, int column, int r0 = 40, int r1 = 360) {
  double sum = 0.0;
  for (int r = r0; r < r1; ++r) sum += z(r, column);
  return sum / (r1 - r0);
}

// Roughness: deviation from the mean of the neighbours 2 km to both sides along the column.
double roughness(const Raster<float>& z, int column, int r0 = 40, int r1 = 360) {
  double sum = 0.0;
  for (int r = r0; r < r1; ++r)
    sum += std::pow(z(r, column) - 0.5 * (z(r - 8, column) + z(r + 8, column)), 2);
  return std::sqrt(sum / (r1 - r0));
}

// Mean squared slope across the boundary over that along it, in a belt of 4 km around it.
double anisotropy(const Raster<float>& z) {
  double across = 0.0, along = 0.0;
  for (int r = 40; r < 360; ++r)
    for (int c = kMiddle - 8; c < kMiddle + 8; ++c) {
      across += std::pow(z(r, c + 1) - z(r, c - 1), 2);
      along += std::pow(z(r + 1, c) - z(r - 1, c), 2);
    }
  return across / along;
}

TEST(WarpedFolds, RidgesRunAlongConvergentBoundaries) {
  const Context context;
  const auto map = test::pair_map();
  const auto pair = test::make_pair(map, kGrid, {0.01, 0.0}, 0.0, context);
  double compress = 0.0, paper = 0.0, unwarped = 0.0;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    compress += anisotropy(folds_of(pair, map, context, {}, seed)) / 8;
    // Half the blur's width: where the paper's own warp stretches.
    paper += anisotropy(folds_of(pair, map, context, {.folding_time = 4e5, .warp = FoldWarp::Paper},
                                 seed)) /
             8;
    unwarped += anisotropy(folds_of(pair, map, context, {.folding_time = 0.0}, seed)) / 8;
  }
  RecordProperty("compress", std::to_string(compress));
  RecordProperty("paper", std::to_string(paper));
  EXPECT_GT(compress, 3.0);
  EXPECT_LT(paper, 0.8 * unwarped);
  EXPECT_NEAR(unwarped, 1.0, 0.3);
}

TEST(WarpedFolds, DivergentPairMakesAGrabenWithoutFolds) {
  const Context context;
  const auto map = test::pair_map();
  const auto apart = test::make_pair(map, kGrid, {-0.01, 0.0}, 0.0, context);
  const auto together = test::make_pair(map, kGrid, {0.01, 0.0}, 0.0, context);
  const FoldParameters parameters;
  const auto rift = folds_of(apart, map, context, parameters);
  const auto range = folds_of(together, map, context, parameters);
  const int shoulder = int(parameters.rift_width / kGrid.cell_size);
  for (int r0 = 40; r0 < 360; r0 += 80) {  // along the whole of it
    const double floor = mean_of(rift, kMiddle, r0, r0 + 80);
    EXPECT_LT(floor, mean_of(rift, kMiddle - shoulder, r0, r0 + 80) - 100.0);
    EXPECT_LT(floor, mean_of(rift, kMiddle + shoulder, r0, r0 + 80) - 100.0);
  }
  EXPECT_LT(roughness(rift, kMiddle), 0.1 * roughness(range, kMiddle));
}

TEST(WarpedFolds, TransformPairHasNeitherFoldsNorRift) {
  const Context context;
  const auto map = test::pair_map();
  const auto sliding = test::make_pair(map, kGrid, {0.0, 0.01}, 0.0, context);
  const auto together = test::make_pair(map, kGrid, {0.01, 0.0}, 0.0, context);
  const auto z = folds_of(sliding, map, context), range = folds_of(together, map, context);
  // What is left is the unfolded ground around the peaks, 16 km away.
  EXPECT_LT(roughness(z, kMiddle), 0.15 * roughness(range, kMiddle));
  EXPECT_NEAR(mean_of(z, kMiddle), mean_of(z, kMiddle - 12), 60.0);  // 3 km aside
  EXPECT_NEAR(mean_of(z, kMiddle), mean_of(z, kMiddle + 12), 60.0);
}

TEST(WarpedFolds, AmplitudeChangesWithoutAStepWhereTheKindChanges) {
  const Context context;
  const auto map = test::pair_map();
  const auto pair = test::make_pair(map, kGrid, {0.0, 0.0}, 4e-7, context);  // about its middle
  std::vector<double> amplitude;  // in windows of 10 km, every 2 km
  for (int r = 48; r + 40 < 352; r += 8) {
    double sum = 0.0;
    for (std::uint32_t seed = 0; seed < 12; ++seed)
      sum += roughness(folds_of(pair, map, context, {}, seed), kMiddle, r, r + 40) / 12;
    amplitude.push_back(sum);
  }
  const auto [low, high] = std::minmax_element(amplitude.begin(), amplitude.end());
  EXPECT_LT(*low, 0.1 * *high);
  for (std::size_t i = 1; i < amplitude.size(); ++i)
    EXPECT_LT(std::fabs(amplitude[i] - amplitude[i - 1]), 0.25 * *high) << i;
}

TEST(WarpedFolds, IsolatedPeakIsAConeAsItsParametersSay) {
  const Context context;
  const auto map = test::map_of({{50e3, 50e3}}, 2400.0);
  const Grid grid = grid_over({30e3, 30e3}, glm::dvec2(40e3), 400);  // cells of 100 m
  for (double slope : {12.0, 20.0, 30.0})
    for (double crater : {400.0, 1000.0}) {
      const auto plates = infer_plates(map, grid, {}, 1, context);
      ASSERT_EQ(plates.volcanoes.size(), 1u);
      const test::Pair pair{plates, plate_boundaries(plates, {}, context),
                            velocity_map(plates, {}, context)};
      FoldParameters parameters;
      parameters.volcano_slope_deg = slope;
      parameters.crater_radius = crater;
      parameters.crater_depth = 0.3 * crater;
      const auto z = folds_of(pair, map, context, parameters);
      const auto highest = std::max_element(z.values().begin(), z.values().end());
      const std::size_t at = highest - z.values().begin();
      // The peak tops the rim, as far as cells of 100 m can show it.
      const glm::dvec2 top = grid.center(int(at / grid.nx), int(at % grid.nx));
      EXPECT_LE(*highest, 2400.5);
      EXPECT_LE(std::hypot(top.x - 50e3, top.y - 50e3), 1.5 * crater);
      EXPECT_GE(z(grid.row_of(50e3), grid.column_of(50e3)),
                *highest - 75.0 * std::tan(radians(slope)));
      // The crater's floor: the lowest place within its radius of the peak.
      float floor = 1e9f;  // found: below the rim

      glm::dvec2 centre{};
      for (int r = 0; r < grid.ny; ++r)
        for (int c = 0; c < grid.nx; ++c) {
          const glm::dvec2 p = grid.center(r, c);
          if (std::fabs(std::hypot(p.x - 50e3, p.y - 50e3) - crater) < 100.0) {
            bool pit = true;
            for (int dr = -1; dr <= 1; ++dr)
              for (int dc = -1; dc <= 1; ++dc) pit &= z(r + dr, c + dc) >= z(r, c);
            if (pit && z(r, c) < floor) floor = z(r, c), centre = p;
          }
        }
      EXPECT_NEAR(2400.0 - floor, parameters.crater_depth, 0.15 * parameters.crater_depth + 15.0);
      // Slope of the flanks, in every direction from the crater.
      for (int k = 0; k < 12; ++k) {
        const double angle = 2.0 * M_PI * k / 12;
        const auto height_at = [&](double distance) {
          const glm::dvec2 p = centre + distance * glm::dvec2(std::cos(angle), std::sin(angle));
          return z(grid.row_of(p.y), grid.column_of(p.x));
        };
        const double fall = height_at(crater + 400.0) - height_at(crater + 2400.0);
        EXPECT_NEAR(degrees(std::atan(fall / 2000.0)), slope, 2.0);
      }
    }
}

TEST(WarpedFolds, FadeWithDistanceToPeaks) {
  const Context context;
  const auto map = test::map_of({{45e3, 10e3}, {55e3, 12e3}});
  const auto pair = test::make_pair(map, kGrid, {0.01, 0.0}, 0.0, context);
  const auto z = folds_of(pair, map, context);
  EXPECT_LT(roughness(z, kMiddle, 300, 380), 0.15 * roughness(z, kMiddle, 20, 80));
}

TEST(WarpedFolds, AgreesBetweenResolutions) {
  const Context context;
  const auto map = test::pair_map();
  const Grid coarse = grid_over({0.0, 0.0}, glm::dvec2(100e3), 100);
  const Grid fine = grid_over({0.0, 0.0}, glm::dvec2(100e3), 300);
  const auto a =
      folds_of(test::make_pair(map, coarse, {0.01, 0.0}, 0.0, context, 1500.0), map, context);
  const auto b =
      folds_of(test::make_pair(map, fine, {0.01, 0.0}, 0.0, context, 1500.0), map, context);
  double sum = 0.0, spread = 0.0;
  for (int r = 0; r < 100; ++r)
    for (int c = 0; c < 100; ++c) {
      sum += std::pow(a(r, c) - b(3 * r + 1, 3 * c + 1), 2);
      spread += std::pow(a(r, c), 2);
    }
  EXPECT_LT(std::sqrt(sum / spread), 0.05);
}

TEST(WarpedFolds, SameForAnyNumberOfThreads) {
  const auto map = test::pair_map();
  Raster<float> first;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      const auto pair = test::make_pair(map, kGrid, {0.01, 0.003}, 0.0, context, 1500.0);
      const auto z = folds_of(pair, map, context);
      if (first.empty()) first = z;
      EXPECT_EQ(z, first);
    });
  }
}

TEST(WarpedFolds, SmallGridsAndBadParameters) {
  const Context context;
  const auto map = test::pair_map();
  for (auto [nx, ny] : {std::pair(1, 1), {1, 40}, {37, 1}}) {
    const Grid grid{nx, ny, 2e3, {10e3, 10e3}};
    const auto pair = test::make_pair(map, grid, {0.01, 0.0}, 0.0, context);
    const Raster<float> relief = folds_of(pair, map, context);
    for (float z : relief.values()) EXPECT_TRUE(std::isfinite(z));
  }
  const auto pair = test::make_pair(map, {4, 4, 25e3, {0.0, 0.0}}, {0.01, 0.0}, 0.0, context);
  EXPECT_THROW(folds_of(pair, map, context, {.octaves = 99}), InputError);
}

}  // namespace
}  // namespace orogen
