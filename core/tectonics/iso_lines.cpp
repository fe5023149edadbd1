#include "tectonics/iso_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "foundation/distance_transform.h"
#include "foundation/parallel.h"
#include "foundation/simd.h"

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
  glm::dvec2 a, e;  // from a along e, m
  double per_length2;
};

// Squared distances (m²) from n places of a row, x + j step, to the nearest of some segments.
OROGEN_CLONES void squared_distances(const Segment* begin, const Segment* end, double x,
                                     double step, double y, float* out, int n) {
  std::fill_n(out, n, std::numeric_limits<float>::infinity());
  for (const Segment* s = begin; s != end; ++s) {
    const double ry = y - s->a.y;
    for (int j = 0; j < n; ++j) {
      const double rx = x + j * step - s->a.x;
      double t = (rx * s->e.x + ry * s->e.y) * s->per_length2;
      t = t < 0.0 ? 0.0 : t;
      t = t > 1.0 ? 1.0 : t;
      const double dx = rx - t * s->e.x, dy = ry - t * s->e.y;
      const float squared = float(dx * dx + dy * dy);
      out[j] = squared < out[j] ? squared : out[j];
    }
  }
}

// The pieces of lines near the cells they run through: in the cell, and one farther on both ways.
struct PiecesByCell {
  PiecesByCell(std::span<const Polyline> lines, const Grid& grid) : marked(grid), place(grid) {
    std::vector<Segment> all;
    std::vector<std::pair<std::size_t, int>> by_cell;
    for (const Polyline& line : lines)
      for (std::size_t i = 1; i < line.size(); ++i) {
        all.emplace_back(line[i - 1], line[i]);
        const glm::dvec2 middle = 0.5 * (line[i - 1] + line[i]);
        const int r = std::clamp(grid.row_of(middle.y), 0, grid.ny - 1);
        const int c = std::clamp(grid.column_of(middle.x), 0, grid.nx - 1);
        by_cell.push_back({grid.index(r, c), int(all.size()) - 1});
      }
    std::sort(by_cell.begin(), by_cell.end());
    int last = -1;  // piece taken for the present cell
    for (const auto& [cell, piece] : by_cell) {
      if (!marked[cell]) {
        marked[cell] = 1;
        place[cell] = std::int32_t(begin.size());
        begin.push_back(pieces.size());
        last = -1;
      }
      for (int k = std::max(piece - 1, last + 1); k <= std::min(piece + 1, int(all.size()) - 1);
           ++k) {
        pieces.push_back(all[k]);
        last = k;
      }
    }
    begin.push_back(pieces.size());
  }

  /// Squared distances (m²) from n places of a row to the pieces of a marked cell.
  void from_cell(std::size_t cell, double x, double y, float* out, int n) const {
    const std::size_t at = place[cell];
    squared_distances(pieces.data() + begin[at], pieces.data() + begin[at + 1], x,
                      marked.grid().cell_size, y, out, n);
  }

  /// From a cell's centre to the pieces of all marked cells at most two rows and columns away.
  float from_around(int row, int column) const {
    const glm::dvec2 p = marked.grid().center(row, column);
    float best = std::numeric_limits<float>::infinity(), squared = best;
    for (int r = row - 2; r <= row + 2; ++r)
      for (int c = column - 2; c <= column + 2; ++c)
        if (marked.grid().contains(r, c) && marked(r, c)) {
          from_cell(marked.grid().index(r, c), p.x, p.y, &squared, 1);
          best = std::min(best, squared);
        }
    return best;
  }

  Raster<std::uint8_t> marked;
  Raster<std::int32_t> place;      // of a marked cell, among them
  std::vector<std::size_t> begin;  // of a marked cell's pieces
  std::vector<Segment> pieces;
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
  const PiecesByCell pieces(lines, grid);
  Raster<float> distance(grid, float(grid.width() + grid.height()));
  NearestFeature near;
  if (!pieces.pieces.empty()) near = nearest_feature(pieces.marked, context);
  const float close = 2.0f * float(grid.cell_size);
  parallel_rows(context, grid.ny, [&](int r) {
    float* d = distance.row(r);
    if (!pieces.pieces.empty()) {
      const std::int32_t* nearest = near.nearest.row(r);
      for (int c = 0, end; c < grid.nx; c = end) {  // cells with the same nearest one together
        end = int(std::find_if(nearest + c, nearest + grid.nx,
                               [&](std::int32_t cell) { return cell != nearest[c]; }) -
                  nearest);
        const glm::dvec2 p = grid.center(r, c);
        pieces.from_cell(nearest[c], p.x, p.y, d + c, end - c);
      }
      for (int c = 0; c < grid.nx; ++c)
        if (near.distance(r, c) <= close) d[c] = pieces.from_around(r, c);
      for (int c = 0; c < grid.nx; ++c) d[c] = std::sqrt(d[c]);
    }
    for (int c = 0; c < grid.nx; ++c) d[c] = field(r, c) < level ? -d[c] : d[c];
  });
  return distance;
}

}  // namespace orogen
