#include "inputs/map_rasters.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {
namespace {

/// Edges of rings by the grid rows whose centre line they cross.
class EdgeTable {
 public:
  explicit EdgeTable(const Grid& grid) : grid_(grid) {}

  void add(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      glm::dvec2 a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if (a.y > b.y) std::swap(a, b);
      const int first = first_row_above(a.y), end = first_row_above(b.y);
      if (first < end) edges_.push_back({a, b, first, end});
    }
  }

  /// Sorted x of the crossings with each row's centre line, rows in CSR form.
  void finish() {
    offsets_.assign(std::size_t(grid_.ny) + 1, 0);
    for (const Edge& e : edges_)
      for (int r = e.first; r < e.end; ++r) ++offsets_[r + 1];
    for (int r = 0; r < grid_.ny; ++r) offsets_[r + 1] += offsets_[r];
    crossings_.resize(offsets_.back());
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    for (const Edge& e : edges_)
      for (int r = e.first; r < e.end; ++r) {
        const double y = grid_.center(r, 0).y;
        crossings_[next[r]++] = e.a.x + (y - e.a.y) * (e.b.x - e.a.x) / (e.b.y - e.a.y);
      }
  }

  /// Sets the cells of one row that lie inside to `value`.
  template <class T>
  void fill_row(int r, T value, T* row) {
    const auto begin = crossings_.begin() + offsets_[r], end = crossings_.begin() + offsets_[r + 1];
    std::sort(begin, end);
    for (auto it = begin; it + 1 < end; it += 2)
      std::fill(row + first_column_past(it[0]), row + first_column_past(it[1]), value);
  }

 private:
  struct Edge {
    glm::dvec2 a, b;  // a below b
    int first, end;   // rows with a.y < centre <= b.y, half open
  };

  /// The first row whose centre lies above y, in [0, ny].
  int first_row_above(double y) const {
    const double guess = (y - grid_.origin.y) / grid_.cell_size - 0.5;
    int r = int(std::clamp(std::ceil(guess), 0.0, double(grid_.ny)));
    while (r > 0 && grid_.center(r - 1, 0).y > y) --r;
    while (r < grid_.ny && !(grid_.center(r, 0).y > y)) ++r;
    return r;
  }
  /// The first column whose centre lies east of x, in [0, nx].
  int first_column_past(double x) const {
    const double guess = (x - grid_.origin.x) / grid_.cell_size - 0.5;
    int c = int(std::clamp(std::ceil(guess), 0.0, double(grid_.nx)));
    while (c > 0 && grid_.center(0, c - 1).x > x) --c;
    while (c < grid_.nx && !(grid_.center(0, c).x > x)) ++c;
    return c;
  }

  const Grid& grid_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> offsets_;
  std::vector<double> crossings_;
};

}  // namespace

Grid grid_for(const VectorMap& map, int resolution) {
  if (resolution < 1 || resolution > 65536)
    throw InputError("resolution: must be from 1 to 65536 cells, not " +
                     std::to_string(resolution));
  return grid_over(map.frame.origin, map.frame.size, resolution);
}

Raster<std::uint8_t> land_mask(const VectorMap& map, const Grid& grid, const Context& context) {
  if (map.coasts.empty()) return Raster<std::uint8_t>(grid, 1);
  Raster<std::uint8_t> land(grid, 0);
  EdgeTable edges(grid);
  for (const Coast& coast : map.coasts) {
    edges.add(coast.outer);
    for (const Ring& hole : coast.holes) edges.add(hole);
  }
  edges.finish();
  parallel_rows(context, grid.ny, [&](int r) { edges.fill_row(r, std::uint8_t(1), land.row(r)); });
  return land;
}

Raster<std::uint16_t> lake_mask(const VectorMap& map, const Grid& grid, const Context& context) {
  if (map.lakes.size() > 65534) throw InputError("lakes: more than 65534");
  Raster<std::uint16_t> lakes(grid, 0);
  for (std::size_t i = 0; i < map.lakes.size(); ++i) {
    EdgeTable edges(grid);
    edges.add(map.lakes[i].outer);
    for (const Ring& island : map.lakes[i].islands) edges.add(island);
    edges.finish();
    parallel_rows(context, grid.ny,
                  [&](int r) { edges.fill_row(r, std::uint16_t(i + 1), lakes.row(r)); });
  }
  return lakes;
}

Raster<std::uint8_t> open_sides(const VectorMap&, const Grid& grid,
                                const Raster<std::uint8_t>& land) {
  Raster<std::uint8_t> open(grid, 0);
  const auto copy = [&](int r, int c) { open(r, c) = land(r, c); };
  for (int c = 0; c < grid.nx; ++c) {
    copy(0, c);
    copy(grid.ny - 1, c);
  }
  for (int r = 0; r < grid.ny; ++r) {
    copy(r, 0);
    copy(r, grid.nx - 1);
  }
  return open;
}

std::vector<std::size_t> rasterise_line(const Grid& grid, const Polyline& line) {
  std::vector<std::size_t> cells;
  std::unordered_map<std::size_t, std::size_t> place;  // of each cell in the chain
  const auto visit = [&](glm::dvec2 p) {
    if (!(p.x >= 0.0 && p.y >= 0.0 && p.x < grid.nx && p.y < grid.ny)) return;
    const std::size_t cell = grid.index(int(p.y), int(p.x));
    const auto [at, is_new] = place.try_emplace(cell, cells.size());
    for (; !is_new && cells.size() > at->second + 1; cells.pop_back()) place.erase(cells.back());
    if (is_new) cells.push_back(cell);
  };
  for (std::size_t k = 0; k < line.size(); ++k) {
    const glm::dvec2 a = grid.to_cells(line[k]);
    visit(a);
    if (k + 1 == line.size()) break;
    // Steps of less than one cell each way, from where the line enters the grid to where it leaves.
    const glm::dvec2 d = grid.to_cells(line[k + 1]) - a;
    double begin = 0.0, end = 1.0;
    for (const auto& [from, way, size] :
         {std::tuple(a.x, d.x, double(grid.nx)), std::tuple(a.y, d.y, double(grid.ny))}) {
      if (way == 0.0) continue;
      const double t = -from / way, u = (size - from) / way;
      begin = std::fmax(begin, std::fmin(t, u));
      end = std::fmin(end, std::fmax(t, u));
    }
    if (!(begin <= end)) continue;
    const double reach = std::fmax(std::fabs(d.x), std::fabs(d.y)) * (end - begin);
    const int steps = int(reach) + 2;
    for (int s = 0; s <= steps; ++s) visit(a + d * (begin + (end - begin) * s / steps));
  }
  return cells;
}

}  // namespace orogen
