#include "tectonics/boundaries.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "tectonics/plate_pair.h"

namespace orogen {
namespace {

const Grid kGrid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 200);

TEST(Boundaries, KindFollowsRelativeMotion) {
  const Context context;
  struct {
    glm::dvec2 west;
    PlateBoundaryKind kind;
    double convergence;
  } cases[] = {{{0.01, 0.0}, PlateBoundaryKind::Convergent, 1.0},
               {{-0.01, 0.0}, PlateBoundaryKind::Divergent, -1.0},
               {{0.0, 0.01}, PlateBoundaryKind::Transform, 0.0},
               {{0.005, -0.01}, PlateBoundaryKind::Transform, 0.447},
               {{0.01, 0.005}, PlateBoundaryKind::Convergent, 0.894}};
  for (const auto& c : cases) {
    const auto pair = test::make_pair(test::pair_map(), kGrid, c.west, 0.0, context);
    ASSERT_EQ(pair.boundaries.boundaries.size(), 1u);
    const PlateBoundary& b = pair.boundaries.boundaries[0];
    for (std::size_t i = 0; i < b.points.size(); ++i) {
      EXPECT_NEAR(b.points[i].x, 50e3, 1e-3);
      EXPECT_EQ(b.kind[i], c.kind);
      EXPECT_NEAR(b.convergence[i], c.convergence, 0.02);
    }
    EXPECT_NEAR(pair.boundaries.convergence(100, 100), c.convergence, 0.02);
    EXPECT_EQ(pair.boundaries.boundary_kind(100, 100), int(c.kind));
    EXPECT_EQ(pair.boundaries.boundary_kind(100, 5), 0);
  }
}

TEST(Boundaries, DistanceIsThatToTheLine) {
  const Context context;
  const auto pair = test::make_pair(test::pair_map(), kGrid, {0.01, 0.0}, 0.0, context);
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c)
      ASSERT_NEAR(pair.boundaries.boundary_distance(r, c), std::fabs(kGrid.center(r, c).x - 50e3),
                  0.1);
}

TEST(Boundaries, ConvergenceFadesAwayAndChangesWithoutAStep) {
  const Context context;
  // Counter-rotating plates: convergent at one end of the boundary, divergent at the other.
  const auto pair = test::make_pair(test::pair_map(), kGrid, {0.0, 0.0}, 4e-7, context);
  const auto& z = pair.boundaries.convergence;
  EXPECT_LT(z(185, 100) * z(15, 100), -0.3);
  float steepest = 0.0f;
  for (int r = 1; r < kGrid.ny; ++r)
    for (int c = 1; c < kGrid.nx; ++c)
      steepest =
          std::max({steepest, std::fabs(z(r, c) - z(r - 1, c)), std::fabs(z(r, c) - z(r, c - 1))});
  EXPECT_LT(steepest, 0.06f);  // over a cell of 500 m
  EXPECT_LT(std::fabs(z(185, 2)), 0.25f * std::fabs(z(185, 100)));
}

TEST(Boundaries, MeetSmoothlyWhereThreePlatesJoin) {
  const Context context;
  const auto map = test::map_of({{20e3, 20e3}, {80e3, 25e3}, {50e3, 80e3}});
  PlateParameters parameters;
  parameters.merge_area = 0.0;
  parameters.merge_direction = 1.0;
  parameters.line_boundaries = parameters.volcanoes = false;
  const PlateMotion motions[] = {{{20e3, 20e3}, {0.01, 0.0}, 0.0},
                                 {{80e3, 25e3}, {-0.01, 0.0}, 0.0},
                                 {{50e3, 80e3}, {0.0, 0.02}, 0.0}};
  const auto plates = infer_plates(map, kGrid, parameters, 3, context, motions);
  ASSERT_EQ(plates.plates.size(), 3u);
  const auto boundaries = plate_boundaries(plates, {}, context);
  EXPECT_EQ(boundaries.boundaries.size(), 3u);
  float steepest = 0.0f, low = 0.0f, high = 0.0f;
  const auto& z = boundaries.convergence;
  for (int r = 1; r < kGrid.ny; ++r)
    for (int c = 1; c < kGrid.nx; ++c) {
      steepest =
          std::max({steepest, std::fabs(z(r, c) - z(r - 1, c)), std::fabs(z(r, c) - z(r, c - 1))});
      low = std::min(low, z(r, c)), high = std::max(high, z(r, c));
    }
  EXPECT_LT(low, -0.5f);
  EXPECT_GT(high, 0.5f);
  EXPECT_LT(steepest, 0.08f);
}

