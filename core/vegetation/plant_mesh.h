// Meshes of plants, as Blender stores them: faces of any number of corners.
//
// UVs are of corners, so that vertices are shared and bark is continuous around its seam. On stems
// u runs once around and v counts, from the foot, how often the foot's circumference fits into the
// length; on leaves, blades and petals both run from 0 to 1, u across and v from foot to tip.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace orogen {

enum class PlantMaterial : std::uint8_t { Stem, Leaf, Petal, FlowerCentre };

struct PlantMesh {
  std::vector<glm::vec3> positions;       // m, the plant's foot at 0, z up
  std::vector<std::int32_t> corners;      // vertices of faces, anticlockwise from outside
  std::vector<std::int32_t> face_starts;  // where each face's corners begin, and their number
  std::vector<glm::vec2> uvs;             // of corners
  std::vector<PlantMaterial> materials;   // of faces
  std::vector<std::uint8_t> levels;  // of faces: 0 the stem from the ground, 1 what it bears, ...
};

}  // namespace orogen
