// Gaussian blur at a standard deviation in metres.
//
//   B(p) = integral of F(q) exp(-|p - q|² / 2σ²) / (2πσ²) dq
//
// Beyond the grid a field goes on with the value of its nearest cell. Up to σ = 1 cell the kernel
// is summed as it stands, cut off at 5σ; above, each axis is two recursive passes (after R.
// Deriche, "Recursively implementing the Gaussian and its derivatives", 1993; three complex
// exponentials, fitted anew to 2e-6 of the kernel's top), at a cost that does not depend on σ.
// Limits: within 1e-4 of the field's range of the sampled kernel (2e-3 at hundreds of cells, from
// float32); far below half a cell the sampled kernel is no longer a Gaussian.
#pragma once

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

/// `sigma` in metres; 0 gives the field back. InputError for a negative or infinite `sigma`.
Raster<float> gaussian_blur(const Raster<float>& field, double sigma, const Context& context);

}  // namespace orogen
