// The numbers of a layer of rock, declared. The struct is in column.h; this is apart so that what
// reads columns need not know it.
#pragma once

#include <tuple>

#include "foundation/parameters.h"
#include "strata/column.h"

namespace orogen {

constexpr auto parameter_table(const Layer*) {
  using P = Layer;
  return std::tuple{
      real("thickness", &P::thickness, 1.0, 50e3, "m", "Thickness before the layer folds."),
      real("viscosity", &P::viscosity, 1.0, 1e30, "Pa s",
           "Competence: the stiffer a layer is beside the one below, the wider its folds."),
      real("fold_wavelength", &P::fold_wavelength, 0.0, 200e3, "m",
           "Distance from crest to crest of its folds, 100 m or more; 0: that which its thickness "
           "and viscosity give."),
      real("fold_share", &P::fold_share, 0.0, 0.5, "",
           "Speed at which its folds grow, over the uplift rate, 0.01 or more; 0: it does not "
           "fold."),
  };
}

}  // namespace orogen
