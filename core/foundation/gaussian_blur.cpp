#include "foundation/gaussian_blur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

constexpr int kLanes = 16;           // lines filtered side by side
constexpr double kDirectUpTo = 1.0;  // cells
constexpr int kTerms = 3;

// exp(−x²/2) = Re Σ (a − ib) exp(−(l − iw) x) for x >= 0 within 2e-6, found by weighted least
// squares on [0, 9].
struct Term {
  double a, b, l, w;
};
constexpr Term kGaussian[kTerms] = {{3.07858363, 6.7695778, 2.15257122, 0.52421923},
                                    {0.1437285, -0.05956289, 2.04054903, 2.84844843},
                                    {-2.222314, -0.72487913, 2.11855078, 1.60966611}};

struct Kernel {
  std::vector<float> direct;  // weights of distances 0, 1, ...; empty: recursive
  // y = Σ Re(c s), s <- x + p s
  std::array<float, kTerms> c_re{}, c_im{}, p_re{}, p_im{}, steady_re{}, steady_im{};
};

Kernel kernel_of(double sigma_cells) {
  Kernel kernel;
  if (sigma_cells <= kDirectUpTo) {
    const int radius = std::max(1, int(std::ceil(5.0 * sigma_cells)));
    std::vector<double> weights(radius + 1);
    double sum = 0.0;
    for (int i = 0; i <= radius; ++i) {
      weights[i] = std::exp(-0.5 * (i / sigma_cells) * (i / sigma_cells));
      sum += i ? 2.0 * weights[i] : weights[i];
    }
    for (double w : weights) kernel.direct.push_back(float(w / sum));
    return kernel;
  }
  std::complex<double> c[kTerms], p[kTerms];
  double sum = 0.0;
  for (int k = 0; k < kTerms; ++k) {
    const Term& t = kGaussian[k];
    p[k] = std::exp(-std::complex<double>(t.l, -t.w) / sigma_cells);
    kernel.p_re[k] = float(p[k].real());
    kernel.p_im[k] = float(p[k].imag());
    p[k] = {kernel.p_re[k], kernel.p_im[k]};  // as the loop sees it, so that the sum is 1
    c[k] = {t.a, -t.b};
    sum += (c[k] * (1.0 + p[k]) / (1.0 - p[k])).real();
  }
  for (int k = 0; k < kTerms; ++k) {
    const std::complex<double> steady = 1.0 / (1.0 - p[k]);
    kernel.c_re[k] = float(c[k].real() / sum);
    kernel.c_im[k] = float(c[k].imag() / sum);
    kernel.steady_re[k] = float(steady.real());
    kernel.steady_im[k] = float(steady.imag());
  }
  return kernel;
}

// One direction of the recursion over n places of kLanes lines. `step` is kLanes or −kLanes. The
// forward pass counts the place itself, the backward one (which comes first) does not.
template <bool Forward>
OROGEN_CLONES void recursive_pass(const Kernel& q, const float* in, float* out, int n) {
  float re[kTerms][kLanes], im[kTerms][kLanes];
  const float* first = Forward ? in : in + std::size_t(n - 1) * kLanes;
  for (int k = 0; k < kTerms; ++k)
    for (int j = 0; j < kLanes; ++j) {
      re[k][j] = q.steady_re[k] * first[j];
      im[k][j] = q.steady_im[k] * first[j];
    }
  for (int i = 0; i < n; ++i) {
    const std::size_t at = std::size_t(Forward ? i : n - 1 - i) * kLanes;
    const float* x = in + at;
    float* y = out + at;
    float sum[kLanes] = {};
    for (int k = 0; k < kTerms; ++k) {
      const float pr = q.p_re[k], pi = q.p_im[k], cr = q.c_re[k], ci = q.c_im[k];
      for (int j = 0; j < kLanes; ++j) {
        const float r = pr * re[k][j] - pi * im[k][j], s = pr * im[k][j] + pi * re[k][j];
        const float used = Forward ? r + x[j] : r;
        sum[j] += cr * used - ci * s;
        re[k][j] = r + x[j];
        im[k][j] = s;
      }
    }
    for (int j = 0; j < kLanes; ++j) y[j] = Forward ? y[j] + sum[j] : sum[j];
  }
}

OROGEN_CLONES void direct_pass(const Kernel& q, const float* in, float* out, int n) {
  const int radius = int(q.direct.size()) - 1;
  for (int i = 0; i < n; ++i) {
    float sum[kLanes];
    for (int j = 0; j < kLanes; ++j) sum[j] = q.direct[0] * in[std::size_t(i) * kLanes + j];
    for (int d = 1; d <= radius; ++d) {
      const float* low = in + std::size_t(std::max(i - d, 0)) * kLanes;
      const float* high = in + std::size_t(std::min(i + d, n - 1)) * kLanes;
      for (int j = 0; j < kLanes; ++j) sum[j] += q.direct[d] * (low[j] + high[j]);
    }
    std::copy(sum, sum + kLanes, out + std::size_t(i) * kLanes);
  }
}

void filter(const Kernel& kernel, const float* in, float* out, int n) {
  if (!kernel.direct.empty()) return direct_pass(kernel, in, out, n);
  recursive_pass<false>(kernel, in, out, n);
  recursive_pass<true>(kernel, in, out, n);
}

// Filters `lines` lines of n values; value i of line l is at l * line_step + i * step.
void filter_lines(const Kernel& kernel, const float* in, float* out, int lines, int n,
                  std::size_t line_step, std::size_t step, const Context& context) {
  parallel_chunks(context, (lines + kLanes - 1) / kLanes, 1, [&](std::size_t block, std::size_t) {
    const int first = int(block) * kLanes, count = std::min(kLanes, lines - first);
    std::vector<float> x(std::size_t(n) * kLanes), y(x.size());
    const bool rows = step == 1;
    for (int a = 0; a < (rows ? count : n); ++a)
      for (int b = 0; b < (rows ? n : count); ++b) {
        const int l = rows ? a : b, i = rows ? b : a;
        x[std::size_t(i) * kLanes + l] = in[(first + l) * line_step + i * step];
      }
    filter(kernel, x.data(), y.data(), n);
    for (int a = 0; a < (rows ? count : n); ++a)
      for (int b = 0; b < (rows ? n : count); ++b) {
        const int l = rows ? a : b, i = rows ? b : a;
        out[(first + l) * line_step + i * step] = y[std::size_t(i) * kLanes + l];
      }
  });
}

}  // namespace

Raster<float> gaussian_blur(const Raster<float>& field, double sigma, const Context& context) {
  if (!(sigma >= 0.0) || !std::isfinite(sigma))
    throw InputError("gaussian_blur: sigma " + std::to_string(sigma) +
                     " is not allowed; a finite length of 0 m or more is wanted");
  const Grid& grid = field.grid();
  const double cells = sigma / grid.cell_size;
  if (cells < 1e-3 || field.empty()) return field;
  const Kernel kernel = kernel_of(cells);
  Raster<float> result(grid);
  filter_lines(kernel, field.data(), result.data(), grid.ny, grid.nx, grid.nx, 1, context);
  filter_lines(kernel, result.data(), result.data(), grid.nx, grid.ny, 1, grid.nx, context);
  return result;
}

}  // namespace orogen
