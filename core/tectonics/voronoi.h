// Exact Voronoi cells of points, clipped to a rectangle.
//
// Which cells are neighbours is decided by exact predicates (CGAL's Delaunay triangulation); the
// corners are the crossings of bisectors, rounded to double.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "inputs/vector_map.h"

namespace orogen {

struct VoronoiCell {
  Ring polygon;                 // anticlockwise; empty if the cell misses the rectangle
  std::vector<int> neighbours;  // cell across the side from polygon[i] to the next; -1: the frame
};

/// One cell a point, in order. Of points at the same place the first has the cell, the others none.
std::vector<VoronoiCell> voronoi_cells(std::span<const glm::dvec2> points, glm::dvec2 low,
                                       glm::dvec2 high);

/// Signed area of a ring (m²), positive if it runs anticlockwise.
double ring_area(const Ring& ring);

/// Centroid of a ring's inside; the mean of its points if it has no area.
glm::dvec2 ring_centroid(const Ring& ring);

}  // namespace orogen
