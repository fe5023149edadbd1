#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "foundation/random.h"
#include "island/island_steps.h"

namespace orogen {

namespace {

constexpr std::uint64_t kSourceStream = 3;

bool touches_lake(const Island& island, std::int32_t corner) {
  const auto edges = island.map.corner_edges.of(corner);
  return std::ranges::any_of(edges, [&](std::int32_t e) { return at_lake(island, e); });
}

/// Where rivers end.
bool is_mouth(const Island& island, std::int32_t corner) {
  return island.corners.ocean[corner] || island.coast[corner] || island.map.corner_border[corner];
}

double length(const PolygonMap& map, std::int32_t edge) {
  const auto [v, w] = map.edge_corners[edge];
  const glm::dvec2 way = map.corners[v] - map.corners[w];
  return std::sqrt(way.x * way.x + way.y * way.y);
}

/// Whether a river runs within so many steps of a corner.
bool near_river(const Island& island, const std::vector<std::uint8_t>& river, std::int32_t corner,
                int steps) {
  std::vector<std::int32_t> reached{corner};
  for (std::size_t ring = 0; steps >= 0; --steps) {
    const std::size_t end = reached.size();
    for (; ring < end; ++ring) {
      if (river[reached[ring]]) return true;
      for (const std::int32_t edge : island.map.corner_edges.of(reached[ring])) {
        const std::int32_t next = island.map.other_end(edge, reached[ring]);
        if (std::ranges::find(reached, next) == reached.end()) reached.push_back(next);
      }
    }
  }
  return false;
}

}  // namespace

std::vector<std::int32_t> drain(Island& island) {
  const PolygonMap& map = island.map;
  const std::size_t n = map.corners.size();
  using Item = std::pair<float, std::int32_t>;  // level, place in `upwards`
  std::priority_queue<Item, std::vector<Item>, std::greater<>> waiting;
  std::vector<std::int32_t> order, upwards;
  std::vector<float> level(n, INFINITY);
  island.downstream.assign(n, -1);
  const auto reach = [&](std::int32_t v, float height) {
    level[v] = height;
    waiting.push({height, std::int32_t(order.size())});
    order.push_back(v);
  };
  for (std::int32_t v = 0; v < std::int32_t(n); ++v)
    if (is_mouth(island, v)) reach(v, island.corners.elevation[v]);
  while (!waiting.empty()) {
    const std::int32_t v = order[waiting.top().second];
    waiting.pop();
    upwards.push_back(v);
    for (const std::int32_t edge : map.corner_edges.of(v)) {
      const std::int32_t w = map.other_end(edge, v);
      if (level[w] != INFINITY) continue;
      reach(w, std::max(level[v], island.corners.elevation[w]));
      island.downstream[w] = edge;  // the way out of a pit or across a lake
    }
  }
  for (std::int32_t v = 0; v < std::int32_t(n); ++v) {
    if (is_mouth(island, v)) continue;
    double steepest = 0.0;
    for (const std::int32_t edge : map.corner_edges.of(v)) {
      const double drop = double(level[v]) - level[map.other_end(edge, v)];
      if (drop <= 0.0 || drop <= steepest * length(map, edge)) continue;
      steepest = drop / length(map, edge);
      island.downstream[v] = edge;
    }
  }
  return upwards;
}

void start_rivers(Island& island, const IslandParameters& parameters, std::uint32_t seed,
                  std::span<const std::int32_t> upwards) {
  const PolygonMap& map = island.map;
  const std::int32_t n = std::int32_t(map.corners.size());
  std::vector<std::uint8_t> river(n, 0);
  for (std::int32_t source = 0; source < n; ++source) {
    if (random_uniform(seed, kSourceStream, source) >= parameters.river_density ||
        is_mouth(island, source) || touches_lake(island, source) ||
        near_river(island, river, source, parameters.river_spacing - 1))
      continue;
    for (std::int32_t v = source; !river[v]; v = map.other_end(island.downstream[v], v)) {
      river[v] = 1;
      if (island.downstream[v] < 0) break;
    }
  }
  island.corner_river.assign(n, 0);
  island.edge_river.assign(map.edge_corners.size(), 0);
  for (auto v = upwards.rbegin(); v != upwards.rend(); ++v) {
    if (!river[*v]) continue;
    const std::int32_t carried = ++island.corner_river[*v], edge = island.downstream[*v];
    if (edge < 0) continue;
    island.edge_river[edge] = carried;
    island.corner_river[map.other_end(edge, *v)] += carried;
  }
}

void spread_moisture(Island& island, const IslandParameters& parameters) {
  const PolygonMap& map = island.map;
  std::vector<float>& moisture = island.corners.moisture;
  moisture.assign(map.corners.size(), 0.0f);
  std::priority_queue<std::pair<float, std::int32_t>> waiting;
  for (std::int32_t v = 0; v < std::int32_t(moisture.size()); ++v) {
    const double carried = island.corner_river[v] / parameters.moist_volume;
    moisture[v] = touches_lake(island, v) ? 1.0f : float(std::min(carried, 1.0));
    if (moisture[v] > 0.0f) waiting.push({moisture[v], v});
  }
  while (!waiting.empty()) {
    const auto [wet, v] = waiting.top();
    waiting.pop();
    if (wet < moisture[v]) continue;
    const float next = float(wet * parameters.moisture_decay);
    for (const std::int32_t edge : map.corner_edges.of(v)) {
      const std::int32_t w = map.other_end(edge, v);
      if (next <= moisture[w]) continue;
      moisture[w] = next;
      waiting.push({next, w});
    }
  }
}

}  // namespace orogen
