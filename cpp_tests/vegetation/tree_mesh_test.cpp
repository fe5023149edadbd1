#include "vegetation/tree_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <set>

#include "foundation/errors.h"
#include "random_trees.h"
#include "vegetation/tree_species.h"

namespace orogen {
namespace {

const Context kContext;

std::span<const std::int32_t> face(const PlantMesh& mesh, std::size_t f) {
  return std::span(mesh.corners)
      .subspan(mesh.face_starts[f], mesh.face_starts[f + 1] - mesh.face_starts[f]);
}

/// Twice the area of a flat face, as a vector.
glm::dvec3 doubled_area(const PlantMesh& mesh, std::size_t f) {
  const auto corners = face(mesh, f);
  const glm::dvec3 first = mesh.positions[corners[0]];
  glm::dvec3 sum{0.0, 0.0, 0.0};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += glm::cross(glm::dvec3(mesh.positions[corners[k]]) - first,
                      glm::dvec3(mesh.positions[corners[k + 1]]) - first);
  return sum;
}

void expect_sound_arrays(const PlantMesh& mesh) {
  const std::size_t faces = mesh.materials.size();
  ASSERT_EQ(mesh.levels.size(), faces);
  ASSERT_EQ(mesh.face_starts.size(), faces + 1);
  ASSERT_EQ(mesh.uvs.size(), mesh.corners.size());
  ASSERT_EQ(mesh.face_starts.front(), 0);
  ASSERT_EQ(mesh.face_starts.back(), std::int32_t(mesh.corners.size()));
  std::vector<char> used(mesh.positions.size(), 0);
  for (std::size_t f = 0; f < faces; ++f) {
    const auto corners = face(mesh, f);
    ASSERT_GE(corners.size(), 3u);
    ASSERT_EQ(std::set(corners.begin(), corners.end()).size(), corners.size());
    for (const std::int32_t v : corners) {
      ASSERT_TRUE(v >= 0 && v < std::int32_t(mesh.positions.size()));
      used[v] = 1;
    }
  }
  ASSERT_EQ(std::count(used.begin(), used.end(), 0), 0) << "vertices without faces";
  for (const glm::vec3 p : mesh.positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
}

/// Tubes are closed but for one ring each, and hang together as their faces' sides say.
void expect_closed_tubes(const PlantMesh& mesh, std::size_t tubes) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> sides;
  for (std::size_t f = 0; f < mesh.materials.size(); ++f) {
    if (mesh.materials[f] != PlantMaterial::Stem) continue;
    const auto corners = face(mesh, f);
    for (std::size_t k = 0; k < corners.size(); ++k)
      ASSERT_EQ(++(sides[{corners[k], corners[(k + 1) % corners.size()]}]), 1);
  }
  std::map<std::int32_t, std::int32_t> rim;
  for (const auto& [side, count] : sides)
    if (!sides.contains({side.second, side.first})) {
      ASSERT_TRUE(rim.emplace(side.first, side.second).second);
    }
  std::size_t rings = 0;
  while (!rim.empty()) {
    std::int32_t vertex = rim.begin()->first;
    for (auto at = rim.find(vertex); at != rim.end(); at = rim.find(vertex)) {
      vertex = at->second;
      rim.erase(at);
    }
    ++rings;
  }
  ASSERT_EQ(rings, tubes);
}

TEST(TreeMesh, RandomTreesMakeSoundMeshes) {
  for (std::uint64_t number = 0; number < 150; ++number) {
    SCOPED_TRACE(number);
    const TreeSkeleton tree = grow_tree(random_tree(number), number, kContext);
    const double quality = number % 3 ? 1.0 : 0.3;
    const PlantMesh mesh = mesh_tree(tree, {.quality = quality}, kContext);
    ASSERT_NO_FATAL_FAILURE(expect_sound_arrays(mesh));
    if (quality == 1.0) {
      ASSERT_NO_FATAL_FAILURE(expect_closed_tubes(mesh, tree.stems.size()));
      ASSERT_EQ(std::count(mesh.materials.begin(), mesh.materials.end(), PlantMaterial::Leaf),
                std::ptrdiff_t(tree.leaves.size()));
    }
  }
}

TEST(TreeMesh, AStraightTrunkHasTheVolumeOfItsCone) {
  for (const double taper : {1.0, 0.6, 0.0})
    for (const int sides : {3, 7, 32}) {
      TreeParameters p;
      p.levels = 1, p.scale = 10.0, p.ratio = 0.05;
      p.stems[0].taper = taper, p.stems[0].curve_resolution = 5;
      const PlantMesh mesh = mesh_tree(grow_tree(p, 1, kContext), {.trunk_sides = sides}, kContext);
      double volume = 0.0;
      for (std::size_t f = 0; f < mesh.materials.size(); ++f)
        volume += glm::dot(doubled_area(mesh, f), glm::dvec3(mesh.positions[face(mesh, f)[0]])) / 6;
      const double radius = 0.5, tip = radius * (1.0 - taper), depth = 2.0 * radius;
      const double polygon = 0.5 * sides * std::sin(2.0 * std::numbers::pi / sides);
      // The foot in the ground is a prism, open below: the missing face adds what it would there.
      volume += polygon * radius * radius * depth / 3.0;
      const double cone = polygon * 10.0 / 3.0 * (radius * radius + radius * tip + tip * tip);
      EXPECT_NEAR(volume, cone + polygon * radius * radius * depth, 1e-4) << taper << " " << sides;
    }
}

TEST(TreeMesh, BarkIsContinuousAroundItsSeam) {
  const TreeSkeleton tree = grow_tree(find_tree_species("black_oak").parameters, 1, kContext);
  const PlantMesh mesh = mesh_tree(tree, {}, kContext);
  const double girth = 2.0 * std::numbers::pi * tree.stems[0].radius;
  int at_seam = 0;
  for (std::size_t f = 0; f < mesh.materials.size(); ++f) {
    const auto corners = face(mesh, f);
    if (mesh.levels[f] != 0 || corners.size() != 4) continue;
    const glm::vec2* uv = &mesh.uvs[mesh.face_starts[f]];
    const float wide = uv[1].x - uv[0].x;
    ASSERT_TRUE(wide > 0.0f && wide < 0.06f) << "a face runs back across the picture";
    ASSERT_EQ(uv[0].y, uv[1].y);
    at_seam += uv[1].x == 1.0f;
    // A square of the picture stays one on a straight stem: v counts lengths in girths.
    const double up = glm::length(mesh.positions[corners[3]] - mesh.positions[corners[0]]);
    if (f < 40) {
      EXPECT_NEAR((uv[3].y - uv[0].y) * girth, up, 0.35 * up);
    }
  }
  EXPECT_GT(at_seam, 20);
}

double leaf_area(const PlantMesh& mesh) {
  double area = 0.0;
  for (std::size_t f = 0; f < mesh.materials.size(); ++f)
    if (mesh.materials[f] == PlantMaterial::Leaf) area += 0.5 * glm::length(doubled_area(mesh, f));
  return area;
}

TEST(TreeMesh, LowerQualityKeepsTheLeavesAreaAndAPartOfTheLeaves) {
  TreeParameters p = find_tree_species("silver_birch").parameters;
  p.leaf_shape = LeafShape::Triangle;  // four corners at any quality
  const TreeSkeleton tree = grow_tree(p, 1, kContext);
  const double full = leaf_area(mesh_tree(tree, {}, kContext));
  EXPECT_NEAR(full, double(tree.leaves.size()) * 0.5 * 0.11 * 0.11 * 0.8, 1e-3 * full);
  std::set<std::pair<float, float>> before;  // feet of leaves
  std::size_t vertices = 0;
  for (const double quality : {1.0, 0.5, 0.2, 0.05}) {
    const PlantMesh mesh = mesh_tree(tree, {.quality = quality}, kContext);
    EXPECT_NEAR(leaf_area(mesh), full, 0.1 * full) << quality;
    std::set<std::pair<float, float>> feet;
    for (std::size_t f = 0; f < mesh.materials.size(); ++f)
      if (mesh.materials[f] == PlantMaterial::Leaf) {
        const glm::vec3 foot = mesh.positions[face(mesh, f)[0]];
        feet.insert({foot.x, foot.y});
      }
    EXPECT_NEAR(double(feet.size()), quality * double(tree.leaves.size()),
                4.0 * std::sqrt(double(tree.leaves.size())));
    if (!before.empty()) {
      EXPECT_TRUE(std::includes(before.begin(), before.end(), feet.begin(), feet.end()));
      EXPECT_LT(mesh.positions.size(), vertices);
    }
    before = std::move(feet);
    vertices = mesh.positions.size();
  }
}

TEST(TreeMesh, NoSpeciesIsTooHeavy) {
  for (const TreeSpecies& species : tree_species()) {
    const TreeSkeleton tree = grow_tree(species.parameters, 1, kContext);
    EXPECT_LT(mesh_tree(tree, {}, kContext).positions.size(), 3'000'000u) << species.name;
    EXPECT_LT(mesh_tree(tree, {.quality = 0.1}, kContext).positions.size(), 300'000u)
        << species.name;
    EXPECT_LT(mesh_tree(tree, {.quality = 0.01}, kContext).positions.size(), 70'000u)
        << species.name;
  }
}

TEST(TreeMesh, ThreadsChangeNoByte) {
  const TreeSkeleton tree = grow_tree(find_tree_species("black_oak").parameters, 1, kContext);
  PlantMesh one, four;
  Context single({}, 1), many({}, 4);
  single.run([&] { one = mesh_tree(tree, {.quality = 0.7}, single); });
  many.run([&] { four = mesh_tree(tree, {.quality = 0.7}, many); });
  const auto same = [](const auto& a, const auto& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
  };
  EXPECT_TRUE(same(one.positions, four.positions));
  EXPECT_TRUE(same(one.corners, four.corners));
  EXPECT_TRUE(same(one.uvs, four.uvs));
}

TEST(TreeMesh, RefusesQualityOutOfRange) {
  const TreeSkeleton tree = grow_tree(find_tree_species("dwarf_juniper").parameters, 1, kContext);
  EXPECT_THROW(mesh_tree(tree, {.quality = 0.0}, kContext), InputError);
  EXPECT_THROW(mesh_tree(tree, {.quality = 1.5}, kContext), InputError);
}

}  // namespace
}  // namespace orogen
