// The mesh whose edges may become folds (paper C, section 5.2).
//
// Points: a Poisson-disc sample of a rectangle grown by one wavelength λ on each side, so that no
// fold ends at the border because the mesh does. No two points p, q are nearer than
// 0.727 (λ(p) + λ(q)) / 2; that radius makes the mean edge λ (within 1%, over the rectangle).
// Faces: their Delaunay triangulation.
//
// The sample is random sequential addition: space is cut into cells small enough to hold one point,
// fixed to the coordinates' origin; round by round each open cell is thrown one dart, in an order
// drawn by a hash, and darts too near a point are dropped. So the mesh is a function of rectangle,
// λ and seed alone, and where the rectangle only grows the points in its middle stay.
//
// Limits: where λ varies, its relative change over one λ should stay well below 1; the cost grows
// with the square of highest over lowest λ.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "foundation/context.h"
#include "foundation/varying.h"

namespace orogen {

/// λ by place, in metres: a number, or a raster read bilinearly (beyond it, its edge goes on).
class FoldWavelength {
 public:
  /// InputError unless λ is within 1 m to 1000 km. The raster, if any, is not owned.
  explicit FoldWavelength(const Varying& wavelength);

  double at(glm::dvec2 p) const;
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  bool is_even() const { return !wavelength_.raster; }  // the same everywhere

 private:
  Varying wavelength_;
  double lowest_, highest_;
};

struct FoldMesh {
  struct Edge {
    int a = -1, b = -1;         // points, a < b
    int left = -1, right = -1;  // faces to the left and right on the way from a to b; -1: none
  };
  struct Face {
    std::array<int, 3> points{};  // anticlockwise, the lowest number first
    std::array<int, 3> edges{};   // edges[k] joins points[k] and points[(k + 1) % 3]
  };

  std::vector<glm::dvec2> points;  // m, in rows from south to north
  std::vector<Edge> edges;         // by a, then b
  std::vector<Face> faces;         // by points

  glm::dvec2 along(int edge) const { return points[edges[edge].b] - points[edges[edge].a]; }
  glm::dvec2 middle(int edge) const {
    return 0.5 * (points[edges[edge].a] + points[edges[edge].b]);
  }
  glm::dvec2 center(int face) const {
    const auto& p = faces[face].points;
    return (points[p[0]] + points[p[1]] + points[p[2]]) / 3.0;
  }
};

/// The mesh over [low, high] grown by the highest wavelength. InputError if it would have more than
/// 20 million points.
FoldMesh fold_mesh(glm::dvec2 low, glm::dvec2 high, const FoldWavelength& wavelength,
                   std::uint32_t seed, const Context& context);

}  // namespace orogen
