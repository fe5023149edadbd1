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
constexpr double kSpurSlope = 0.42, kFaceSlope = 0.78;
constexpr double kPyramidReach = 3500.0;  // m
constexpr double kGorgeSlope = 0.88, kBackSlope = 0.27, kBackWidth = 200.0;
constexpr double kBackSpread = 0.2;
constexpr double kCapFall = 0.06, kDeepestFall = 250.0;  // of held ground, 1, m
constexpr double kReachSpread = 0.3;
constexpr FbmParameters kRoughness{.seed = 13, .wavelength = 2500.0, .octaves = 2};  // m
constexpr double kTwistWavelength = 3000.0;                                          // m

/// Slope of a pyramid in the direction of `d` (m): spurs that wind, and faces between them.
double flank(const Summit& summit, glm::dvec2 d, double r) {
  static const Fbm twist({.seed = 12, .wavelength = kTwistWavelength, .octaves = 1});
  static const Fbm spurs({.seed = 11, .wavelength = 1.0, .octaves = 2});
  const glm::dvec2 place = summit.center + d;
  const double turn = 0.15 * twist(place.x, place.y) * std::min(1.0, r / kTwistWavelength);
  const glm::dvec2 turned(d.x * std::cos(turn) - d.y * std::sin(turn),
                          d.x * std::sin(turn) + d.y * std::cos(turn));
  const glm::dvec2 around = summit.center / 1e3 + turned / r;  // so that no two peaks look alike
  const double beside = spurs(around.x, around.y);
  return kSpurSlope + (kFaceSlope - kSpurSlope) * std::tanh(0.8 * beside * beside);
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
    for_disc(grid, at, (pyramids[cell] - floor) / (kGorgeSlope - kFaceSlope),
             [&](std::size_t i, double square) {
               least[i] = std::min(least[i], float(floor + kGorgeSlope * std::sqrt(square)));
             });
  }
}

/// Backs under the beds that come from above a pyramid.
void carry_springs(Raster<float>& least, const RiverBeds& beds, const Context& context) {
  const Grid& grid = least.grid();
  const Raster<float> rough = fbm(kRoughness, grid, context);
  const Raster<float> pyramids = least;
  std::vector<float> bed(pyramids.values().begin(), pyramids.values().end());
  for (std::size_t i = 0; i < beds.cells.size(); ++i) {  // from the mouths up
    const std::int32_t cell = beds.cells[i], below = beds.receivers[i];
    if (below >= 0) bed[cell] = std::max(bed[cell], bed[below]);
    if (bed[cell] <= pyramids[cell]) continue;
    context.check();
    const double height = bed[cell], flat = std::max(kBackWidth, 1.5 * grid.cell_size);
    for_disc(grid, grid.center(cell / grid.nx, cell % grid.nx),
             flat + height / (kBackSlope * (1.0 - kBackSpread)), [&](std::size_t k, double square) {
               const double beyond = std::max(0.0, std::sqrt(square) - flat);
               const double slope = kBackSlope * (1.0 + kBackSpread * std::tanh(rough[k]));
               least[k] = std::max(least[k], float(height - slope * beyond));
             });
  }
  for (std::size_t i = 0; i < beds.cells.size(); ++i)
    if (beds.receivers[i] >= 0)
      least[beds.cells[i]] = std::max(least[beds.cells[i]], least[beds.receivers[i]]);
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

Raster<float> summit_cap(const std::vector<Summit>& summits, const Grid& grid, double reach,
                         const Context& context) {
  if (summits.empty()) return Raster<float>(grid, INFINITY);
  const double highest = summits.front().height;
  Raster<float> cap(grid, float(highest));
  std::vector<glm::dvec2> places;
  for (const Summit& s : summits) places.push_back(s.center);
  const Raster<float> nearest = nearest_point(places, grid, context).distance;
  const Raster<float> rough = fbm(kRoughness, grid, context);
  for (const Summit& s : summits) {
    const double beyond =
        reach * (1.0 + kReachSpread) + (highest - s.height) / s.steepness + grid.cell_size;
    for_disc(grid, s.center, beyond, [&](std::size_t i, double square) {
      const double r = std::sqrt(square);
      const double share = 0.5 + 0.5 * std::tanh(rough[i]);  // so that held ground is no plateau
      const double away =
          std::max(0.5 * (r - nearest[i]), r - reach * (1.0 + kReachSpread * share));
      const double fall = kSummitFall * std::min(r, 2.0 * grid.cell_size) +
                          std::min(kCapFall * double(nearest[i]), kDeepestFall) * share;
      const double here = s.height - fall + s.steepness * std::max(0.0, away);
      cap[i] = std::min(cap[i], float(here));
    });
  }
  return cap;
}

}  // namespace orogen
