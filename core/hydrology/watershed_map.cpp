#include "hydrology/watershed_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "foundation/distance_transform.h"
#include "foundation/parallel.h"
#include "hydrology/base_level.h"
#include "hydrology/depressions.h"
#include "hydrology/lower_envelope.h"
#include "inputs/map_rasters.h"

namespace orogen {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kBedRounds = 2;        // of lowering undercut beds
constexpr float kUndercut = 0.5f;    // m, let pass
constexpr double kLeastRise = 0.01;  // of a river's natural rise, however low its source must lie
constexpr double kDrainEpsilon = 1e-3;  // m

// N at each cell.
Raster<float> steepening(const Raster<float>& peak_distance, const WatershedParameters& parameters,
                         const Context& context) {
  Raster<float> n(peak_distance.grid());
  const float reach = float(parameters.peak_reach), gain = float(parameters.peak_steepening);
  parallel_rows(context, n.grid().ny, [&](int r) {
    for (int c = 0; c < n.grid().nx; ++c) {
      const float x = peak_distance(r, c) / reach, s = 1.0f + x * x;
      n(r, c) = 1.0f + gain / (s * s);
    }
  });
  return n;
}

template <class Visit>
void for_neighbours(const Grid& grid, std::size_t i, Visit&& visit) {
  const int r = int(i / grid.nx), c = int(i % grid.nx);
  for (int dr = -1; dr <= 1; ++dr)
    for (int dc = -1; dc <= 1; ++dc)
      if ((dr || dc) && grid.contains(r + dr, c + dc)) visit(grid.index(r + dr, c + dc));
}

bool beside_sea(const Raster<std::uint8_t>& land, std::size_t cell) {
  bool found = false;
  for_neighbours(land.grid(), cell, [&](std::size_t j) { found |= !land[j]; });
  return found;
}

double between(const Grid& grid, std::int32_t a, std::int32_t b) {
  return grid.cell_size *
         std::hypot(double(a / grid.nx - b / grid.nx), double(a % grid.nx - b % grid.nx));
}

// Highest that a river may rise at its source.
double source_limit(const VectorMap& map, const River& river,
                    const WatershedParameters& parameters) {
  if (map.peaks.empty() || river.points.empty()) return kInfinity;
  double limit = 0.0;
  for (const Peak& peak : map.peaks) {
    const glm::dvec2 d = (peak.position - river.points.front()) / parameters.peak_reach;
    const double height = peak.height_m.value_or(parameters.default_peak_height);
    limit = std::max(limit, height / (1.0 + d.x * d.x + d.y * d.y));
  }
  return parameters.source_share * limit;
}

// Level of a lake for which the map gives none: a gentle rise from the nearest sea.
double lake_level(const Lake& lake, double sea_distance, const WatershedParameters& parameters) {
  return lake.level_m.value_or(parameters.river_slope * sea_distance);
}

// Beds as heights of their cells, in the order of `beds.cells` (receivers first).
std::vector<float> bed_heights(const VectorMap& map, const RiverBeds& beds,
                               const Raster<std::uint8_t>& land, const Raster<float>& n,
                               const Raster<float>& sea_distance,
                               const std::vector<double>& lake_levels,
                               const WatershedParameters& parameters) {
  const Grid& grid = land.grid();
  const std::size_t count = beds.cells.size();
  Raster<std::int32_t> slot(grid, -1);
  for (std::size_t i = 0; i < count; ++i) slot[beds.cells[i]] = std::int32_t(i);
  // Natural rise above the foot of the own river.
  std::vector<double> rise(count);
  std::vector<double> whole_rise(map.rivers.size(), 0.0);
  const auto receiver = [&](std::size_t i) {
    return beds.receivers[i] < 0 ? -1 : slot[beds.receivers[i]];
  };
  const auto river = [&](std::size_t i) { return beds.river[beds.cells[i]] - 1; };
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t to = receiver(i);
    const double step =
        to < 0 ? 0.5 * grid.cell_size : between(grid, beds.cells[i], beds.cells[to]);
    const double below = to >= 0 && river(to) == river(i) ? rise[to] : 0.0;
    rise[i] = below + parameters.river_slope * step * n[beds.cells[i]];
    whole_rise[river(i)] = std::max(whole_rise[river(i)], rise[i]);
  }
  std::vector<float> height(count);
  const auto mouth_level = [&](std::size_t i) -> double {
    const River& r = map.rivers[river(i)];
    if (beside_sea(land, beds.cells[i]) || r.end == RiverEnd::Sea) return 0.0;
    if (r.end == RiverEnd::Lake && r.joins >= 0 && r.joins < int(lake_levels.size()))
      return lake_levels[r.joins];
    if (r.end == RiverEnd::River)  // the trunk's bed may pass by a cell or two away
      for (const int reach : {1, 2})
        for (int dr = -reach; dr <= reach; ++dr)
          for (int dc = -reach; dc <= reach; ++dc) {
            const int row = beds.cells[i] / grid.nx + dr, column = beds.cells[i] % grid.nx + dc;
            if (!grid.contains(row, column)) continue;
            const std::int32_t j = slot(row, column);
            if (j >= 0 && j < std::int32_t(i) && river(j) == r.joins) return double(height[j]);
          }
    if (r.end_height_m) return *r.end_height_m;
    const double away = sea_distance[beds.cells[i]];
    return std::isfinite(away) ? parameters.river_slope * away : 0.0;
  };
  std::vector<double> foot(count);
  std::vector<double> scale(map.rivers.size(), -1.0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t to = receiver(i);
    const int own = river(i);
    foot[i] = to < 0 ? mouth_level(i) : river(to) == own ? foot[to] : height[to];
    if (scale[own] < 0.0) {
      const double room = source_limit(map, map.rivers[own], parameters) - foot[i];
      scale[own] = std::clamp(room / whole_rise[own], kLeastRise, 1.0);
    }
    height[i] = float(foot[i] + scale[own] * rise[i]);
  }
  return height;
}

