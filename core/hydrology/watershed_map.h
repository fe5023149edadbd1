// The watershed map (paper A, section 6): heights along rivers from their mouths up, and
// hillslopes.
//
// Along a river, from its mouth (sea 0; the lake's level; end_height_m at the frame; the height of
// the river it joins) upstream:
//
//   dz/dx = river_slope N(d)             N(d) = 1 + peak_steepening / (1 + (d / peak_reach)²)²
//
// d: distance to the nearest peak. Where a river so reaches above `source_share` of the height of
// the peaks around its source, its rise is scaled down. Elsewhere the lower envelope
//
//   g(p) = min over river, lake and coast cells s of  h(s) + hill_slope W(|p − s|) mean N on [s, p]
//   W(r) = r² / (r + floor_width)        (a valley floor or coastal plain, then straight slopes)
//
// found by passing each cell's source to its neighbours in sweeps (O(cells)); the mean of N is
// Simpson's on the straight line. A river bed that the envelope undercuts is lowered, and what lies
// below it in proportion, so that it falls along its whole course and g equals the bed there. Every
// land cell has a lower neighbour among its eight, or is a lake, or the end of a river at the
// frame.
//
// Limits: the envelope is that of straight lines, as exact as lower_envelope.h says; without
// sea, rivers and lakes the land cells on the grid's border lie at 0.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "hydrology/river_beds.h"
#include "inputs/vector_map.h"

namespace orogen {

struct WatershedParameters {
  double river_slope = 0.008;
  double hill_slope = 0.12;
  double peak_steepening = 4.0;
  double peak_reach = 10e3;    // m
  double floor_width = 500.0;  // m
  double source_share = 0.7;
  double default_peak_height = 1000.0;  // m
};

constexpr auto parameter_table(const WatershedParameters*) {
  using P = WatershedParameters;
  return std::tuple{
      real("river_slope", &P::river_slope, 1e-5, 0.5, "", "Slope of rivers far from any peak."),
      real("hill_slope", &P::hill_slope, 1e-4, 2.0, "", "Slope of hillsides far from any peak."),
      real("peak_steepening", &P::peak_steepening, 0.0, 50.0, "",
           "How much steeper slopes are at a peak than far from it."),
      real("peak_reach", &P::peak_reach, 100.0, 500e3, "m",
           "Distance from a peak at which that steepening has faded to a quarter."),
      real("floor_width", &P::floor_width, 0.0, 20e3, "m",
           "Width over which valley floors and coastal plains steepen into hillsides."),
      real("source_share", &P::source_share, 0.05, 1.0, "",
           "Highest a river may rise, over the height of the peaks around its source."),
      real("default_peak_height", &P::default_peak_height, 1.0, 12e3, "m",
           "Height of peaks for which the map gives none."),
  };
}

struct WatershedMap {
  Raster<float> elevation;          // watershed_elevation, m; 0 at sea
  Raster<float> river_distance;     // m, to the nearest river, lake or coast
  Raster<std::int32_t> river_cell;  // that river, lake or coast cell, by index
  std::vector<float> bed_height;    // m, for each of the beds' cells
};

/// `beds`: the map's rivers on the grid of `land` (1 on land); `peak_distance` in metres.
WatershedMap watershed_map(const VectorMap& map, const RiverBeds& beds,
                           const Raster<std::uint8_t>& land, const Raster<float>& peak_distance,
                           const WatershedParameters& parameters, const Context& context);

const StageInfo& watershed_stage();

}  // namespace orogen
