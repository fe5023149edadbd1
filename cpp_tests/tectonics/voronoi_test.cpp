#include "tectonics/voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/random.h"

namespace orogen {
namespace {

const glm::dvec2 kLow{-5e3, 2e3}, kHigh{95e3, 62e3};

glm::dvec2 somewhere(std::uint64_t seed, std::uint64_t i) {
  return {kLow.x + (kHigh.x - kLow.x) * random_uniform(seed, 1, i),
          kLow.y + (kHigh.y - kLow.y) * random_uniform(seed, 2, i)};
}

bool inside(const Ring& ring, glm::dvec2 p, double tolerance) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec2 a = ring[i], d = ring[(i + 1) % ring.size()] - a;
    const double length = std::hypot(d.x, d.y);
    if (length > 0.0 && (d.x * (p.y - a.y) - d.y * (p.x - a.x)) / length < -tolerance) return false;
  }
  return !ring.empty();
}

void expect_partition(const std::vector<glm::dvec2>& points, std::uint64_t seed) {
  const auto cells = voronoi_cells(points, kLow, kHigh);
  ASSERT_EQ(cells.size(), points.size());
  double area = 0.0;
  for (const VoronoiCell& cell : cells) {
    ASSERT_EQ(cell.polygon.size(), cell.neighbours.size());
    ASSERT_GE(ring_area(cell.polygon), -1e-6);
    area += ring_area(cell.polygon);
  }
  const double whole = (kHigh.x - kLow.x) * (kHigh.y - kLow.y);
  EXPECT_NEAR(area, whole, 1e-9 * whole);
  for (int k = 0; k < 50; ++k) {
    const glm::dvec2 p = somewhere(seed + 1000, k);
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (std::hypot(points[i].x - p.x, points[i].y - p.y) <
          std::hypot(points[nearest].x - p.x, points[nearest].y - p.y))
        nearest = i;
    EXPECT_TRUE(inside(cells[nearest].polygon, p, 1e-3));
  }
}

TEST(Voronoi, PartitionsTheFrameByNearestPoint) {
  for (int seed = 0; seed < 100; ++seed) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 1 + seed * 2; ++i) points.push_back(somewhere(seed, i));
    expect_partition(points, seed);
  }
}

TEST(Voronoi, HandlesLinesGridsAndRepeatedPoints) {
  std::vector<glm::dvec2> line, grid, repeated;
  for (int i = 0; i < 10; ++i) line.push_back({9e3 * i, 10e3 + 4e3 * i});
  for (int i = 0; i < 64; ++i) grid.push_back({10e3 * (i % 8), 5e3 + 7e3 * (i / 8)});
  for (int i = 0; i < 30; ++i) repeated.push_back(somewhere(5, i % 10));
  expect_partition(line, 1);
  expect_partition(grid, 2);
  expect_partition(repeated, 3);
  const auto cells = voronoi_cells(repeated, kLow, kHigh);
  for (int i = 0; i < 30; ++i) EXPECT_EQ(cells[i].polygon.empty(), i >= 10);
  EXPECT_TRUE(voronoi_cells({}, kLow, kHigh).empty());
}

TEST(Voronoi, NeighboursAreMutual) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 80; ++i) points.push_back(somewhere(11, i));
  const auto cells = voronoi_cells(points, kLow, kHigh);
  for (int i = 0; i < 80; ++i)
    for (std::size_t k = 0; k < cells[i].polygon.size(); ++k) {
      const int j = cells[i].neighbours[k];
      const glm::dvec2 side =
          cells[i].polygon[(k + 1) % cells[i].polygon.size()] - cells[i].polygon[k];
      if (j < 0 || std::hypot(side.x, side.y) < 1e-3) continue;
      const auto& back = cells[j].neighbours;
      EXPECT_NE(std::find(back.begin(), back.end(), i), back.end());
    }
}

TEST(Voronoi, CentroidAndArea) {
  const Ring ring{{1e6, 1e6}, {1e6 + 4.0, 1e6}, {1e6 + 4.0, 1e6 + 2.0}, {1e6, 1e6 + 2.0}};
  EXPECT_NEAR(ring_area(ring), 8.0, 1e-9);
  EXPECT_NEAR(ring_centroid(ring).x, 1e6 + 2.0, 1e-9);
  EXPECT_NEAR(ring_centroid(ring).y, 1e6 + 1.0, 1e-9);
}

}  // namespace
}  // namespace orogen
