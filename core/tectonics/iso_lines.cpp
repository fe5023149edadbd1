#include "tectonics/iso_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "foundation/distance_transform.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

// A piece of line through one square, from side to side. A side is named by its lower-left cell's
// number, twice, plus 1 if it is upright.
struct Piece {
  std::int64_t from, to;
};

class Marching {
 public:
  Marching(const Raster<float>& field, float level) : field_(field), level_(level) {}

  void square(int r, int c, std::vector<Piece>& out) const {
    const bool a = above(r, c), b = above(r, c + 1), d = above(r + 1, c + 1), e = above(r + 1, c);
    if (a == b && b == d && d == e) return;
    const std::int64_t n = std::int64_t(field_.grid().index(r, c)), nx = field_.grid().nx;
    const std::int64_t sides[4] = {2 * n, 2 * (n + 1) + 1, 2 * (n + nx), 2 * n + 1};
    const bool corner[5] = {a, b, d, e, a};
    // Sides in turn, anticlockwise. With higher ground on its left a line comes in over a side that
    // falls and leaves over one that rises.
    int in[2], exit[2], ins = 0, exits = 0;
    for (int s = 0; s < 4; ++s) {
      if (corner[s] && !corner[s + 1]) in[ins++] = s;
      if (!corner[s] && corner[s + 1]) exit[exits++] = s;
    }
    if (ins == 1) return out.push_back({sides[in[0]], sides[exit[0]]});
    const float mean =
        0.25f * (field_(r, c) + field_(r, c + 1) + field_(r + 1, c + 1) + field_(r + 1, c));
    // The next exit anticlockwise cuts off a low corner, the one before a high corner.
    for (int k = 0; k < 2; ++k) {
      const int s = in[k], other = mean >= level_ ? (s + 1) % 4 : (s + 3) % 4;
      out.push_back({sides[s], sides[other]});
    }
  }

  glm::dvec2 crossing(std::int64_t side) const {
    const Grid& grid = field_.grid();
    const std::size_t i = std::size_t(side / 2), j = i + (side % 2 ? grid.nx : 1);
    const double low = field_[i], high = field_[j];
    const double t = std::clamp((level_ - low) / (high - low), 0.0, 1.0);
    const glm::dvec2 p = grid.center(int(i / grid.nx), int(i % grid.nx));
    return p + t * grid.cell_size * (side % 2 ? glm::dvec2(0.0, 1.0) : glm::dvec2(1.0, 0.0));
  }

 private:
  bool above(int r, int c) const { return field_(r, c) >= level_; }

  const Raster<float>& field_;
  float level_;
};

std::vector<Piece> march(const Marching& marching, const Grid& grid, const Context& context) {
  constexpr int kRows = 16;
  const int bands = std::max(0, (grid.ny - 1 + kRows - 1) / kRows);
  std::vector<std::vector<Piece>> found(bands);
  parallel_chunks(context, bands, 1, [&](std::size_t band, std::size_t) {
    const int end = std::min((int(band) + 1) * kRows, grid.ny - 1);
    for (int r = int(band) * kRows; r < end; ++r)
      for (int c = 0; c + 1 < grid.nx; ++c) marching.square(r, c, found[band]);
  });
  std::vector<Piece> pieces;
  for (const auto& some : found) pieces.insert(pieces.end(), some.begin(), some.end());
  return pieces;
}

struct Segment {
  Segment(glm::dvec2 from, glm::dvec2 to) : a(from), e(to - from) {
    const double squared = e.x * e.x + e.y * e.y;
    per_length2 = squared > 0.0 ? 1.0 / squared : 0.0;
  }
  double squared_distance(glm::dvec2 p) const {
    const glm::dvec2 r = p - a;
    const double t = std::clamp((r.x * e.x + r.y * e.y) * per_length2, 0.0, 1.0);
    const double dx = r.x - t * e.x, dy = r.y - t * e.y;
    return dx * dx + dy * dy;
  }

  glm::dvec2 a, e;  // from a along e, m
  double per_length2;
};

}  // namespace

std::vector<Polyline> iso_lines(const Raster<float>& field, float level, const Context& context) {
  const Marching marching(field, level);
  const std::vector<Piece> pieces = march(marching, field.grid(), context);
  // Every side is left by one piece at most and reached by one at most.
  std::vector<std::pair<std::int64_t, int>> starts, ends;
  for (int i = 0; i < int(pieces.size()); ++i) {
    starts.push_back({pieces[i].from, i});
    ends.push_back({pieces[i].to, i});
  }
  std::sort(starts.begin(), starts.end());
  std::sort(ends.begin(), ends.end());
  const auto find = [](const auto& list, std::int64_t side) {
    const auto at = std::lower_bound(list.begin(), list.end(), std::pair{side, -1});
    return at != list.end() && at->first == side ? at->second : -1;
  };
  std::vector<char> done(pieces.size(), 0);
  std::vector<Polyline> lines;
  for (int i = 0; i < int(pieces.size()); ++i) {
    if (done[i]) continue;
    int first = i;
    for (int k = find(ends, pieces[i].from); k >= 0; k = find(ends, pieces[k].from)) {
      if (k == i) {
        first = i;
        break;
      }
      first = k;
    }
    Polyline line{marching.crossing(pieces[first].from)};
    for (int k = first; k >= 0 && !done[k]; k = find(starts, pieces[k].to)) {
      done[k] = 1;
      line.push_back(marching.crossing(pieces[k].to));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Raster<float> signed_distance(const Raster<float>& field, float level,
                              std::span<const Polyline> lines, const Context& context) {
  const Grid& grid = field.grid();
  std::vector<Segment> segments;
  for (const Polyline& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) segments.emplace_back(line[i - 1], line[i]);
  Raster<float> distance(grid, float(grid.width() + grid.height()));
  NearestFeature near;
  Raster<std::int32_t> first(grid);  // segment in a marked cell, the first of several
  if (!segments.empty()) {
    Raster<std::uint8_t> marked(grid);
    for (int i = int(segments.size()) - 1; i >= 0; --i) {
      const glm::dvec2 middle = segments[i].a + 0.5 * segments[i].e;
      const std::size_t cell = grid.index(std::clamp(grid.row_of(middle.y), 0, grid.ny - 1),
                                          std::clamp(grid.column_of(middle.x), 0, grid.nx - 1));
      marked[cell] = 1;
      first[cell] = i;
    }
    near = nearest_feature(marked, context);
  }
  const int last = int(segments.size()) - 1;
  const float close = 8.0f * float(grid.cell_size);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      if (last >= 0) {
        const int i = first[near.nearest(r, c)], reach = near.distance(r, c) < close ? 3 : 1;
        const glm::dvec2 p = grid.center(r, c);
        double best = segments[i].squared_distance(p);
        for (int k = std::max(i - reach, 0); k <= std::min(i + reach, last); ++k)
          best = std::min(best, segments[k].squared_distance(p));
        distance(r, c) = float(std::sqrt(best));
      }
      if (field(r, c) < level) distance(r, c) = -distance(r, c);
    }
  });
  return distance;
}

}  // namespace orogen
