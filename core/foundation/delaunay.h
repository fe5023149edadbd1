// Delaunay's triangulation of points of the plane, with exact decisions (CGAL).
//
// Triangles are anticlockwise, lowest point first, and sorted: what depends on them depends on the
// points and their order alone. Points that follow each other should lie near each other
// (hilbert.h): then the cost is some 0.5 s for a million of them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "foundation/context.h"

namespace orogen {

struct Triangulation {
  std::vector<std::array<std::int32_t, 3>> triangles;
  /// Triangle across the side from corner k to corner k + 1; -1 beyond the hull.
  std::vector<std::array<std::int32_t, 3>> across;
};

/// Points that all lie on one line have no triangles. Of points at the same place one is used.
Triangulation delaunay(std::span<const glm::dvec2> points, const Context& context);

/// Sorts points along Hilbert's curve over the square that begins at `origin` with this side (m);
/// equal places by x, then y.
void sort_along_curve(std::vector<glm::dvec2>& points, glm::dvec2 origin, double side);

}  // namespace orogen
