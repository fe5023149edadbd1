#include "tectonics/sub_plates.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "foundation/distance_transform.h"
#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"
#include "tectonics/peak_chains.h"
#include "tectonics/plate_merging.h"
#include "tectonics/voronoi.h"

namespace orogen {

namespace {

constexpr int kTile = 32;             // cells
constexpr double kSideOffset = 0.05;  // of a chain's points from its line, over their spacing
constexpr int kPiecesPerSpacing = 3;  // points along a chain from one peak to the next
constexpr double kBendReach = 5.0;    // standard deviations that bends stay within

// The points whose Voronoi cells are taken, and the sub-plate that each belongs to.
struct Generators {
  std::vector<glm::dvec2> points;
  std::vector<int> sub_plate;
  std::vector<std::vector<int>> peaks;  // of each sub-plate
  std::vector<int> opposite;            // of each sub-plate

  int add_sub_plate(std::vector<int> of_peaks) {
    peaks.push_back(std::move(of_peaks));
    opposite.push_back(-1);
    return int(peaks.size()) - 1;
  }
};

// Points close to both sides of a line of peaks; left and right are one sub-plate each.
void add_chain(Generators& g, const std::vector<glm::dvec2>& positions,
               const std::vector<int>& chain, const std::vector<int>& numbers) {
  Polyline line;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    for (int k = 0; k < kPiecesPerSpacing; ++k)
      line.push_back(positions[chain[i]] + (k + 0.5) / kPiecesPerSpacing *
                                               (positions[chain[i + 1]] - positions[chain[i]]));
  std::vector<int> peaks;
  for (int i : chain) peaks.push_back(numbers[i]);
  const int left = g.add_sub_plate(peaks), right = g.add_sub_plate(peaks);
  g.opposite[left] = right;
  g.opposite[right] = left;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const glm::dvec2 along = line[std::min(i + 1, line.size() - 1)] - line[i ? i - 1 : 0];
    const double spacing = std::hypot(along.x, along.y) * (i && i + 1 < line.size() ? 0.5 : 1.0);
    const glm::dvec2 normal = glm::dvec2(-along.y, along.x) / std::hypot(along.x, along.y);
    const glm::dvec2 offset = kSideOffset * spacing * normal;
    g.points.push_back(line[i] + offset);
    g.sub_plate.push_back(left);
    g.points.push_back(line[i] - offset);
    g.sub_plate.push_back(right);
  }
}

Generators make_generators(const VectorMap& map, const PlateParameters& parameters,
                           std::vector<int>& volcanoes) {
  std::vector<glm::dvec2> positions;  // of the peaks in `numbers`
  std::vector<int> numbers;
  for (int i = 0; i < int(map.peaks.size()); ++i) {
    if (map.peaks[i].volcano.value_or(false)) {
      volcanoes.push_back(i);
      continue;
    }
    numbers.push_back(i);
    positions.push_back(map.peaks[i].position);
  }
  const PeakPattern pattern =
      find_peak_pattern(positions, {.minimum_peaks = parameters.chain_minimum_peaks,
                                    .isolation_factor = parameters.isolation_factor});
  std::vector<char> used(positions.size(), 0);
  Generators g;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (parameters.volcanoes && pattern.isolated[i] && !map.peaks[numbers[i]].volcano) {
      volcanoes.push_back(numbers[i]);
      used[i] = 1;
    }
  std::sort(volcanoes.begin(), volcanoes.end());
  if (parameters.line_boundaries)
    for (const auto& chain : pattern.chains) {
      for (int i : chain) used[i] = 1;
      add_chain(g, positions, chain, numbers);
    }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (used[i]) continue;
    g.points.push_back(positions[i]);
    g.sub_plate.push_back(g.add_sub_plate({numbers[i]}));
  }
  return g;
}

struct Cells {
  std::vector<VoronoiCell> voronoi;
  std::vector<double> area;
  std::vector<glm::dvec2> centroid;
};

// Area and mean velocity p − c of each sub-plate.
std::vector<SubPlate> make_sub_plates(const Generators& g, const Cells& cells) {
  std::vector<SubPlate> result(g.peaks.size());
  for (std::size_t i = 0; i < g.points.size(); ++i) {
    SubPlate& s = result[g.sub_plate[i]];
    s.area += cells.area[i];
    s.velocity += cells.area[i] * (g.points[i] - cells.centroid[i]);
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (result[i].area > 0.0) result[i].velocity /= result[i].area;
    result[i].opposite = g.opposite[i];
  }
  return result;
}

