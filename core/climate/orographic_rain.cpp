#include "climate/orographic_rain.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include "foundation/parallel.h"
#include "foundation/resample.h"
#include "foundation/spectral_filter.h"
#include "foundation/units.h"

namespace orogen {

namespace {

using Complex = std::complex<double>;

constexpr double kMostCells = 1024.0;     // a side, padding included
constexpr double kPaddingTimes = 5.0;     // ways of the wind in both times
constexpr double kLeastPadding = 0.25;    // of the longer side
constexpr double kLeastFrequency = 1e-9;  // 1/s: slower waves lift nothing

struct Wind {
  double u, v;  // m/s, east and north
};

Wind wind_of(const OrographicRainParameters& p) {
  const double from = radians(p.wind_from_deg);
  return {-p.wind_speed * std::sin(from), -p.wind_speed * std::cos(from)};
}

/// Rain (kg/m²/s) for a wave of ground.
Complex response(double k, double l, const Wind& wind, const OrographicRainParameters& p) {
  const double s = wind.u * k + wind.v * l;
  if (std::fabs(s) < kLeastFrequency) return 0.0;
  const double square = (p.moist_stability * p.moist_stability - s * s) / (s * s) * (k * k + l * l);
  const Complex m = square >= 0.0 ? Complex(std::copysign(std::sqrt(square), s), 0.0)
                                  : Complex(0.0, std::sqrt(-square));
  const Complex i(0.0, 1.0);
  return p.uplift_sensitivity * i * s /
         ((1.0 - i * m * p.moist_layer) * (1.0 + i * s * p.conversion_time) *
          (1.0 + i * s * p.fallout_time));
}

/// Land in the middle of a larger field into which it sinks.
Raster<double> padded(const Raster<float>& land, int padding, const Context& context) {
  const Grid& grid = land.grid();
  Raster<double> field(Grid{grid.nx + 2 * padding, grid.ny + 2 * padding, grid.cell_size,
                            grid.origin - padding * grid.cell_size});
  const auto share = [&](int at, int cells) {
    const int beyond = std::max({-at, at - cells + 1, 0});
    return 0.5 + 0.5 * std::cos(std::numbers::pi * std::min(1.0, double(beyond) / padding));
  };
  parallel_rows(context, field.grid().ny, [&](int r) {
    const int from = std::clamp(r - padding, 0, grid.ny - 1);
    const double of_row = share(r - padding, grid.ny);
    for (int c = 0; c < field.grid().nx; ++c)
      field(r, c) = of_row * share(c - padding, grid.nx) *
                    std::max(0.0f, land(from, std::clamp(c - padding, 0, grid.nx - 1)));
  });
  return field;
}

/// The grid, or a coarser one that the model can pad by so many metres.
Grid model_grid(const Grid& grid, double padding) {
  const double longer = std::fmax(grid.width(), grid.height());
  const int most = std::max(2, int(kMostCells * longer / (longer + 2.0 * padding)));
  if (std::max(grid.nx, grid.ny) <= most) return grid;
  return grid_over(grid.origin, {grid.width(), grid.height()}, most);
}

}  // namespace

Raster<float> orographic_rain(const Raster<float>& elevation,
                              const OrographicRainParameters& parameters, const Context& context) {
  check_parameters(parameters);
  const Grid& fine = elevation.grid();
  const double way = parameters.wind_speed * (parameters.conversion_time + parameters.fallout_time);
  const double reach =
      std::max(kPaddingTimes * way, kLeastPadding * std::fmax(fine.width(), fine.height()));
  const Grid grid = model_grid(fine, reach);
  const Raster<float> ground = grid == fine ? elevation : resample_mean(elevation, grid, context);
  const int padding = int(std::ceil(reach / grid.cell_size));
  Raster<double> field = padded(ground, padding, context);
  const Wind wind = wind_of(parameters);
  const ChangeWaves lift = [&](double kx, std::span<const double> ky, std::span<Complex> waves) {
    for (std::size_t j = 0; j < waves.size(); ++j)
      waves[j] *= response(kx, ky[j], wind, parameters);
  };
  spectral_filter(field, transform_length(field.grid().nx), transform_length(field.grid().ny), lift,
                  context);
  const double metres_a_year = parameters.storm_share * kSecondsPerYear / 1000.0;
  Raster<float> rain(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c)
      rain(r, c) = float(std::max(
          0.0, parameters.background_rain + metres_a_year * field(r + padding, c + padding)));
  });
  return grid == fine ? rain : resample_bilinear(rain, fine, context);
}

}  // namespace orogen
