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
  Raster<float> sediment;  // m of it, loose, on the rock; empty: none
};

/// Strata under a ground. Nothing is owned; `rocks` and `horizons` belong together.
struct RockBody {
  const HorizonStack& horizons;
  const RockTable& rocks;
  const Raster<float>& elevation;
  const Raster<float>* sediment = nullptr;  // m of it on the rock; nullptr: none

  /// Height of the ground at a place, bilinearly.
  float ground_at(glm::dvec2 position) const {
    return float(bilinear_at(elevation.grid(), position)(elevation));
  }
  /// Height of the rock under the sediment at a place with this ground.
  float rock_top_at(glm::dvec2 position, float ground) const {
    if (!sediment) return ground;
    return ground - float(bilinear_at(sediment->grid(), position)(*sediment));
  }
  /// Rock at height z in a place with these horizons, whose rock ends at `rock_top`.
  Rock rock_at(const float* h, float z, float rock_top) const {
    const bool loose = sediment && z > rock_top + kSedimentGap;
    return loose ? loose_sediment(rocks) : rocks.rock_at(h, z);
  }
};

}  // namespace orogen
