#include "inputs/river_routing.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "inputs/map_rasters.h"

namespace orogen {
namespace {

/// Peaks make the cells around them costly.
Raster<float> step_costs(const VectorMap& map, const Grid& grid) {
  Raster<float> cost(grid, 1.0f);
  const double reach = 3000.0;
  const int cells = std::min(grid.nx + grid.ny, int(reach / grid.cell_size) + 1);
  for (const Peak& peak : map.peaks) {
    const int row = grid.row_of(peak.position.y), column = grid.column_of(peak.position.x);
    for (int r = std::max(0, row - cells); r <= std::min(grid.ny - 1, row + cells); ++r)
      for (int c = std::max(0, column - cells); c <= std::min(grid.nx - 1, column + cells); ++c) {
        const double d = glm::length(grid.center(r, c) - peak.position);
        cost(r, c) = std::fmax(cost(r, c), float(7.0 - 6.0 * std::fmin(1.0, d / reach)));
      }
  }
  return cost;
}

/// Keeps the points of a path that lie more than `tolerance` off the line through their neighbours
/// (Douglas and Peucker 1973).
void simplify(const Polyline& path, std::size_t first, std::size_t last, double tolerance,
              Polyline& kept) {
  double farthest = tolerance;
  std::size_t split = 0;
  const glm::dvec2 u = path[last] - path[first];
  for (std::size_t i = first + 1; i < last; ++i) {
    const glm::dvec2 w = path[i] - path[first];
    const double length = glm::length(u);
    const double d = length > 0.0 ? std::fabs(u.x * w.y - u.y * w.x) / length : glm::length(w);
    if (d > farthest) farthest = d, split = i;
  }
  if (split) {
    simplify(path, first, split, tolerance, kept);
    simplify(path, split, last, tolerance, kept);
  } else {
    kept.push_back(path[last]);
  }
}

/// A chain without the 40% below its source: nothing flows in so high up.
Polyline lower_course(const RiverGraph& graph, int c, const std::vector<Outlet>& outlets) {
  const Chain& chain = graph.chains[c];
  Polyline line;
  for (const int v : chain.vertices) line.push_back(graph.points[v]);
  for (const int end : {chain.first(), chain.last()}) {
    if (!graph.is_end(end) || outlets[end].here) continue;
    if (end == chain.first()) std::reverse(line.begin(), line.end());
    double left = 0.4 * chain.length;
    while (line.size() > 1 && left > 0.0) {
      const double step = glm::length(line.back() - line[line.size() - 2]);
      if (left < step) {
        line.back() += left / step * (line[line.size() - 2] - line.back());
        break;
      }
      left -= step;
      line.pop_back();
    }
  }
  return line;
}

}  // namespace

RiverRouting::RiverRouting(const VectorMap& map, const LandRegion& land, const RiverGraph& graph,
                           const std::vector<Outlet>& outlets)
    : land_(land), grid_(grid_for(map, 200)) {
  const Context context;
  const auto ground = land_mask(map, grid_, context);
  const auto lakes = lake_mask(map, grid_, context);
  next_ = Raster<int>(grid_, -1);
  for (int r = 0; r < grid_.ny; ++r)
    for (int c = 0; c < grid_.nx; ++c) {
      const bool side = r == 0 || c == 0 || r + 1 == grid_.ny || c + 1 == grid_.nx;
      if (side || !ground(r, c) || lakes(r, c)) next_(r, c) = int(grid_.index(r, c));
    }
  const std::vector<int> part = connected_parts(graph);
  std::vector<char> drains(graph.chains.size(), 0);
  for (std::size_t c = 0; c < graph.chains.size(); ++c)
    for (const int v : {graph.chains[c].first(), graph.chains[c].last()})
      if (outlets[v].here) drains[part[c]] = 1;
  std::vector<Segment> segments;
  for (std::size_t c = 0; c < graph.chains.size(); ++c) {
    if (!drains[part[c]]) continue;
    const Polyline line = lower_course(graph, int(c), outlets);
    append_segments(segments, line, false, 0);
    for (const std::size_t i : rasterise_line(grid_, line)) next_[i] = int(i);
  }
  rivers_ = SegmentTree(std::move(segments));
  search(step_costs(map, grid_));
}

void RiverRouting::search(const Raster<float>& cost) {
  struct Entry {
    double cost;
    int cell;
    bool operator<(const Entry& b) const { return cost != b.cost ? cost > b.cost : cell > b.cell; }
  };
  std::priority_queue<Entry> queue;
  Raster<double> reached(grid_, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < next_.size(); ++i)
    if (next_[i] >= 0) {
      reached[i] = 0.0;
      queue.push({0.0, int(i)});
    }
  while (!queue.empty()) {
    const Entry e = queue.top();
    queue.pop();
    if (e.cost > reached[e.cell]) continue;
    const int r = e.cell / grid_.nx, c = e.cell % grid_.nx;
    for (int dr = -1; dr <= 1; ++dr)
      for (int dc = -1; dc <= 1; ++dc) {
        if (!grid_.contains(r + dr, c + dc)) continue;
        const std::size_t i = grid_.index(r + dr, c + dc);
        const double step = (dr != 0 && dc != 0 ? std::sqrt(2.0) : 1.0) * cost[i];
        if (e.cost + step >= reached[i]) continue;
        reached[i] = e.cost + step;
        next_[i] = e.cell;
        queue.push({reached[i], int(i)});
      }
  }
}

Polyline RiverRouting::way_from(glm::dvec2 from, glm::dvec2 otherwise) const {
  const int row = std::clamp(grid_.row_of(from.y), 0, grid_.ny - 1);
  const int column = std::clamp(grid_.column_of(from.x), 0, grid_.nx - 1);
  Polyline path{from};
  for (int cell = int(grid_.index(row, column)); next_[cell] >= 0 && next_[cell] != cell;) {
    cell = next_[cell];
    if (next_[cell] != cell) path.push_back(grid_.center(cell / grid_.nx, cell % grid_.nx));
  }
  if (path.size() < 2) return {otherwise};
  Polyline way;
  simplify(path, 0, path.size() - 1, 0.7 * grid_.cell_size, way);
  // From the last cell straight to the nearest goal itself.
  std::optional<SegmentTree::Hit> best;
  for (const SegmentTree* tree : {&land_.coast(), &land_.lakes(), &land_.frame(), &rivers_})
    if (const auto hit = tree->nearest(way.back());
        hit && (!best || hit->distance < best->distance))
      best = hit;
  if (best) way.push_back(best->point);
  return way;
}

}  // namespace orogen
