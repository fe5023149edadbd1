#include <algorithm>
#include <deque>
#include <limits>

#include "island/island_steps.h"

namespace orogen {

namespace {

/// Spreads from the marked centers over those that `may` be reached.
template <class May>
void flood(const PolygonMap& map, std::vector<std::uint8_t>& marked, May&& may) {
  std::vector<std::int32_t> waiting;
  for (std::int32_t c = 0; c < std::int32_t(marked.size()); ++c)
    if (marked[c]) waiting.push_back(c);
  while (!waiting.empty()) {
    const std::int32_t center = waiting.back();
    waiting.pop_back();
    for (const std::int32_t edge : map.center_edges.of(center)) {
      const std::int32_t other = map.beyond(edge, center);
      if (other < 0 || marked[other] || !may(other)) continue;
      marked[other] = 1;
      waiting.push_back(other);
    }
  }
}

constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max();

/// Steps from the coast; along a lake they count nothing.
std::vector<std::int32_t> steps_from_coast(const Island& island) {
  const PolygonMap& map = island.map;
  const bool shore = std::ranges::count(island.coast, 1) > 0;
  const auto& sources = shore ? island.coast : map.corner_border;
  std::vector<std::int32_t> steps(map.corners.size(), kFar);
  std::deque<std::int32_t> waiting;
  for (std::int32_t v = 0; v < std::int32_t(steps.size()); ++v)
    if (sources[v]) {
      steps[v] = 0;
      waiting.push_back(v);
    }
  while (!waiting.empty()) {
    const std::int32_t v = waiting.front();
    waiting.pop_front();
    for (const std::int32_t edge : map.corner_edges.of(v)) {
      const std::int32_t w = map.other_end(edge, v), step = at_lake(island, edge) ? 0 : 1;
      if (steps[v] + step >= steps[w]) continue;
      steps[w] = steps[v] + step;
      step ? waiting.push_back(w) : waiting.push_front(w);
    }
  }
  return steps;
}

}  // namespace

void mark_water(Island& island, double water_share, bool sea_at_sides) {
  const PolygonMap& map = island.map;
  IslandValues &centers = island.centers, &corners = island.corners;
  centers.water.assign(map.centers.size(), 0);
  for (std::int32_t c = 0; c < std::int32_t(map.centers.size()); ++c) {
    const auto ring = map.center_corners.of(c);
    const auto wet = std::ranges::count_if(ring, [&](std::int32_t v) { return corners.water[v]; });
    centers.water[c] =
        double(wet) >= water_share * double(ring.size()) || (sea_at_sides && map.center_border[c]);
  }
  centers.ocean.assign(map.centers.size(), 0);
  for (std::size_t c = 0; c < map.centers.size(); ++c)
    centers.ocean[c] = map.center_border[c] && centers.water[c];
  flood(map, centers.ocean, [&](std::int32_t c) { return centers.water[c] != 0; });
  corners.ocean.assign(map.corners.size(), 0);
  island.coast.assign(map.corners.size(), 0);
  for (std::int32_t v = 0; v < std::int32_t(map.corners.size()); ++v) {
    const auto touched = map.corner_centers.of(v);
    const auto sea =
        std::ranges::count_if(touched, [&](std::int32_t c) { return centers.ocean[c]; });
    corners.ocean[v] = sea == std::ptrdiff_t(touched.size());
    island.coast[v] = sea > 0 && !corners.ocean[v];
  }
}

void raise_from_coast(Island& island) {
  const std::vector<std::int32_t> steps = steps_from_coast(island);
  std::int32_t highest = 1, deepest = 1;
  for (std::size_t v = 0; v < steps.size(); ++v) {
    std::int32_t& most = island.corners.ocean[v] ? deepest : highest;
    most = std::max(most, steps[v]);
  }
  island.corners.elevation.resize(steps.size());
  for (std::size_t v = 0; v < steps.size(); ++v)
    island.corners.elevation[v] = island.corners.ocean[v] ? -float(steps[v]) / float(deepest)
                                                          : float(steps[v]) / float(highest);
}

void level_lakes(Island& island) {
  const PolygonMap& map = island.map;
  std::vector<std::uint8_t> seen(map.centers.size(), 0);
  for (std::int32_t first = 0; first < std::int32_t(map.centers.size()); ++first) {
    if (seen[first] || !island.centers.water[first] || island.centers.ocean[first]) continue;
    std::vector<std::int32_t> lake{first};
    seen[first] = 1;
    float level = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < lake.size(); ++i) {
      for (const std::int32_t v : map.center_corners.of(lake[i]))
        level = std::min(level, island.corners.elevation[v]);
      for (const std::int32_t edge : map.center_edges.of(lake[i])) {
        const std::int32_t other = map.beyond(edge, lake[i]);
        if (other < 0 || seen[other] || !island.centers.water[other] || island.centers.ocean[other])
          continue;
        seen[other] = 1;
        lake.push_back(other);
      }
    }
    for (const std::int32_t center : lake)
      for (const std::int32_t v : map.center_corners.of(center))
        island.corners.elevation[v] = level;
  }
}

}  // namespace orogen
