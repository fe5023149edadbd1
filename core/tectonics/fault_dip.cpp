#include "tectonics/fault_dip.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

// Slope of the field at a cell, by central differences (one-sided at the grid's sides).
glm::dvec2 gradient(const Raster<float>& field, int r, int c) {
  const Grid& grid = field.grid();
  const int west = std::max(c - 1, 0), east = std::min(c + 1, grid.nx - 1);
  const int south = std::max(r - 1, 0), north = std::min(r + 1, grid.ny - 1);
  const auto slope = [&](float from, float to, int cells) {
    return cells > 0 ? (double(to) - from) / (cells * grid.cell_size) : 0.0;
  };
  return {slope(field(r, west), field(r, east), east - west),
          slope(field(south, c), field(north, c), north - south)};
}

float at(const Raster<float>& field, glm::dvec2 p) {
  const Grid& grid = field.grid();
  return field(std::clamp(grid.row_of(p.y), 0, grid.ny - 1),
               std::clamp(grid.column_of(p.x), 0, grid.nx - 1));
}

}  // namespace

FaultMotion fault_motion(const Raster<float>& uplift_rate, const Raster<float>& fault,
                         const FaultDipParameters& parameters, const Context& context) {
  check_parameters(parameters, "fault_dip");
  const Grid& grid = fault.grid();
  if (uplift_rate.grid() != grid)
    throw InputError("uplift_rate: must lie on the same grid as the fault");
  // cos / sin: at 90 degrees tan is not quite infinite.
  const double dip = parameters.dip_deg * std::numbers::pi / 180.0;
  const double per_rise = parameters.dip_deg == 90.0 ? 0.0 : std::cos(dip) / std::sin(dip);
  FaultMotion out{Raster<float>(grid), Raster<float>(grid)};
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const double s = fault(r, c);
      if (!(s > 0.0 && s < parameters.dip_reach)) continue;
      const glm::dvec2 slope = gradient(fault, r, c);
      const double length = std::hypot(slope.x, slope.y);
      if (!(length > 0.0)) continue;
      const glm::dvec2 inward = slope / length;
      const double rise = at(uplift_rate, grid.center(r, c) - (s - 1.5 * grid.cell_size) * inward);
      const double x = s / parameters.dip_reach, fade = (1.0 - x) * (1.0 - x) * (1.0 + 2.0 * x);
      out.velocity_x(r, c) = float(-rise * per_rise * fade * inward.x);
      out.velocity_y(r, c) = float(-rise * per_rise * fade * inward.y);
    }
  });
  return out;
}

}  // namespace orogen
