#include "foundation/tin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <set>

#include "foundation/errors.h"
#include "foundation/hilbert.h"
#include "foundation/random.h"

namespace orogen {
namespace {

/// Domains from a few vertices to some thousand, far from square too, by either maker.
Tin random_tin(int number, const Context& context) {
  const auto uniform = [&](int what) { return random_uniform(number, 70, what); };
  const TinDomain domain{{-1e6 * uniform(0), 4.6e6 * uniform(1)},
                         {1e4 * (0.01 + uniform(2)), 1e4 * (0.01 + uniform(3))}};
  const double spacing = std::sqrt(domain.area()) / std::pow(10.0, 1.9 * uniform(4) - 0.1);
  return (number % 2 ? poisson_tin : jittered_tin)(domain, spacing, std::uint32_t(number), context);
}

TEST(Hilbert, EveryCellFollowsOneBesideIt) {
  // The first 64 x 64 cells of the curve fill a square (its first 4096 places).
  std::vector<std::pair<int, int>> cells(4096, {-1, -1});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const std::uint32_t key = hilbert_key(std::uint32_t(x), std::uint32_t(y));
      ASSERT_LT(key, 4096u);
      cells[key] = {x, y};
    }
  for (std::size_t k = 1; k < cells.size(); ++k)
    ASSERT_EQ(std::abs(cells[k].first - cells[k - 1].first) +
                  std::abs(cells[k].second - cells[k - 1].second),
              1)
        << k;
  EXPECT_NE(hilbert_key(65535, 0), hilbert_key(0, 65535));
}

TEST(Tin, AreasArePositiveAndSumToTheDomains) {
  Context context;
  for (int number = 0; number < 100; ++number) {
    const Tin tin = random_tin(number, context);
    double sum = 0.0;
    for (double a : tin.cell_areas) {
      ASSERT_GT(a, 0.0);
      sum += a;
    }
    ASSERT_NEAR(sum, tin.domain.area(), 1e-9 * tin.domain.area()) << number;
  }
}

TEST(Tin, TrianglesAreDelaunayAndFillTheRectangle) {
  Context context;
  for (int number = 0; number < 40; ++number) {
    const Tin tin = random_tin(number, context);
    if (tin.size() > 2000) continue;
    const glm::dvec2 origin = tin.domain.origin;
    std::size_t on_sides = 0;
    for (std::uint8_t s : tin.sides) on_sides += s != 0;
    // Euler: with b of n vertices on the hull there are 2 n - b - 2 triangles.
    ASSERT_EQ(tin.triangles.size(), 2 * tin.size() - on_sides - 2) << number;
    for (const auto& t : tin.triangles) {
      ASSERT_LT(t[0], t[1]);
      ASSERT_LT(t[0], t[2]);
      const glm::dvec2 a = tin.points[t[0]] - origin, b = tin.points[t[1]] - origin - a,
                       c = tin.points[t[2]] - origin - a;
      const double twice = b.x * c.y - b.y * c.x;
      ASSERT_GT(twice, 0.0);
      const double bb = b.x * b.x + b.y * b.y, cc = c.x * c.x + c.y * c.y;
      const glm::dvec2 middle{(c.y * bb - b.y * cc) / (2 * twice),
                              (b.x * cc - c.x * bb) / (2 * twice)};
      const double radius = std::hypot(middle.x, middle.y);
      for (const glm::dvec2 p : tin.points) {
        const glm::dvec2 way = p - origin - a - middle;
        ASSERT_GT(std::hypot(way.x, way.y), radius * (1.0 - 1e-9));
      }
    }
    ASSERT_TRUE(std::is_sorted(tin.triangles.begin(), tin.triangles.end()));
  }
}

TEST(Tin, NeighborsAreTheSidesOfTriangles) {
  Context context;
  for (int number = 0; number < 40; ++number) {
    const Tin tin = random_tin(number, context);
    std::set<std::pair<std::int32_t, std::int32_t>> sides;
    for (const auto& t : tin.triangles)
      for (int k = 0; k < 3; ++k) {
        sides.insert({t[k], t[(k + 1) % 3]});
        sides.insert({t[(k + 1) % 3], t[k]});
      }
    auto side = sides.begin();
    for (std::int32_t v = 0; v < std::int32_t(tin.size()); ++v)
      for (std::int32_t e = tin.first_edge[v]; e < tin.first_edge[v + 1]; ++e, ++side) {
        ASSERT_NE(side, sides.end());
        ASSERT_EQ(*side, std::pair(v, tin.neighbors[e]));
        const glm::dvec2 way = tin.points[v] - tin.points[tin.neighbors[e]];
        ASSERT_FLOAT_EQ(tin.edge_lengths[e], float(std::hypot(way.x, way.y)));
      }
    ASSERT_EQ(side, sides.end());
  }
}

TEST(Tin, SidesAreStraightAndCornersAreThere) {
  Context context;
  for (int number = 0; number < 40; ++number) {
    const Tin tin = random_tin(number, context);
    const glm::dvec2 low = tin.domain.origin, high = tin.domain.far_corner();
    std::vector<int> corners(16, 0);
    for (std::size_t i = 0; i < tin.size(); ++i) {
      const glm::dvec2 p = tin.points[i];
      const int expected =
          (p.x == low.x) + 2 * (p.x == high.x) + 4 * (p.y == low.y) + 8 * (p.y == high.y);
      ASSERT_EQ(tin.sides[i], expected);
      ++corners[expected];
    }
    for (int corner : {5, 6, 9, 10}) ASSERT_EQ(corners[corner], 1);
    const auto mask = side_mask(tin, kWestSide | kNorthSide);
    ASSERT_EQ(std::count(mask.begin(), mask.end(), 1),
              corners[1] + corners[8] + corners[5] + corners[9] + corners[10]);
  }
}

TEST(Tin, SpacingGivesTheCountAskedForAndPointsKeepApart) {
  Context context;
  const TinDomain domain{{0, 0}, {60e3, 40e3}};
  for (double count : {1000.0, 20000.0})
    for (auto maker : {jittered_tin, poisson_tin}) {
      const double spacing = spacing_for(domain, count);
      const Tin tin = maker(domain, spacing, 3, context);
      EXPECT_NEAR(double(tin.size()), count, 0.08 * count);
      float shortest = 1e9f, longest = 0.0f;
      for (float length : tin.edge_lengths) {
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
      }
      EXPECT_GT(shortest, (maker == poisson_tin ? 0.45 : 0.02) * spacing);
      EXPECT_LT(longest, 2.6 * spacing);
    }
}

TEST(Tin, NoTriangleIsObtuseAtASide) {
  Context context;
  for (int number = 0; number < 20; ++number) {
    const Tin tin = (number % 2 ? poisson_tin : jittered_tin)(
        {{0, 0}, {6e3, 4e3}}, 100.0 + 3.0 * number, std::uint32_t(number), context);
    for (const auto& t : tin.triangles)
      for (int k = 0; k < 3; ++k) {
        if (!(tin.sides[t[k]] & tin.sides[t[(k + 1) % 3]])) continue;
        const glm::dvec2 apex = tin.points[t[(k + 2) % 3]];
        const glm::dvec2 p = tin.points[t[k]] - apex, q = tin.points[t[(k + 1) % 3]] - apex;
        ASSERT_GE(p.x * q.x + p.y * q.y, 0.0) << number;
      }
  }
}

TEST(Tin, NumbersFollowSpace) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {1e5, 1e5}}, 800.0, 1, context);
  double way = 0.0;
  for (std::size_t i = 1; i < tin.size(); ++i) {
    const glm::dvec2 step = tin.points[i] - tin.points[i - 1];
    way += std::hypot(step.x, step.y);
  }
  EXPECT_LT(way / double(tin.size()), 1.4 * 800.0);
}

