// Detail on slopes: ledges where hard beds crop out, and roughness (paper C, section 7.1: noise by
// slope and elevation, here held to the strata).
//
// Ledges. Within a layer a height s above its bottom goes to s + d(s), d' = g_j - 1 in sub-layer j:
//
//   g_j = e^{c r_j} / Σ_i a_i e^{c r_i}      r_j resistance, a_j share of the thickness,
//                                            c = `ledge_contrast`
//
// so that hard beds stand steeper than weak ones while each layer keeps its thickness; |d| is held
// below `ledge_height`. Roughness is fBm times slope, resistance and height:
//
//   z' = z + S (d + roughness n (0.3 + 0.7 r) (0.5 + 0.5 (z - z_min) / (z_max - z_min)))
//   S = smoothstep of the slope from `least_slope` to `full_slope`
//
// Flat ground (valley floors, river beds) stays as it is.
// Limits: small hollows can arise on slopes; nothing drains them.
#pragma once

#include <cstdint>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/stage.h"
#include "strata/rock_body.h"

namespace orogen {

struct RockDetailParameters {
  double ledge_contrast = 1.5;
  double ledge_height = 40.0;           // m
  double roughness = 12.0;              // m
  double roughness_wavelength = 600.0;  // m
  double least_slope = 0.15;
  double full_slope = 0.5;
};

constexpr auto parameter_table(const RockDetailParameters*) {
  using P = RockDetailParameters;
  return std::tuple{
      real("ledge_contrast", &P::ledge_contrast, 0.0, 10.0, "",
           "How much steeper than the weakest rock the hardest stands, as a power of e."),
      real("ledge_height", &P::ledge_height, 0.0, 1e3, "m",
           "How far ledges may move the ground up or down."),
      real("roughness", &P::roughness, 0.0, 1e3, "m",
           "Standard deviation of roughness on steep slopes of hard rock."),
      real("roughness_wavelength", &P::roughness_wavelength, 1.0, 100e3, "m",
           "Wavelength of the widest roughness."),
      real("least_slope", &P::least_slope, 0.0, 10.0, "1", "Slope at which detail begins."),
      real("full_slope", &P::full_slope, 1e-3, 20.0, "1", "Slope from which on detail is whole."),
  };
}

/// The elevation with detail. InputError unless full_slope is above least_slope.
Raster<float> add_rock_detail(const RockBody& body, const StratigraphicColumn& column,
                              const RockDetailParameters& parameters, std::uint32_t seed,
                              const Context& context);

const StageInfo& rock_detail_stage();

}  // namespace orogen
