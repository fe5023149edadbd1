#include "foundation/spectral_filter.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "foundation/parallel.h"

namespace orogen {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t kGrain = 16;  // rows or columns

std::vector<double> wavenumbers(int n, double cell) {
  std::vector<double> k(n);
  for (int i = 0; i < n; ++i) k[i] = 2.0 * std::numbers::pi * (i <= n / 2 ? i : i - n) / (n * cell);
  return k;
}

/// each(row, line, wave, transform) for every row of the field, with room of its own.
template <class Each>
void for_rows(int rows, int nx, const Context& context, Each&& each) {
  parallel_chunks(context, rows, kGrain, [&](std::size_t begin, std::size_t end) {
    Eigen::FFT<double> fft;
    fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<double> line(nx);
    std::vector<Complex> wave(nx / 2 + 1);
    for (std::size_t r = begin; r < end; ++r) each(r, line, wave, fft);
  });
}

}  // namespace

int transform_length(int n) {
  for (n += n % 2;; n += 2) {
    int rest = n;
    for (int factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

void spectral_filter(Raster<double>& field, int nx, int ny, const ChangeWaves& change,
                     const Context& context) {
  const int rows = field.grid().ny, columns = field.grid().nx, half = nx / 2 + 1;
  const std::vector<double> kx = wavenumbers(nx, field.grid().cell_size);
  const std::vector<double> ky = wavenumbers(ny, field.grid().cell_size);
  std::vector<Complex> waves(std::size_t(half) * ny, 0.0);  // column by column
  for_rows(rows, nx, context, [&](std::size_t r, auto& line, auto& wave, auto& fft) {
    std::copy_n(field.row(int(r)), columns, line.begin());
    fft.fwd(wave.data(), line.data(), nx);
    for (int k = 0; k < half; ++k) waves[std::size_t(k) * ny + r] = wave[k];
  });
  parallel_chunks(context, half, kGrain, [&](std::size_t begin, std::size_t end) {
    Eigen::FFT<double> fft;
    std::vector<Complex> wave(ny);
    for (std::size_t k = begin; k < end; ++k) {
      Complex* column = waves.data() + k * ny;
      fft.fwd(wave.data(), column, ny);
      change(kx[k], ky, wave);
      fft.inv(column, wave.data(), ny);
    }
  });
  for_rows(rows, nx, context, [&](std::size_t r, auto& line, auto& wave, auto& fft) {
    for (int k = 0; k < half; ++k) wave[k] = waves[std::size_t(k) * ny + r];
    fft.inv(line.data(), wave.data(), nx);
    std::copy_n(line.begin(), columns, field.row(int(r)));
  });
}

}  // namespace orogen
