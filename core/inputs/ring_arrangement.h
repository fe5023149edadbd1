// Do closed rings cross or touch, themselves or each other, and which lies directly inside which?
//
// One sweep from west to east over all edges (Shamos and Hoey 1976), O(n log n), that stops at the
// first contact. Vertices are lattice points (multiples of 1/1024 m), so that every comparison is
// exact in 128-bit integers. Edges that follow each other in a ring share their vertex and nothing
// else; any other common point is a contact.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "inputs/vector_map.h"

namespace orogen {

inline constexpr double kLattice = 1024.0;  // lattice points a metre
inline constexpr double kFarthest = 2e7;    // m, largest coordinate

/// The nearest lattice point; |coordinates| at most kFarthest.
glm::dvec2 on_lattice(glm::dvec2 position);

struct RingContact {
  std::size_t ring_a, edge_a;  // edge i runs from vertex i to vertex i + 1
  std::size_t ring_b, edge_b;
  glm::dvec2 place;  // m
};

struct RingArrangement {
  std::optional<RingContact> contact;
  std::vector<int> parent;  // the ring directly around each ring; -1: none. Empty after a contact
};

/// Each ring: at least three vertices, no repeated neighbours, area other than 0.
RingArrangement arrange_rings(std::span<const Ring* const> rings);

/// Positive for an anticlockwise ring (m²).
double signed_area(const Ring& ring);

}  // namespace orogen
