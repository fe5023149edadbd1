#include "strata/rock_detail.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

/// d of one layer, for a thickness of 1: linear between the tops of its sub-layers.
struct LedgeProfile {
  std::vector<double> top, shift, resistance;

  LedgeProfile(const Layer& layer, double contrast) {
    double whole = 0.0, mean = 0.0;
    for (const SubLayer& s : layer.sub_layers) whole += s.share;
    for (const SubLayer& s : layer.sub_layers)
      mean += s.share / whole * std::exp(contrast * resistance_of(s));
    double t = 0.0, d = 0.0;
    for (const SubLayer& s : layer.sub_layers) {
      const double share = s.share / whole, r = resistance_of(s);
      t += share;
      d += share * (std::exp(contrast * r) / mean - 1.0);
      top.push_back(t);
      shift.push_back(d);
      resistance.push_back(r);
    }
  }

  double at(int sub_layer, double t) const {
    const double t0 = sub_layer ? top[sub_layer - 1] : 0.0;
    const double d0 = sub_layer ? shift[sub_layer - 1] : 0.0;
    const double u = std::clamp((t - t0) / (top[sub_layer] - t0), 0.0, 1.0);
    return d0 + u * (shift[sub_layer] - d0);
  }
};

double slope_at(const Raster<float>& z, int r, int c) {
  const Grid& g = z.grid();
  const int east = std::min(c + 1, g.nx - 1), west = std::max(c - 1, 0);
  const int north = std::min(r + 1, g.ny - 1), south = std::max(r - 1, 0);
  const double dx = east > west ? (z(r, east) - z(r, west)) / (east - west) : 0.0;
  const double dy = north > south ? (z(north, c) - z(south, c)) / (north - south) : 0.0;
  return std::hypot(dx, dy) / g.cell_size;
}

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

Raster<float> add_rock_detail(const RockBody& body, const StratigraphicColumn& column,
                              const RockDetailParameters& parameters, std::uint32_t seed,
                              const Context& context) {
  check_parameters(parameters);
  if (!(parameters.full_slope > parameters.least_slope))
    throw InputError("full_slope: must be above least_slope");
  const Raster<float>& z = body.elevation;
  const Grid& grid = z.grid();
  std::vector<LedgeProfile> profiles{{column.basement, parameters.ledge_contrast}};
  for (const Layer& layer : column.layers) profiles.emplace_back(layer, parameters.ledge_contrast);
  const Raster<float> noise = fbm(
      {.seed = seed, .wavelength = parameters.roughness_wavelength, .octaves = 6}, grid, context);
  const auto [low, high] = std::minmax_element(z.values().begin(), z.values().end());
  const double lowest = *low, range = std::max(double(*high) - lowest, 1.0);
  Raster<float> result(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    std::vector<float> h(body.horizons.heights.size());
    for (int c = 0; c < grid.nx; ++c) {
      const double height = z(r, c);
      result(r, c) = z(r, c);
      const double steep =
          smoothstep(parameters.least_slope, parameters.full_slope, slope_at(z, r, c));
      if (steep == 0.0) continue;
      body.horizons.at(grid.center(r, c), h.data());
      const Rock rock = body.rocks.rock_at(h.data(), z(r, c));
      if (rock.layer > body.rocks.layers()) continue;  // sediment
      const LedgeProfile& profile = profiles[rock.layer];
      const double thickness = h[rock.layer] - body.rocks.bottom_of(rock.layer, h.data());
      const double ledge = thickness * profile.at(rock.sub_layer, 1.0 - rock.gamma);
      const double most = std::max(parameters.ledge_height, 1e-9);
      const double rough = parameters.roughness * noise(r, c) *
                           (0.3 + 0.7 * profile.resistance[rock.sub_layer]) *
                           (0.5 + 0.5 * (height - lowest) / range);
      result(r, c) = float(height + steep * (most * std::tanh(ledge / most) + rough));
    }
  });
  return result;
}

const StageInfo& rock_detail_stage() {
  static const StageInfo info{"rock_detail",
                              "Lets hard beds stand out as ledges and roughens steep slopes.",
                              "Cordonnier et al. 2018, section 7.1",
                              {"elevation", "exhumation"},
                              {"elevation"},
                              {"column"}};
  return info;
}

}  // namespace orogen
