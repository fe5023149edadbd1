// The dual of a triangulation, clipped to a rectangle: corners and edges of a polygon map.
//
// Two triangles with a common side give the edge between their circumcentres; a side of the hull
// gives a ray from its triangle's. What of it lies inside the rectangle is kept. Where edges cross
// the rectangle's sides new corners arise; edges along the sides join them, in order.
#pragma once

#include "foundation/delaunay.h"
#include "island/polygon_map.h"

namespace orogen {

/// Sets corners, edge_centers and edge_corners. `map.centers` are the triangulation's points, and
/// lie in the rectangle.
void clip_dual(const Triangulation& triangulation, PolygonMap& map);

}  // namespace orogen
