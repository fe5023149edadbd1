// Values that a user gives over a terrain's whole extent: heights to start from, painted factors.
//
// `rows` x `columns` cells from the south-west, whatever the resolution of the terrain; they need
// not be square. On a grid they are interpolated bilinearly between cells' centres and held beyond
// the outermost ones. A grid's cell that covers more than one of them takes the mean of as many
// samples, evenly spread.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

struct GivenRaster {
  int rows = 0, columns = 0;
  std::vector<float> values;
};

/// Numbers in rows from the south-west, at the extent's corners and evenly between them.
struct CornerMap {
  int rows = 0, columns = 0;
  std::vector<double> values;
};

/// What may be given: the name in recipes, what is allowed, and what holds where nothing is given
/// (none: a stage that reads it needs it).
struct GivenRasterInfo {
  std::string_view name, unit, text;
  double least, most;
  std::optional<double> otherwise;
  bool whole = false;  // whole numbers, labels of kinds
};

std::span<const GivenRasterInfo> known_given_rasters();
/// nullptr if there is none of that name.
const GivenRasterInfo* find_given_raster(std::string_view name);

/// The value at a place, 0 to 1 from the extent's south-west corner to its north-east one.
double value_at(const GivenRaster& given, glm::dvec2 part);

/// Carries values to a grid over the same extent.
Raster<float> on_grid(const GivenRaster& given, const Grid& grid, const Context& context);
/// Interpolated bilinearly.
Raster<float> on_grid(const CornerMap& given, const Grid& grid, const Context& context);
/// Carries labels: each cell takes the one at its centre.
Raster<std::int32_t> labels_on_grid(const GivenRaster& given, const Grid& grid);

}  // namespace orogen
