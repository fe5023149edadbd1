#include "vegetation/ground_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <set>

#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

std::span<const std::int32_t> face(const PlantMesh& mesh, std::size_t f) {
  return std::span(mesh.corners)
      .subspan(mesh.face_starts[f], mesh.face_starts[f + 1] - mesh.face_starts[f]);
}

TEST(GroundCover, EachSpeciesIsNamedOnceAndStandsOnTheGround) {
  std::set<std::string_view> names;
  for (const GroundCover& species : ground_cover()) {
    EXPECT_TRUE(names.insert(species.name).second) << species.name;
    EXPECT_EQ(&find_ground_cover(species.name), &species);
    const PlantMesh mesh = make_ground_cover(species.parameters, 1, false);
    float low = 1.0f, high = 0.0f;
    for (const glm::vec3 p : mesh.positions) low = std::min(low, p.z), high = std::max(high, p.z);
    const GroundCoverParameters& p = species.parameters;
    const double tallest = std::max(p.height, p.stalks ? p.stalk_height + p.petal_length : 0.0);
    EXPECT_GT(low, -0.05 * tallest) << species.name;
    EXPECT_LT(high, tallest * (1.0 + p.height_variation)) << species.name;
    EXPECT_LT(mesh.positions.size(), 4000u) << species.name;
  }
  EXPECT_GE(names.size(), 6u);
  EXPECT_THROW(find_ground_cover("grass"), InputError);
}

GroundCoverParameters random_cover(std::uint64_t number) {
  std::uint64_t counter = 0;
  const auto real = [&](double low, double high) {
    return low + (high - low) * random_uniform(3, number, counter++);
  };
  GroundCoverParameters p;
  p.blades = int(real(0.0, 40.0)), p.height = real(0.05, 2.0);
  p.height_variation = real(0.0, 0.9), p.spread = real(0.0, 0.5);
  p.lean_deg = real(0.0, 90.0), p.droop_deg = real(-90.0, 180.0);
  p.blade_segments = 1 + int(real(0.0, 8.0)), p.pinnae = int(real(-8.0, 20.0));
  p.pinnae = std::max(0, p.pinnae);
  p.stalks = int(real(0.0, 6.0)), p.petals = int(real(0.0, 12.0));
  return p;
}

TEST(GroundCover, RandomTuftsHaveTheirPartsAndSoundFaces) {
  for (std::uint64_t number = 0; number < 200; ++number) {
    SCOPED_TRACE(number);
    const GroundCoverParameters p = random_cover(number);
    const PlantMesh mesh = make_ground_cover(p, number, false);
    const std::size_t faces = mesh.materials.size();
    ASSERT_EQ(mesh.face_starts.size(), faces + 1);
    ASSERT_EQ(mesh.uvs.size(), mesh.corners.size());
    ASSERT_EQ(mesh.face_starts.back(), std::int32_t(mesh.corners.size()));
    for (std::size_t f = 0; f < faces; ++f) {
      const auto corners = face(mesh, f);
      ASSERT_EQ(std::set(corners.begin(), corners.end()).size(), corners.size());
      for (const std::int32_t v : corners)
        ASSERT_TRUE(v >= 0 && v < std::int32_t(mesh.positions.size()));
    }
    for (const glm::vec3 place : mesh.positions)
      ASSERT_TRUE(std::isfinite(place.x + place.y + place.z));
    for (const glm::vec2 uv : mesh.uvs)
      ASSERT_TRUE(uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f);
    const auto count = [&](PlantMaterial material) {
      return std::count(mesh.materials.begin(), mesh.materials.end(), material);
    };
    const int leaves = p.pinnae ? 2 * p.pinnae * p.blades : p.blade_segments * p.blades;
    ASSERT_EQ(count(PlantMaterial::Leaf), leaves);
    ASSERT_EQ(count(PlantMaterial::Petal), p.stalks * (p.petals ? p.petals : 2));
    ASSERT_EQ(count(PlantMaterial::FlowerCentre), p.petals ? p.stalks : 0);
  }
}

TEST(GroundCover, BladesHaveTheirLengthAndNarrowToAPoint) {
  const GroundCoverParameters p{.blades = 20,
                                .height = 0.4,
                                .height_variation = 0.0,
                                .blade_width = 0.01,
                                .blade_segments = 5};
  const PlantMesh mesh = make_ground_cover(p, 9, false);
  const int vertices = 2 * p.blade_segments + 1;
  ASSERT_EQ(mesh.positions.size(), std::size_t(20 * vertices));
  for (int blade = 0; blade < 20; ++blade) {
    const glm::vec3* v = &mesh.positions[blade * vertices];
    EXPECT_NEAR(glm::length(v[1] - v[0]), 0.01f, 1e-6f);
    float length = 0.0f;
    glm::vec3 before = 0.5f * (v[0] + v[1]);
    for (int s = 1; s <= p.blade_segments; ++s) {
      const bool tip = s == p.blade_segments;
      const glm::vec3 here = tip ? v[2 * s] : 0.5f * (v[2 * s] + v[2 * s + 1]);
      length += glm::length(here - before);
      before = here;
    }
    EXPECT_NEAR(length, 0.4f, 1e-5f);
    EXPECT_LT(before.z, 0.4f);
  }
}

TEST(GroundCover, CrossedQuadsHoldTheTuftAndStandAtRightAngles) {
  for (const GroundCover& species : ground_cover()) {
    const PlantMesh tuft = make_ground_cover(species.parameters, 4, false);
    const PlantMesh quads = make_ground_cover(species.parameters, 4, true);
    ASSERT_EQ(quads.positions.size(), 8u);
    ASSERT_EQ(quads.materials.size(), 2u);
    glm::vec3 normals[2];
    for (int f = 0; f < 2; ++f) {
      const auto c = face(quads, f);
      const glm::vec3 across = quads.positions[c[1]] - quads.positions[c[0]];
      const glm::vec3 up = quads.positions[c[3]] - quads.positions[c[0]];
      EXPECT_NEAR(glm::dot(glm::normalize(across), glm::normalize(up)), 0.0f, 1e-6f);
      normals[f] = glm::normalize(glm::cross(across, up));
      for (const glm::vec3 p : tuft.positions) {
        EXPECT_LE(std::hypot(p.x, p.y), 0.5f * glm::length(across) * 1.00001f);
        EXPECT_LE(p.z, up.z * 1.00001f);
      }
    }
    EXPECT_NEAR(glm::dot(normals[0], normals[1]), 0.0f, 1e-6f);
  }
}

TEST(GroundCover, ASeedIsATuft) {
  const GroundCoverParameters& p = find_ground_cover("oxeye_daisy").parameters;
  const PlantMesh a = make_ground_cover(p, 1, false), b = make_ground_cover(p, 1, false);
  const PlantMesh c = make_ground_cover(p, 2, false);
  const std::size_t bytes = a.positions.size() * sizeof(glm::vec3);
  ASSERT_EQ(a.positions.size(), c.positions.size());
  EXPECT_EQ(std::memcmp(a.positions.data(), b.positions.data(), bytes), 0);
  EXPECT_NE(std::memcmp(a.positions.data(), c.positions.data(), bytes), 0);
}

TEST(GroundCover, RefusesWhatIsOutOfRange) {
  EXPECT_THROW(make_ground_cover({.height = -1.0}, 1, false), InputError);
  EXPECT_THROW(make_ground_cover({.blade_segments = 0}, 1, false), InputError);
}

}  // namespace
}  // namespace orogen
