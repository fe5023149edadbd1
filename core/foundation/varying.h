// A quantity that is either the same everywhere or given cell by cell.
#pragma once

#include <string>

#include "foundation/errors.h"
#include "foundation/raster.h"

namespace orogen {

struct Varying {
  double value = 0.0;
  const Raster<float>* raster = nullptr;  // if set, it counts and `value` does not; not owned

  Varying() = default;
  Varying(double constant) : value(constant) {}
  Varying(const Raster<float>& field) : raster(&field) {}

  float at(std::size_t cell) const { return raster ? (*raster)[cell] : float(value); }

  /// InputError if the raster lies on another grid.
  void check(const Grid& grid, const std::string& name) const {
    if (raster && raster->grid() != grid)
      throw InputError(name + ": must lie on the same grid as the elevation");
  }
};

}  // namespace orogen
