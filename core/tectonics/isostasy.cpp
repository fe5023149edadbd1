#include "tectonics/isostasy.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <string>

#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/resample.h"
#include "foundation/spectral_filter.h"

namespace orogen {

namespace {

constexpr double kGravity = 9.81;  // m/s²
constexpr double kPadding = 10.0;  // α
constexpr double kCoarse = 16.0;   // cells an α at least, where the load is gathered
constexpr int kMargin = 3;         // coarse cells around the grid, for the interpolation

void check(const IsostasyParameters& p) {
  check_parameters(p, "isostasy");
  if (p.mantle_density <= p.crust_density)
    throw InputError("isostasy.mantle_density: " + detail::format_number(p.mantle_density) +
                     " kg/m3 is not allowed; more than the crust's " +
                     detail::format_number(p.crust_density) + " kg/m3 is wanted");
}

double density_contrast(const IsostasyParameters& p, HollowFill fill) {
  return p.mantle_density - (fill == HollowFill::Crust ? p.crust_density : 0.0);
}

// The load on cells of `factor` cells, with `kMargin` empty ones below and to the left.
Raster<double> gather(const Raster<float>& load, int factor, const Context& context) {
  const Grid& fine = load.grid();
  const double cell = factor * fine.cell_size;
  const double share = 1.0 / (double(factor) * factor);
  const int inner_x = (fine.nx + factor - 1) / factor, inner_y = (fine.ny + factor - 1) / factor;
  Raster<double> out(
      Grid{inner_x + 2 * kMargin, inner_y + 2 * kMargin, cell, fine.origin - kMargin * cell});
  parallel_rows(context, inner_y, [&](int r) {
    double* row = out.row(r + kMargin) + kMargin;
    for (int i = r * factor; i < std::min((r + 1) * factor, fine.ny); ++i)
      for (int c = 0; c < fine.nx; ++c) row[c / factor] += share * load(i, c);
  });
  return out;
}

/// What the plate makes of a load's waves.
ChangeWaves bending(double alpha) {
  return [alpha](double kx, std::span<const double> ky, std::span<std::complex<double>> waves) {
    for (std::size_t j = 0; j < waves.size(); ++j) {
      const double square = alpha * alpha * (kx * kx + ky[j] * ky[j]);
      waves[j] /= 1.0 + 0.25 * square * square;
    }
  };
}

Raster<float> scaled(const Raster<float>& field, double factor) {
  Raster<float> out = field;
  for (float& v : out.values()) v = float(factor * v);
  return out;
}

}  // namespace

double airy_uplift_share(const IsostasyParameters& parameters) {
  check(parameters);
  return 1.0 - parameters.crust_density / parameters.mantle_density;
}

double airy_root_share(const IsostasyParameters& parameters) {
  check(parameters);
  return parameters.crust_density / (parameters.mantle_density - parameters.crust_density);
}

double flexural_parameter(const IsostasyParameters& p, HollowFill fill) {
  check(p);
  const double thickness = p.elastic_thickness;
  const double rigidity = p.young_modulus * thickness * thickness * thickness /
                          (12.0 * (1.0 - p.poisson_ratio * p.poisson_ratio));
  return std::sqrt(std::sqrt(4.0 * rigidity / (density_contrast(p, fill) * kGravity)));
}

Raster<float> flexural_deflection(const Raster<float>& load, const IsostasyParameters& parameters,
                                  const Context& context, HollowFill fill) {
  const double alpha = flexural_parameter(parameters, fill);
  const double local = parameters.crust_density / density_contrast(parameters, fill);
  const Grid& grid = load.grid();
  for (std::size_t i = 0; i < load.size(); ++i)
    if (!std::isfinite(load[i]))
      throw InputError("load[" + std::to_string(i) + "]: finite metres of rock are wanted");
  if (alpha == 0.0 || load.empty()) return scaled(load, local);
  const int factor = std::max(1, int(alpha / (kCoarse * grid.cell_size)));
  Raster<double> field = gather(load, factor, context);
  const double cell = field.grid().cell_size;
  const int padding = int(std::ceil(kPadding * alpha / cell));
  spectral_filter(field, transform_length(field.grid().nx + padding),
                  transform_length(field.grid().ny + padding), bending(alpha), context);
  Raster<float> deflection(field.grid());
  for (std::size_t i = 0; i < field.size(); ++i) deflection[i] = float(local * field[i]);
  return resample_bicubic(deflection, grid, context);
}

Raster<float> isostatic_uplift(const Raster<float>& thickening,
                               const IsostasyParameters& parameters, const Context& context) {
  if (parameters.isostasy == Isostasy::None) return thickening;
  if (parameters.isostasy == Isostasy::Airy)
    return scaled(thickening, airy_uplift_share(parameters));
  Raster<float> rise = flexural_deflection(thickening, parameters, context, HollowFill::Air);
  for (std::size_t i = 0; i < rise.size(); ++i) rise[i] = thickening[i] - rise[i];
  return rise;
}

Raster<float> floating_uplift(const Raster<float>& thickening, const IsostasyParameters& parameters,
                              const Context& context) {
  if (parameters.isostasy == Isostasy::None) return thickening;
  Raster<float> floating = isostatic_uplift(thickening, parameters, context);
  const auto sum_over_thickening = [&](const Raster<float>& values) {
    return parallel_sum(context, values.size(), [&](std::size_t i) {
      return thickening[i] > 0.0f ? double(values[i]) : 0.0;
    });
  };
  const double before = sum_over_thickening(thickening), after = sum_over_thickening(floating);
  if (!(after > 0.0)) return thickening;
  for (float& rate : floating.values()) rate *= float(before / after);
  return floating;
}

}  // namespace orogen
