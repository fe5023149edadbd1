// Mountains grown by uplift against stream power, so that they follow a vector map.
//
// The aim h is the regional height that the map tells (hydrology/regional_height.h), shaped by the
// folds, rifts and cones of paper A's combined relief c (by at most 30%):
//
//   h = regional height · (1 + 0.3 tanh((G_σ/2 c − G_3σ c) / G_3σ c))
//
// Uplift is fitted until the landscape that stream power makes of it follows h at large:
//
//   0 = U_i − k A^m |∇z_i|          steady state (erosion/stream_power.h), n = 1
//   U_{i+1} = U_i · [ (G_σ h + ε) / (G_σ z_i + ε) ]^γ
//                 · Π_p [ H_p / max of z_i around p ]^(γ₁ exp(−|x − p|² / 2 r²))
//                       [ 0.83 H_p / mean of z_i around p ]^(γ₂ exp(−|x − p|² / 2 r₂²))
//                 · exp(−γ₃ G ([z_i is held down] − [z_i is held up]))
//         ≤ 1.3 k₀ tan(talus angle) A₀^m       there hillslopes stand at the talus angle already
//
// h counts up to 0.83 of the greatest height that the peaks allow. G_σ: Gaussian blur over land
// alone, σ = `fit_radius`; H_p: height of peak p, compared with the highest ground that is nearer
// to p than to other peaks and within `peak_reach`, and with the mean of its massif (2 km: real
// ranges are some 17% lower there). Ground is held between the least and the greatest heights that
// the peaks ask for (sculpting/summits.h), and nowhere steeper than the talus angle, across divides
// too (slope_limit.h). The talus slope goes with the rock's strength, (k / k₀)^-0.6 without the
// folds and within 40%. At the end soil creep over `creep_length` (or 0.35 cells) rounds crests.
//
// Coarse to fine: levels of `coarsest_cells`, twice that, ... along the longer side, then the grid
// asked for, so that valleys integrate over the whole land first, and alike at every resolution.
// Rock varies: k = k₀ exp(s n(x) − s²/2 − h f(x)), n fBm, f the folds of the combined relief
// between some 300 m and 3.5 km of width over their own deviation around: crests bring hard rock to
// light, so that ridges and valleys follow the folds. U varies likewise with its own noise. Slopes
// are capped at the talus angle. Ranges and plains differ in where channels begin: k works on A +
// A₀(x), log A₀ between `hillslope_area` in ranges and `plain_area` in plains, by the ruggedness
//
//   R(x) = max over peaks p of  min(1, (H_p − G_2σ h)⁺ / min(`range_relief`, 0.3 H_p)) e^(−r_p /
//   `range_reach`)
//
// so that plains are smooth fans that carry their rivers at a degree or less, and ranges stand on
// them, cut into spurs.
// Drawn rivers (hydrology/river_beds.h) are receivers that water must follow; a bed has at least
// the drainage area that Hack's law (L = 1.4 A^0.6, km) gives its length, times `bed_area_factor`:
// so its valley lies lower than the land around and gathers its water. At the coarsest level land
// beside a bed drains to it. A bed that would hang above the ground beside its own upper course
// gets more, so that it cuts down; where a valley beside would undercut it, a spur carries it past.
// The sea is base level 0; a river's end at the frame has its own height. Sides that cut the land
// let no water through elsewhere.
//
// Limits: the result is a steady state: no relict surfaces. Where h asks for heights that its
// slopes do not allow under the talus angle, the land stays lower.
#pragma once

#include <cstdint>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "hydrology/river_beds.h"
#include "inputs/vector_map.h"

