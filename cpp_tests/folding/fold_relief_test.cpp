#include "folding/fold_relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "folding/compression_fields.h"
#include "folding/fold_layers.h"
#include "folding/segment_buckets.h"
#include "foundation/errors.h"

namespace orogen {
namespace {

using std::numbers::pi;

double slow_distance(const std::vector<Segment>& segments, glm::dvec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments) least = std::min(least, distance_to(s, p));
  return least;
}

// Segments of all lengths, points, copies, and all along one line in every fifth set.
std::vector<Segment> random_segments(int seed, double size) {
  std::vector<Segment> segments;
  for (int i = 0; i < 1 + seed * seed % 300; ++i) {
    const auto number = [&](int k) { return random_uniform(seed, i, k); };
    const glm::dvec2 a = size * glm::dvec2(number(0), seed % 5 == 0 ? 0.3 : number(1));
    const double angle = 2.0 * pi * number(2), length = size * std::pow(number(3), 6.0);
    const glm::dvec2 way(std::cos(angle), seed % 5 == 0 ? 0.0 : std::sin(angle));
    segments.push_back({a, i % 7 == 0 ? a : a + length * way});
    if (i % 11 == 0) segments.push_back(segments.back());
  }
  return segments;
}

TEST(SegmentBuckets, DistancesAreThoseOfALoopOverAll) {
  for (int seed = 0; seed < 100; ++seed) {
    const auto segments = random_segments(seed, 5e3);
    const SegmentBuckets buckets(segments);
    for (int k = 0; k < 100; ++k) {
      const glm::dvec2 p =
          12e3 * glm::dvec2(random_uniform(seed, 1, k), random_uniform(seed, 2, k)) -
          glm::dvec2(3e3);
      ASSERT_EQ(buckets.distance(p), slow_distance(segments, p));
      const glm::dvec2 half =
          900.0 * glm::dvec2(random_uniform(seed, 3, k), random_uniform(seed, 4, k));
      std::vector<Segment> near;
      buckets.for_near(p - half, p + half, [&](const Segment& s) { near.push_back(s); });
      for (const Segment& s : segments) {
        const auto copies = [&](const std::vector<Segment>& v) {
          return std::count(v.begin(), v.end(), s);
        };
        const glm::dvec2 low = glm::min(s.a, s.b), high = glm::max(s.a, s.b);
        const bool meets = low.x <= p.x + half.x && high.x >= p.x - half.x &&
                           low.y <= p.y + half.y && high.y >= p.y - half.y;
        ASSERT_TRUE(copies(near) == copies(segments) || (!meets && copies(near) == 0));
      }
    }
  }
}

TEST(FoldRelief, DistancesAreExact) {
  const Context context;
  for (int seed = 0; seed < 100; ++seed) {
    const Grid grid{1 + seed * 7 % 61, 1 + seed * 13 % 53, 50.0 + 3.0 * seed, {4e5, -3e5}};
    FoldSkeleton skeleton;
    for (auto* segments : {&skeleton.top, &skeleton.bottom}) {
      *segments =
          random_segments(seed + (segments == &skeleton.top ? 0 : 1000), 2.0 * grid.width());
      for (Segment& s : *segments) {
        s.a += grid.origin;
        s.b += grid.origin;
      }
    }
    const auto distances = fold_distances(skeleton, grid, context);
    const double rounding = 2e-6 * (grid.width() + grid.height());
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        ASSERT_NEAR(distances.crest(r, c), slow_distance(skeleton.top, grid.center(r, c)),
                    rounding);
        ASSERT_NEAR(distances.trough(r, c), slow_distance(skeleton.bottom, grid.center(r, c)),
                    rounding);
      }
  }
}

TEST(FoldRelief, HeightsFollowTheFormula) {
  const Context context;
  for (int seed = 0; seed < 100; ++seed) {
    const Grid grid{1 + seed * 5 % 43, 1 + seed * 17 % 37, 300.0, {0.0, 0.0}};
    const auto field = test::random_field(grid, seed);
    const auto skeleton =
        fold_skeleton(field, FoldWavelength(1000.0 + 50.0 * seed), {}, seed, context);
    Raster<float> speed = crest_speed(field, 2e-4, context);
    shape_folds(skeleton, speed, 0.0, context);
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        const double highest =
            2e-4 * std::hypot(field.compression_x(r, c), field.compression_y(r, c));
        const double top = slow_distance(skeleton.top, grid.center(r, c));
        const double bottom = slow_distance(skeleton.bottom, grid.center(r, c));
        const double expected =
            skeleton.top.empty() || highest == 0.0
                ? 0.0
                : 0.5 * highest * (1.0 + std::cos(2.0 * pi * top / (2.0 * (bottom + top))));
        ASSERT_NEAR(speed(r, c), expected, 2e-4 * 1e-5);
        ASSERT_GE(speed(r, c), 0.0f);
        ASSERT_LE(speed(r, c), highest * (1 + 1e-6));
      }
  }
}

