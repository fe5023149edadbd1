// What the solvers of the stream power law have in common to set, whatever they work on. Each
// parameter is declared here once; a struct that has members of these names takes the declarations
// into its own table, with its own defaults.
#pragma once

#include <tuple>

#include "foundation/parameters.h"

namespace orogen {

template <class P>
constexpr auto incision_parameters() {
  return std::tuple{
      real("area_exponent", &P::area_exponent, 0.0, 2.0, "1",
           "Exponent m of the drainage area in the rate of incision."),
      real("slope_exponent", &P::slope_exponent, 0.2, 5.0, "1",
           "Exponent n of the slope in the rate of incision."),
      real("minimum_drainage_area", &P::minimum_drainage_area, 0.0, 1e9, "m2",
           "Drainage area of hillslopes, below which incision does not fall off."),
  };
}

template <class P>
constexpr auto deposition_parameters() {
  return std::tuple{
      real("deposition_coefficient", &P::deposition_coefficient, 0.0, 10.0, "1",
           "How readily rivers lay down what they carry; 0 carries everything to the sea."),
      integer("deposition_iterations", &P::deposition_iterations, 1, 50, "1",
              "Rounds in which the flux of sediment and the heights are brought to agree."),
      boolean("fill_lakes", &P::fill_lakes,
              "Whether lakes hold sediment back until they are full."),
  };
}

}  // namespace orogen