std::vector<std::pair<int, int>> adjacency(const Generators& g, const Cells& cells,
                                           double shortest_side) {
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < g.points.size(); ++i) {
    const VoronoiCell& cell = cells.voronoi[i];
    for (std::size_t k = 0; k < cell.polygon.size(); ++k) {
      const int j = cell.neighbours[k];
      if (j <= int(i) || g.sub_plate[i] == g.sub_plate[j]) continue;
      const glm::dvec2 side = cell.polygon[(k + 1) % cell.polygon.size()] - cell.polygon[k];
      if (std::hypot(side.x, side.y) > shortest_side)
        pairs.push_back(std::minmax(g.sub_plate[i], g.sub_plate[j]));
    }
  }
  return pairs;
}

void assemble(PlateMap& result, const Generators& g, const Cells& cells,
              const std::vector<SubPlate>& sub_plates, const std::vector<int>& merged,
              double speed_scale) {
  result.plates.resize(merged.empty() ? 0 : 1 + *std::max_element(merged.begin(), merged.end()));
  for (std::size_t i = 0; i < g.points.size(); ++i) {
    if (cells.voronoi[i].polygon.empty()) continue;
    Plate& plate = result.plates[merged[g.sub_plate[i]]];
    plate.pieces.push_back(cells.voronoi[i].polygon);
    plate.area += cells.area[i];
    plate.centroid += cells.area[i] * cells.centroid[i];
  }
  for (std::size_t s = 0; s < sub_plates.size(); ++s) {
    Plate& plate = result.plates[merged[s]];
    plate.velocity += sub_plates[s].area * speed_scale * sub_plates[s].velocity;
    plate.peaks.insert(plate.peaks.end(), g.peaks[s].begin(), g.peaks[s].end());
  }
  for (Plate& plate : result.plates) {
    std::sort(plate.peaks.begin(), plate.peaks.end());
    plate.peaks.erase(std::unique(plate.peaks.begin(), plate.peaks.end()), plate.peaks.end());
    if (plate.area <= 0.0) continue;
    plate.centroid /= plate.area;
    plate.velocity /= plate.area;
  }
  for (std::size_t i = 0; i < g.points.size(); ++i) {
    const VoronoiCell& cell = cells.voronoi[i];
    for (std::size_t k = 0; k < cell.polygon.size(); ++k) {
      const int j = cell.neighbours[k];
      if (j <= int(i)) continue;
      const int left = merged[g.sub_plate[i]], right = merged[g.sub_plate[j]];
      if (left != right)
        result.sides.push_back(
            {cell.polygon[k], cell.polygon[(k + 1) % cell.polygon.size()], left, right});
    }
  }
}

// The plate of each cell: that of the generator nearest to the bent place.
void paint(PlateMap& result, const std::vector<glm::dvec2>& points,
           const std::vector<int>& plate_of, const Grid& grid, const Context& context) {
  result.plate = Raster<std::int32_t>(grid, 0);
  if (result.plates.size() < 2) return;
  const double reach = kBendReach * result.bend.roughness;
  const int across = (grid.nx + kTile - 1) / kTile, up = (grid.ny + kTile - 1) / kTile;
  parallel_chunks(context, std::size_t(across) * up, 1, [&](std::size_t tile, std::size_t) {
    const int r0 = int(tile) / across * kTile, c0 = int(tile) % across * kTile;
    const int r1 = std::min(r0 + kTile, grid.ny), n = std::min(kTile, grid.nx - c0);
    const auto near = nearest_candidates(points, grid.center(r0, c0) - glm::dvec2(reach),
                                         grid.center(r1 - 1, c0 + n - 1) + glm::dvec2(reach));
    const bool whole = std::all_of(near.begin(), near.end(),
                                   [&](int i) { return plate_of[i] == plate_of[near.front()]; });
    double x[kTile], y[kTile];
    float dx[kTile] = {}, dy[kTile] = {};
    for (int r = r0; r < r1; ++r) {
      std::int32_t* out = result.plate.row(r) + c0;
      if (whole) {
        std::fill(out, out + n, plate_of[near.front()]);
        continue;
      }
      for (int i = 0; i < n; ++i) {
        const glm::dvec2 p = grid.center(r, c0 + i);
        x[i] = p.x, y[i] = p.y;
      }
      result.bend.displacements(x, y, dx, dy, n);
      for (int i = 0; i < n; ++i) {
        const glm::dvec2 p{x[i] + dx[i], y[i] + dy[i]};
        double best = 0.0;
        int nearest = -1;
        for (int id : near) {
          const glm::dvec2 d = points[id] - p;
          const double squared = d.x * d.x + d.y * d.y;
          if (nearest < 0 || squared < best) best = squared, nearest = id;
        }
        out[i] = plate_of[nearest];
      }
    }
  });
}