TEST(Boundaries, BentLinesFollowTheBentRaster) {
  const Context context;
  const auto pair = test::make_pair(test::pair_map(), kGrid, {0.01, 0.0}, 0.0, context, 2000.0);
  double bend = 0.0;
  for (const auto& p : pair.boundaries.boundaries[0].points)
    bend = std::max(bend, std::fabs(p.x - 50e3));
  EXPECT_GT(bend, 1500.0);
  int wrong = 0, far = 0;
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 1; c < kGrid.nx; ++c)
      if (pair.plates.plate(r, c) != pair.plates.plate(r, c - 1)) {
        ++far;
        wrong += pair.boundaries.boundary_distance(r, c) > 1500.0f;
      }
  EXPECT_GE(far, kGrid.ny);
  EXPECT_LT(wrong, far / 20);
}

TEST(Boundaries, OnePlateHasNone) {
  const Context context;
  const auto plates = infer_plates(test::map_of({}), kGrid, {}, 1, context);
  const auto boundaries = plate_boundaries(plates, {}, context);
  EXPECT_TRUE(boundaries.boundaries.empty());
  for (float d : boundaries.boundary_distance.values()) EXPECT_EQ(d, 200e3f);
  for (float c : boundaries.convergence.values()) EXPECT_EQ(c, 0.0f);
}

TEST(Boundaries, SameForAnyNumberOfThreads) {
  BoundaryMap first;
  VelocityMap velocity;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      const auto pair =
          test::make_pair(test::pair_map(), kGrid, {0.01, 0.003}, 1e-7, context, 2000.0);
      if (first.convergence.empty()) first = pair.boundaries, velocity = pair.velocity;
      EXPECT_EQ(pair.boundaries.convergence, first.convergence);
      EXPECT_EQ(pair.boundaries.boundary_distance, first.boundary_distance);
      EXPECT_EQ(pair.boundaries.boundary_kind, first.boundary_kind);
      EXPECT_EQ(pair.velocity.velocity_x, velocity.velocity_x);
    });
  }
}

TEST(VelocityMap, TurnsFromOnePlateToTheOtherOverTheBlurAtAnyResolution) {
  const Context context;
  for (int resolution : {100, 400}) {
    const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), resolution);
    const auto pair = test::make_pair(test::pair_map(), grid, {0.01, 0.0}, 0.0, context);
    for (int c = 0; c < grid.nx; ++c) {
      const double x = (grid.center(0, c).x - 50e3) / VelocityParameters{}.velocity_blur;
      ASSERT_NEAR(pair.velocity.velocity_x(resolution / 2, c), -0.01 * std::erf(x / std::sqrt(2.0)),
                  1e-4);
      ASSERT_NEAR(pair.velocity.velocity_y(resolution / 2, c), 0.0, 1e-9);
    }
  }
}

TEST(Boundaries, RefusesParametersOutOfRange) {
  const Context context;
  const auto plates = infer_plates(test::map_of({}), kGrid, {}, 1, context);
  BoundaryParameters bad;
  bad.fade_length = -1.0;
  EXPECT_THROW(plate_boundaries(plates, bad, context), InputError);
}

}  // namespace
}  // namespace orogen
