// Polygon map (paper B, IV-A and IV-B): Voronoi's cells of points on a rectangle, as a graph of
// centers, edges and corners.
//
// A center is a point with its cell; a corner is where cells meet; an edge parts two cells (or a
// cell and the outside) and joins two corners, and is also the side between two centers of
// Delaunay's triangulation. Cells are clipped to the rectangle: where an edge leaves it, and at its
// four corners, there are corners too.
//
//   Euler: corners - edges + centers = 1
//
// Which cells meet is decided exactly (delaunay.h); corners are circumcentres, rounded to double.
// Four points on one circle make two corners at one place. Relaxation moves each point to the mean
// of its cell's corners.
// Cost: 0.1 s for 100,000 cells, as often as there are relaxations and once more.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "foundation/context.h"

namespace orogen {

/// A list of numbers for each of many: those of i are items[first[i]] to items[first[i + 1] - 1].
struct Lists {
  std::vector<std::int32_t> first{0};
  std::vector<std::int32_t> items;

  std::span<const std::int32_t> of(std::int32_t i) const {
    return {items.data() + first[i], items.data() + first[i + 1]};
  }
};

struct PolygonMap {
  glm::dvec2 low{0.0, 0.0}, high{0.0, 0.0};  // m, the rectangle
  std::vector<glm::dvec2> centers;           // m
  std::vector<glm::dvec2> corners;           // m
  /// Of each edge: two centers, the second -1 at the rectangle's side; two corners, anticlockwise
  /// about the first center.
  std::vector<std::array<std::int32_t, 2>> edge_centers, edge_corners;
  /// Of each center, anticlockwise: edge i joins corner i and the next.
  Lists center_edges, center_corners;
  Lists corner_edges, corner_centers;                      // of each corner, rising
  std::vector<std::uint8_t> center_border, corner_border;  // 1 at a side of the rectangle

  /// The center across an edge; -1: none.
  std::int32_t beyond(std::int32_t edge, std::int32_t center) const {
    const auto [a, b] = edge_centers[edge];
    return a == center ? b : a;
  }
  /// The other corner of an edge.
  std::int32_t other_end(std::int32_t edge, std::int32_t corner) const {
    const auto [a, b] = edge_corners[edge];
    return a == corner ? b : a;
  }
};

/// The map of these points, in their order. InputError if one lies outside the rectangle, two lie
/// at one place, or all on one line.
PolygonMap polygon_map(std::vector<glm::dvec2> points, glm::dvec2 low, glm::dvec2 high,
                       const Context& context);

/// Random points, along Hilbert's curve, relaxed so many times.
PolygonMap random_polygon_map(int cells, int relaxations, glm::dvec2 low, glm::dvec2 high,
                              std::uint32_t seed, const Context& context);

}  // namespace orogen
