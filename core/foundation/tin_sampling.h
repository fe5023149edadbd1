// Fields carried between a TIN and a grid, or another TIN.
//
// From a TIN a field is read linearly within its triangles, so that planes come out exact to
// rounding and values keep their range; beyond the domain the value of its nearest side goes on.
// Of a grid_tin on its own grid values are taken as they are.
// From a grid it is read bilinearly between cell centres, with the edge value beyond the outermost
// ones (as resample.h does).
// Cost: a grid is painted triangle by triangle, about 10 ns a cell and 30 ns a triangle; of further
// fields, sampled with the first, about a third.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "foundation/tin.h"

namespace orogen {

using VertexField = std::span<const double>;  // one value a vertex

/// Value at the centre of each cell of the grid. Triangles without area are left out.
Raster<float> sample_to_grid(const Tin& tin, VertexField field, const Grid& grid,
                             const Context& context);
/// The same of several fields, whose triangles are looked at once.
std::vector<Raster<float>> sample_to_grid(const Tin& tin, std::span<const VertexField> fields,
                                          const Grid& grid, const Context& context);

/// Number of the triangle that holds the centre of each cell.
Raster<std::int32_t> triangles_on(const Tin& tin, const Grid& grid, const Context& context);

/// Where a point lies among three vertices: a field there is their weighted mean.
struct TinPlace {
  std::array<std::int32_t, 3> vertices{};
  std::array<double, 3> weights{};

  /// The same, rounding mended: no weight below 0, so that values keep their range.
  TinPlace within() const {
    TinPlace place = *this;
    double sum = 0.0;
    for (double& w : place.weights) sum += w = w > 0.0 ? w : 0.0;
    for (double& w : place.weights) w /= sum;
    return place;
  }
  /// value(vertex) gives the field.
  template <class Value>
  double mix(Value&& value) const {
    return weights[0] * value(vertices[0]) + weights[1] * value(vertices[1]) +
           weights[2] * value(vertices[2]);
  }
};

/// The place of each point; those beyond the domain are moved to its nearest side.
std::vector<TinPlace> locate(const Tin& tin, std::span<const glm::dvec2> points,
                             const Context& context);

/// Value at each point.
std::vector<double> sample_at_points(const Raster<float>& raster,
                                     std::span<const glm::dvec2> points, const Context& context);
std::vector<double> sample_at_points(const Tin& tin, std::span<const double> field,
                                     std::span<const glm::dvec2> points, const Context& context);

}  // namespace orogen
