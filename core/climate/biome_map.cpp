#include "climate/biome_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "climate/holdridge.h"
#include "climate/whittaker.h"
#include "foundation/distance_transform.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/units.h"
#include "hydrology/sea.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 16384;

template <class T>
Raster<std::uint8_t> zeros_of(const Raster<T>& values) {
  Raster<std::uint8_t> result(values.grid());
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = values[i] == 0;
  return result;
}

const Raster<float>& need(const Raster<float>* field, std::string_view name,
                          Classification classification) {
  if (field) return *field;
  throw InputError("classification: '" + std::string(kClassifications[int(classification)]) +
                   "' goes by '" + std::string(name) +
                   "', which there is not; the stage 'climate' makes it");
}

/// Biome of dry land, cell by cell.
std::function<Biome(std::size_t)> dry_biome(const BiomeInputs& inputs, Classification by) {
  if (by == Classification::Paper) {
    const auto& warm = need(inputs.temperature, "temperature", by);
    const auto& moist = need(inputs.moisture, "moisture", by);
    return [&](std::size_t i) { return biome_of(warm[i], moist[i]); };
  }
  const bool holdridge = by == Classification::Holdridge;
  const auto& warm = holdridge ? need(inputs.biotemperature, "biotemperature", by)
                               : need(inputs.air_temperature, "air_temperature", by);
  const auto& rain = need(inputs.rainfall, "rainfall", by);
  return [&, biome = holdridge ? holdridge_biome : whittaker_biome](std::size_t i) {
    return biome(warm[i], rain[i]);
  };
}

/// Steepness, rise over run.
double slope_at(const Raster<float>& elevation, int r, int c) {
  const Grid& grid = elevation.grid();
  const int west = std::max(c - 1, 0), east = std::min(c + 1, grid.nx - 1);
  const int south = std::max(r - 1, 0), north = std::min(r + 1, grid.ny - 1);
  const double dx = (elevation(r, east) - elevation(r, west)) / std::max(east - west, 1);
  const double dy = (elevation(north, c) - elevation(south, c)) / std::max(north - south, 1);
  return std::hypot(dx, dy) / grid.cell_size;
}

}  // namespace

Raster<std::int32_t> map_biomes(const BiomeInputs& inputs, const BiomeParameters& parameters,
                                const Context& context) {
  check_parameters(parameters);
  const Raster<float>& elevation = inputs.elevation;
  const Grid& grid = elevation.grid();
  const auto dry = dry_biome(inputs, parameters.classification);
  const Raster<std::uint8_t> land = inputs.land ? land_beside_sea(elevation, zeros_of(*inputs.land))
                                                : Raster<std::uint8_t>(grid, 1);
  const Raster<float> to_sea = distance_transform(zeros_of(land), context);
  const double steepest = std::tan(radians(parameters.beach_slope_deg));
  const double widest = parameters.beach_width + 0.5 * grid.cell_size;  // from the sea's middle
  const auto ground = [&](int r, int c) {
    const std::size_t i = grid.index(r, c);
    if (!land[i]) return Biome::Ocean;
    if (inputs.water_depth && (*inputs.water_depth)[i] > 0.0f) return Biome::Lake;
    if (inputs.painted && (*inputs.painted)[i] >= 0) return Biome((*inputs.painted)[i]);
    const bool beach = elevation[i] < parameters.beach_height && to_sea[i] <= widest &&
                       slope_at(elevation, r, c) <= steepest;
    if (beach) return Biome::Beach;
    return inputs.snow_cover && (*inputs.snow_cover)[i] >= 1.0f ? Biome::Snow : dry(i);
  };
  Raster<std::int32_t> made(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) made(r, c) = std::int32_t(ground(r, c));
  });
  return made;
}

}  // namespace orogen
