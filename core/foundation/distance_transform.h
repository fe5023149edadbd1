// Exact Euclidean distance from every cell to the nearest feature.
//
// For cells: the lower envelope of parabolas along rows, after a scan of columns (Felzenszwalb and
// Huttenlocher 2012; Meijster et al. 2000), in O(cells); distances run between cell centres. For
// points: tile by tile against the points that can be nearest somewhere in the tile; distances run
// from the cell's centre to the point itself, so that they do not depend on the resolution.
// Where two features are equally near, the one with the lower index is given for points; for cells
// it is one of them, always the same.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

struct NearestFeature {
  Raster<float> distance;        // m; infinity where there is no feature at all
  Raster<std::int32_t> nearest;  // cell or point nearest to each cell; -1 if there is none
};

/// Distance (m) to the nearest cell whose value is not 0.
Raster<float> distance_transform(const Raster<std::uint8_t>& features, const Context& context);

/// The same, and which cell that is.
NearestFeature nearest_feature(const Raster<std::uint8_t>& features, const Context& context);

/// Distance to, and number of, the nearest of the points (m, anywhere).
NearestFeature nearest_point(std::span<const glm::dvec2> points, const Grid& grid,
                             const Context& context);

/// Numbers of the points that are nearest to some place of the box [low, high], in order (perhaps
/// a few more than those).
std::vector<int> nearest_candidates(std::span<const glm::dvec2> points, glm::dvec2 low,
                                    glm::dvec2 high);

}  // namespace orogen
