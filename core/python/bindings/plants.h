// Where plants are asked for.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "vegetation/placement.h"

namespace orogen::python {

/// None or two corners. InputError for anything else.
std::optional<PlantRegion> to_region(const pybind11::object& region);

}  // namespace orogen::python