// Lowers beds that the envelope undercuts, and what lies downstream in proportion.
bool lower_undercut(const RiverBeds& beds, const Raster<float>& envelope,
                    std::vector<float>& height) {
  const std::vector<float> before = height;
  Raster<std::int32_t> slot(envelope.grid(), -1);
  for (std::size_t i = 0; i < height.size(); ++i) slot[beds.cells[i]] = std::int32_t(i);
  bool undercut = false;
  for (std::size_t i = height.size(); i-- > 0;) {
    const float ground = envelope[beds.cells[i]];
    if (ground < height[i]) {
      undercut |= ground < height[i] - kUndercut;
      height[i] = ground;
    }
    if (beds.receivers[i] < 0 || !(height[i] < before[i]) || before[i] <= 0.0f) continue;
    const std::int32_t to = slot[beds.receivers[i]];
    height[to] = std::min(height[to], before[to] * (height[i] / before[i]));
  }
  return undercut;
}

// A river that ends on the land short of the sea goes on to the nearest sea cell.
void join_sea(Raster<float>& sources, const RiverBeds& beds, const std::vector<float>& height,
              const VectorMap& map, const Raster<std::uint8_t>& land, const NearestFeature& sea) {
  const Grid& grid = land.grid();
  for (std::size_t i = 0; i < beds.cells.size(); ++i) {
    const std::int32_t cell = beds.cells[i];
    if (beds.receivers[i] >= 0 || map.rivers[beds.river[cell] - 1].end != RiverEnd::Sea) continue;
    const std::int32_t end = sea.nearest[cell];
    if (end < 0) continue;
    const auto path = rasterise_line(grid, {grid.center(cell / grid.nx, cell % grid.nx),
                                            grid.center(end / grid.nx, end % grid.nx)});
    for (std::size_t k = 1; k < path.size(); ++k)
      if (land[path[k]])
        sources[path[k]] = std::min(sources[path[k]],
                                    height[i] * float(double(path.size() - 1 - k) / path.size()));
  }
}

