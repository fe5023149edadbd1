#include "foundation/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/random.h"

namespace orogen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double between(const Grid& grid, std::size_t a, std::size_t b) {
  const glm::dvec2 p = grid.center(int(a / grid.nx), int(a % grid.nx));
  const glm::dvec2 q = grid.center(int(b / grid.nx), int(b % grid.nx));
  return std::hypot(p.x - q.x, p.y - q.y);
}

TEST(DistanceTransform, IsExactOnRandomMasks) {
  const Context context;
  const int sizes[] = {1, 2, 7, 31, 64, 65};
  for (int seed = 0; seed < 100; ++seed) {
    const Grid grid{sizes[seed % 6], sizes[seed / 6 % 6], 30.0, {500.0, -700.0}};
    Raster<std::uint8_t> mask(grid);
    const double share = seed % 4 ? 0.02 * (seed % 7) : 0.5;
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = random_uniform(seed, 0, i) < share;
    const auto distance = distance_transform(mask, context);
    const auto feature = nearest_feature(mask, context);
    EXPECT_EQ(feature.distance, distance);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      double best = kInfinity;
      for (std::size_t j = 0; j < mask.size(); ++j)
        if (mask[j]) best = std::min(best, between(grid, i, j));
      if (best == kInfinity) {
        ASSERT_EQ(distance[i], float(kInfinity));
        ASSERT_EQ(feature.nearest[i], -1);
        continue;
      }
      ASSERT_NEAR(distance[i], best, 1e-3);
      ASSERT_TRUE(mask[feature.nearest[i]]);
      ASSERT_NEAR(between(grid, i, feature.nearest[i]), best, 1e-9);
    }
  }
}

TEST(NearestPoint, IsExactForPointsAnywhere) {
  const Context context;
  for (int seed = 0; seed < 40; ++seed) {
    const Grid grid{1 + seed * 3 % 80, 1 + seed * 7 % 70, 100.0, {-2e5, 3e5}};
    std::vector<glm::dvec2> points;
    for (int i = 0; i < seed % 9 * 30; ++i)
      points.push_back(grid.origin + glm::dvec2(12e3 * random_uniform(seed, 1, i) - 2e3,
                                                12e3 * random_uniform(seed, 2, i) - 2e3));
    const auto feature = nearest_point(points, grid, context);
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        double best = kInfinity;
        for (const auto& p : points)
          best = std::min(best, std::hypot(p.x - grid.center(r, c).x, p.y - grid.center(r, c).y));
        if (points.empty()) {
          ASSERT_EQ(feature.nearest(r, c), -1);
          continue;
        }
        ASSERT_NEAR(feature.distance(r, c), best, 0.01);
        const glm::dvec2 d = points[feature.nearest(r, c)] - grid.center(r, c);
        ASSERT_NEAR(std::hypot(d.x, d.y), best, 0.01);
      }
  }
}

TEST(NearestPoint, CandidatesHoldEveryPointThatIsNearestInTheBox) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 300; ++i)
    points.push_back({100.0 * random_uniform(1, 1, i), 100.0 * random_uniform(1, 2, i)});
  const auto near = nearest_candidates(points, {40.0, 40.0}, {50.0, 45.0});
  EXPECT_LT(near.size(), 100u);
  for (int k = 0; k < 1000; ++k) {
    const glm::dvec2 p{40.0 + 10.0 * random_uniform(2, 1, k), 40.0 + 5.0 * random_uniform(2, 2, k)};
    const auto nearest = std::min_element(points.begin(), points.end(), [&](auto a, auto b) {
      return std::hypot(a.x - p.x, a.y - p.y) < std::hypot(b.x - p.x, b.y - p.y);
    });
    EXPECT_TRUE(std::binary_search(near.begin(), near.end(), int(nearest - points.begin())));
  }
}

TEST(DistanceTransform, IsTheSameForAnyNumberOfThreads) {
  const Grid grid{301, 203, 10.0, {0.0, 0.0}};
  Raster<std::uint8_t> mask(grid);
  std::vector<glm::dvec2> points;
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = random_uniform(3, 0, i) < 0.003;
  for (int i = 0; i < 50; ++i)
    points.push_back({3e3 * random_uniform(4, 1, i), 2e3 * random_uniform(4, 2, i)});
  NearestFeature cells, places;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      const auto a = nearest_feature(mask, context), b = nearest_point(points, grid, context);
      if (cells.distance.empty()) cells = a, places = b;
      EXPECT_EQ(a.distance, cells.distance);
      EXPECT_EQ(a.nearest, cells.nearest);
      EXPECT_EQ(b.distance, places.distance);
      EXPECT_EQ(b.nearest, places.nearest);
    });
  }
}

}  // namespace
}  // namespace orogen
