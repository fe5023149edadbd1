#include "folding/fold_relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "folding/segment_buckets.h"
#include "foundation/errors.h"
#include "foundation/gaussian_blur.h"
#include "foundation/parallel.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

constexpr int kTile = 16, kPatch = 8;  // cells a side
constexpr int kLanes = 8;
constexpr float kRounding = 1.0001f;   // widens what is looked at
constexpr double kSeenRounding = 0.3;  // cells
constexpr float kFar = std::numeric_limits<float>::infinity();
using TileValues = std::array<float, kTile * kTile>;  // rows of kTile

struct Tile {
  int row, column, rows, columns;
};

// Segments as the inner loops want them: from the tile's middle, in metres.
struct Rays {
  std::vector<float> x, y, dx, dy, per_square;  // start, way to the end, 1 / length²
  int count = 0;                                // of those filled

  void make_room(int n) {
    if (n <= int(x.size())) return;
    for (auto* values : {&x, &y, &dx, &dy, &per_square}) values->resize(2 * std::size_t(n));
  }
  void add(const Segment& s, glm::dvec2 origin) {
    make_room(count + 1);
    x[count] = float(s.a.x - origin.x);
    y[count] = float(s.a.y - origin.y);
    dx[count] = float(s.b.x - s.a.x);
    dy[count] = float(s.b.y - s.a.y);
    ++count;
  }
};

OROGEN_CLONES void invert_squares(const float* dx, const float* dy, int count,
                                  float* __restrict out) {
  for (int i = 0; i < count; ++i) {
    const float square = dx[i] * dx[i] + dy[i] * dy[i];
    out[i] = square > 0.0f ? 1.0f / square : 0.0f;
  }
}

// Those rays whose square is at most `most`, without a branch that could not be foreseen.
void keep_near(const Rays& from, const float* squares, float most, Rays& to) {
  to.make_room(from.count);
  const float *x = from.x.data(), *y = from.y.data(), *dx = from.dx.data(), *dy = from.dy.data(),
              *per_square = from.per_square.data();
  float *__restrict tx = to.x.data(), *__restrict ty = to.y.data(), *__restrict tdx = to.dx.data(),
                   *__restrict tdy = to.dy.data(), *__restrict tper = to.per_square.data();
  int count = 0;
  for (int i = 0; i < from.count; ++i) {
    tx[count] = x[i];
    ty[count] = y[i];
    tdx[count] = dx[i];
    tdy[count] = dy[i];
    tper[count] = per_square[i];
    count += squares[i] <= most;
  }
  to.count = count;
}

__attribute__((always_inline)) inline float squared_distance(float ex, float ey, float dx, float dy,
                                                             float per_square) {
  float t = (ex * dx + ey * dy) * per_square;
  t = t < 0.0f ? 0.0f : t;
  t = t > 1.0f ? 1.0f : t;
  const float px = ex - t * dx, py = ey - t * dy;
  return px * px + py * py;
}

// Squared distances from one place to each ray.
OROGEN_CLONES void from_place(const float* x, const float* y, const float* dx, const float* dy,
                              const float* per_square, int count, float px, float py,
                              float* __restrict out) {
  for (int i = 0; i < count; ++i)
    out[i] = squared_distance(px - x[i], py - y[i], dx[i], dy[i], per_square[i]);
}

// The least of a number of values that is a multiple of kLanes.
OROGEN_CLONES float least_of(const float* values, int count) {
  float least[kLanes];
  std::copy_n(values, kLanes, least);
  for (int i = kLanes; i < count; i += kLanes)
    for (int k = 0; k < kLanes; ++k) least[k] = values[i + k] < least[k] ? values[i + k] : least[k];
  return *std::min_element(least, least + kLanes);
}

