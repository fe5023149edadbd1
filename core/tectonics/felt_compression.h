// Compression as folds feel it, and its mean (additions to paper C, sections 4.3 and 5.2).
//
//   C' = S(w C)           w: plate_convergence where the crust is continental, 0 where oceanic
//   mean: that of |C'| over the cells with more than 1% of the greatest uplift
//
// S: smoothed_compression. Eq. 2 squeezes the ground behind plates that part, and oceanic crust
// dives instead of folding: neither is compressed. Divided by the mean, arrows of any length fold
// and lift alike.
#pragma once

#include "foundation/context.h"
#include "foundation/raster.h"
#include "tectonics/compression.h"
#include "tectonics/transport_field.h"

namespace orogen {

/// `convergence`: plate_convergence at `smoothing` (m). InputError if it lies on another grid.
CompressionField felt_compression(const TransportField& transport, CompressionField field,
                                  const Raster<float>& convergence, double smoothing,
                                  const Context& context);

/// At least 1e-3; 1 where nothing rises. `uplift_rate` (m/yr) on the field's grid.
double mean_compression(const CompressionField& field, const Raster<float>& uplift_rate,
                        const Context& context);

}  // namespace orogen
