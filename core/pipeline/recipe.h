// A recipe: everything that determines a terrain, as a versioned JSON document (*.orogen.json).
//
//   {"orogen": 1,                        format version
//    "name": "corsica",
//    "seed": 1,                          0 to 4294967295
//    "resolution": 1024,                 cells along the longer side
//    "extent": {"origin": [x, y], "size": [w, h]},   m, in the map's projection; default: its frame
//    "map": {GeoJSON} or {"file": "path relative to the recipe"},
//    "phases": [{"years": 5e6, "plates": [...]}, ...],             moving plates (recipe_inputs.h)
//    "column": {"preset": "jura"} or {"basement": ..., "layers": [...]},
//    "rain": [[1, 2], [1, 2]],                                     weights from the south-west
//    "rasters": {"uplift_factor": [[1, 2], [1, 1]], ...},          fields given (raster_inputs.h)
//    "fold_edits": [{"edit": "add", ...}, ...],                    folds changed by hand
//    "features": [{"points": [...]}, ...],             feature curves (feature_inputs.h)
//    "river_sources": [{"name": "Spring", "position": [x, y], "discharge": 50}, ...],   m, m³/s
//    "plants": {"trees": {...}, "ground_cover": {...}},   what grows (plant_inputs.h)
//    "stages": [{"stage": "plates", "parameters": {...}}, ...]}
//        default: those of paper A with a map, of paper C with phases, those that erode the raster
//        `elevation` with it, else those of paper B's island
//
// `orogen` must be there, `extent` where there is no map, and what the stages need; parameters not
// named keep their defaults. Reading is strict:
// an unknown key, a wrong type, a stage that reads what no stage before it writes is an InputError
// that begins with the place (`stages[2].parameters.fold_wavelength: ...`).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "inputs/check_map.h"
#include "inputs/vector_map.h"
#include "pipeline/stages.h"

namespace orogen {

inline constexpr int kRecipeVersion = 1;
inline constexpr int kMinResolution = 2;
inline constexpr int kMaxResolution = 65536;

struct Extent {
  glm::dvec2 origin{0.0, 0.0};  // m, lower-left corner
  glm::dvec2 size{0.0, 0.0};    // m
};

struct RecipeStage {
  std::string stage;
  ParameterSet parameters;  // those that were set
};

struct Recipe {
  std::string name;
  std::uint32_t seed = 1;
  int resolution = 1024;
  std::optional<Extent> extent;
  RecipeInputs inputs;
  std::map<std::string, std::string, std::less<>> documents;  // each input's JSON, canonical
  std::vector<RecipeStage> stages;
};

struct RecipeSource {
  std::filesystem::path folder;  // of the recipe, for the map's file
  std::string name;              // when the document gives none
  ReadOptions map_options;
};

/// Reads a recipe, or a bare GeoJSON map, for which it makes the default recipe.
Recipe read_recipe(std::string_view json, const RecipeSource& source = {});
Recipe load_recipe(const std::filesystem::path& file, const ReadOptions& map_options = {});

/// The recipe of paper A for a map: every stage of `default_stages` with its defaults.
Recipe default_recipe(const VectorMap& map);
std::vector<RecipeStage> default_stages(DefaultFor recipe = DefaultFor::Maps);

/// Canonical JSON: keys sorted, numbers as short as they can be, the map inline. Equal recipes give
/// equal text. `indent` < 0: one line.
std::string write_recipe(const Recipe& recipe, int indent = -1);

/// SHA-256 of the canonical JSON on one line.
std::string recipe_hash(const Recipe& recipe);

/// The grid on which the recipe is computed; `resolution` 0: the recipe's own.
Grid recipe_grid(const Recipe& recipe, int resolution = 0);

/// InputError, beginning with the place, if a stage is unknown, its parameters are wrong, it reads
/// a field that no stage before it writes, it needs an input that the recipe lacks, or a fold edit
/// is for a layer or phase that there is not.
void check_stages(const std::vector<RecipeStage>& stages, const RecipeInputs& inputs);

}  // namespace orogen
