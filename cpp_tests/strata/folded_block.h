// A block of folded rock for tests: layers in anticlines and synclines along y.
#pragma once

#include <cmath>
#include <numbers>

#include "foundation/context.h"
#include "foundation/noise.h"
#include "strata/horizons.h"
#include "strata/section.h"

namespace orogen::test {

/// Three layers of two sub-layers each over a basement.
inline StratigraphicColumn three_layers() {
  const auto layer = [](const char* name, double thickness, Lithology low, Lithology high) {
    Layer l;
    l.name = name;
    l.thickness = thickness;
    l.sub_layers = {{1.0, low, {}}, {2.0, high, {}}};
    return l;
  };
  StratigraphicColumn column;
  column.basement = layer("basement", 4000.0, Lithology::Granite, Lithology::Gneiss);
  column.layers = {layer("old", 600.0, Lithology::Shale, Lithology::Sandstone),
                   layer("middle", 300.0, Lithology::Marl, Lithology::Limestone),
                   layer("young", 500.0, Lithology::Clay, Lithology::Conglomerate)};
  return column;
}

/// Horizons lifted by 1000 m and folded along x with this wavelength and amplitude; crest at x = 0.
inline HorizonStack folded(const StratigraphicColumn& column, const Grid& grid, double wavelength,
                           double amplitude, const Context& context) {
  HorizonStack stack = initial_horizons(column, grid, context);
  for (Raster<float>& horizon : stack.heights)
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c)
        horizon(r, c) += float(1000.0 + amplitude * std::cos(2.0 * std::numbers::pi *
                                                             grid.center(r, c).x / wavelength));
  return stack;
}

/// Folded layers under rough ground.
struct RoughBlock {
  Context context;
  StratigraphicColumn column = three_layers();
  RockTable rocks{column, {}, StrataPalette::Map};
  Grid grid{60, 40, 100.0, {2000.0, 1000.0}};
  HorizonStack horizons = folded(column, grid, 2500.0, 450.0, context);
  Raster<float> elevation = fbm({.seed = 3, .wavelength = 2000.0}, grid, context);
  RockBody body{horizons, rocks, elevation};

  RoughBlock() {
    for (float& z : elevation.values()) z = 500.0f + 300.0f * z;
  }
};

}  // namespace orogen::test
