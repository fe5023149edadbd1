// Plates inferred from the peaks of a map (paper A, section 4).
//
// Sub-plates are the Voronoi cells of the peaks, clipped to the map's frame (the grid, if the map
// has none), so that plates do not depend on the resolution. Each moves from its centroid c towards
// its peak p:
//
//   u = p − c                     (m; towards packed peaks)
//   v = plate_speed u / max |u|   (m/yr, over all sub-plates)
//
// and sub-plates that move alike merge (plate_merging.h). Against two limits that the paper states:
// - a single line of peaks (peak_chains.h) gives one boundary along it: the cells are those of
//   points set close to both sides of the line, and each side is one sub-plate;
// - an isolated peak makes no sub-plate: it is a volcano within a plate (unless the map says of a
//   peak whether it is one).
//
// The raster `plate` is bent by noise (fBm, in metres) so that no straight side shows; the polygons
// are not. T1 = 0.4 and T2 = 0.1 give 4 or 5 plates on Corsica's map and on Sierra Nevada's, 3 on
// Cyprus', with most high peaks within 8 km of a convergent boundary; T2 = 0.2 leaves Sierra Nevada
// a single plate.
//
// Limits: velocities are a reading of the map, not of the Earth; two peaks make two cells unless
// `chain_minimum_peaks` is 2; no peak, or only isolated ones, gives one plate at rest.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "inputs/vector_map.h"

namespace orogen {

struct PlateParameters {
  double merge_direction = 0.4;
  double merge_area = 0.1;
  double plate_speed = 0.02;  // m/yr
  bool line_boundaries = true;
  int chain_minimum_peaks = 3;
  bool volcanoes = true;
  double isolation_factor = 3.5;
  double boundary_roughness = 2000.0;  // m
  double boundary_wavelength = 15e3;   // m
};

constexpr auto parameter_table(const PlateParameters*) {
  using P = PlateParameters;
  return std::tuple{
      real("merge_direction", &P::merge_direction, 0.0, 1.0, "",
           "Neighbouring plates merge if the cosine between their velocities exceeds this (T1)."),
      real("merge_area", &P::merge_area, 0.0, 1.0, "",
           "A plate smaller than this share of its largest neighbour merges with it (T2)."),
      real("plate_speed", &P::plate_speed, 1e-4, 0.3, "m/yr", "Speed of the fastest sub-plate."),
      boolean("line_boundaries", &P::line_boundaries,
              "A single line of peaks gives one plate boundary along it."),
      integer("chain_minimum_peaks", &P::chain_minimum_peaks, 2, 100, "",
              "Fewest peaks that make a line."),
      boolean("volcanoes", &P::volcanoes,
              "Isolated peaks of which the map does not say otherwise are volcanoes and make no "
              "plates."),
      real("isolation_factor", &P::isolation_factor, 1.5, 100.0, "",
           "A peak is isolated if its nearest neighbour is this many times farther than the map's "
           "median."),
      real("boundary_roughness", &P::boundary_roughness, 0.0, 20e3, "m",
           "How far noise bends plate boundaries aside (standard deviation)."),
      real("boundary_wavelength", &P::boundary_wavelength, 1e3, 200e3, "m",
           "Wavelength of the widest bends of plate boundaries."),
  };
}

/// A velocity that the user sets for the plate at `position`.
struct PlateMotion {
  glm::dvec2 position{0.0, 0.0};  // m
  glm::dvec2 velocity{0.0, 0.0};  // m/yr, at the plate's centroid
  double angular_velocity = 0.0;  // rad/yr, anticlockwise about the centroid
};

struct Plate {
  std::vector<Ring> pieces;       // the merged Voronoi cells, anticlockwise
  double area = 0.0;              // m²
  glm::dvec2 centroid{0.0, 0.0};  // m
  glm::dvec2 velocity{0.0, 0.0};  // m/yr
  double angular_velocity = 0.0;  // rad/yr
  std::vector<int> peaks;         // of the map; those of a line are named by both its sides

  glm::dvec2 velocity_at(glm::dvec2 p) const {
    return velocity + angular_velocity * glm::dvec2(centroid.y - p.y, p.x - centroid.x);
  }
};

/// A straight stretch between two plates; `left` lies to the left on the way from a to b.
struct PlateSide {
  glm::dvec2 a{0.0, 0.0}, b{0.0, 0.0};  // m
  int left = -1, right = -1;
};

/// Displacement (m) that bends the straight sides: a cell at p lies on the plate of p + bend(p).
struct BoundaryBend {
  std::uint32_t seed = 0;
  double roughness = 0.0, wavelength = 1.0;  // m
  void displacements(const double* x, const double* y, float* dx, float* dy, int n) const;
};

struct PlateMap {
  std::vector<Plate> plates;
  std::vector<PlateSide> sides;
  std::vector<int> volcanoes;  // peaks that are volcanoes, by number
  double plate_speed = 0.0;    // m/yr, of the parameters: what relative velocities are held against
  BoundaryBend bend;
  Raster<std::int32_t> plate;
  Raster<float> peak_distance;  // m; the grid's width + height where the map has no peak
};

PlateMap infer_plates(const VectorMap& map, const Grid& grid, const PlateParameters& parameters,
                      std::uint32_t seed, const Context& context,
                      std::span<const PlateMotion> motions = {});

const StageInfo& plates_stage();

}  // namespace orogen
