#include "sculpting/feature_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/noise.h"
#include "foundation/random.h"

namespace orogen {
namespace {

const Grid kGrid{400, 300, 25.0, {1000.0, -500.0}};

constexpr double degrees(double angle) {
  return angle * M_PI / 180.0;
}

/// A straight ridge from west to east through the grid's middle.
FeatureCurve ridge(double height, double plateau, double size, double angle, double envelope) {
  FeatureCurve made;
  for (const double x : {3000.0, 5500.0, 8500.0}) {
    const FeatureSide side{size, angle, envelope};
    made.points.push_back({{x, 3250.0, height}, true, plateau, side, side});
  }
  return made;
}

Raster<float> hills() {
  Raster<float> ground = fbm({.seed = 4, .wavelength = 3000.0}, kGrid, Context());
  for (float& h : ground.values()) h = 200.0f + 60.0f * h;
  return ground;
}

Raster<float> bend(Raster<float> ground, std::span<const FeatureCurve> curves,
                   FeatureReport* report = nullptr) {
  Context context;
  const auto constraints = feature_constraints(curves, ground.grid(), context);
  const FeatureReport made = apply_features(ground, constraints, {}, context);
  if (report) *report = made;
  return ground;
}

TEST(FeatureSolver, HoldsPlateauAndSlopesOnAPlain) {
  for (const double angle : {5.0, 15.0, 30.0, 45.0}) {
    const double size = 300.0, height = 100.0 + size * std::tan(degrees(angle));
    const std::vector curves{ridge(height, 100.0, size, degrees(angle), 400.0)};
    const Raster<float> made = bend(Raster<float>(kGrid, 100.0f), curves);
    const int column = kGrid.column_of(5500.0);
    for (int r = 0; r < kGrid.ny; ++r) {
      const double away = std::fabs(kGrid.center(r, column).y - 3250.0);
      if (away < 90.0) {
        EXPECT_NEAR(made(r, column), height, 0.02 * (height - 100.0)) << angle;
      }
      if (away > 150.0 && away < 350.0) {
        const double fall = std::fabs(made(r + 1, column) - made(r - 1, column)) / 50.0;
        EXPECT_NEAR(std::atan(fall), degrees(angle), 0.05 * degrees(angle)) << away;
      }
    }
  }
}

TEST(FeatureSolver, HoldsSlopesInAnyDirection) {
  const Grid grid{300, 300, 20.0};
  for (const double turn : {0.0, 20.0, 45.0, 70.0, 110.0, 160.0}) {
    const glm::dvec2 along(std::cos(degrees(turn)), std::sin(degrees(turn))),
        middle(3000.0, 3000.0);
    FeatureCurve made;
    for (const double s : {-2000.0, 0.0, 2000.0}) {
      const glm::dvec2 p = middle + s * along;
      const FeatureSide side{500.0, degrees(20.0), 500.0};
      made.points.push_back({{p.x, p.y, 300.0}, true, 60.0, side, side});
    }
    const Raster<float> ground = bend(Raster<float>(grid, 118.0f), std::vector{made});
    for (const double away : {200.0, 300.0, 400.0}) {
      const glm::dvec2 p = middle + away * glm::dvec2(-along.y, along.x);
      const int r = grid.row_of(p.y), c = grid.column_of(p.x);
      const double gx = (ground(r, c + 1) - ground(r, c - 1)) / 40.0;
      const double gy = (ground(r + 1, c) - ground(r - 1, c)) / 40.0;
      EXPECT_NEAR(std::atan(std::hypot(gx, gy)), degrees(20.0), 0.05 * degrees(20.0)) << turn;
    }
  }
}

TEST(FeatureSolver, SidesMayDiffer) {
  FeatureCurve cliff = ridge(250.0, 50.0, 0.0, 0.0, 500.0);
  for (FeaturePoint& p : cliff.points) {
    p.left = {100.0, degrees(56.3), 300.0};   // north
    p.right = {1000.0, degrees(5.0), 300.0};  // south
  }
  const Raster<float> made = bend(Raster<float>(kGrid, 100.0f), std::vector{cliff});
  const int c = kGrid.column_of(5500.0);
  const auto at = [&](double y) { return double(made(kGrid.row_of(y), c)); };
  EXPECT_NEAR(at(3250.0 + 80.0) - at(3250.0 + 130.0), 75.0, 12.0);
  EXPECT_NEAR(at(3250.0 - 200.0) - at(3250.0 - 900.0), 700.0 * std::tan(degrees(5.0)), 4.0);
}

TEST(FeatureSolver, LeavesWhatLiesOutsideToTheBit) {
  const Raster<float> before = hills();
  const std::vector curves{ridge(500.0, 80.0, 200.0, degrees(40.0), 300.0)};
  FeatureReport report;
  const Raster<float> after = bend(before, curves, &report);
  const auto constraints = feature_constraints(curves, kGrid, Context());
  std::size_t inside = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (constraints.zone[i])
      ++inside;
    else
      ASSERT_EQ(before[i], after[i]);
  }
  EXPECT_EQ(inside, report.cells);
  EXPECT_GT(inside, 10000u);
  EXPECT_LT(inside, 40000u);
}

/// Eq. 9 as printed, one cell at a time.
double worst_residual(const Raster<float>& after, const FeatureConstraints& asked) {
  double worst = 0.0;
  const auto at = [&](int r, int c, int r0, int c0) {
    return double(after.grid().contains(r, c) ? after(r, c) : after(r0, c0));
  };
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c) {
      const auto zone = FeatureZone(asked.zone(r, c));
      if (zone == FeatureZone::None) continue;
      const double alpha = zone == FeatureZone::Plateau ? 0.9 : 0.0;
      const double beta = zone == FeatureZone::Slope ? 0.5 : 0.0;
      const double nx = asked.onward_x(r, c), ny = asked.onward_y(r, c);
      const double mean = 0.25 * (at(r, c - 1, r, c) + at(r, c + 1, r, c) + at(r - 1, c, r, c) +
                                  at(r + 1, c, r, c));
      const double towards = nx * nx * at(r, c - (nx > 0.0 ? 1 : -1), r, c) +
                             ny * ny * at(r - (ny > 0.0 ? 1 : -1), c, r, c);
      const double rise =
          asked.slope(r, c) * 25.0 * (std::fabs(nx * nx * nx) + std::fabs(ny * ny * ny));
      worst = std::max(worst, std::fabs(alpha * asked.elevation(r, c) + beta * (towards + rise) +
                                        (1.0 - alpha - beta) * mean - after(r, c)));
    }
  return worst;
}

