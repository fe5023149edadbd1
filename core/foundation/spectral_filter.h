// A field filtered in the domain of wavenumbers: Fourier transform, a change to each wave, and
// back.
//
// The field lies in the lower-left part of a period of nx x ny cells, the rest of which is 0; what
// wraps round comes back into it, so pad by the reach of the filter. Lengths whose only factors are
// 2, 3 and 5 are quick. A filter of real fields gives real fields: it treats the wave (-kx, -ky) as
// the complex conjugate of (kx, ky); only waves with kx >= 0 are asked for.
// Every row and column is transformed by itself: the same bytes with any number of threads.
#pragma once

#include <complex>
#include <functional>
#include <span>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

/// Changes the waves of one kx (rad/m), one for each of ky.
using ChangeWaves = std::function<void(double kx, std::span<const double> ky,
                                       std::span<std::complex<double>> waves)>;

void spectral_filter(Raster<double>& field, int nx, int ny, const ChangeWaves& change,
                     const Context& context);

/// The next even length that is a product of 2, 3 and 5.
int transform_length(int n);

}  // namespace orogen
