#include "hydrology/river_beds.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/noise.h"
#include "inputs/map_rasters.h"

namespace orogen {

namespace {

constexpr double kStep = 60.0;                           // m between the points of a wandering bed
constexpr double kPeakClearance = 300.0, kYield = 90.0;  // m
constexpr double kFarOff = 1.01 * kPeakClearance;

constexpr double kLongPiece = 1500.0;  // m: rivers drawn in shorter pieces show their own bends

/// Mean length of the straight pieces of a map's rivers (m).
double mean_piece(const VectorMap& map) {
  double length = 0.0, pieces = 0.0;
  for (const River& river : map.rivers)
    for (std::size_t i = 1; i < river.points.size(); ++i, ++pieces)
      length += glm::distance(river.points[i - 1], river.points[i]);
  return length / std::max(pieces, 1.0);
}

// A displacement that depends on the place alone, so that confluences stay together.
class Wander {
 public:
  Wander(const VectorMap& map, double amplitude, double wavelength, std::uint32_t seed)
      : peaks_(map.peaks),
        amplitude_(amplitude * std::min(1.0, mean_piece(map) / kLongPiece)),
        east_({.seed = seed, .wavelength = wavelength, .octaves = 3}),
        north_({.seed = seed + 1, .wavelength = wavelength, .octaves = 3}) {}

  Polyline operator()(const Polyline& line) const {
    Polyline dense;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const glm::dvec2 a = line[i], d = line[i + 1] - a;
      const int pieces = std::max(1, int(std::ceil(std::hypot(d.x, d.y) / kStep)));
      for (int k = 0; k < pieces; ++k) dense.push_back(moved(a + d * (double(k) / pieces)));
    }
    if (!line.empty()) dense.push_back(moved(line.back()));
    return dense;
  }

 private:
  glm::dvec2 moved(glm::dvec2 p) const { return off_peaks(amplitude_ > 0.0 ? wandered(p) : p); }

  glm::dvec2 off_peaks(glm::dvec2 p) const {
    for (const Peak& peak : peaks_) {
      const glm::dvec2 d = p - peak.position;
      if (std::fabs(d.x) > kFarOff || std::fabs(d.y) > kFarOff) continue;
      const double r = std::hypot(d.x, d.y);
      if (r > 0.0 && r < kPeakClearance) p += d * (std::min(kYield, kPeakClearance - r) / r);
    }
    return p;
  }

  glm::dvec2 wandered(glm::dvec2 p) const {
    const auto part = [&](const Fbm& noise) {
      return amplitude_ * std::tanh(0.8 * double(noise(p.x, p.y)));
    };
    return p + glm::dvec2(part(east_), part(north_));
  }

  const std::vector<Peak>& peaks_;
  double amplitude_;
  Fbm east_, north_;
};

// Rivers that others join come before the rivers that join them.
std::vector<int> mouths_first(const VectorMap& map) {
  const int n = int(map.rivers.size());
  std::vector<int> depth(n, 0), order(n);
  for (int i = 0; i < n; ++i) {
    order[i] = i;
    for (int j = i; map.rivers[j].end == RiverEnd::River && depth[i] <= n; ++depth[i]) {
      const int next = map.rivers[j].joins;
      if (next < 0 || next >= n) break;
      j = next;
    }
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth[a] < depth[b]; });
  return order;
}

bool are_neighbours(const Grid& grid, std::int32_t a, std::int32_t b) {
  return std::abs(a / grid.nx - b / grid.nx) <= 1 && std::abs(a % grid.nx - b % grid.nx) <= 1;
}

double step_length(const Grid& grid, std::int32_t a, std::int32_t b) {
  const int rows = std::abs(a / grid.nx - b / grid.nx),
            columns = std::abs(a % grid.nx - b % grid.nx);
  return grid.cell_size * (rows && columns ? std::sqrt(2.0) : 1.0);
}

}  // namespace

RiverBeds lay_river_beds(const VectorMap& map, const Raster<std::uint8_t>& land, double wander,
                         double wander_wavelength, std::uint32_t seed) {
  const Grid& grid = land.grid();
  const Wander wandering(map, wander, wander_wavelength, seed);
  RiverBeds beds{Raster<std::int32_t>(grid), {}, {}, {}, wander, wander_wavelength, seed};
  for (const int index : mouths_first(map)) {
    const auto path = rasterise_line(grid, wandering(map.rivers[index].points));
    std::int32_t below = -1;
    for (auto it = path.rbegin(); it != path.rend(); ++it) {
      const auto cell = std::int32_t(*it);
      if (!land[cell]) {
        below = -1;  // what lies upstream of a stretch of sea has its mouth there
        continue;
      }
      if (below >= 0 && !are_neighbours(grid, cell, below)) below = -1;  // the line left the grid
      if (!beds.river[cell]) {
        beds.river[cell] = index + 1;
        beds.cells.push_back(cell);
        beds.receivers.push_back(below);
      }
      below = cell;
    }
  }
  Raster<float> length(grid);
  for (std::size_t i = beds.cells.size(); i-- > 0;) {
    const std::int32_t c = beds.cells[i], r = beds.receivers[i];
    if (r >= 0) length[r] = std::max(length[r], length[c] + float(step_length(grid, c, r)));
  }
  beds.source_length.reserve(beds.cells.size());
  for (const std::int32_t c : beds.cells) beds.source_length.push_back(length[c]);
  return beds;
}

std::vector<std::int32_t> forced_receivers(const RiverBeds& beds) {
  std::vector<std::int32_t> result(beds.river.size(), -1);
  for (std::size_t i = 0; i < beds.cells.size(); ++i) result[beds.cells[i]] = beds.receivers[i];
  return result;
}

}  // namespace orogen
