// The folded rocks of a terrain at one time: what sections, meshes and volumes are cut from.
#pragma once

#include "foundation/bilinear.h"
#include "foundation/raster.h"
#include "strata/horizons.h"

namespace orogen {

/// A column, and where its horizons have come to lie.
struct Strata {
  StratigraphicColumn column;
  RockTable rocks;
  HorizonStack horizons;
};

/// Strata under a ground. Nothing is owned; `rocks` and `horizons` belong together.
struct RockBody {
  const HorizonStack& horizons;
  const RockTable& rocks;
  const Raster<float>& elevation;

  /// Height of the ground at a place, bilinearly.
  float ground_at(glm::dvec2 position) const {
    return float(bilinear_at(elevation.grid(), position)(elevation));
  }
};

}  // namespace orogen
