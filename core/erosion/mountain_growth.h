// Mountains that grow while rivers cut them: uplift and folds against stream power, with the rock
// that comes to light (paper C, section 6).
//
// On a TIN over the terrain's rectangle (or a grid in a TIN's clothes: see tin.h), for every step
// of dt years and every vertex:
//
//   rock at the surface     from the horizons h_k and the height z        (strata/horizons.h)
//   u, k, θ                 its rate of rise, erodibility and talus angle
//   dz/dt = u - k A^m s^n + G q / A    implicit, each vertex after its receiver
//                                                                         (tin_stream_power.h)
//   dz/dt = -l (s - tan θ)  landslides where s > tan θ                    (tin_hillslope.h)
//   creep                   if there is a diffusivity                     (tin_hillslope.h)
//   h_k += v_k dt           the horizons rise: v_0 = u_0, v_k = v_{k-1} + u_k
//   rebound                 h_k and z rise as what erosion took no longer weighs (isostasy.h)
//   z(p) <- z(p - v dt)     and h_k likewise, where a dipping fault carries rock sideways
//
// z (m), t (yr), A drainage area (m²), u_0 uplift rate of the crust and u_k that of the folds of
// layer k (m/yr). The motion may change from phase to phase; a step belongs to one phase.
// Coarse to fine: the first part of the time runs on meshes of 2, 4, ... times the spacing, so that
// valleys are where they will be when the finest mesh takes over for the last `fine_share`.
// Sides are open (base level, at height 0 until they sink), or closed: water then flows along them.
// Ground below 0 is sea: rivers end at its shore, and nothing wears it. So is a sea that is drawn,
// which stays at height 0 until it sinks.
//
// With G = 0 what rivers and landslides take is gone. With G > 0 rivers carry it, debris of
// landslides too, and lay it down in valleys, on fans and in lakes: loose sediment, whose thickness
// is kept at each vertex above the rock, and which is eroded first.
//
// Rock is carried sideways whenever it has moved by half an edge, by interpolation within triangles
// (which blurs by about half an edge each time). Results are carried to the grid the same way.
// Limits: no glaciers; nothing is laid down in the sea; sediment is as dense as rock, and its
// layers are not told apart.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "erosion/growth_watch.h"
#include "erosion/river_parameters.h"
#include "foundation/context.h"
#include "foundation/mass_balance.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "foundation/tin.h"
#include "strata/horizons.h"
#include "tectonics/isostasy.h"