TEST(FoldRelief, IsContinuousAndLevelOnCrestsAndInTroughs) {
  const Context context;
  const double lambda = 5e3;
  const Grid coarse = grid_over({0.0, 0.0}, glm::dvec2(40e3), 100);
  const auto skeleton =
      fold_skeleton(test::uniform_field(coarse, 0.3), FoldWavelength(lambda), {}, 1, context);
  const auto shape_at = [&](glm::dvec2 p) {
    const double t = slow_distance(skeleton.top, p), b = slow_distance(skeleton.bottom, p);
    return 0.5 * (1.0 + std::cos(pi * t / (t + b)));
  };
  // The steepest slope anywhere: π/2 (d_t + d_b)/(d_t + d_b)² at worst, with the two some λ/8
  // apart.
  for (int k = 0; k < 3000; ++k) {
    const glm::dvec2 p = 40e3 * glm::dvec2(random_uniform(1, 1, k), random_uniform(1, 2, k));
    const double angle = 2.0 * pi * random_uniform(1, 3, k);
    const glm::dvec2 q = p + 1.0 * glm::dvec2(std::cos(angle), std::sin(angle));
    ASSERT_LT(std::fabs(shape_at(p) - shape_at(q)), 16.0 / lambda);
  }
  for (const auto* segments : {&skeleton.top, &skeleton.bottom})
    for (const Segment& s : *segments) {
      const glm::dvec2 m = 0.5 * (s.a + s.b), d = s.b - s.a;
      if (m.x < 0.0 || m.y < 0.0 || m.x > 40e3 || m.y > 40e3) continue;  // slivers at the rim
      const glm::dvec2 across = glm::dvec2(-d.y, d.x) / glm::length(d);
      const double level = segments == &skeleton.top ? 1.0 : 0.0;
      ASSERT_NEAR(shape_at(m), level, 1e-9);
      ASSERT_NEAR(shape_at(m + 1.0 * across), level, 1e-4);
    }
}

/// Shares of cells of λ/72 across which the slope changes by more than a quarter and by more than
/// half of an even fold's steepest, and the greatest change over it.
struct Creases {
  double quarter = 0.0, half = 0.0, most = 0.0;
};

Creases creases_of(const Raster<float>& shape, double lambda) {
  const Grid& grid = shape.grid();
  const double steepest = pi / lambda * grid.cell_size;
  const int rim = 72;  // there the mesh has slivers
  Creases found;
  double count = 0.0;
  for (int r = rim; r < grid.ny - rim; ++r)
    for (int c = rim; c < grid.nx - rim; ++c) {
      const double here = 2.0 * shape(r, c);
      const double across = std::fabs(shape(r, c - 1) - here + shape(r, c + 1));
      const double along = std::fabs(shape(r - 1, c) - here + shape(r + 1, c));
      const double change = std::max(across, along) / steepest;
      found.quarter += change > 0.25;
      found.half += change > 0.5;
      found.most = std::max(found.most, change);
      count += 1.0;
    }
  found.quarter /= count;
  found.half /= count;
  return found;
}

TEST(FoldRelief, SlopesAreContinuous) {
  const Context context;
  const double lambda = 5e3;
  const Grid grid{600, 600, lambda / 72.0, {0.0, 0.0}};
  Creases worst, sharp;
  for (int seed = 1; seed <= 3; ++seed) {
    const auto skeleton = fold_skeleton(test::uniform_field(grid, 0.3 * seed),
                                        FoldWavelength(lambda), {}, std::uint32_t(seed), context);
    for (const double rounding : {0.0, kCreaseRounding * lambda}) {
      Raster<float> shape(grid, 1.0f);
      shape_folds(skeleton, shape, rounding, context);
      const Creases found = creases_of(shape, lambda);
      Creases& most = rounding > 0.0 ? worst : sharp;
      most.quarter = std::max(most.quarter, found.quarter);
      most.half = std::max(most.half, found.half);
      most.most = std::max(most.most, found.most);
      const auto [low, high] = std::minmax_element(shape.values().begin(), shape.values().end());
      EXPECT_GE(*low, 0.0f);
      EXPECT_GT(*high, 0.98f);
      EXPECT_LE(*high, 1.0f);
    }
  }
  EXPECT_GT(sharp.half, 5e-4);  // what is mended
  EXPECT_GT(sharp.most, 1.0);
  EXPECT_LT(worst.quarter, 0.007);
  EXPECT_LT(worst.half, 1e-4);
  EXPECT_LT(worst.most, 0.65);
}

TEST(FoldRelief, NoCompressionNoRelief) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(50e3), 60);
  const auto empty = test::uniform_field(grid, 0.0, 0.0);
  const auto skeleton = fold_skeleton(empty, FoldWavelength(5e3), {}, 1, context);
  Raster<float> speed(grid, 1.0f);  // even where something else would rise
  shape_folds(skeleton, speed, 125.0, context);
  EXPECT_EQ(speed, Raster<float>(grid));
  EXPECT_EQ(fold_distances(skeleton, grid, context).crest[0],
            std::numeric_limits<float>::infinity());
  EXPECT_THROW(crest_speed(empty, -1.0, context), InputError);
  EXPECT_THROW(crest_speed(empty, std::nan(""), context), InputError);
  // Beside compressed ground it fades.
  const auto belt = test::belt_field(grid);
  Raster<float> folds = crest_speed(belt, 1e-4, context);
  shape_folds(fold_skeleton(belt, FoldWavelength(5e3), {}, 1, context), folds, 125.0, context);
  for (int r = 0; r < grid.ny; ++r) EXPECT_EQ(folds(r, 3), 0.0f);
  EXPECT_GT(*std::max_element(folds.values().begin(), folds.values().end()), 2e-5f);
}

TEST(FoldRelief, LocalWavelengthIsNearTheAskedOne) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 200);
  const auto skeleton =
      fold_skeleton(test::uniform_field(grid, 0.3), FoldWavelength(4e3), {}, 1, context);
  const auto d = fold_distances(skeleton, grid, context);
  double sum = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i) sum += 2.0 * (d.crest[i] + d.trough[i]);
  EXPECT_NEAR(sum / double(grid.size()) / 4e3, 0.87, 0.03);
}

}  // namespace
}  // namespace orogen
