#include "tectonics/compression.h"

#include <algorithm>
#include <array>
#include <vector>

#include "foundation/parallel.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

using Patch = TransportField::Patch;

constexpr int kColumns = Patch::kMost - 1, kRows = 15;  // cells a tile
constexpr double kNoCompression = 1e-9;

struct Corners {
  std::array<double, Patch::kMost> x, y;  // Φ⁻¹ along one row of corners
};

// Cells between two rows of corners; returns the sum of q.
OROGEN_CLONES double squeeze_row(const Corners& low, const Corners& high, double per_cell, int n,
                                 float* crust, float* compression_x, float* compression_y) {
  std::array<double, Patch::kMost> amount;
  const double half = 0.5 * per_cell;
  for (int j = 0; j < n; ++j) {
    // Diagonals: their sum and difference are twice the mean sides.
    const double ux = high.x[j + 1] - low.x[j], uy = high.y[j + 1] - low.y[j];
    const double vx = low.x[j + 1] - high.x[j], vy = low.y[j + 1] - high.y[j];
    const double xx = half * (ux + vx), xy = half * (ux - vx);
    const double yx = half * (uy + vy), yy = half * (uy - vy);
    const double q = xx * yy - xy * yx;
    const Stretch s = stretch_of(xx, xy, yx, yy);
    const double beyond = 1.0 - s.smaller - kNoCompression;
    const double strength = 0.5 * (beyond + std::fabs(beyond));  // max(beyond, 0)
    amount[j] = q;
    crust[j] = float(q);
    compression_x[j] = float(strength * s.direction_x);
    compression_y[j] = float(strength * s.direction_y);
  }
  double sum = 0.0;
  for (int j = 0; j < n; ++j) sum += amount[j];
  return sum;
}

struct Tile {
  int row, column, rows, columns;  // first cell, and cells
};

double squeeze_tile(const TransportField& transport, const Grid& grid, const Tile& tile,
                    CompressionField& out) {
  const double h = grid.cell_size;
  const glm::dvec2 low = grid.origin + h * glm::dvec2(tile.column, tile.row);
  const glm::dvec2 size = h * glm::dvec2(tile.columns, tile.rows);
  const Patch patch(transport, low + 0.5 * size, 0.5 * std::hypot(size.x, size.y));
  std::array<double, Patch::kMost> x, centers;
  for (int c = 0; c <= tile.columns; ++c) {
    x[c] = grid.origin.x + h * (tile.column + c);
    centers[c] = grid.origin.x + h * (tile.column + c + 0.5);
  }
  Corners corners[2];
  double sum = 0.0;
  for (int r = 0; r <= tile.rows; ++r) {
    Corners& high = corners[r % 2];
    patch.inverse(x.data(), grid.origin.y + h * (tile.row + r), high.x.data(), high.y.data(),
                  tile.columns + 1);
    if (r == 0) continue;
    const std::size_t at = grid.index(tile.row + r - 1, tile.column);
    sum += squeeze_row(corners[(r + 1) % 2], high, 1.0 / h, tile.columns, out.crust.data() + at,
                       out.compression_x.data() + at, out.compression_y.data() + at);
    std::int32_t* plate = out.plate.data() + at;
    patch.nearest_plate(centers.data(), grid.origin.y + h * (tile.row + r - 0.5), plate,
                        tile.columns);
  }
  return sum;
}

}  // namespace

CompressionField compression_field(const TransportField& transport, const Grid& grid,
                                   const Context& context) {
  CompressionField out{Raster<float>(grid), Raster<float>(grid), Raster<float>(grid),
                       Raster<std::int32_t>(grid)};
  const int across = (grid.nx + kColumns - 1) / kColumns, up = (grid.ny + kRows - 1) / kRows;
  std::vector<double> sums(std::size_t(across) * up);
  parallel_chunks(context, sums.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const int row = int(i) / across * kRows, column = int(i) % across * kColumns;
      const Tile tile{row, column, std::min(kRows, grid.ny - row),
                      std::min(kColumns, grid.nx - column)};
      sums[i] = squeeze_tile(transport, grid, tile, out);
    }
  });
  for (double sum : sums) out.source_area_m2 += sum * grid.cell_area();
  return out;
}

}  // namespace orogen