TEST(Tin, OrderOfPointsAndThreadsDoNotMatter) {
  Context one({}, 1), four({}, 4);
  Tin a, b;
  const TinDomain domain{{5.0, -3.0}, {3000.0, 2000.0}};
  one.run([&] { a = poisson_tin(domain, 40.0, 9, one); });
  four.run([&] { b = poisson_tin(domain, 40.0, 9, four); });
  std::vector<glm::dvec2> reversed(a.points.rbegin(), a.points.rend());
  const Tin c = triangulate(domain, reversed, one);
  for (const Tin* other : {static_cast<const Tin*>(&b), &c}) {
    EXPECT_EQ(a.points, other->points);
    EXPECT_EQ(a.triangles, other->triangles);
    EXPECT_EQ(a.neighbors, other->neighbors);
    EXPECT_EQ(a.cell_areas, other->cell_areas);
  }
  EXPECT_NE(a.points, poisson_tin(domain, 40.0, 10, one).points);
}

TEST(Tin, SquareOfFourCorners) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {10, 10}}, 100.0, 1, context);
  EXPECT_EQ(tin.size(), 4u);
  EXPECT_EQ(tin.triangles.size(), 2u);
}

TEST(Tin, RefusesWhatIsNoMesh) {
  Context context;
  const TinDomain square{{0, 0}, {1, 1}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<glm::dvec2> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto with = [&](glm::dvec2 p) {
    auto points = corners;
    points.push_back(p);
    return points;
  };
  EXPECT_NO_THROW(triangulate(square, with({0.5, 0.5}), context));
  EXPECT_THROW(triangulate(square, with({0.5, 1.5}), context), InputError);
  EXPECT_THROW(triangulate(square, with({nan, 0.5}), context), InputError);
  EXPECT_THROW(triangulate(square, with({1, 1}), context), InputError);
  EXPECT_THROW(triangulate(square, {{0, 0}, {1, 0}, {1, 1}}, context), InputError);
  EXPECT_THROW(triangulate({{0, 0}, {0, 1}}, corners, context), InputError);
  EXPECT_THROW(triangulate({{0, nan}, {1, 1}}, corners, context), InputError);
  EXPECT_THROW(jittered_tin(square, 0.0, 1, context), InputError);
  EXPECT_THROW(jittered_tin(square, 1e-6, 1, context), InputError);
  EXPECT_THROW(poisson_tin(square, nan, 1, context), InputError);
  EXPECT_THROW(spacing_for(square, 3.0), InputError);
}

}  // namespace
}  // namespace orogen