// Distances from the cells of a patch, rows of kTile, to the nearest of the rays.
OROGEN_CLONES void nearest_in_patch(const float* rx, const float* ry, const float* dx,
                                    const float* dy, const float* per_square, int count, float x0,
                                    float y0, float step, float* __restrict out) {
  constexpr int kCells = kPatch * kPatch;
  float x[kCells], y[kCells], least[kCells];
  for (int i = 0; i < kCells; ++i) {
    x[i] = x0 + float(i % kPatch) * step;
    y[i] = y0 + float(i / kPatch) * step;
    least[i] = kFar;
  }
  for (int k = 0; k < count; ++k) {
    const float ax = rx[k], ay = ry[k], wx = dx[k], wy = dy[k], per = per_square[k];
#pragma GCC ivdep
    for (int i = 0; i < kCells; ++i) {
      const float square = squared_distance(x[i] - ax, y[i] - ay, wx, wy, per);
      least[i] = square < least[i] ? square : least[i];
    }
  }
  for (int i = 0; i < kCells; ++i) out[i / kPatch * kTile + i % kPatch] = std::sqrt(least[i]);
}

// Distances to segments, tile by tile. Of places up to h from c, none is farther than d(c) + h from
// a segment, with d(c) the distance from c to the nearest one. So a tile looks only at segments
// that close to its square, and a patch only at those within d(c) + 2 h of its middle.
class TileDistances {
 public:
  TileDistances(const SegmentBuckets& buckets, const Grid& grid) : buckets_(buckets), grid_(grid) {}

  void measure(const Tile& tile, TileValues& out) {
    const double cell = grid_.cell_size;
    const double half = 0.5 * (kTile - 1) * cell;
    const glm::dvec2 middle = grid_.center(tile.row, tile.column) + glm::dvec2(half);
    const glm::dvec2 reach((1.0 + std::numbers::sqrt2) * half + buckets_.distance(middle));
    near_.count = 0;
    buckets_.for_near(middle - reach, middle + reach,
                      [&](const Segment& s) { near_.add(s, middle); });
    invert_squares(near_.dx.data(), near_.dy.data(), near_.count, near_.per_square.data());
    squares_.assign((near_.count + kLanes - 1) / kLanes * kLanes, kFar);
    for (int r = 0; r < tile.rows; r += kPatch)
      for (int c = 0; c < tile.columns; c += kPatch)
        measure_patch(r, c, float(cell), &out[r * kTile + c]);
  }

 private:
  void measure_patch(int row, int column, float cell, float* out) {
    const float x0 = (float(column) - 0.5f * (kTile - 1)) * cell;
    const float y0 = (float(row) - 0.5f * (kTile - 1)) * cell;
    const float half = 0.5f * (kPatch - 1) * cell;
    from_place(near_.x.data(), near_.y.data(), near_.dx.data(), near_.dy.data(),
               near_.per_square.data(), near_.count, x0 + half, y0 + half, squares_.data());
    const float nearest = std::sqrt(least_of(squares_.data(), int(squares_.size())));
    const float reach = (nearest + 2.0f * std::numbers::sqrt2_v<float> * half) * kRounding;
    keep_near(near_, squares_.data(), reach * reach, nearest_);
    nearest_in_patch(nearest_.x.data(), nearest_.y.data(), nearest_.dx.data(), nearest_.dy.data(),
                     nearest_.per_square.data(), nearest_.count, x0, y0, cell, out);
  }

  const SegmentBuckets& buckets_;
  const Grid& grid_;
  Rays near_, nearest_;  // to the tile, to the patch
  std::vector<float> squares_;
};

// (1 + cos(π x)) / 2 for x = d_t / (d_t + d_b), by the odd polynomial of sin about x = 1/2 (Taylor
// to the 11th power: error 3e-8).
OROGEN_CLONES void shape_cells(const float* crest, const float* trough, int count,
                               float* __restrict shape) {
  for (int i = 0; i < count; ++i) {
    const float x = crest[i] / (crest[i] + trough[i]);
    const float y = 3.14159265f * (0.5f - x), q = y * y;
    float p = -2.50521084e-8f;
    p = p * q + 2.75573192e-6f;
    p = p * q - 1.98412698e-4f;
    p = p * q + 8.33333333e-3f;
    p = p * q - 1.66666667e-1f;
    const float s = 0.5f + 0.5f * (y + y * q * p);
    shape[i] = s < 0.0f ? 0.0f : s > 1.0f ? 1.0f : s;
  }
}

/// A blur may leave [0, 1] by its rounding.
void multiply(float* values, const float* shape, int count) {
  for (int c = 0; c < count; ++c) values[c] *= std::clamp(shape[c], 0.0f, 1.0f);
}

