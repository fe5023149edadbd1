#include "sculpting/summits.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/disc.h"
#include "foundation/distance_transform.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr double kCapSteepness = 0.3;  // of the cap beyond a peak's own reach
constexpr double kSummitFall = 0.02;   // least mean slope from a peak to its neighbours
constexpr double kFlank = 0.45, kSpurs = 0.35;
constexpr double kPyramidReach = 3500.0;                                     // m
constexpr double kGorgeSlope = 0.85, kBackSlope = 0.28, kBackWidth = 300.0;  // m
constexpr double kGully = 0.22, kGullyDepth = 200.0;                         // 1, m
constexpr std::size_t kGrain = 65536;
constexpr FbmParameters kSpurNoise{.seed = 11, .wavelength = 1.0, .octaves = 2};

/// Slope of a pyramid in the direction of `d` (m).
double flank(const Summit& summit, glm::dvec2 d, double r) {
  const glm::dvec2 around = summit.center / 1e3 + d / r;  // so that no two peaks look alike
  return kFlank * (1.0 + kSpurs * std::tanh(double(fbm(kSpurNoise, around.x, around.y))));
}

/// A river that passes a peak has a gorge there: pyramids are cut back along beds.
void cut_gorges(Raster<float>& least, const std::vector<Summit>& summits, const RiverBeds& beds,
                const Context& context) {
  const Grid& grid = least.grid();
  const Raster<float> pyramids = least;
  for (const std::int32_t cell : beds.cells) {
    if (pyramids[cell] <= 0.0f) continue;
    context.check();
    const glm::dvec2 at = grid.center(cell / grid.nx, cell % grid.nx);
    double floor = 0.0;
    for (const Summit& s : summits)
      floor = std::max(floor, s.height - kGorgeSlope * glm::distance(at, s.center));
    for_disc(grid, at, (pyramids[cell] - floor) / (kGorgeSlope - kFlank),
             [&](std::size_t i, double square) {
               least[i] = std::min(least[i], float(floor + kGorgeSlope * std::sqrt(square)));
             });
  }
}

/// Backs under the beds that come from above a pyramid.
void carry_springs(Raster<float>& least, const RiverBeds& beds, const Context& context) {
  const Grid& grid = least.grid();
  const Raster<float> pyramids = least;
  std::vector<float> bed(pyramids.values().begin(), pyramids.values().end());
  for (std::size_t i = 0; i < beds.cells.size(); ++i) {  // from the mouths up
    const std::int32_t cell = beds.cells[i], below = beds.receivers[i];
    if (below >= 0) bed[cell] = std::max(bed[cell], bed[below]);
    if (bed[cell] <= pyramids[cell]) continue;
    context.check();
    const double height = bed[cell], flat = std::max(kBackWidth, 1.5 * grid.cell_size);
    for_disc(grid, grid.center(cell / grid.nx, cell % grid.nx), flat + height / kBackSlope,
             [&](std::size_t k, double square) {
               const double beyond = std::max(0.0, std::sqrt(square) - flat);
               least[k] = std::max(least[k], float(height - kBackSlope * beyond));
             });
  }
}

}  // namespace

std::vector<Summit> collect_summits(const VectorMap& map, const Raster<std::uint8_t>& land) {
  const Grid& grid = land.grid();
  std::vector<Summit> all;
  for (const Peak& peak : map.peaks) {
    const int r = grid.row_of(peak.position.y), c = grid.column_of(peak.position.x);
    if (!peak.height_m || !grid.contains(r, c) || !land(r, c)) continue;
    all.push_back(
        {grid.center(r, c), std::int32_t(grid.index(r, c)), *peak.height_m, kCapSteepness});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Summit& a, const Summit& b) { return a.height > b.height; });
  std::vector<Summit> kept;
  for (Summit& s : all) {
    bool shared = false;
    for (const Summit& higher : kept) {
      const glm::dvec2 d = higher.center - s.center;
      shared |= higher.cell == s.cell;
      const double distance = std::max(std::hypot(d.x, d.y), grid.cell_size);
      s.steepness = std::max(s.steepness, 2.1 * (higher.height - s.height) / distance);
    }
    if (!shared) kept.push_back(s);
  }
  return kept;
}

Raster<float> summit_pyramids(const std::vector<Summit>& summits, const RiverBeds& beds,
                              const Context& context) {
  const Grid& grid = beds.river.grid();
  Raster<float> least(grid);
  for (const Summit& s : summits)
    for_disc(grid, s.center, kPyramidReach, [&](std::size_t i, double square) {
      const double r = std::sqrt(square), far = square / (kPyramidReach * kPyramidReach);
      const glm::dvec2 d = grid.center(int(i) / grid.nx, int(i) % grid.nx) - s.center;
      const double height = r > 0.0 ? s.height * (1.0 - far * far) - flank(s, d, r) * r : s.height;
      least[i] = std::max(least[i], float(height));
    });
  cut_gorges(least, summits, beds, context);
  carry_springs(least, beds, context);
  return least;
}

void cut_gullies(Raster<float>& pyramids, const std::vector<double>& drainage_area,
                 const RiverBeds& beds, const Context& context) {
  const double cell = pyramids.grid().cell_size;
  parallel_chunks(context, pyramids.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (pyramids[i] <= 0.0f || beds.river[i]) continue;
      const double length = std::sqrt(drainage_area[i]) - 2.0 * cell;  // none on the first slopes
      const double depth = std::clamp(kGully * length, 0.0, kGullyDepth);
      pyramids[i] = std::max(0.0f, pyramids[i] - float(depth));
    }
  });
}

Raster<float> summit_cap(const std::vector<Summit>& summits, const Grid& grid, double reach,
                         const Context& context) {
  if (summits.empty()) return Raster<float>(grid, INFINITY);
  const double highest = summits.front().height;
  Raster<float> cap(grid, float(highest));
  std::vector<glm::dvec2> places;
  for (const Summit& s : summits) places.push_back(s.center);
  const Raster<float> nearest = nearest_point(places, grid, context).distance;
  for (const Summit& s : summits) {
    const double beyond = reach + (highest - s.height) / s.steepness + grid.cell_size;
    for_disc(grid, s.center, beyond, [&](std::size_t i, double square) {
      const double r = std::sqrt(square);
      const double away = std::max(0.5 * (r - nearest[i]), r - reach);
      const double here = s.height - kSummitFall * std::min(r, 2.0 * grid.cell_size) +
                          s.steepness * std::max(0.0, away);
      cap[i] = std::min(cap[i], float(here));
    });
  }
  return cap;
}

}  // namespace orogen