namespace orogen {

enum class MapSide { Open, Closed };
inline constexpr std::string_view kMapSideNames[] = {"open", "closed"};

enum class GrowthMesh { Jittered, PoissonDisc, Grid };
inline constexpr std::string_view kGrowthMeshNames[] = {"jittered", "poisson_disc", "grid"};

struct MountainGrowthParameters {
  GrowthMesh mesh = GrowthMesh::Jittered;
  double vertices_per_cell = 1.0;
  int steps = 100;
  int coarse_levels = 3;
  double fine_share = 0.4;
  double area_exponent = 0.5;
  double slope_exponent = 1.0;
  double minimum_drainage_area = 1.8e5;  // m²
  double deposition_coefficient = 0.0;
  int deposition_iterations = 4;
  bool fill_lakes = true;
  double sediment_erodibility_factor = 1.0;
  double landslide_rate = 0.01;  // m/yr
  double diffusivity = 0.0;      // m²/yr
  double critical_slope = 0.0;
  double initial_relief = 20.0;  // m
  MapSide west_side = MapSide::Open, east_side = MapSide::Open;
  MapSide south_side = MapSide::Open, north_side = MapSide::Open;
  int frames = 0;
};

constexpr auto parameter_table(const MountainGrowthParameters*) {
  using P = MountainGrowthParameters;
  return std::tuple_cat(
      std::tuple{
          choice("mesh", &P::mesh, kGrowthMeshNames,
                 "Points of the mesh: a jittered lattice, random ones, or the cells of a grid."),
          real("vertices_per_cell", &P::vertices_per_cell, 0.01, 4.0, "",
               "Vertices of the finest mesh for each cell of the terrain."),
          integer("steps", &P::steps, 1, 10000, "", "Steps in time on the finest mesh."),
          integer("coarse_levels", &P::coarse_levels, 0, 8, "",
                  "Coarser meshes that the growth begins on."),
          real("fine_share", &P::fine_share, 0.01, 1.0, "",
               "Share of the time on the finest mesh, if there are coarser ones."),
      },
      incision_parameters<P>(), deposition_parameters<P>(),
      std::tuple{
          real("sediment_erodibility_factor", &P::sediment_erodibility_factor, 0.01, 100.0, "1",
               "Erodibility of sediment that rivers laid down, over that of the weakest rock."),
          real("landslide_rate", &P::landslide_rate, 0.0, 1e9, "m/yr",
               "Speed at which ground falls for each unit of slope above the talus slope."),
          real("diffusivity", &P::diffusivity, 0.0, 100.0, "m2/yr", "Diffusivity of soil creep."),
          real("critical_slope", &P::critical_slope, 0.0, 10.0, "1",
               "Slope at which creep runs away; 0 leaves creep linear."),
          real("initial_relief", &P::initial_relief, 0.0, 1e3, "m",
               "Depth of the hollows in the ground before it rises."),
          choice("west_side", &P::west_side, kMapSideNames, "Whether water leaves in the west."),
          choice("east_side", &P::east_side, kMapSideNames, "Whether water leaves in the east."),
          choice("south_side", &P::south_side, kMapSideNames, "Whether water leaves in the south."),
          choice("north_side", &P::north_side, kMapSideNames, "Whether water leaves in the north."),
          integer("frames", &P::frames, 0, 10000, "",
                  "Pictures of the growth to keep, in even steps of time; all on the finest mesh."),
      });
}

/// Uplift during one phase. Not owned; all on one grid.
struct UpliftPhase {
  double years = 5e6;
  const Raster<float>* crust = nullptr;       // u_0, m/yr
  std::vector<const Raster<float>*> folds;    // u_k of each layer, m/yr; nullptr: none
  const Raster<float>* velocity_x = nullptr;  // v, m/yr; nullptr: rock stays in its place
  const Raster<float>* velocity_y = nullptr;
};

/// What grows.
struct MountainGrowthInput {
  const HorizonStack& horizons;  // before the first phase
  const RockTable& rocks;
  std::vector<UpliftPhase> phases;
  const Raster<std::uint8_t>* sea = nullptr;          // not 0 where base level lies; nullptr: none
  const Raster<float>* rain = nullptr;                // 1: the mean; nullptr: everywhere
  const Raster<float>* uplift_factor = nullptr;       // of all rates; nullptr: 1
  const Raster<float>* erodibility_factor = nullptr;  // of rock; nullptr: 1
  IsostasyParameters isostasy{};
  GrowthWatch* watch = nullptr;  // nullptr: nobody looks on
};

/// Sediment at least this deep hides the rock below it.
inline constexpr float kHidingSediment = 1.0f;  // m

/// The mountains at one time, on the grid.
struct GrowthFrame {
  double years = 0.0;         // since the start
  Raster<float> elevation;    // m
  Raster<std::int32_t> rock;  // at the surface: RockTable::number
};

/// The last one is the end.
struct GrowthFrames {
  std::vector<GrowthFrame> frames;
};

/// The finest mesh at the end.
struct GrownTin : Tin {
  std::vector<double> elevation;           // m, of each vertex
  std::vector<double> sediment_thickness;  // m, that rivers laid down; empty: none
};

struct MountainGrowth {
  Raster<float> elevation;           // m
  Raster<float> uplift_rate;         // m/yr, of the rock at the surface in the last phase
  Raster<float> drainage_area;       // m²
  Raster<float> exhumation;          // m, of rock
  Raster<float> sediment_thickness;  // m
  HorizonStack horizons;
  std::vector<GrowthFrame> frames;  // the last one is the end
  double years = 0.0;
  GrownTin tin;
  MassBalance balance;  // of the steps on the finest mesh
};

/// InputError for a parameter out of range, no phase, rain or sea on another grid, or no way out
/// for water.
MountainGrowth grow_mountains(const MountainGrowthInput& input,
                              const MountainGrowthParameters& parameters, std::uint32_t seed,
                              Context& context);

const StageInfo& mountain_growth_stage();

}  // namespace orogen