void check_motions(std::span<const PlateMotion> motions) {
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const PlateMotion& m = motions[i];
    if (!std::isfinite(m.position.x + m.position.y + m.velocity.x + m.velocity.y +
                       m.angular_velocity))
      throw InputError("motions[" + std::to_string(i) + "]: finite numbers are wanted");
  }
}

// The plate whose pieces hold the place; the nearest generator's where the place lies outside.
int plate_at(const std::vector<glm::dvec2>& points, const std::vector<int>& plate_of,
             glm::dvec2 place) {
  const auto near = nearest_candidates(points, place, place);
  return near.empty() ? 0 : plate_of[near.front()];
}

Raster<float> distance_to_peaks(const VectorMap& map, const Grid& grid, const Context& context) {
  std::vector<glm::dvec2> positions;
  for (const Peak& peak : map.peaks) positions.push_back(peak.position);
  if (positions.empty()) return Raster<float>(grid, float(grid.width() + grid.height()));
  return nearest_point(positions, grid, context).distance;
}

}  // namespace

void BoundaryBend::displacements(const double* x, const double* y, float* dx, float* dy,
                                 int n) const {
  FbmParameters noise{.seed = seed, .wavelength = wavelength, .octaves = 4, .gain = 0.4};
  fbm(noise, x, y, dx, n);
  noise.seed = seed ^ 0x5bd1e995u;
  fbm(noise, x, y, dy, n);
  const float scale = float(roughness), reach = float(kBendReach * roughness);
  for (int i = 0; i < n; ++i) {
    dx[i] = std::clamp(scale * dx[i], -reach, reach);
    dy[i] = std::clamp(scale * dy[i], -reach, reach);
  }
}

PlateMap infer_plates(const VectorMap& map, const Grid& grid, const PlateParameters& parameters,
                      std::uint32_t seed, const Context& context,
                      std::span<const PlateMotion> motions) {
  check_parameters(parameters, "plates");
  check_motions(motions);
  PlateMap result;
  result.plate_speed = parameters.plate_speed;
  result.bend = {seed, parameters.boundary_roughness, parameters.boundary_wavelength};
  Generators g = make_generators(map, parameters, result.volcanoes);
  if (g.points.empty()) {  // one plate at rest
    g.points.push_back(grid.origin + 0.5 * glm::dvec2(grid.width(), grid.height()));
    g.sub_plate.push_back(g.add_sub_plate({}));
  }
  Cells cells;
  const bool framed = map.frame.size.x > 0.0 && map.frame.size.y > 0.0;
  const glm::dvec2 corner = framed ? map.frame.origin : grid.origin;
  const glm::dvec2 size = framed ? map.frame.size : glm::dvec2(grid.width(), grid.height());
  cells.voronoi = voronoi_cells(g.points, corner, corner + size);
  for (const VoronoiCell& cell : cells.voronoi) {
    context.check();
    cells.area.push_back(ring_area(cell.polygon));
    cells.centroid.push_back(cell.polygon.empty() ? glm::dvec2(0.0) : ring_centroid(cell.polygon));
  }
  const auto sub_plates = make_sub_plates(g, cells);
  const double extent = std::hypot(size.x, size.y);
  const auto merged =
      merge_plates(sub_plates, adjacency(g, cells, 1e-9 * extent),
                   {.direction = parameters.merge_direction, .area = parameters.merge_area});
  double fastest = 0.0;
  for (const SubPlate& s : sub_plates)
    fastest = std::max(fastest, std::hypot(s.velocity.x, s.velocity.y));
  const bool moves = fastest > 1e-9 * extent;
  assemble(result, g, cells, sub_plates, merged, moves ? parameters.plate_speed / fastest : 0.0);
  std::vector<int> plate_of;
  for (int s : g.sub_plate) plate_of.push_back(merged[s]);
  for (const PlateMotion& motion : motions) {
    Plate& plate = result.plates[plate_at(g.points, plate_of, motion.position)];
    plate.velocity = motion.velocity;
    plate.angular_velocity = motion.angular_velocity;
  }
  paint(result, g.points, plate_of, grid, context);
  result.peak_distance = distance_to_peaks(map, grid, context);
  return result;
}

const StageInfo& plates_stage() {
  static const StageInfo info{"plates",
                              "Infers plates and their velocities from the map's peaks.",
                              "Michel, Emilien and Cani 2015, section 4 and section 7's limits",
                              {},
                              {"plate", "peak_distance"},
                              {"map"}};
  return info;
}

}  // namespace orogen
