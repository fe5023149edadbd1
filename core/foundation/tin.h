// Triangulated irregular network (TIN): scattered points over a rectangle, joined by Delaunay's
// triangles. A field over it is one value a vertex, linear within each triangle.
//
//   cell area of a vertex = a third of the area of its triangles (m²)
//
// so that the sum of cell area times height is exactly the volume under the surface that is drawn,
// and cells are positive however thin a triangle. Vertices are numbered along Hilbert's curve and
// triangles by their lowest vertex: what lies near in space lies near in memory, and the numbers
// depend on the points alone. Positions are double and a point's two coordinates lie side by side:
// they are read together, seldom, and not by the solvers, which read edge lengths (float).
//
// The rectangle's corners are vertices and its sides are straight rows of edges.
// Makers: `jittered_tin` a hexagonal lattice with every point moved by up to 0.4 of the spacing
// each way; `poisson_tin` random points no closer to each other than 0.77 of the spacing, found in
// the cells of a background grid in rounds (Wei 2008, doi:10.1145/1399504.1360619): no short edges.
// Neither makes a triangle that is obtuse at a side of the rectangle.
// Both have about 1.155 area / spacing² vertices. CGAL does the triangulation: exact decisions.
// `grid_tin` is a regular grid in the same clothes, so that one solver runs on both: vertices are
// the middles of equal cells, row by row, each with its 8 neighbours; triangles halve the squares
// between. Its domain ends at the outermost middles, and a vertex owns its whole cell: sums are
// over cells, volumes under the triangles lack half a cell along the sides, and what a solver takes
// from triangles (creep) runs half as fast along a side. Water keeps to eight directions, and it
// shows. Cost: 1 to 2 s and 200 to 250 MB, more than half of it given back, for a million vertices.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "foundation/context.h"

namespace orogen {

struct TinDomain {
  glm::dvec2 origin{0.0, 0.0};  // m, lower-left corner
  glm::dvec2 size{0.0, 0.0};    // m

  glm::dvec2 far_corner() const { return origin + size; }
  double area() const { return size.x * size.y; }  // m²
  void check() const;                              // InputError if it is empty or not finite

  bool operator==(const TinDomain&) const = default;
};

/// Bits of the sides of the rectangle that a vertex lies on.
enum TinSide : std::uint8_t { kWestSide = 1, kEastSide = 2, kSouthSide = 4, kNorthSide = 8 };

struct Tin {
  TinDomain domain;
  std::vector<glm::dvec2> points{};                      // m
  std::vector<std::array<std::int32_t, 3>> triangles{};  // anticlockwise, lowest vertex first
  std::vector<std::int32_t>
      first_edge{};                       // of each vertex, in the next two; one more than vertices
  std::vector<std::int32_t> neighbors{};  // rising within a vertex
  std::vector<float> edge_lengths{};      // m, to the neighbour
  std::vector<double> cell_areas{};       // m²
  std::vector<std::uint8_t> sides{};      // TinSide bits; 0 inside
  int columns = 0;  // vertices lie in rows of so many, from the south-west; 0: anywhere

  std::size_t size() const { return points.size(); }
  std::span<const std::int32_t> neighbors_of(std::int32_t vertex) const {
    return {neighbors.data() + first_edge[vertex], neighbors.data() + first_edge[vertex + 1]};
  }
};

/// The triangulation of these points (any order). InputError if one lies outside the domain or
/// twice at a place, or if a corner of the domain is missing.
Tin triangulate(const TinDomain& domain, std::vector<glm::dvec2> points, const Context& context);

Tin jittered_tin(const TinDomain& domain, double spacing, std::uint32_t seed,
                 const Context& context);
Tin poisson_tin(const TinDomain& domain, double spacing, std::uint32_t seed,
                const Context& context);

/// The middles of columns x rows equal cells over `area`, in the order of a Grid. InputError for
/// fewer than 2 x 2.
Tin grid_tin(const TinDomain& area, int columns, int rows);

/// The spacing (m) at which the makers give about `vertices` vertices.
double spacing_for(const TinDomain& domain, double vertices);

/// Not 0 at vertices on one of `sides` (TinSide bits): where water may leave.
std::vector<std::uint8_t> side_mask(const Tin& tin, unsigned sides);

}  // namespace orogen