OROGEN_CLONES void scaled_length(const float* x, const float* y, float factor, int count,
                                 float* __restrict out) {
  for (int i = 0; i < count; ++i) out[i] = factor * std::sqrt(x[i] * x[i] + y[i] * y[i]);
}

// body(tile, distances to crests, distances to troughs) for the tiles that `wanted` says yes to.
template <class Wanted, class Body>
void for_tiles(const FoldSkeleton& skeleton, const Grid& grid, const Context& context,
               Wanted&& wanted, Body&& body) {
  const SegmentBuckets crests(skeleton.top), troughs(skeleton.bottom);
  const int across = (grid.nx + kTile - 1) / kTile, up = (grid.ny + kTile - 1) / kTile;
  parallel_chunks(context, std::size_t(across) * up, 16, [&](std::size_t begin, std::size_t end) {
    TileDistances to_crest(crests, grid), to_trough(troughs, grid);
    TileValues crest, trough;
    for (std::size_t i = begin; i < end; ++i) {
      const int row = int(i) / across * kTile, column = int(i) % across * kTile;
      const Tile tile{row, column, std::min(kTile, grid.ny - row),
                      std::min(kTile, grid.nx - column)};
      if (!wanted(tile)) continue;
      to_crest.measure(tile, crest);
      to_trough.measure(tile, trough);
      body(tile, crest, trough);
    }
  });
}

}  // namespace

FoldDistances fold_distances(const FoldSkeleton& skeleton, const Grid& grid,
                             const Context& context) {
  FoldDistances result{Raster<float>(grid, kFar), Raster<float>(grid, kFar)};
  if (skeleton.top.empty()) return result;
  for_tiles(
      skeleton, grid, context, [](const Tile&) { return true; },
      [&](const Tile& tile, const TileValues& crest, const TileValues& trough) {
        for (int r = 0; r < tile.rows; ++r) {
          std::copy_n(&crest[r * kTile], tile.columns,
                      result.crest.row(tile.row + r) + tile.column);
          std::copy_n(&trough[r * kTile], tile.columns,
                      result.trough.row(tile.row + r) + tile.column);
        }
      });
  return result;
}

Raster<float> crest_speed(const CompressionField& field, double fold_rate, const Context& context) {
  if (!(fold_rate >= 0.0 && std::isfinite(fold_rate)))
    throw InputError("fold_rate: must be finite and not negative (m/yr)");
  const Grid& grid = field.compression_x.grid();
  Raster<float> speed(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    scaled_length(field.compression_x.row(r), field.compression_y.row(r), float(fold_rate), grid.nx,
                  speed.row(r));
  });
  return speed;
}

void shape_folds(const FoldSkeleton& skeleton, Raster<float>& crest, double rounding,
                 const Context& context) {
  if (skeleton.top.empty()) {
    std::fill(crest.values().begin(), crest.values().end(), 0.0f);
    return;
  }
  const Grid& grid = crest.grid();
  const bool rounded = rounding >= kSeenRounding * grid.cell_size;
  Raster<float> shape;
  if (rounded) shape = Raster<float>(grid);
  for_tiles(
      skeleton, grid, context,
      [&](const Tile& tile) {
        for (int r = 0; r < tile.rows; ++r) {
          const float* cells = crest.row(tile.row + r) + tile.column;
          if (std::any_of(cells, cells + tile.columns, [](float v) { return v != 0.0f; }))
            return true;
        }
        return false;
      },
      [&](const Tile& tile, const TileValues& to_crest, const TileValues& to_trough) {
        TileValues values;
        shape_cells(to_crest.data(), to_trough.data(), tile.rows * kTile, values.data());
        for (int r = 0; r < tile.rows; ++r) {
          const float* s = &values[r * kTile];
          if (rounded)
            std::copy_n(s, tile.columns, shape.row(tile.row + r) + tile.column);
          else
            multiply(crest.row(tile.row + r) + tile.column, s, tile.columns);
        }
      });
  if (!rounded) return;
  shape = gaussian_blur(shape, rounding, context);
  parallel_rows(context, grid.ny, [&](int r) { multiply(crest.row(r), shape.row(r), grid.nx); });
}

}  // namespace orogen
