#include "foundation/distance_transform.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/parallel.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

constexpr std::int32_t kNone = -1;
constexpr int kColumns = 64;  // columns scanned together
constexpr int kTile = 32;     // cells

// For each cell the row of the nearest feature in its own column; kNone in columns without any.
Raster<std::int32_t> nearest_rows(const Raster<std::uint8_t>& features, const Context& context) {
  const Grid& grid = features.grid();
  Raster<std::int32_t> rows(grid);
  parallel_chunks(context, grid.nx, kColumns, [&](std::size_t begin, std::size_t end) {
    for (int r = 0; r < grid.ny; ++r) {
      const std::uint8_t* feature = features.row(r);
      const std::int32_t* below = r ? rows.row(r - 1) : nullptr;
      std::int32_t* row = rows.row(r);
      for (std::size_t c = begin; c < end; ++c) row[c] = feature[c] ? r : below ? below[c] : kNone;
    }
    for (int r = grid.ny - 2; r >= 0; --r) {
      const std::int32_t* above = rows.row(r + 1);
      std::int32_t* row = rows.row(r);
      for (std::size_t c = begin; c < end; ++c) {
        const std::int32_t a = above[c], b = row[c];
        const bool take = a != kNone && (b == kNone || a - r < r - b);
        row[c] = take ? a : b;
      }
    }
  });
  return rows;
}

// Lower envelope of the parabolas (c − i)² + height[i] of one row.
struct Envelope {
  std::vector<int> vertex;
  std::vector<double> from;  // vertex[k] is lowest from here on
  std::vector<double> height;

  explicit Envelope(int n) : vertex(n), from(n), height(n) {}

  int build(int row, const std::int32_t* rows, int n) {
    int count = 0;
    for (int c = 0; c < n; ++c) {
      if (rows[c] == kNone) continue;
      const double d = row - rows[c], f = d * d + double(c) * c;
      double start = -std::numeric_limits<double>::infinity();
      while (count > 0) {
        start = (f - height[count - 1]) / (2.0 * (c - vertex[count - 1]));
        if (start > from[count - 1]) break;
        --count;
        start = -std::numeric_limits<double>::infinity();
      }
      vertex[count] = c;
      from[count] = start;
      height[count] = f;
      ++count;
    }
    return count;
  }
};

template <class Write>
void for_nearest(const Raster<std::uint8_t>& features, const Context& context, Write&& write) {
  const Grid& grid = features.grid();
  const Raster<std::int32_t> rows = nearest_rows(features, context);
  parallel_chunks(context, grid.ny, 8, [&](std::size_t begin, std::size_t end) {
    Envelope envelope(grid.nx);
    for (std::size_t r = begin; r < end; ++r) {
      const int count = envelope.build(int(r), rows.row(int(r)), grid.nx);
      for (int c = 0, k = 0; c < grid.nx; ++c) {
        while (k + 1 < count && envelope.from[k + 1] < c) ++k;
        const int column = count ? envelope.vertex[k] : kNone;
        write(int(r), c, count ? rows(int(r), column) : kNone, column);
      }
    }
  });
}

float distance_between(const Grid& grid, int r, int c, int row, int column) {
  if (column == kNone) return std::numeric_limits<float>::infinity();
  const double dr = r - row, dc = c - column;
  return float(std::sqrt(dr * dr + dc * dc) * grid.cell_size);
}

double squared(double x) {
  return x * x;
}

OROGEN_CLONES void keep_nearer(float x0, float step, float px, float dy2, std::int32_t id,
                               float* best, std::int32_t* nearest, int n) {
  for (int i = 0; i < n; ++i) {
    const float dx = x0 + step * float(i) - px;
    const float d = dx * dx + dy2;
    const bool nearer = d < best[i];
    best[i] = nearer ? d : best[i];
    nearest[i] = nearer ? id : nearest[i];
  }
}

}  // namespace

Raster<float> distance_transform(const Raster<std::uint8_t>& features, const Context& context) {
  Raster<float> distance(features.grid());
  for_nearest(features, context, [&](int r, int c, int row, int column) {
    distance(r, c) = distance_between(features.grid(), r, c, row, column);
  });
  return distance;
}

NearestFeature nearest_feature(const Raster<std::uint8_t>& features, const Context& context) {
  const Grid& grid = features.grid();
  NearestFeature result{Raster<float>(grid), Raster<std::int32_t>(grid)};
  for_nearest(features, context, [&](int r, int c, int row, int column) {
    result.distance(r, c) = distance_between(grid, r, c, row, column);
    result.nearest(r, c) = column == kNone ? kNone : std::int32_t(grid.index(row, column));
  });
  return result;
}

std::vector<int> nearest_candidates(std::span<const glm::dvec2> points, glm::dvec2 low,
                                    glm::dvec2 high) {
  double bound = std::numeric_limits<double>::infinity();
  for (const auto& p : points)
    bound = std::min(bound, squared(std::max(p.x - low.x, high.x - p.x)) +
                                squared(std::max(p.y - low.y, high.y - p.y)));
  bound *= 1.0 + 1e-6;  // float distances below must not lose the true nearest
  std::vector<int> candidates;
  for (int i = 0; i < int(points.size()); ++i) {
    const auto& p = points[i];
    const double dx = std::max({low.x - p.x, p.x - high.x, 0.0});
    const double dy = std::max({low.y - p.y, p.y - high.y, 0.0});
    if (dx * dx + dy * dy <= bound) candidates.push_back(i);
  }
  return candidates;
}

NearestFeature nearest_point(std::span<const glm::dvec2> points, const Grid& grid,
                             const Context& context) {
  NearestFeature result{Raster<float>(grid), Raster<std::int32_t>(grid, kNone)};
  const int across = (grid.nx + kTile - 1) / kTile, up = (grid.ny + kTile - 1) / kTile;
  parallel_chunks(context, std::size_t(across) * up, 1, [&](std::size_t tile, std::size_t) {
    const int r0 = int(tile) / across * kTile, c0 = int(tile) % across * kTile;
    const int r1 = std::min(r0 + kTile, grid.ny), n = std::min(kTile, grid.nx - c0);
    const glm::dvec2 corner = grid.center(r0, c0);
    const auto candidates = nearest_candidates(points, corner, grid.center(r1 - 1, c0 + n - 1));
    for (int r = r0; r < r1; ++r) {
      float best[kTile];
      std::fill(best, best + n, std::numeric_limits<float>::infinity());
      std::int32_t* nearest = result.nearest.row(r) + c0;
      const double y = grid.center(r, c0).y;
      for (int id : candidates)  // in cells from the tile's corner: precise wherever the map lies
        keep_nearer(0.0f, 1.0f, float((points[id].x - corner.x) / grid.cell_size),
                    float(squared((y - points[id].y) / grid.cell_size)), id, best, nearest, n);
      for (int i = 0; i < n; ++i)
        result.distance(r, c0 + i) = std::sqrt(best[i]) * float(grid.cell_size);
    }
  });
  return result;
}

}  // namespace orogen
