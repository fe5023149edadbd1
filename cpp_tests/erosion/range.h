// A small range to grow: two layers on a basement.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "erosion/mountain_growth.h"

namespace orogen {

/// A basement under two layers: weak below, hard on top, with beds.
inline StratigraphicColumn column_of_two() {
  const auto layer = [](double thickness, std::vector<SubLayer> beds) {
    Layer l;
    l.thickness = thickness;
    l.sub_layers = std::move(beds);
    return l;
  };
  StratigraphicColumn column;
  column.basement = layer(4000.0, {{1.0, Lithology::Granite, {}}});
  column.layers = {layer(500.0, {{1.0, Lithology::Marl, {}}}),
                   layer(300.0, {{1.0, Lithology::Limestone, {}}, {1.0, Lithology::Marl, {}}})};
  return column;
}

/// A range along the middle of a square of 20 km.
struct Range {
  Context context;
  Grid grid{80, 80, 250.0, {1000.0, -2000.0}};
  StratigraphicColumn column = column_of_two();
  RockStrengthParameters strength;
  RockTable rocks{column, strength, StrataPalette::Map};
  HorizonStack horizons = initial_horizons(column, grid, context);
  Raster<float> crust{grid}, fold{grid};
  MountainGrowthInput input{horizons, rocks, {}};
  MountainGrowthParameters parameters;

  Range() {
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        const double y = (r + 0.5) / grid.ny;
        crust(r, c) = y > 0.25 && y < 0.75 ? 5e-4f : 0.0f;
        fold(r, c) = float(crust(r, c) * 0.2 * (1.0 + std::cos(20.0 * y)));
      }
    input.phases.push_back({.years = 2e6, .crust = &crust, .folds = {nullptr, &fold}});
    parameters.steps = 20;
    parameters.coarse_levels = 1;
  }
  MountainGrowth grow(std::uint32_t seed = 1) {
    return grow_mountains(input, parameters, seed, context);
  }
};

}  // namespace orogen
