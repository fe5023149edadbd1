// How the crust sinks under a load: local (Airy) and by bending of an elastic plate.
//
// Airy: every column floats by itself. Crust that thickens by h raises the ground by
// h (1 − ρ_c / ρ_m); ground h high stands on a root of h ρ_c / (ρ_m − ρ_c).
//
// Flexure (Turcotte and Schubert, Geodynamics, section 3.14 on):
//
//   D ∇⁴w + (ρ_m − ρ_f) g w = ρ_c g h,     D = E T_e³ / (12 (1 − ν²))
//
// w: deflection (m, down); h: load (m of rock); D: flexural rigidity (N m); T_e: elastic thickness
// (m); E: Young's modulus (Pa); ν: Poisson's ratio; g = 9.81 m/s²; ρ_f: what fills
// the hollow: crust under a load that is kept at its height, or air (0), where the load sinks with
// the ground. α = (4 D / ((ρ_m − ρ_f) g))^(1/4) is the flexural parameter: a line load's deflection
// is w0 e^(−x/α) (cos x/α + sin x/α). In the wavenumber domain the answer is exact:
//
//   ŵ = ĥ ρ_c / (ρ_m − ρ_f) / (1 + (α k)⁴ / 4)
//
// Beyond the grid there is no load; it is padded by 10 α, so that what wraps round is under 1e-4.
// Where α spans 32 cells or more the load is gathered on cells of α/32 to α/16; with the bicubic
// interpolation back this costs up to 1e-3 of the greatest deflection.
//
// Limits: a flat Earth, one plate without breaks or faults, in equilibrium (the mantle flows in
// some 10⁴ years).
#pragma once

#include <string_view>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"

namespace orogen {

enum class Isostasy { None, Airy, Flexure };
inline constexpr std::string_view kIsostasyNames[] = {"none", "airy", "flexure"};

struct IsostasyParameters {
  Isostasy isostasy = Isostasy::None;
  double crust_density = 2800.0;    // kg/m³
  double mantle_density = 3300.0;   // kg/m³
  double elastic_thickness = 15e3;  // m
  double young_modulus = 7e10;      // Pa
  double poisson_ratio = 0.25;
};

constexpr auto parameter_table(const IsostasyParameters*) {
  using P = IsostasyParameters;
  return std::tuple{
      choice("isostasy", &P::isostasy, kIsostasyNames,
             "How the crust floats: not at all, column by column, or as an elastic plate."),
      real("crust_density", &P::crust_density, 1000.0, 3500.0, "kg/m3", "Density of the crust."),
      real("mantle_density", &P::mantle_density, 2000.0, 5000.0, "kg/m3",
           "Density of the mantle; it must exceed the crust's."),
      real("elastic_thickness", &P::elastic_thickness, 0.0, 100e3, "m",
           "Thickness of the elastic plate; 0 lets every column float by itself."),
      real("young_modulus", &P::young_modulus, 1e9, 1e12, "Pa",
           "Young's modulus of the elastic plate."),
      real("poisson_ratio", &P::poisson_ratio, 0.0, 0.49, "",
           "Poisson's ratio of the elastic plate."),
  };
}

/// Rise of the ground over the thickening of the crust below it: 1 − ρ_c / ρ_m.
double airy_uplift_share(const IsostasyParameters& parameters);

/// Depth of the root over the height of the ground above it: ρ_c / (ρ_m − ρ_c).
double airy_root_share(const IsostasyParameters& parameters);

/// What fills the hollow under a load.
enum class HollowFill { Crust, Air };

/// α, m.
double flexural_parameter(const IsostasyParameters& parameters,
                          HollowFill fill = HollowFill::Crust);

/// w (m, down) under a load of rock (m). InputError for parameters out of range or a crust that is
/// no lighter than the mantle, and for a load that is not finite.
Raster<float> flexural_deflection(const Raster<float>& load, const IsostasyParameters& parameters,
                                  const Context& context, HollowFill fill = HollowFill::Crust);

/// Rate at which the ground rises (m/yr) where crust thickens at `thickening` (m/yr): what is left
/// of it when the crust has sunk under itself. With Airy's model thickening times
/// airy_uplift_share; with flexure the ground beside a range sinks (foreland basins).
Raster<float> isostatic_uplift(const Raster<float>& thickening,
                               const IsostasyParameters& parameters, const Context& context);

/// The same scaled so that its mean over the cells whose crust thickens is the thickening's: what a
/// target uplift rate asks for. Without isostasy, or where the ground would not rise at all, the
/// thickening itself.
Raster<float> floating_uplift(const Raster<float>& thickening, const IsostasyParameters& parameters,
                              const Context& context);

}  // namespace orogen
