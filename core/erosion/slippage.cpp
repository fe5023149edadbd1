#include "erosion/slippage.h"

#include <cmath>
#include <string>

#include "erosion/slippage_sweep.h"
#include "foundation/errors.h"
#include "foundation/units.h"

namespace orogen {

namespace {

void check_field(const Raster<float>& field, const Grid& grid, const char* name, float low) {
  if (field.grid() != grid)
    throw InputError(std::string(name) + ": its grid differs from rock_elevation's");
  for (std::size_t i = 0; i < field.size(); ++i)
    if (!std::isfinite(field[i]) || field[i] < low)
      throw InputError(std::string(name) + ": row " + std::to_string(i / grid.nx) + ", column " +
                       std::to_string(i % grid.nx) + " holds " + std::to_string(field[i]) +
                       "; a finite number >= " + std::to_string(low) + " is needed");
}

}  // namespace

SlippageResult slip_sediment(const Raster<float>& rock_elevation,
                             const Raster<float>& sediment_thickness,
                             const SlippageParameters& parameters, Context& context,
                             const Raster<std::uint8_t>* pinned) {
  check_parameters(parameters, "slippage");
  const Grid& grid = rock_elevation.grid();
  check_field(rock_elevation, grid, "rock_elevation", -1e30f);
  check_field(sediment_thickness, grid, "sediment_thickness", 0.0f);
  if (pinned && pinned->grid() != grid)
    throw InputError("pinned: its grid differs from rock_elevation's");

  const pipes::PaddedShape shape(grid.nx, grid.ny);
  std::vector<float> base(shape.size()), wear(shape.size()), code(shape.size(), pipes::kWall);
  std::vector<float> sediment(shape.size());
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      const std::size_t i = shape.index(r, c);
      base[i] = rock_elevation(r, c);
      sediment[i] = sediment_thickness(r, c);
      code[i] = pinned && (*pinned)(r, c) ? float(pipes::kPinned) : 0.0f;
    }
  std::vector<float> next = sediment;
  const auto tiles = pipes::make_tiles(shape, code.data());
  const pipes::SlideField<float> field{shape,
                                       &tiles,
                                       base.data(),
                                       wear.data(),
                                       code.data(),
                                       grid.cell_size,
                                       std::tan(radians(parameters.sediment_talus_angle_deg))};

  SlippageResult result{sediment_thickness, rock_elevation};
  context.run([&] {
    pipes::Slider<float> slider(tiles.size());
    result.sweeps = slider.settle(field, sediment, next, parameters.max_sweeps, context);
    result.steepest_excess = pipes::steepest_excess(field, sediment, context);
  });
  double change = 0.0;
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      const float thickness = sediment[shape.index(r, c)];
      change += double(thickness) - double(sediment_thickness(r, c));
      result.sediment_thickness(r, c) = thickness;
      result.elevation(r, c) = rock_elevation(r, c) + thickness;
    }
  result.residual_m3 = change * grid.cell_area();
  return result;
}

}  // namespace orogen
