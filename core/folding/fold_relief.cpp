#include "folding/fold_relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "folding/segment_buckets.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

constexpr int kTile = 16;  // cells a side
constexpr float kFar = std::numeric_limits<float>::infinity();

// A segment as the inner loop wants it: from the tile's middle, in metres.
struct Ray {
  float x, y, dx, dy, per_square;
};

Ray ray_from(const Segment& s, glm::dvec2 origin) {
  const glm::dvec2 a = s.a - origin, d = s.b - s.a;
  const double square = glm::dot(d, d);
  return {float(a.x), float(a.y), float(d.x), float(d.y),
          square > 0.0 ? float(1.0 / square) : 0.0f};
}

// Distances from the cells of a tile, rows of kTile, to the nearest of the rays.
OROGEN_CLONES void nearest_in_tile(const Ray* rays, int count, float x0, float y0, float step,
                                   int rows, float* __restrict out) {
  float x[kTile];
  for (int i = 0; i < kTile; ++i) x[i] = x0 + float(i) * step;
  for (int r = 0; r < rows; ++r) {
    float least[kTile];
    for (int i = 0; i < kTile; ++i) least[i] = kFar;
    const float y = y0 + float(r) * step;
    for (int k = 0; k < count; ++k) {
      const Ray ray = rays[k];
      const float ey = y - ray.y, along = ey * ray.dy;
      for (int i = 0; i < kTile; ++i) {
        const float ex = x[i] - ray.x;
        float t = (ex * ray.dx + along) * ray.per_square;
        t = t < 0.0f ? 0.0f : t;
        t = t > 1.0f ? 1.0f : t;
        const float px = ex - t * ray.dx, py = ey - t * ray.dy;
        const float square = px * px + py * py;
        least[i] = square < least[i] ? square : least[i];
      }
    }
    for (int i = 0; i < kTile; ++i) out[r * kTile + i] = std::sqrt(least[i]);
  }
}

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

OROGEN_CLONES void scaled_length(const float* x, const float* y, float factor, int count,
                                 float* __restrict out) {
  for (int i = 0; i < count; ++i) out[i] = factor * std::sqrt(x[i] * x[i] + y[i] * y[i]);
}

struct Tile {
  int row, column, rows, columns;
};
using TileValues = std::array<float, kTile * kTile>;  // rows of kTile

// Distances to segments, tile by tile: only those that may be nearest to a cell are looked at.
class TileDistances {
 public:
  TileDistances(const SegmentBuckets& buckets, const Grid& grid) : buckets_(buckets), grid_(grid) {}

  void measure(const Tile& tile, TileValues& out) {
    const glm::dvec2 first = grid_.center(tile.row, tile.column);
    const glm::dvec2 half = 0.5 * grid_.cell_size * glm::dvec2(tile.columns - 1, tile.rows - 1);
    buckets_.candidates(first + half, glm::length(half), near_);
    rays_.clear();
    for (const Segment& s : near_) rays_.push_back(ray_from(s, first + half));
    nearest_in_tile(rays_.data(), int(rays_.size()), float(-half.x), float(-half.y),
                    float(grid_.cell_size), tile.rows, out.data());
  }

 private:
  const SegmentBuckets& buckets_;
  const Grid& grid_;
  std::vector<Segment> near_;
  std::vector<Ray> rays_;
};

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

void shape_folds(const FoldSkeleton& skeleton, Raster<float>& crest, const Context& context) {
  if (skeleton.top.empty()) {
    std::fill(crest.values().begin(), crest.values().end(), 0.0f);
    return;
  }
  const auto cells = [&](const Tile& tile, int r) { return crest.row(tile.row + r) + tile.column; };
  for_tiles(
      skeleton, crest.grid(), context,
      [&](const Tile& tile) {
        for (int r = 0; r < tile.rows; ++r)
          for (int c = 0; c < tile.columns; ++c)
            if (cells(tile, r)[c] != 0.0f) return true;
        return false;
      },
      [&](const Tile& tile, const TileValues& to_crest, const TileValues& to_trough) {
        TileValues shape;
        shape_cells(to_crest.data(), to_trough.data(), tile.rows * kTile, shape.data());
        for (int r = 0; r < tile.rows; ++r)
          for (int c = 0; c < tile.columns; ++c) cells(tile, r)[c] *= shape[r * kTile + c];
      });
}

}  // namespace orogen
