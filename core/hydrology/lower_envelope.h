// The highest ground that no hillside overtops: a lower envelope of cones.
//
//   g(p) = min over source cells s of  h(s) + slope W(|p − s|) N(p, s)
//   W(r) = r² / (r + floor_width)
//
// N: mean of `steepness` on the straight line from s to p, by Simpson's rule on panels no longer
// than `smooth_over`. The nearest source is the first guess; then each cell offers its source to
// its neighbours in sweeps until none takes it (two to four rounds, O(cells)).
//
// Limits: sources are passed on from cell to cell, so that where one is lowest only in a wedge
// narrower than a cell another is found. For rivers and coasts the result is within 1% and a fifth
// of a cell's rise; for sources strewn at random within 8% and half a cell's rise.
#pragma once

#include <cstdint>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

struct Hillside {
  double slope = 0.1;
  double floor_width = 0.0;                  // m
  const Raster<float>* steepness = nullptr;  // none: 1 everywhere
  double smooth_over = 1e4;                  // m, within which `steepness` varies little
};

/// `source_height` (m) is infinite where there is no source; `nearest_source` is the nearest
/// source's index at each cell, -1 without any. Outside `domain` (0) the result is 0. Without
/// sources it is infinite.
Raster<float> lower_envelope(const Raster<float>& source_height, const Raster<std::uint8_t>& domain,
                             Raster<std::int32_t>& source, const Hillside& hillside,
                             const Context& context);

}  // namespace orogen
