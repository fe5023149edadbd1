#include "strata/block.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

using Block = test::RoughBlock;

/// Twice the vector area of all faces, and the volume they enclose.
struct Measure {
  glm::dvec3 area{0.0};
  double volume = 0.0;

  explicit Measure(const RockMesh& mesh) {
    const auto add = [&](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
      const glm::dvec3 u = b - a, v = c - a;
      const glm::dvec3 cross(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
      area += cross;
      volume += (a.x * cross.x + a.y * cross.y + a.z * cross.z) / 6.0;
    };
    for (const auto& f : mesh.faces) {
      const glm::dvec3 p[] = {mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]],
                              mesh.vertices[f[3]]};
      add(p[0], p[1], p[2]);
      add(p[0], p[2], p[3]);
    }
  }
};

TEST(BlockDiagram, IsClosedAndHoldsTheVolumeUnderTheGround) {
  Block b;
  const RockMesh mesh = block_diagram(b.body, -1200.0, b.context);
  const Measure m(mesh);
  EXPECT_LT(std::fabs(m.area.x) + std::fabs(m.area.y) + std::fabs(m.area.z), 200.0);  // of 10⁷ m²
  double expected = 0.0;  // of the two triangles of each quadrangle
  for (int r = 0; r + 1 < b.grid.ny; ++r)
    for (int c = 0; c + 1 < b.grid.nx; ++c) {
      const auto z = [&](int i, int j) { return b.elevation(r + i, c + j) + 1200.0; };
      expected += b.grid.cell_area() *
                  ((z(0, 0) + z(0, 1) + z(1, 1)) + (z(0, 0) + z(1, 1) + z(1, 0))) / 6.0;
    }
  EXPECT_NEAR(m.volume, expected, 1e-4 * expected);
  EXPECT_EQ(mesh.faces.size(), mesh.layer.size());
  EXPECT_EQ(mesh.faces.size(), mesh.color.size());
}

TEST(BlockDiagram, WallsShowTheRockThatLiesThere) {
  Block b;
  const RockMesh mesh = block_diagram(b.body, -1200.0, b.context);
  std::vector<float> h(4);
  int checked = 0;
  for (std::size_t f = std::size_t(59) * 39; f + 1 < mesh.faces.size(); ++f) {
    glm::dvec3 middle(0.0);
    for (const int v : mesh.faces[f]) middle += 0.25 * glm::dvec3(mesh.vertices[v]);
    const glm::dvec2 place = glm::dvec2(middle.x, middle.y) + b.grid.origin;
    b.horizons.at(place, h.data());
    const auto& face = mesh.faces[f];
    const auto cut = [&](int v) {  // by the ground or by the base
      const glm::dvec3 p(mesh.vertices[v]);
      return p.z < -1199.9 || b.body.ground_at(glm::dvec2(p.x, p.y) + b.grid.origin) - p.z < 0.1;
    };
    // Where the ground or the base cuts a face halfway, its middle may be other rock.
    if (cut(face[0]) != cut(face[1]) || cut(face[2]) != cut(face[3])) continue;
    const Rock rock = b.rocks.rock_at(h.data(), float(middle.z));
    ASSERT_EQ(rock.layer, mesh.layer[f]);
    ASSERT_EQ(rock.sub_layer, mesh.sub_layer[f]);
    ++checked;
  }
  EXPECT_GT(checked, 300);
}

TEST(BlockDiagram, RefusesABaseAboveGround) {
  Block b;
  EXPECT_THROW(block_diagram(b.body, 5000.0, b.context), InputError);
  const Raster<float> one(Grid{1, 1, 100.0, {}});
  EXPECT_THROW(block_diagram({b.horizons, b.rocks, one}, -5000.0, b.context), InputError);
}

TEST(SectionMesh, HasTheSectionsArea) {
  Block b;
  const Section s = cut_section(b.body, {{2100, 1100}, {4900, 1100}}, 40.0, -900.0, b.context);
  double expected = 0.0;
  for (std::size_t i = 0; i + 1 < s.points.size(); ++i)
    expected +=
        (s.distance[i + 1] - s.distance[i]) * (0.5 * (s.surface[i] + s.surface[i + 1]) + 900.0);
  const Measure m(section_mesh(s, b.grid.origin));
  EXPECT_NEAR(-m.area.y / 2.0, expected, 1e-4 * expected);  // faces look south, to the right
  EXPECT_NEAR(m.area.x, 0.0, 1.0);
}

TEST(HorizonMesh, IsTheHorizonAndMayEndAtTheGround) {
  Block b;
  const RockMesh whole = horizon_mesh(b.body, 2, false, b.context);
  ASSERT_EQ(whole.vertices.size(), b.grid.size());
  for (std::size_t i = 0; i < b.grid.size(); ++i)
    ASSERT_EQ(whole.vertices[i].z, b.horizons.heights[2][i]);
  EXPECT_EQ(whole.faces.size(), 59u * 39u);
  const RockMesh cut = horizon_mesh(b.body, 2, true, b.context);
  EXPECT_LT(cut.faces.size(), whole.faces.size());
  EXPECT_GT(cut.faces.size(), 0u);
  EXPECT_THROW(horizon_mesh(b.body, 4, true, b.context), InputError);
}

}  // namespace
}  // namespace orogen
