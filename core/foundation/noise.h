// Gradient noise and fractional Brownian motion (fBm), as functions of the place in metres.
//
//   fbm(p) = sum over octaves i of gain^i * noise(R_i p * lacunarity^i / wavelength), normalised
//            to unit variance
//
// noise: gradients at integer lattice points, drawn by a hash of (seed, octave, lattice point),
// blended by the quintic 6t⁵ − 15t⁴ + 10t³ (Perlin 2002). Each octave turns the plane by a fixed
// angle (R_i) so that no lattice direction shows. The same place gives the same value on any grid.
// Octaves shorter than two cells are not faded: the sampling grid's cell does not enter.
// Limits: coordinates within some 10⁸ wavelengths of the finest octave.
#pragma once

#include <cstdint>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

struct FbmParameters {
  std::uint32_t seed = 0;
  double wavelength = 1000.0;  // m, of the first octave
  int octaves = 8;
  double lacunarity = 2.0;
  double gain = 0.5;
};

/// Prepared once for many single places.
class Fbm {
 public:
  explicit Fbm(const FbmParameters& parameters);

  /// Variance 1, mean 0.
  float operator()(double x, double y) const;
  /// Values at n places.
  void sample(const double* x, const double* y, float* out, int n) const;

 private:
  struct Octave {
    double xx, xy;  // x' = xx*x - xy*y + shift; y' = xy*x + xx*y + shift
    double shift;
    float amplitude;
    std::uint32_t seed;
  };

  std::vector<Octave> octaves_;
};

/// Fbm of one place.
float fbm(const FbmParameters& parameters, double x, double y);

/// Values at n places: out[i] = fbm(x[i], y[i]).
void fbm(const FbmParameters& parameters, const double* x, const double* y, float* out, int n);

/// Values at the cell centres of a grid.
Raster<float> fbm(const FbmParameters& parameters, const Grid& grid, const Context& context);

}  // namespace orogen
