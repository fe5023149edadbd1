#include "island/polygon_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

const glm::dvec2 kLow{-5e3, 2e3}, kHigh{95e3, 62e3};

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

double distance(glm::dvec2 a, glm::dvec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

double signed_area(const PolygonMap& map, std::int32_t center) {
  const auto ring = map.center_corners.of(center);
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += cross(map.corners[ring[i]] - map.centers[center],
                   map.corners[ring[(i + 1) % ring.size()]] - map.centers[center]);
  return 0.5 * twice;
}

/// Euler's formula, and what the lists say of each other.
void expect_graph(const PolygonMap& map) {
  ASSERT_EQ(map.corners.size() + map.centers.size(), map.edge_centers.size() + 1);
  for (std::int32_t e = 0; e < std::int32_t(map.edge_centers.size()); ++e) {
    const auto [c, d] = map.edge_centers[e];
    const auto [v, w] = map.edge_corners[e];
    ASSERT_TRUE(c >= 0 && c != d && v >= 0 && w >= 0 && v != w);
    ASSERT_TRUE(d >= 0 || (map.center_border[c] && map.corner_border[v] && map.corner_border[w]));
  }
  for (std::int32_t c = 0; c < std::int32_t(map.centers.size()); ++c) {
    const auto edges = map.center_edges.of(c), corners = map.center_corners.of(c);
    ASSERT_EQ(edges.size(), corners.size());
    ASSERT_GE(corners.size(), 3u);
    ASSERT_EQ(std::set(corners.begin(), corners.end()).size(), corners.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
      ASSERT_EQ(map.other_end(edges[i], corners[i]), corners[(i + 1) % corners.size()]);
  }
  std::size_t touches = 0;
  for (std::int32_t v = 0; v < std::int32_t(map.corners.size()); ++v) {
    const auto edges = map.corner_edges.of(v);
    touches += map.corner_centers.of(v).size();
    for (const std::int32_t e : edges) ASSERT_NE(map.other_end(e, v), v);
    ASSERT_EQ(map.corner_centers.of(v).size() + map.corner_border[v], edges.size());
  }
  ASSERT_EQ(touches, map.center_corners.items.size());
}

/// Cells are convex, cover the rectangle, and hold what is nearest to their centers.
void expect_cells(const PolygonMap& map, double scale) {
  double area = 0.0;
  for (std::int32_t c = 0; c < std::int32_t(map.centers.size()); ++c) {
    const auto ring = map.center_corners.of(c);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const glm::dvec2 a = map.corners[ring[i]], b = map.corners[ring[(i + 1) % ring.size()]];
      const glm::dvec2 d = map.corners[ring[(i + 2) % ring.size()]];
      ASSERT_GE(cross(b - a, d - b), -1e-9 * scale * scale);
      ASSERT_GE(cross(b - a, map.centers[c] - a), -1e-9 * scale * scale);
      for (const std::int32_t other : map.corner_centers.of(ring[i]))
        ASSERT_NEAR(distance(a, map.centers[other]), distance(a, map.centers[c]), 1e-8 * scale);
    }
    area += signed_area(map, c);
  }
  const double whole = (map.high.x - map.low.x) * (map.high.y - map.low.y);
  ASSERT_NEAR(area, whole, 1e-9 * whole);
}

TEST(PolygonMap, IsAGraphOfConvexCellsThatCoverTheRectangle) {
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    const int cells = 16 + int(seed % 97) * (seed % 10 ? 1 : 20);
    const auto map = random_polygon_map(cells, seed % 4, kLow, kHigh, seed, Context());
    ASSERT_EQ(map.centers.size(), std::size_t(cells));
    expect_graph(map);
    expect_cells(map, 1e5);
    if (HasFatalFailure()) return;
  }
}

TEST(PolygonMap, HoldsWithPointsOnLatticesAndOnTheSides) {
  for (const int n : {2, 3, 7, 20}) {
    std::vector<glm::dvec2> square, hexagonal, on_sides;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        square.push_back({(i + 0.5) / n, (j + 0.5) / n});
        hexagonal.push_back({(i + 0.25 + 0.5 * (j % 2)) / n, (j + 0.5) / n});
        on_sides.push_back({double(i) / (n - 1), double(j) / (n - 1)});
      }
    for (const auto& points : {square, hexagonal, on_sides}) {
      const auto map = polygon_map(points, {0.0, 0.0}, {1.0, 1.0}, Context());
      expect_graph(map);
      expect_cells(map, 1.0);
    }
  }
}

TEST(PolygonMap, RelaxationEvensCellsOut) {
  double before = INFINITY;
  for (const int times : {0, 1, 2, 3}) {
    const auto map = random_polygon_map(4000, times, kLow, kHigh, 7, Context());
    const double mean = 1e5 * 6e4 / 4000.0;
    double variance = 0.0;
    for (std::int32_t c = 0; c < 4000; ++c)
      variance += std::pow(signed_area(map, c) / mean - 1.0, 2) / 4000.0;
    EXPECT_LT(variance, 0.9 * before) << times;
    before = variance;
  }
  EXPECT_LT(before, 0.14);  // random points: 0.28; corners are averaged, not areas
}

TEST(PolygonMap, RefusesWhatHasNoCells) {
  const auto refused = [](std::vector<glm::dvec2> points, const char* word) {
    try {
      polygon_map(std::move(points), {0.0, 0.0}, {1.0, 1.0}, Context());
      ADD_FAILURE() << word;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused({{0.1, 0.1}, {0.5, 0.5}, {1.1, 0.2}}, "outside");
  refused({{0.1, 0.1}, {0.5, 0.7}, {0.1, 0.1}}, "twice");
  refused({{0.1, 0.1}, {0.5, 0.5}, {0.9, 0.9}}, "line");
  refused({}, "line");
}

}  // namespace
}  // namespace orogen