namespace orogen {

struct ReliefGrowthParameters {
  int coarsest_cells = 256;
  int coarse_steps = 30;
  int middle_steps = 12;
  int finest_steps = 12;
  double fit_radius = 4000.0;
  double peak_reach = 4000.0;
  double fit_rate = 0.8;
  double area_exponent = 0.43;
  double erodibility = 2e-7;
  double erodibility_variation = 0.2;
  double rock_roughness = 0.8;
  double rock_wavelength = 6000.0;
  double fold_hardness = 1.1;
  double uplift_variation = 0.2;
  double uplift_wavelength = 9000.0;
  double hillslope_area = 0.5e6;
  double plain_area = 3e6;
  double range_relief = 350.0;
  double range_reach = 12000.0;
  double talus_angle_deg = 34.0;
  double bed_area_factor = 2.0;
  double creep_length = 35.0;
};

constexpr auto parameter_table(const ReliefGrowthParameters*) {
  using P = ReliefGrowthParameters;
  return std::tuple{
      integer("coarsest_cells", &P::coarsest_cells, 32, 2048, "",
              "Cells along the longer side at the coarsest level."),
      integer("coarse_steps", &P::coarse_steps, 1, 1000, "", "Steps at the coarsest level."),
      integer("middle_steps", &P::middle_steps, 1, 1000, "",
              "Steps at each level between the coarsest and the finest."),
      integer("finest_steps", &P::finest_steps, 1, 1000, "", "Steps at the finest level."),
      real("fit_radius", &P::fit_radius, 100.0, 100e3, "m",
           "Width over which the heights of land are fitted to the combined relief."),
      real("peak_reach", &P::peak_reach, 100.0, 50e3, "m",
           "Distance around a peak in which the highest ground is fitted to the peak's height."),
      real("fit_rate", &P::fit_rate, 0.0, 1.5, "", "How fast uplift follows what is amiss."),
      real("area_exponent", &P::area_exponent, 0.2, 1.0, "", "Exponent m of drainage area."),
      real("erodibility", &P::erodibility, 1e-9, 1e-2, "m^(1-2m)/yr",
           "Mean erodibility k; it scales uplift rates, not heights."),
      real("erodibility_variation", &P::erodibility_variation, 0.0, 2.5, "",
           "Standard deviation of the logarithm of erodibility."),
      real("rock_roughness", &P::rock_roughness, 0.0, 1.0, "",
           "Amplitude of each octave of erodibility's noise over the one before."),
      real("rock_wavelength", &P::rock_wavelength, 100.0, 200e3, "m",
           "Wavelength of the widest variations of erodibility."),
      real("fold_hardness", &P::fold_hardness, 0.0, 2.5, "",
           "Standard deviation of the logarithm of erodibility from the folds' crests to troughs."),
      real("uplift_variation", &P::uplift_variation, 0.0, 2.5, "",
           "Standard deviation of the logarithm of uplift beside its fit."),
      real("uplift_wavelength", &P::uplift_wavelength, 100.0, 500e3, "m",
           "Wavelength of the widest variations of uplift."),
      real("hillslope_area", &P::hillslope_area, 0.0, 1e8, "m2",
           "Drainage area below which ground is hillslope rather than channel, in ranges."),
      real("plain_area", &P::plain_area, 0.0, 1e10, "m2", "The same in plains."),
      real("range_relief", &P::range_relief, 1.0, 5e3, "m",
           "Height of a peak above the land around that makes a range."),
      real("range_reach", &P::range_reach, 100.0, 200e3, "m",
           "Distance from a peak over which its range turns into plain."),
      real("talus_angle_deg", &P::talus_angle_deg, 5.0, 80.0, "deg", "Steepest slope of rock."),
      real("bed_area_factor", &P::bed_area_factor, 0.0, 100.0, "",
           "Least drainage area of a drawn river's bed, over what Hack's law gives its length."),
      real("creep_length", &P::creep_length, 0.0, 2e3, "m",
           "Length over which soil creep rounds crests and hollows."),
  };
}

inline const StageInfo& relief_growth_stage() {
  static const StageInfo info{
      "relief_growth",
      "Grows mountains by uplift against stream power until they follow the map at large.",
      "Paper C, eq. 5; Braun and Willett 2013; paper A's combined relief as the aim",
      {"combined_relief", "land", "river"},
      {"elevation", "uplift_rate", "erodibility", "drainage_area"},
      {"map", "rasters.uplift_factor", "rasters.erodibility_factor"}};
  return info;
}

struct ReliefGrowth {
  Raster<float> elevation;      // m; 0 at sea
  Raster<float> uplift_rate;    // m/yr
  Raster<float> erodibility;    // m^(1-2m)/yr
  Raster<float> drainage_area;  // m²
};

/// What h and k are multiplied by, on the grid of the land; nullptr: 1.
struct ReliefGrowthFactors {
  const Raster<float>* aim = nullptr;
  const Raster<float>* erodibility = nullptr;
};

/// `combined_relief` in metres, `land` (1 on land) and `beds` lie on one grid.
ReliefGrowth grow_relief(const VectorMap& map, const Raster<float>& combined_relief,
                         const Raster<std::uint8_t>& land, const RiverBeds& beds,
                         const ReliefGrowthParameters& parameters, std::uint32_t seed,
                         Context& context, const ReliefGrowthFactors& factors = {});

}  // namespace orogen
