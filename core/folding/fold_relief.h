// The relief of folds between crest and trough lines (paper C, section 5.2, Fig. 9, and 5.3).
//
//   λ(p) = 2 (d_t + d_b)                                 local wavelength, m
//   s(p) = (1 + cos(2π d_t / λ(p))) / 2                  shape: 1 on crests, 0 in troughs
//   u_i(p) = σ_i |C(p)| s(p)                             fold speed, m/yr
//
// d_t, d_b: distance (m) to the top and the bottom skeleton, exact but for rounding to float.
// σ_i: folding speed, m/yr. The paper's f_i is u_i Δt. Where C = 0 the speed is 0; it fades as C.
//
// s is continuous, and level on crests and troughs. Its slope jumps where the nearest crest changes
// off the troughs, or the nearest trough off the crests, since distances do: on the inner side of
// each bend of a line, and about the ends of crests. A Gaussian of λ/40 rounds these creases off,
// so that slopes are continuous. It takes 1% off the crests and fills troughs by as much. Across a
// cell of λ/72 the slope then changes by more than half of an even fold's steepest slope (π/λ) in
// 0.002% of cells (0.1% without), by more than a quarter in 0.5% (1.3%); an even fold's own
// curvature makes 9% of it. Where λ varies its least value counts. Below 0.3 cells nothing is
// rounded: it would not be seen.
#pragma once

#include "folding/fold_skeleton.h"
#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

struct FoldDistances {
  Raster<float> crest;   // d_t, m; infinite without crests
  Raster<float> trough;  // d_b, m
};

/// Both distances in every cell.
FoldDistances fold_distances(const FoldSkeleton& skeleton, const Grid& grid,
                             const Context& context);

/// σ_i |C|: how fast a crest would rise at each cell. InputError unless σ_i is finite and not
/// negative.
Raster<float> crest_speed(const CompressionField& field, double fold_rate, const Context& context);

/// Standard deviation of the Gaussian that rounds creases off, over λ.
inline constexpr double kCreaseRounding = 1.0 / 40.0;

/// Turns crests' speeds (or heights) into those of the folds: crest[i] = crest[i] s(i), with s
/// blurred by `rounding` (m). Distances are taken only around cells that are not 0.
void shape_folds(const FoldSkeleton& skeleton, Raster<float>& crest, double rounding,
                 const Context& context);

}  // namespace orogen
