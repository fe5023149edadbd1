// The stratigraphic column: what layers the crust is made of before it folds (paper C, section 5.1
// and Table 2).
//
// Layers are listed from the bottom to the top; below them lies the basement (layer 0), above them
// loose sediment (layer n + 1). A layer is cut into 1 to 10 sub-layers, each a share of its
// thickness wherever it lies. Folds of layer k have the dominant wavelength of buckling
//
//   λ_k = 2π (τ_k τ_{k-1})^{1/2} (μ_k / (6 μ_{k-1}))^{1/6}                   (paper C, eq. 3)
//
// unless the column sets it: τ thickness (m), μ viscosity (Pa s). The paper leaves the factor open;
// 2π / 6^{1/6} is that of a single viscous layer in a weaker medium (Biot 1961).
// Erodibility and talus angle follow from a sub-layer's resistance r in [0, 1]:
//
//   k = k_soft (k_hard / k_soft)^r,   θ = θ_soft + (θ_hard - θ_soft) r
//
// Angles are Table 2's. Its erodibilities, 2.5e-7 to 8e-7 /yr, need some 15 million years to cut a
// range through at 5e-4 m/yr and leave plateaus after 5 million; the defaults are five times that.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "foundation/parameters.h"
#include "inputs/given_raster.h"
#include "strata/lithology.h"

namespace orogen {

struct SubLayer {
  double share = 1.0;  // of the layer's thickness, relative to the other sub-layers
  Lithology lithology = Lithology::Limestone;
  std::optional<double> resistance;  // 0 to 1; not set: the lithology's
};

struct Layer {
  std::string name;
  double thickness = 1000.0;         // m
  double viscosity = 1e20;           // Pa s
  double fold_wavelength = 0.0;      // m; 0: by eq. 3
  double fold_share = 0.1;           // σ over the target uplift rate, 0.01 to 0.5; 0: no folds
  std::vector<SubLayer> sub_layers;  // from the bottom up
  std::optional<CornerMap> thickness_map;  // m, over the terrain's extent, in place of thickness
};

struct StratigraphicColumn {
  Layer basement;
  std::vector<Layer> layers;
};

/// How resistance becomes erosion's constants.
struct RockStrengthParameters {
  double soft_erodibility = 4e-6;    // m^(1-2m)/yr
  double hard_erodibility = 1.2e-6;  // m^(1-2m)/yr
  double soft_talus_deg = 30.0;
  double hard_talus_deg = 50.0;
};

constexpr auto parameter_table(const RockStrengthParameters*) {
  using P = RockStrengthParameters;
  return std::tuple{
      real("soft_erodibility", &P::soft_erodibility, 1e-12, 1.0, "m^(1-2m)/yr",
           "Stream-power erodibility of the weakest rock."),
      real("hard_erodibility", &P::hard_erodibility, 1e-12, 1.0, "m^(1-2m)/yr",
           "Stream-power erodibility of the hardest rock."),
      real("soft_talus_deg", &P::soft_talus_deg, 1.0, 89.0, "deg",
           "Steepest slope that the weakest rock holds."),
      real("hard_talus_deg", &P::hard_talus_deg, 1.0, 89.0, "deg",
           "Steepest slope that the hardest rock holds."),
  };
}

double erodibility_of(double resistance, const RockStrengthParameters& strength);
/// Rise over run.
double talus_slope_of(double resistance, const RockStrengthParameters& strength);
double resistance_of(const SubLayer& sub_layer);

/// InputError that begins with `place` unless the column can be used: 1 to 40 layers with 1 to 10
/// sub-layers each, and every value within its range.
void check_column(const StratigraphicColumn& column, std::string_view place = "column");

/// Wavelength (m) of each layer's folds.
std::vector<double> fold_wavelengths(const StratigraphicColumn& column);

/// Columns by name: jura, zagros, alps, andes, digne, schist.
std::vector<std::string_view> column_names();
/// InputError for a name that there is not.
StratigraphicColumn preset_column(std::string_view name, std::string_view place = "column");

}  // namespace orogen
