// Folded rocks under a ground, as Python holds them.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "strata/rock_body.h"

namespace orogen::python {

/// Shared with the terrain that they belong to.
struct Rocks {
  std::shared_ptr<const Strata> strata;
  std::shared_ptr<const Raster<float>> elevation;

  RockBody body() const {
    return {strata->horizons, strata->rocks, *elevation,
            strata->sediment.empty() ? nullptr : &strata->sediment};
  }
};

void bind_rocks(pybind11::module_& room);

}  // namespace orogen::python
