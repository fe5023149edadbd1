#include "tectonics/iso_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/noise.h"
#include "foundation/random.h"

namespace orogen {
namespace {

const std::vector<Grid> kGrids{{1, 1, 10.0, {0.0, 0.0}},     {1, 31, 10.0, {5.0, 7.0}},
                               {31, 1, 10.0, {0.0, 0.0}},    {2, 2, 3.0, {-1.0, 2.0}},
                               {61, 47, 100.0, {3e3, -2e3}}, {40, 40, 1.0, {0.0, 0.0}}};

Raster<float> random_field(std::uint64_t seed, const Grid& grid) {
  if (seed % 3 == 0)
    return fbm({.seed = std::uint32_t(seed), .wavelength = 20.0 * grid.cell_size}, grid, Context{});
  Raster<float> field(grid);  // salt and pepper, for even seeds with many on the level; white noise
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] = seed % 3 == 1 ? float(random_bits(seed, 0, i) % 3) - (seed % 2 ? 0.75f : 1.0f)
                             : float(random_uniform(seed, 0, i) - 0.5);
  return field;
}

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 e = b - a;
  const double n = e.x * e.x + e.y * e.y;
  const double t = n > 0.0 ? std::clamp(((p - a).x * e.x + (p - a).y * e.y) / n, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * e.x, p.y - a.y - t * e.y);
}

double bilinear(const Raster<float>& field, glm::dvec2 p) {
  const Grid& grid = field.grid();
  const glm::dvec2 at = grid.to_cells(p) - 0.5;
  const int c = std::clamp(int(at.x), 0, std::max(grid.nx - 2, 0));
  const int r = std::clamp(int(at.y), 0, std::max(grid.ny - 2, 0));
  const double x = at.x - c, y = at.y - r;
  return (1 - y) * ((1 - x) * field(r, c) + x * field(r, c + 1)) +
         y * ((1 - x) * field(r + 1, c) + x * field(r + 1, c + 1));
}

TEST(IsoLines, EachSideThatChangesIsCrossedOnceAtTheLevel) {
  for (std::uint64_t seed = 0; seed < 102; ++seed) {
    const Grid& grid = kGrids[seed % kGrids.size()];
    const auto field = random_field(seed, grid);
    const auto lines = iso_lines(field, 0.0f, Context{});
    std::size_t crossings = 0, expected = 0;
    for (const Polyline& line : lines) {
      ASSERT_GE(line.size(), 2u);
      const bool closed = line.front() == line.back() && line.size() > 2;
      crossings += line.size() - closed;
      for (const glm::dvec2 p : line) EXPECT_NEAR(bilinear(field, p), 0.0, 1e-5);
      for (std::size_t i = 1; i < line.size(); ++i)
        EXPECT_LE(std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y),
                  1.4143 * grid.cell_size);
      if (!closed)
        for (const glm::dvec2 end : {line.front(), line.back()}) {
          const glm::dvec2 at = grid.to_cells(end) - 0.5;
          const double side =
              std::min(std::min(at.x, grid.nx - 1 - at.x), std::min(at.y, grid.ny - 1 - at.y));
          EXPECT_NEAR(side, 0.0, 1e-9);
        }
    }
    if (grid.nx < 2 || grid.ny < 2) {
      EXPECT_TRUE(lines.empty());
      continue;
    }
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        if (c + 1 < grid.nx) expected += (field(r, c) >= 0.0f) != (field(r, c + 1) >= 0.0f);
        if (r + 1 < grid.ny) expected += (field(r, c) >= 0.0f) != (field(r + 1, c) >= 0.0f);
      }
    // On the level itself an open line's ends may fall together.
    if (seed % 6 != 4) {
      EXPECT_EQ(crossings, expected) << seed;
    }
  }
}

TEST(IsoLines, HigherGroundLiesOnTheLeft) {
  const Grid grid{60, 50, 10.0, {0.0, 0.0}};
  const auto field = random_field(3, grid);
  int checked = 0;
  for (const Polyline& line : iso_lines(field, 0.0f, Context{}))
    for (std::size_t i = 1; i < line.size(); ++i) {
      const glm::dvec2 d = line[i] - line[i - 1], middle = 0.5 * (line[i] + line[i - 1]);
      const double length = std::hypot(d.x, d.y);
      if (length < 3.0) continue;
      const glm::dvec2 left = glm::dvec2(-d.y, d.x) / length;
      EXPECT_GT(bilinear(field, middle + left), bilinear(field, middle - left));
      ++checked;
    }
  EXPECT_GT(checked, 50);
}

TEST(IsoLines, ACircleIsOneClosedLine) {
  const Grid grid{81, 81, 25.0, {0.0, 0.0}};
  Raster<float> field(grid);
  for (int r = 0; r < 81; ++r)
    for (int c = 0; c < 81; ++c) {
      const glm::dvec2 d = grid.center(r, c) - glm::dvec2(1000.0);
      field(r, c) = 700.0f - float(std::hypot(d.x, d.y));
    }
  const auto lines = iso_lines(field, 0.0f, Context{});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].front(), lines[0].back());
  double length = 0.0;
  for (std::size_t i = 1; i < lines[0].size(); ++i)
    length += std::hypot(lines[0][i].x - lines[0][i - 1].x, lines[0][i].y - lines[0][i - 1].y);
  EXPECT_NEAR(length, 2.0 * 3.14159265 * 700.0, 5.0);
  const auto distance = signed_distance(field, 0.0f, lines, Context{});
  for (int i = 0; i < 81 * 81; ++i) EXPECT_NEAR(distance[i], field[i], 0.25 * 25.0);
}

TEST(IsoLines, DistanceIsThatToTheNearestPiece) {
  for (std::uint64_t seed = 0; seed < 99; seed += 3) {
    const Grid grid{61, 47, 100.0, {3e3, -2e3}};
    const auto field = random_field(seed, grid);
    const auto lines = iso_lines(field, 0.0f, Context{});
    const auto distance = signed_distance(field, 0.0f, lines, Context{});
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        double best = lines.empty() ? grid.width() + grid.height() : 1e30;
        for (const Polyline& line : lines)
          for (std::size_t i = 1; i < line.size(); ++i)
            best = std::min(best, distance_to_segment(grid.center(r, c), line[i - 1], line[i]));
        EXPECT_EQ(distance(r, c) < 0.0f, field(r, c) < 0.0f && best > 0.0);
        EXPECT_NEAR(std::fabs(distance(r, c)), best, best < 100.0 ? 1e-3 : 141.5);
        EXPECT_GE(std::fabs(distance(r, c)), best - 1e-3);
      }
  }
}

}  // namespace
}  // namespace orogen