TEST(FeatureSolver, SolvesEquation9) {
  std::vector<FeatureCurve> curves;
  for (std::uint64_t k = 0; k < 6; ++k) {
    FeatureCurve made;
    for (std::uint64_t i = 0; i < 4; ++i) {
      const auto random = [&](int stream, double low, double high) {
        return low + (high - low) * random_uniform(k, stream, i);
      };
      const FeatureSide left{random(3, 0, 300), random(4, -0.6, 0.6), random(5, 100, 600)};
      const FeatureSide right{random(6, 0, 300), random(7, -0.6, 0.6), random(8, 100, 600)};
      made.points.push_back({{random(0, 1000, 11000), random(1, -500, 7000), random(2, 0, 600)},
                             random(9, 0, 1) < 0.7,
                             random(10, 0, 100),
                             left,
                             right});
    }
    curves.push_back(made);
  }
  const Raster<float> before = hills();
  FeatureReport report;
  const Raster<float> after = bend(before, curves, &report);
  const FeatureConstraints asked = feature_constraints(curves, kGrid, Context());
  EXPECT_LT(report.residual, 1e-6 * 600.0);
  EXPECT_LT(worst_residual(after, asked), 2e-4);  // heights are rounded to float
  EXPECT_LE(report.iterations, 40);
}

TEST(FeatureSolver, WithoutHeightsOnlySlopesAreAsked) {
  FeatureCurve valley = ridge(0.0, 0.0, 400.0, degrees(-10.0), 200.0);
  for (FeaturePoint& p : valley.points) p.elevation = false;
  const Raster<float> made = bend(Raster<float>(kGrid, 100.0f), std::vector{valley});
  const int c = kGrid.column_of(5500.0);
  const double middle = made(kGrid.row_of(3250.0), c), rim = made(kGrid.row_of(3600.0), c);
  EXPECT_NEAR(rim - middle, 350.0 * std::tan(degrees(10.0)), 8.0);
}

TEST(FeatureSolver, ACurvePartlyOutsideTheGridIsCutOff) {
  const std::vector curves{ridge(300.0, 100.0, 200.0, degrees(20.0), 300.0)};
  const Grid part{120, 80, 25.0, {2000.0, 3000.0}};
  const Raster<float> made = bend(Raster<float>(part, 100.0f), curves);
  const int r = part.row_of(3250.0);
  EXPECT_NEAR(made(r, 118), 300.0, 6.0);
  EXPECT_EQ(made(0, 0), 100.0f);
  const Grid far{50, 50, 25.0, {90000.0, 0.0}};
  const Raster<float> still = bend(Raster<float>(far, 7.0f), curves);
  EXPECT_EQ(std::ranges::count(still.values(), 7.0f), 2500);
}

}  // namespace
}  // namespace orogen
