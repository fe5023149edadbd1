#include "sculpting/map_law.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "foundation/disc.h"
#include "foundation/distance_transform.h"
#include "foundation/parallel.h"
#include "hydrology/base_level.h"
#include "hydrology/depressions.h"
#include "hydrology/drainage.h"
#include "hydrology/flow_graph.h"

namespace orogen {

namespace {

constexpr int kSweeps = 30;
constexpr double kMetWithin = 0.02;    // m
constexpr double kCapSteepness = 0.3;  // of the cap beyond a peak's own reach
constexpr double kCapSoftness = 0.06;  // share of a peak's height over which heights are pressed
constexpr double kSummitFall = 0.02;   // least mean slope from a peak to its neighbours

struct Summit {
  glm::dvec2 center;  // m, of the peak's cell
  std::int32_t cell;
  double height;     // m
  double steepness;  // of its cap towards higher peaks
};

std::vector<Summit> collect_summits(const VectorMap& map, const Raster<std::uint8_t>& land) {
  const Grid& grid = land.grid();
  std::vector<Summit> summits;
  for (const Peak& peak : map.peaks) {
    const int r = grid.row_of(peak.position.y), c = grid.column_of(peak.position.x);
    if (!peak.height_m || !grid.contains(r, c) || !land(r, c)) continue;
    summits.push_back(
        {grid.center(r, c), std::int32_t(grid.index(r, c)), *peak.height_m, kCapSteepness});
  }
  std::stable_sort(summits.begin(), summits.end(),
                   [](const Summit& a, const Summit& b) { return a.height > b.height; });
  std::vector<Summit> kept;
  for (const Summit& summit : summits) {
    Summit s = summit;
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

/// Heights above the cap are pressed below it: identity up to cap - k, then towards the cap.
float press(float z, float cap, float k) {
  const float start = cap - k;
  return z <= start ? z : start + k * (1.0f - std::exp(-(z - start) / k));
}

void press_unnamed_summits(Raster<float>& elevation, const Raster<std::uint8_t>& land,
                           const std::vector<Summit>& summits, const MapLawParameters& p,
                           const Context& context) {
  const Grid& grid = elevation.grid();
  if (summits.empty()) return;
  const double highest = summits.front().height;  // nothing on the map stands above it
  Raster<float> cap(grid, float(highest)), softness(grid, float(kCapSoftness * highest));
  std::vector<glm::dvec2> places;
  for (const Summit& s : summits) places.push_back(s.center);
  const Raster<float> nearest = nearest_point(places, grid, context).distance;
  for (const Summit& s : summits) {
    const double beyond = p.summit_reach + (highest - s.height) / s.steepness + grid.cell_size;
    for_disc(grid, s.center, beyond, [&](std::size_t i, double square) {
      const double r = std::sqrt(square);
      const double away = std::max(0.5 * (r - nearest[i]), r - p.summit_reach);
      const double here = s.height - kSummitFall * std::min(r, 2.0 * grid.cell_size) +
                          s.steepness * std::max(0.0, away);
      if (here >= cap[i]) return;
      cap[i] = float(here);
      softness[i] = float(std::max(kCapSoftness * s.height, 1.0));
    });
  }
  for (std::size_t i = 0; i < cap.size(); ++i)
    if (land[i])
      elevation[i] = std::max(float(p.least_height), press(elevation[i], cap[i], softness[i]));
}

double wendland(double t) {
  const double u = 1.0 - t, u2 = u * u;
  return t >= 1.0 ? 0.0 : u2 * u2 * (4.0 * t + 1.0);
}

/// Adds to the ground around a peak what its cell lacks; valleys keep their floor.
void correct_peak(Raster<float>& elevation, const Raster<std::uint8_t>& land, const Summit& summit,
                  double radius, double least_height) {
  const Grid& grid = elevation.grid();
  const double here = elevation[summit.cell], lack = summit.height - here;
  float floor = elevation[summit.cell];
  for_disc(grid, summit.center, radius, [&](std::size_t i, double) {
    if (land[i]) floor = std::min(floor, elevation[i]);
  });
  const double rise = std::max(here - floor, 1e-3);
  for_disc(grid, summit.center, radius, [&](std::size_t i, double square) {
    if (!land[i]) return;
    const double level = std::clamp((elevation[i] - floor) / rise, 0.0, 1.0);
    const double weight = std::int32_t(i) == summit.cell ? 1.0 : level * (2.0 - level);
    const double z = elevation[i] + lack * weight * wendland(std::sqrt(square) / radius);
    elevation[i] = float(std::max(least_height, z));
  });
}

void meet_peaks(Raster<float>& elevation, const Raster<std::uint8_t>& land,
                const std::vector<Summit>& summits, const MapLawParameters& p,
                const Context& context) {
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double worst = 0.0;
    for (const Summit& s : summits) {
      context.check();
      const double lack = std::abs(s.height - elevation[s.cell]);
      worst = std::max(worst, lack);
      if (lack < kMetWithin) continue;
      correct_peak(elevation, land, s,
                   std::max(p.correction_radius, 1.5 * lack / p.correction_slope), p.least_height);
    }
    if (worst < kMetWithin) return;
  }
}

/// The last word: no neighbour of a peak's cell stands as high as the peak.
void crown_summits(Raster<float>& elevation, const Raster<std::uint8_t>& land,
                   const std::vector<Summit>& summits) {
  const Grid& grid = elevation.grid();
  for (auto it = summits.rbegin(); it != summits.rend(); ++it) {  // higher peaks last
    const Summit& s = *it;
    elevation[s.cell] = float(s.height);
    for_disc(grid, s.center, 2.0 * grid.cell_size, [&](std::size_t i, double square) {
      if (!land[i] || std::int32_t(i) == s.cell) return;
      const double fall = kSummitFall * std::min(std::sqrt(square), 2.0 * grid.cell_size);
      elevation[i] = std::min(elevation[i], float(s.height - fall));
    });
  }
}

}  // namespace

MapLawResult enforce_map(Raster<float>& elevation, const VectorMap& map,
                         const Raster<std::uint8_t>& land, const RiverBeds& beds,
                         const MapLawParameters& parameters, Context& context) {
  check_parameters(parameters);
  if (elevation.grid() != land.grid())
    throw InputError("land: must lie on the same grid as the elevation");
  const BaseLevel base = base_level(map, land, beds);
  for (std::size_t i = 0; i < elevation.size(); ++i)
    elevation[i] =
        base.cells[i] ? base.height[i] : std::max(elevation[i], float(parameters.least_height));
  const auto summits = collect_summits(map, land);
  context.report(0.2);
  for (int round = 0; round < 2; ++round) {
    press_unnamed_summits(elevation, land, summits, parameters, context);
    meet_peaks(elevation, land, summits, parameters, context);
  }
  press_unnamed_summits(elevation, land, summits, parameters, context);
  crown_summits(elevation, land, summits);
  context.report(0.5);

  Raster<std::uint8_t> keep(elevation.grid());
  for (const Summit& s : summits) keep[s.cell] = 1;
  std::vector<std::int32_t> receivers = forced_receivers(beds);
  for (const Summit& s : summits) receivers[s.cell] = -1;  // a spring yields to its peak
  FlowGraph flow(base.cells);
  flow.force_receivers(receivers);
  flow.route(elevation, context);
  context.report(0.8);
  const CarveResult carved = carve_to_drain(elevation, flow, parameters.least_fall, context, &keep);

  MapLawResult result;
  result.drainage_area = drainage_area(flow, context);
  result.deepest_cut_m = carved.deepest_cut_m;
  for (const Summit& s : summits) {
    const double error = std::abs(elevation[s.cell] - s.height);
    result.largest_peak_error_m = std::max(result.largest_peak_error_m, error);
    result.peaks_met += error < 1.0;
  }
  return result;
}

}  // namespace orogen
