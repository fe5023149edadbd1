// Small cases and measures that the tests of virtual pipes share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "erosion/virtual_pipes.h"
#include "erosion/virtual_pipes_oracle.h"
#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/random.h"

namespace orogen {
namespace {

inline PipeErosionResult run(const Raster<float>& z, const PipeParameters& p,
                             const PipeForcing& f = {}, int threads = 0) {
  Context context({}, threads);
  return erode_virtual_pipes<float>(z, f, p, context);
}

inline PipeErosionResult run_double(const Raster<float>& z, const PipeParameters& p,
                                    const PipeForcing& f = {}) {
  Context context;
  return erode_virtual_pipes<double>(z, f, p, context);
}

/// Hills of some 500 m with a sea around a part of them.
inline Raster<float> hills(int nx, int ny, double cell, std::uint32_t seed, double lift = 150.0) {
  const Context context;
  FbmParameters noise;
  noise.seed = seed;
  noise.wavelength = 20.0 * cell;
  Raster<float> z = fbm(noise, Grid{nx, ny, cell}, context);
  for (float& v : z.values()) v = float(lift + 2.0 * cell * double(v));
  return z;
}

inline PipeParameters no_water() {
  PipeParameters p;
  p.rain_rate_mm_per_h = 0.0;
  p.evaporation_rate = 0.0;
  p.open_sides = false;
  return p;
}

inline PipeParameters steps_of(PipeParameters p, double cell, int steps) {
  p.duration = stable_time_step(cell, p) * steps;
  return p;
}

}  // namespace
}  // namespace orogen
