#include "foundation/noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "foundation/errors.h"
#include "foundation/kept.h"
#include "foundation/parallel.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

// Standard deviation of one octave below, found by sampling 2·10⁷ places.
constexpr float kOctaveDeviation = 0.1761f;

constexpr std::uint32_t mix32(std::uint32_t x) {  // Wellons' lowbias32
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ (x >> 16);
}

inline float gradient_dot(std::uint32_t hash, float dx, float dy) {
  constexpr float scale = 1.0f / 32768.0f;
  const float gx = float(int(hash & 0xffffu) - 32768) * scale;
  const float gy = float(int(hash >> 16) - 32768) * scale;
  return gx * dx + gy * dy;
}

inline float fade(float t) {
  return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

inline float lattice_noise(std::uint32_t seed, double x, double y) {
  const double fx = std::floor(x), fy = std::floor(y);
  const float tx = float(x - fx), ty = float(y - fy);
  const auto ix = std::uint32_t(std::int32_t(fx)), iy = std::uint32_t(std::int32_t(fy));
  const std::uint32_t row0 = mix32(iy ^ seed), row1 = mix32((iy + 1) ^ seed);
  const float a = gradient_dot(mix32(ix + row0), tx, ty);
  const float b = gradient_dot(mix32(ix + 1 + row0), tx - 1.0f, ty);
  const float c = gradient_dot(mix32(ix + row1), tx, ty - 1.0f);
  const float d = gradient_dot(mix32(ix + 1 + row1), tx - 1.0f, ty - 1.0f);
  const float u = fade(tx), v = fade(ty);
  const float low = a + u * (b - a), high = c + u * (d - c);
  return low + v * (high - low);
}

template <class Octave>
inline float value_at(const Octave& o, double x, double y) {
  return o.amplitude *
         lattice_noise(o.seed, o.xx * x - o.xy * y + o.shift, o.xy * x + o.xx * y + o.shift);
}

template <class Octave>
OROGEN_CLONES void add_octave(const Octave& o, const double* x, const double* y, float* out,
                              int n) {
  for (int i = 0; i < n; ++i) out[i] += value_at(o, x[i], y[i]);
}

}  // namespace

Fbm::Fbm(const FbmParameters& p) {
  if (!(p.wavelength > 0.0) || p.octaves < 1 || p.octaves > 32)
    throw InputError("fbm: wavelength must be above 0 and octaves from 1 to 32");
  double frequency = 1.0 / p.wavelength, amplitude = 1.0, energy = 0.0;
  for (int i = 0; i < p.octaves; ++i) {
    const double angle = 0.5 + 1.2 * i;
    const std::uint32_t seed = mix32(p.seed + 0x9e3779b9u * std::uint32_t(i + 1));
    octaves_.push_back({std::cos(angle) * frequency, std::sin(angle) * frequency,
                        double(seed & 1023u) + 0.37, float(amplitude), seed});
    energy += amplitude * amplitude;
    frequency *= p.lacunarity;
    amplitude *= p.gain;
  }
  const float scale = float(1.0 / (kOctaveDeviation * std::sqrt(energy)));
  for (Octave& octave : octaves_) octave.amplitude *= scale;
}

float Fbm::operator()(double x, double y) const {
  float sum = 0.0f;
  for (const Octave& octave : octaves_) sum += value_at(octave, x, y);
  return sum;
}

void Fbm::sample(const double* x, const double* y, float* out, int n) const {
  std::fill(out, out + n, 0.0f);
  for (const Octave& octave : octaves_) add_octave(octave, x, y, out, n);
}

float fbm(const FbmParameters& parameters, double x, double y) {
  return Fbm(parameters)(x, y);
}

void fbm(const FbmParameters& parameters, const double* x, const double* y, float* out, int n) {
  Fbm(parameters).sample(x, y, out, n);
}

namespace {

Raster<float> noise_on(const FbmParameters& parameters, const Grid& grid, const Context& context) {
  Raster<float> result(grid);
  const Fbm noise(parameters);
  parallel_rows(context, grid.ny, [&](int r) {
    std::vector<double> x(grid.nx), y(grid.nx, grid.center(r, 0).y);
    for (int c = 0; c < grid.nx; ++c) x[c] = grid.center(r, c).x;
    noise.sample(x.data(), y.data(), result.row(r), grid.nx);
  });
  return result;
}

}  // namespace

Raster<float> fbm(const FbmParameters& p, const Grid& grid, const Context& context) {
  const Kept::Key key("fbm", p.seed, p.wavelength, p.octaves, p.lacunarity, p.gain, grid.nx,
                      grid.ny, grid.cell_size, grid.origin.x, grid.origin.y);
  return *kept(
      context, key, [&] { return noise_on(p, grid, context); },
      [](const Raster<float>& noise) { return noise.size() * sizeof(float); });
}

}  // namespace orogen
