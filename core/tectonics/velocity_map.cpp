#include "tectonics/velocity_map.h"

#include "foundation/gaussian_blur.h"
#include "foundation/parallel.h"

namespace orogen {

VelocityMap velocity_map(const PlateMap& plates, const VelocityParameters& parameters,
                         const Context& context) {
  check_parameters(parameters, "velocity");
  const Grid& grid = plates.plate.grid();
  VelocityMap result{Raster<float>(grid), Raster<float>(grid)};
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const glm::dvec2 v = plates.plates[plates.plate(r, c)].velocity_at(grid.center(r, c));
      result.velocity_x(r, c) = float(v.x);
      result.velocity_y(r, c) = float(v.y);
    }
  });
  result.velocity_x = gaussian_blur(result.velocity_x, parameters.velocity_blur, context);
  result.velocity_y = gaussian_blur(result.velocity_y, parameters.velocity_blur, context);
  return result;
}

const StageInfo& velocity_stage() {
  static const StageInfo info{"velocity",
                              "Smooths the velocities of the plates.",
                              "Michel, Emilien and Cani 2015, section 5, \"Velocity map\"",
                              {"plate"},
                              {"velocity_x", "velocity_y"}};
  return info;
}

}  // namespace orogen
