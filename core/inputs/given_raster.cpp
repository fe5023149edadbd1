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
    {"kept", "1", "Where ground is to stay: 1 there, 0 elsewhere.", 0.0, 1.0, std::nullopt},
};

int samples_per_cell(int given, int cells) {
  return std::max(1, int(std::ceil(double(given) / cells - 1e-6)));
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

Raster<float> on_grid(const GivenRaster& given, const Grid& grid, const Context& context) {
  const int across = samples_per_cell(given.columns, grid.nx);
  const int up = samples_per_cell(given.rows, grid.ny);
  const double per_x = double(given.columns) / grid.nx, per_y = double(given.rows) / grid.ny;
  const auto value = [&](int r, int c) {
    return double(given.values[std::size_t(r) * given.columns + c]);
  };
  Raster<float> result(grid);
  parallel_rows(context, grid.ny, [&](int row) {
    for (int column = 0; column < grid.nx; ++column) {
      double sum = 0.0;
      for (int j = 0; j < up; ++j)
        for (int i = 0; i < across; ++i) {
          const glm::dvec2 place((column + (i + 0.5) / across) * per_x - 0.5,
                                 (row + (j + 0.5) / up) * per_y - 0.5);
          sum += Bilinear(place, given.columns, given.rows)(value);
        }
      result(row, column) = float(sum / (across * up));
    }
  });
  return result;
}

}  // namespace orogen
