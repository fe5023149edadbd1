#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "foundation/random.h"
#include "foundation/tin.h"
#include "foundation/tin_sampling.h"

namespace orogen {
namespace {

TEST(TinGrid, EveryCellHasItsNeighboursAndItsArea) {
  for (const auto& [columns, rows] : {std::pair{2, 2}, {7, 2}, {2, 5}, {13, 11}}) {
    const Tin tin = grid_tin({{50.0, -20.0}, {columns * 30.0, rows * 40.0}}, columns, rows);
    ASSERT_EQ(tin.size(), std::size_t(columns) * rows);
    EXPECT_EQ(tin.columns, columns);
    EXPECT_EQ(tin.domain.origin, glm::dvec2(65.0, 0.0));
    for (std::int32_t v = 0; v < std::int32_t(tin.size()); ++v) {
      const int r = v / columns, c = v % columns;
      EXPECT_NEAR(tin.points[v].x, 65.0 + 30.0 * c, 1e-9);
      EXPECT_NEAR(tin.points[v].y, 40.0 * r, 1e-9);
      EXPECT_EQ(tin.cell_areas[v], 1200.0);
      EXPECT_EQ(tin.sides[v], (c == 0 ? kWestSide : 0) | (c == columns - 1 ? kEastSide : 0) |
                                  (r == 0 ? kSouthSide : 0) | (r == rows - 1 ? kNorthSide : 0));
      std::vector<std::int32_t> near;
      for (std::int32_t n = 0; n < std::int32_t(tin.size()); ++n)
        if (n != v && std::abs(n / columns - r) <= 1 && std::abs(n % columns - c) <= 1)
          near.push_back(n);
      ASSERT_TRUE(std::ranges::equal(tin.neighbors_of(v), near)) << v;
      for (std::int32_t e = tin.first_edge[v]; e < tin.first_edge[v + 1]; ++e) {
        const glm::dvec2 way = tin.points[tin.neighbors[e]] - tin.points[v];
        EXPECT_NEAR(tin.edge_lengths[e], std::hypot(way.x, way.y), 1e-5);
      }
    }
    double area = 0.0;
    for (const auto& t : tin.triangles) {
      const glm::dvec2 a = tin.points[t[1]] - tin.points[t[0]];
      const glm::dvec2 b = tin.points[t[2]] - tin.points[t[0]];
      EXPECT_GT(a.x * b.y - a.y * b.x, 0.0);
      EXPECT_EQ(t[0], std::min({t[0], t[1], t[2]}));
      area += 0.5 * (a.x * b.y - a.y * b.x);
    }
    EXPECT_NEAR(area, tin.domain.area(), 1e-9 * area);
  }
  EXPECT_THROW(grid_tin({{0.0, 0.0}, {10.0, 10.0}}, 1, 5), InputError);
  EXPECT_THROW(grid_tin({{0.0, 0.0}, {10.0, 0.0}}, 5, 5), InputError);
}

TEST(TinGrid, ItsOwnGridTakesValuesAsTheyAre) {
  Context context;
  const Grid grid{17, 9, 33.3, {1e5, -7e4}};
  const Tin tin = grid_tin({grid.origin, {grid.width(), grid.height()}}, grid.nx, grid.ny);
  std::vector<double> field(tin.size());
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = random_uniform(1, 1, i);
  const Raster<float> same = sample_to_grid(tin, field, grid, context);
  for (std::size_t i = 0; i < field.size(); ++i) ASSERT_EQ(same[i], float(field[i]));
  // On another grid planes are exact inside, and held beyond the outermost middles.
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = tin.points[i].x - grid.origin.x;
  const Grid fine{34, 18, 16.65, grid.origin};
  const Raster<float> plane = sample_to_grid(tin, field, fine, context);
  for (int c = 0; c < fine.nx; ++c)
    ASSERT_NEAR(plane(5, c), std::clamp((c + 0.5) * 16.65, 16.65, 16.5 * 33.3), 1e-3);
}

}  // namespace
}  // namespace orogen