bool has_pits(const Raster<float>& elevation, const Raster<std::uint8_t>& ends,
              const Context& context) {
  return parallel_sum(context, elevation.size(), [&](std::size_t i) {
           if (ends[i]) return 0.0;
           bool lower = false;
           for_neighbours(elevation.grid(), i,
                          [&](std::size_t j) { lower |= elevation[j] < elevation[i]; });
           return lower ? 0.0 : 1.0;
         }) > 0.0;
}

}  // namespace

WatershedMap watershed_map(const VectorMap& map, const RiverBeds& beds,
                           const Raster<std::uint8_t>& land, const Raster<float>& peak_distance,
                           const WatershedParameters& parameters, const Context& context) {
  check_parameters(parameters, "watershed");
  const Grid& grid = land.grid();
  const Raster<float> n = steepening(peak_distance, parameters, context);
  Raster<std::uint8_t> at_sea(grid), starts(grid), ends(grid);
  const auto lakes = lake_mask(map, grid, context);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    at_sea[i] = !land[i];
    ends[i] = !land[i] || lakes[i];
    starts[i] = ends[i] || beds.river[i];
  }
  const NearestFeature sea = nearest_feature(at_sea, context);
  for (std::size_t i = 0; i < beds.cells.size(); ++i) {
    const std::int32_t cell = beds.cells[i];
    const bool off_the_map = map.rivers[beds.river[cell] - 1].end == RiverEnd::Frame;
    if (beds.receivers[i] < 0 && (off_the_map || sea.nearest[cell] < 0)) ends[cell] = 1;
  }
  if (std::none_of(starts.values().begin(), starts.values().end(), [](auto s) { return s; })) {
    open_sides(starts);
    open_sides(ends);
  }
  std::vector<double> levels;
  for (const Lake& lake : map.lakes) levels.push_back(lake_level(lake, 0.0, parameters));
  for (std::size_t i = grid.size(); i-- > 0;)
    if (const int k = lakes[i] - 1;
        k >= 0 && !map.lakes[k].level_m && std::isfinite(sea.distance[i]))
      levels[k] = lake_level(map.lakes[k], sea.distance[i], parameters);

  WatershedMap result;
  result.bed_height = bed_heights(map, beds, land, n, sea.distance, levels, parameters);
  NearestFeature nearest = nearest_feature(starts, context);
  const Hillside hillside{parameters.hill_slope, parameters.floor_width, &n, parameters.peak_reach};
  Raster<std::int32_t> source = nearest.nearest;
  for (int round = 0;; ++round) {
    Raster<float> sources(grid, kInfinity);
    for (std::size_t i = 0; i < grid.size(); ++i)
      if (starts[i]) sources[i] = lakes[i] && land[i] ? float(levels[lakes[i] - 1]) : 0.0f;
    for (std::size_t i = 0; i < beds.cells.size(); ++i)
      if (!lakes[beds.cells[i]]) sources[beds.cells[i]] = result.bed_height[i];
    join_sea(sources, beds, result.bed_height, map, land, sea);
    result.elevation = lower_envelope(sources, land, source, hillside, context);
    if (!lower_undercut(beds, result.elevation, result.bed_height) || round == kBedRounds) break;
  }
  if (has_pits(result.elevation, ends, context))
    fill_depressions(result.elevation, ends, kDrainEpsilon, context);
  result.river_distance = std::move(nearest.distance);
  result.river_cell = std::move(nearest.nearest);
  return result;
}

const StageInfo& watershed_stage() {
  static const StageInfo info{
      "watershed",
      "Raises heights along rivers from their mouths, and hillslopes from rivers and coast.",
      "Michel, Emilien and Cani 2015, section 6, \"Watershed map\"",
      {"land", "river", "peak_distance"},
      {"watershed_elevation", "river_distance"},
      {"map"}};
  return info;
}

}  // namespace orogen
