// Runs a recipe.
//
// Each stage's result is kept in a Cache under the SHA-256 of: the version of the program, the
// grid, the map, the seed, the stage's name and every parameter, and the keys of the results it
// reads. So a changed parameter recomputes its own stage and those that read from it, no others.
//
// Before anything is allocated the memory is estimated:
//   cells * (bytes of all fields written + largest working memory of a stage) + a fixed part,
// and refused beyond the limit with both figures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foundation/context.h"
#include "pipeline/cache.h"
#include "pipeline/recipe.h"
#include "pipeline/terrain.h"

namespace orogen {

/// The work would need more memory than is allowed.
class MemoryLimitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct GenerateOptions {
  int resolution = 0;                  // cells along the longer side; 0: the recipe's
  std::optional<std::uint32_t> seed;   // in place of the recipe's
  std::size_t memory_limit_bytes = 0;  // 0: what the machine has available
  GrowthWatch* watch = nullptr;        // looks on while mountains grow or are worn; not on cached ones
};

struct StageTime {
  std::string stage;
  double seconds = 0.0;
  bool cached = false;
};

struct Generated {
  Terrain terrain;
  Products products;
  std::uint32_t seed = 0;
  std::vector<StageTime> stages;
  std::size_t estimated_bytes = 0;
  std::vector<std::string> warnings;  // what in the recipe had no effect
};

/// InputError, MemoryLimitError, Cancelled.
Generated generate(const Recipe& recipe, const GenerateOptions& options, Context& context,
                   Cache* cache = nullptr);

/// Peak memory in bytes for a recipe on a grid, beyond what the process holds already.
std::size_t estimate_memory(const std::vector<RecipeStage>& stages, const Grid& grid);

/// Memory the machine (or its control group) can still give, in bytes.
std::size_t available_memory();

}  // namespace orogen
