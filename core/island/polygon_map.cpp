#include "island/polygon_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "foundation/delaunay.h"
#include "foundation/errors.h"
#include "foundation/random.h"
#include "island/clipped_dual.h"

namespace orogen {

namespace {

Lists count_lists(std::size_t size, auto&& for_each) {
  Lists lists;
  lists.first.assign(size + 1, 0);
  for_each([&](std::int32_t owner, std::int32_t) { ++lists.first[owner + 1]; });
  for (std::size_t i = 0; i < size; ++i) lists.first[i + 1] += lists.first[i];
  lists.items.resize(lists.first.back());
  std::vector<std::int32_t> next(lists.first.begin(), lists.first.end() - 1);
  for_each([&](std::int32_t owner, std::int32_t item) { lists.items[next[owner]++] = item; });
  return lists;
}

/// Sorts the edges of a cell so that each begins where the last one ends.
void chain(const PolygonMap& map, std::int32_t center, std::span<std::int32_t> edges) {
  const auto begin = [&](std::int32_t e) {
    return map.edge_corners[e][map.edge_centers[e][0] == center ? 0 : 1];
  };
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const std::int32_t end = map.other_end(edges[i], begin(edges[i]));
    const auto next = std::find_if(edges.begin() + i + 1, edges.end(),
                                   [&](std::int32_t e) { return begin(e) == end; });
    if (next == edges.end()) throw std::logic_error("polygon map: a cell is open");
    std::swap(edges[i + 1], *next);
  }
}

void join(PolygonMap& map) {
  const std::int32_t edges = std::int32_t(map.edge_centers.size());
  map.center_edges = count_lists(map.centers.size(), [&](auto&& add) {
    for (std::int32_t e = 0; e < edges; ++e)
      for (const std::int32_t center : map.edge_centers[e])
        if (center >= 0) add(center, e);
  });
  map.center_corners = map.center_edges;
  for (std::int32_t c = 0; c < std::int32_t(map.centers.size()); ++c) {
    const std::int32_t first = map.center_edges.first[c], last = map.center_edges.first[c + 1];
    chain(map, c, {map.center_edges.items.data() + first, std::size_t(last - first)});
    for (std::int32_t i = first; i < last; ++i) {
      const std::int32_t e = map.center_edges.items[i];
      map.center_corners.items[i] = map.edge_corners[e][map.edge_centers[e][0] == c ? 0 : 1];
    }
  }
  map.corner_edges = count_lists(map.corners.size(), [&](auto&& add) {
    for (std::int32_t e = 0; e < edges; ++e)
      for (const std::int32_t corner : map.edge_corners[e]) add(corner, e);
  });
  map.corner_centers = count_lists(map.corners.size(), [&](auto&& add) {
    for (std::int32_t c = 0; c < std::int32_t(map.centers.size()); ++c)
      for (const std::int32_t corner : map.center_corners.of(c)) add(corner, c);
  });
}

void mark_border(PolygonMap& map) {
  map.center_border.assign(map.centers.size(), 0);
  map.corner_border.assign(map.corners.size(), 0);
  for (std::size_t e = 0; e < map.edge_centers.size(); ++e) {
    if (map.edge_centers[e][1] >= 0) continue;
    map.center_border[map.edge_centers[e][0]] = 1;
    for (const std::int32_t corner : map.edge_corners[e]) map.corner_border[corner] = 1;
  }
}

std::string describe(glm::dvec2 p) {
  return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
}

void check(std::span<const glm::dvec2> points, glm::dvec2 low, glm::dvec2 high) {
  if (!(low.x < high.x && low.y < high.y)) throw InputError("rectangle: has no area");
  for (const glm::dvec2 p : points)
    if (!(p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y))
      throw InputError("points: " + describe(p) + " lies outside " + describe(low) + " to " +
                       describe(high));
  std::vector<glm::dvec2> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(),
            [](glm::dvec2 a, glm::dvec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) throw InputError("points: " + describe(*twice) + " is given twice");
}

std::vector<glm::dvec2> corner_means(const PolygonMap& map) {
  std::vector<glm::dvec2> means(map.centers.size());
  for (std::int32_t c = 0; c < std::int32_t(means.size()); ++c) {
    const auto ring = map.center_corners.of(c);
    for (const std::int32_t corner : ring) means[c] += map.corners[corner] / double(ring.size());
  }
  return means;
}

}  // namespace

PolygonMap polygon_map(std::vector<glm::dvec2> points, glm::dvec2 low, glm::dvec2 high,
                       const Context& context) {
  check(points, low, high);
  const Triangulation triangulation = delaunay(points, context);
  if (triangulation.triangles.empty()) throw InputError("points: all lie on one line");
  PolygonMap map;
  map.low = low;
  map.high = high;
  map.centers = std::move(points);
  clip_dual(triangulation, map);
  join(map);
  mark_border(map);
  return map;
}

PolygonMap random_polygon_map(int cells, int relaxations, glm::dvec2 low, glm::dvec2 high,
                              std::uint32_t seed, const Context& context) {
  std::vector<glm::dvec2> points(cells);
  for (int i = 0; i < cells; ++i)
    points[i] =
        low + (high - low) * glm::dvec2(random_uniform(seed, 1, i), random_uniform(seed, 2, i));
  const glm::dvec2 size = high - low;
  sort_along_curve(points, low, std::fmax(size.x, size.y));
  PolygonMap map = polygon_map(std::move(points), low, high, context);
  for (int i = 0; i < relaxations; ++i) map = polygon_map(corner_means(map), low, high, context);
  return map;
}

}  // namespace orogen
