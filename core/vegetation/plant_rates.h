// How many plants must be tried for a table's numbers to be left when spacing has taken its part
// (see vegetation/placement.h).
#pragma once

#include <array>
#include <vector>

#include "vegetation/plant_table.h"

namespace orogen {

struct PlantRates {
  /// Of each biome: tries a m² of kinds 0 to k, summed.
  std::array<std::vector<double>, kBiomes> up_to_kind;
  double most = 0.0;  // of all kinds, in the biome that has most

  double of_biome(std::size_t biome) const {
    return up_to_kind[biome].empty() ? 0.0 : up_to_kind[biome].back();
  }
};

/// Plants a m² that the table asks for of each kind in a biome, times `factor`.
std::vector<double> wanted_plants(const PlantTable& table, std::size_t biome, double factor);

/// Of the biomes that are there; those of others are 0. InputError if so many cannot stand at their
/// spacing.
PlantRates plant_rates(const PlantTable& table, double factor,
                       const std::array<bool, kBiomes>& there);

}  // namespace orogen
