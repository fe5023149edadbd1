// What the stages of colliding plates hand to each other beside fields.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "folding/fold_layers.h"
#include "pipeline/stages.h"
#include "strata/horizons.h"
#include "tectonics/collision_uplift.h"
#include "tectonics/fault_dip.h"
#include "tectonics/ground_shift.h"
#include "tectonics/isostasy.h"

namespace orogen {

/// Product of `collision` and `map_collision`, phase by phase.
struct CollisionPhase {
  double years = 0.0;
  CompressionField compression;   // as folds feel it
  double mean_compression = 1.0;  // |C| where the crust rises
  CollisionUplift uplift;
  GroundShift shift;                  // by later phases; what follows is at its last place
  Raster<float> rise;                 // m/yr, of the basement: with margins and isostasy
  std::optional<FaultMotion> motion;  // of a dipping fault
};
struct CollisionPhases {
  std::vector<CollisionPhase> phases;
  double target_uplift_rate = 0.0;  // m/yr
  IsostasyParameters isostasy;

  double years() const {
    double sum = 0.0;
    for (const CollisionPhase& phase : phases) sum += phase.years;
    return sum;
  }
};

/// Product of the stage `fold_layers`: layer by layer in each phase. Speeds are at their last
/// places, skeletons where their phase left them.
struct FoldedPhases {
  std::vector<std::vector<FoldedLayer>> phases;
};

/// A line for each of the recipe's fold edits that changed nothing, and why.
std::vector<std::string> fold_edit_warnings(const RecipeInputs& inputs, const FoldedPhases& folds);

/// Product of `mountain_growth` and `map_strata`.
struct GrownHorizons {
  HorizonStack horizons;
  RockStrengthParameters strength;
  double years = 0.0;
  Raster<float> sediment{};           // m, that rivers laid down; empty: none
  double sediment_erodibility = 0.0;  // m^(1-2m)/yr
};

}  // namespace orogen
