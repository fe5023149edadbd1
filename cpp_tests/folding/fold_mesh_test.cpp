#include "folding/fold_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "folding/segment.h"
#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

constexpr glm::dvec2 kLow(0.0, 0.0), kHigh(100e3, 100e3);

bool inside(glm::dvec2 p) {
  return p.x > 0.0 && p.y > 0.0 && p.x < 100e3 && p.y < 100e3;
}

TEST(FoldMesh, MeanEdgeIsTheWavelength) {
  const Context context;
  for (const auto& [lambda, seeds, paper] :
       {std::tuple{7e3, 20, 955}, std::tuple{3e3, 6, 4246}, std::tuple{1e3, 1, 36715}}) {
    double sum = 0.0;
    int count = 0;
    for (int seed = 0; seed < seeds; ++seed) {
      const FoldMesh mesh = fold_mesh(kLow, kHigh, FoldWavelength(lambda), seed, context);
      EXPECT_NEAR(double(mesh.edges.size()), paper, 0.25 * paper);
      for (int e = 0; e < int(mesh.edges.size()); ++e)
        if (inside(mesh.middle(e))) {
          sum += glm::length(mesh.along(e));
          ++count;
        }
    }
    EXPECT_NEAR(sum / count, lambda, 0.01 * lambda);
  }
}

TEST(FoldMesh, PointsKeepTheirDistanceAndLeaveNoHole) {
  const Context context;
  for (int seed = 0; seed < 20; ++seed) {
    const double lambda = 4e3 + 1e3 * seed;
    const FoldMesh mesh = fold_mesh(kLow, kHigh, FoldWavelength(lambda), seed, context);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        nearest = std::min(nearest, glm::distance(mesh.points[i], mesh.points[j]));
    EXPECT_GE(nearest, 0.727 * lambda * (1 - 1e-9));
    for (int k = 0; k < 200; ++k) {
      const glm::dvec2 p =
          100e3 * glm::dvec2(random_uniform(seed, 1, k), random_uniform(seed, 2, k));
      double d = std::numeric_limits<double>::infinity();
      for (const glm::dvec2 q : mesh.points) d = std::min(d, glm::distance(p, q));
      EXPECT_LE(d, lambda);
    }
  }
}

TEST(FoldMesh, IsADelaunayTriangulation) {
  const Context context;
  for (int seed = 0; seed < 20; ++seed) {
    const FoldMesh mesh = fold_mesh(kLow, kHigh, FoldWavelength(9e3), seed, context);
    // Euler: the outer face is the other one.
    EXPECT_EQ(mesh.points.size() - mesh.edges.size() + mesh.faces.size(), 1u);
    for (int f = 0; f < int(mesh.faces.size()); ++f) {
      const auto& face = mesh.faces[f];
      const glm::dvec2 a = mesh.points[face.points[0]], b = mesh.points[face.points[1]] - a,
                       c = mesh.points[face.points[2]] - a;
      const double twice = b.x * c.y - b.y * c.x;
      ASSERT_GT(twice, 0.0);
      const double bb = glm::dot(b, b), cc = glm::dot(c, c);
      const glm::dvec2 middle((c.y * bb - b.y * cc) / (2 * twice),
                              (b.x * cc - c.x * bb) / (2 * twice));
      for (const glm::dvec2 p : mesh.points)
        ASSERT_GE(glm::distance(p, a + middle), glm::length(middle) * (1 - 1e-9));
      for (int k = 0; k < 3; ++k) {
        const auto& edge = mesh.edges[face.edges[k]];
        const int p = face.points[k], q = face.points[(k + 1) % 3];
        ASSERT_EQ(edge.a, std::min(p, q));
        ASSERT_EQ(edge.b, std::max(p, q));
        ASSERT_EQ(p < q ? edge.left : edge.right, f);
      }
    }
    ASSERT_TRUE(std::is_sorted(
        mesh.edges.begin(), mesh.edges.end(),
        [](const auto& s, const auto& t) { return std::pair(s.a, s.b) < std::pair(t.a, t.b); }));
  }
}

TEST(FoldMesh, PointsStayWhereTheRectangleGrows) {
  const Context context;
  const FoldWavelength lambda(3e3);
  const auto small = fold_mesh(kLow, kHigh, lambda, 5, context).points;
  const auto large =
      fold_mesh(kLow - glm::dvec2(21e3), kHigh + glm::dvec2(8e3), lambda, 5, context).points;
  int kept = 0, all = 0;
  for (const glm::dvec2 p : small)
    if (p.x > 15e3 && p.y > 15e3 && p.x < 85e3 && p.y < 85e3) {
      ++all;
      kept += std::find(large.begin(), large.end(), p) != large.end();
    }
  EXPECT_EQ(kept, all);
  EXPECT_GT(all, 400);
}

TEST(FoldMesh, EdgesFollowAVaryingWavelength) {
  const Context context;
  Raster<float> raster(grid_over(kLow, kHigh, 64));
  for (int r = 0; r < 64; ++r)
    for (int c = 0; c < 64; ++c) raster(r, c) = float(2e3 + 6e3 * c / 63.0);
  const FoldWavelength lambda(raster);
  EXPECT_EQ(lambda.lowest(), 2e3);
  EXPECT_EQ(lambda.highest(), 8e3);
  double sum[4]{}, count[4]{};
  for (int seed = 0; seed < 5; ++seed) {
    const FoldMesh mesh = fold_mesh(kLow, kHigh, lambda, seed, context);
    for (int e = 0; e < int(mesh.edges.size()); ++e) {
      const glm::dvec2 m = mesh.middle(e);
      if (!inside(m)) continue;
      sum[int(m.x / 25e3)] += glm::length(mesh.along(e)) / lambda.at(m);
      ++count[int(m.x / 25e3)];
    }
  }
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(sum[k] / count[k], 1.0, 0.05);
}

TEST(FoldMesh, SmallAndNarrowRectangles) {
  const Context context;
  for (const glm::dvec2 size : {glm::dvec2(10.0, 10.0), glm::dvec2(10.0, 50e3), glm::dvec2(0.0)})
    for (int seed = 0; seed < 20; ++seed) {
      const FoldMesh mesh =
          fold_mesh({3e5, -2e5}, glm::dvec2(3e5, -2e5) + size, FoldWavelength(7e3), seed, context);
      EXPECT_GE(mesh.points.size(), 2u);
      EXPECT_EQ(mesh.points.size() - mesh.edges.size() + mesh.faces.size(), 1u);
    }
}

TEST(FoldMesh, RefusesWavelengthsThatCannotBe) {
  const Context context;
  for (const double bad : {0.0, -3.0, std::nan(""), 1e7})
    EXPECT_THROW(FoldWavelength{bad}, InputError);
  Raster<float> raster(Grid{3, 3, 10.0}, 50.0f);
  raster[4] = std::nanf("");
  EXPECT_THROW(FoldWavelength{raster}, InputError);
  raster[4] = 0.0f;
  EXPECT_THROW(FoldWavelength{raster}, InputError);
  EXPECT_THROW(FoldWavelength{Raster<float>()}, InputError);
  EXPECT_THROW(fold_mesh(kLow, kHigh, FoldWavelength(2.0), 1, context), InputError);
}

}  // namespace
}  // namespace orogen
