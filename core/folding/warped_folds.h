// Relief of folds by noise warped along plate velocities (paper A, section 5, "Noise warping").
//
//   n(p) = fBm(p − τ V(p))                        τ = folding_time, V the smoothed velocity
//   f(p) = E(p) k(p) (plain + (1 − plain) (C(p) + (1 − C(p)) M(p)) q(n(p))) + rifts, volcanoes
//   q(n) = (t + sqrt(t² + 0.1)) / (2 (1 + s)), t = 1 + s n       s = fold_strength
//
// E: height of the peaks around (mean by 1 / (d² + e²)², e = peak_reach / 4)
// k = 1 / (1 + (d / peak_reach)²), d the distance to the nearest peak
// C: smoothstep of convergence from 0.15 to 0.75: folds only where plates converge, fading along
// and
//    away from the boundary
// M = 1 / (1 + (d / massif_radius)²)²: rough but unfolded ground close to peaks elsewhere
// In k and M, d is stretched and squeezed by noise (up to 0.4), so that no rings stand around
// peaks.
//
// The noise function is sampled at the warped place: nothing is blurred by resampling. The paper
// warps by p + V. Across a convergent boundary that stretches the noise unless the jump of τV
// exceeds 2.5 times the blur σ; p − V compresses it there by 1 + 0.8 τ|V| / σ always. So p − V is
// the default, by measurement (the tests compare both on a straight boundary); `warp` chooses.
//
// Rifts, where convergence < 0, with the distance d to the boundary:
//   rift_depth k (u − 1) / (1 + u²),  u = 2.414 (d / rift_width)⁴
// a flat-floored graben with shoulders a fifth as high, without folds. Transform boundaries have
// neither. Volcanoes: cones of `volcano_slope_deg` with a crater (a paraboloid); the named peak is
// the highest place of the crater's rim.
//
// Limits: f is a first relief, not hydrologically sound (see sculpting/combination.h); peaks are
// met only roughly.
#pragma once

#include <cstdint>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "inputs/vector_map.h"
#include "tectonics/boundaries.h"
#include "tectonics/sub_plates.h"
#include "tectonics/velocity_map.h"

namespace orogen {

enum class FoldWarp { Compress, Paper };  // p − τV, p + τV

struct FoldParameters {
  double fold_wavelength = 9000.0;  // m
  int octaves = 8;
  double gain = 0.5;
  double folding_time = 1.2e6;  // yr
  FoldWarp warp = FoldWarp::Compress;
  double fold_strength = 0.6;
  double plain_share = 0.25;
  double peak_reach = 15e3;             // m
  double massif_radius = 5000.0;        // m
  double default_peak_height = 1000.0;  // m
  double rift_depth = 400.0;            // m
  double rift_width = 7000.0;           // m
  double volcano_slope_deg = 18.0;
  double crater_radius = 400.0;  // m
  double crater_depth = 150.0;   // m
};

inline constexpr std::string_view kFoldWarpNames[] = {"compress", "paper"};

constexpr auto parameter_table(const FoldParameters*) {
  using P = FoldParameters;
  return std::tuple{
      real("fold_wavelength", &P::fold_wavelength, 200.0, 200e3, "m",
           "Wavelength of the noise before it is folded."),
      integer("octaves", &P::octaves, 1, 16, "", "Octaves of the noise."),
      real("gain", &P::gain, 0.0, 0.9, "", "Amplitude of each octave over the one before."),
      real("folding_time", &P::folding_time, 0.0, 50e6, "yr",
           "Time over which plate velocities shift the noise."),
      choice("warp", &P::warp, kFoldWarpNames,
             "Which way the noise is shifted: compress folds it along convergent boundaries."),
      real("fold_strength", &P::fold_strength, 0.0, 3.0, "",
           "Standard deviation of the folds over the height of their range."),
      real("plain_share", &P::plain_share, 0.0, 1.0, "",
           "Height of the land away from convergent boundaries over that at them."),
      real("peak_reach", &P::peak_reach, 500.0, 500e3, "m",
           "Distance from the nearest peak at which the relief has halved."),
      real("massif_radius", &P::massif_radius, 100.0, 200e3, "m",
           "Distance from a peak off convergent boundaries at which its massif is a quarter as "
           "high."),
      real("default_peak_height", &P::default_peak_height, 1.0, 12e3, "m",
           "Height of peaks for which the map gives none."),
      real("rift_depth", &P::rift_depth, 0.0, 5e3, "m", "Depth of a rift where plates part."),
      real("rift_width", &P::rift_width, 200.0, 100e3, "m",
           "Distance from a rift's middle to its shoulders."),
      real("volcano_slope_deg", &P::volcano_slope_deg, 3.0, 40.0, "deg",
           "Slope of volcanic cones."),
      real("crater_radius", &P::crater_radius, 0.0, 20e3, "m", "Radius of a volcano's crater."),
      real("crater_depth", &P::crater_depth, 0.0, 3e3, "m",
           "Depth of a volcano's crater below its rim."),
  };
}

/// fold_relief, in metres. `pattern`: folds made otherwise (fold_layers.h), of mean 0 and variance
/// 1 where the ground folds; then n = 0.94 pattern + 0.34 fBm. nullptr: the noise alone.
Raster<float> warped_folds(const VectorMap& map, const PlateMap& plates,
                           const BoundaryMap& boundaries, const VelocityMap& velocity,
                           const FoldParameters& parameters, std::uint32_t seed,
                           const Context& context, const Raster<float>* pattern = nullptr);

const StageInfo& folds_stage();

}  // namespace orogen
