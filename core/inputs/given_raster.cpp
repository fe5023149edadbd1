#include "inputs/given_raster.h"

#include <cmath>

#include "foundation/bilinear.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr GivenRasterInfo kGivenRasters[] = {
    {"elevation", "m", "Ground to start from.", -12e3, 12e3, std::nullopt},
    {"uplift_factor", "1", "What uplift is multiplied by; of a map, the heights it aims at.", 0.0,
     10.0, 1.0},
    {"erodibility_factor", "1", "What the erodibility of rock is multiplied by.", 0.01, 100.0, 1.0},
    {"kept_elevation", "m", "Ground that is to stay where `kept` says so.", -12e3, 12e3,
     std::nullopt},
    {"elevation_change", "1", "What an island's heights, from -1 to 1, are raised by.", -2.0, 2.0,
     0.0},
    {"temperature_change", "1", "What temperature, 0 to 1, is raised by.", -1.0, 1.0, 0.0},
    {"moisture_change", "1", "What moisture, 0 to 1, is raised by.", -1.0, 1.0, 0.0},
    {"biome", "1", "Kinds of country by hand, as the field `biome` counts them; -1: not painted.",
     -1.0, 13.0, -1.0, true},
    {"kept", "1", "Where ground is to stay: 1 there, 0 elsewhere.", 0.0, 1.0, std::nullopt},
};

int samples_per_cell(int given, int cells) {
  return std::max(1, int(std::ceil(double(given) / cells - 1e-6)));
}

/// `place`: in cells, from the centre of the first.
double between_cells(const GivenRaster& given, glm::dvec2 place) {
  return Bilinear(place, given.columns, given.rows)(
      [&](int r, int c) { return double(given.values[std::size_t(r) * given.columns + c]); });
}

}  // namespace

std::span<const GivenRasterInfo> known_given_rasters() {
  return kGivenRasters;
}

const GivenRasterInfo* find_given_raster(std::string_view name) {
  for (const GivenRasterInfo& info : kGivenRasters)
    if (info.name == name) return &info;
  return nullptr;
}

double value_at(const GivenRaster& given, glm::dvec2 part) {
  return between_cells(given, {part.x * given.columns - 0.5, part.y * given.rows - 0.5});
}

Raster<float> on_grid(const GivenRaster& given, const Grid& grid, const Context& context) {
  const int across = samples_per_cell(given.columns, grid.nx);
  const int up = samples_per_cell(given.rows, grid.ny);
  const double per_x = double(given.columns) / grid.nx, per_y = double(given.rows) / grid.ny;
  Raster<float> result(grid);
  parallel_rows(context, grid.ny, [&](int row) {
    for (int column = 0; column < grid.nx; ++column) {
      double sum = 0.0;
      for (int j = 0; j < up; ++j)
        for (int i = 0; i < across; ++i)
          sum += between_cells(given, {(column + (i + 0.5) / across) * per_x - 0.5,
                                       (row + (j + 0.5) / up) * per_y - 0.5});
      result(row, column) = float(sum / (across * up));
    }
  });
  return result;
}

Raster<float> on_grid(const CornerMap& given, const Grid& grid, const Context& context) {
  const glm::dvec2 scale((given.columns - 1) / grid.width(), (given.rows - 1) / grid.height());
  const auto value = [&](int r, int c) { return given.values[std::size_t(r) * given.columns + c]; };
  Raster<float> result(grid);
  parallel_rows(context, grid.ny, [&](int row) {
    for (int column = 0; column < grid.nx; ++column) {
      const glm::dvec2 place = (grid.center(row, column) - grid.origin) * scale;
      result(row, column) = float(Bilinear(place, given.columns, given.rows)(value));
    }
  });
  return result;
}

Raster<std::int32_t> labels_on_grid(const GivenRaster& given, const Grid& grid) {
  const auto place = [](int cell, int cells, int of) {
    return std::min(int((cell + 0.5) * of / cells), of - 1);
  };
  Raster<std::int32_t> result(grid);
  for (int row = 0; row < grid.ny; ++row)
    for (int column = 0; column < grid.nx; ++column)
      result(row, column) = std::int32_t(
          std::lround(given.values[std::size_t(place(row, grid.ny, given.rows)) * given.columns +
                                   place(column, grid.nx, given.columns)]));
  return result;
}

}  // namespace orogen
