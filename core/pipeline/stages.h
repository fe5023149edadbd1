// The stages that a recipe may name, in the order in which they usually run.
//
// A stage reads fields (and the map), and writes fields, as its StageInfo says. What is not a field
// (the outlines of plates, river beds) travels in Products; whoever reads a product reads the field
// that was written with it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

#include "erosion/growth_watch.h"
#include "folding/fold_edits.h"
#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/stage.h"
#include "inputs/feature_curve.h"
#include "inputs/plate_gesture.h"
#include "inputs/river_source.h"
#include "inputs/vector_map.h"
#include "pipeline/raster_inputs.h"
#include "pipeline/terrain.h"
#include "strata/column.h"
#include "vegetation/planting.h"

namespace orogen {

/// Results beyond fields, at most one of each type; shared and constant like fields.
class Products {
 public:
  /// std::out_of_range if no stage has made one.
  template <class T>
  const T& get() const {
    const auto found = values_.find(typeid(T));
    if (found == values_.end())
      throw std::out_of_range(std::string("no stage has made ") + typeid(T).name());
    return *static_cast<const T*>(found->second.get());
  }

  /// nullptr if no stage has made one.
  template <class T>
  std::shared_ptr<const T> find() const {
    const auto found = values_.find(typeid(T));
    if (found == values_.end()) return nullptr;
    return std::static_pointer_cast<const T>(found->second);
  }

  template <class T>
  std::shared_ptr<const T> set(T value) {
    auto shared = std::make_shared<const T>(std::move(value));
    values_.insert_or_assign(typeid(T), shared);
    return shared;
  }

  /// Takes over everything in `other`.
  void add(const Products& other);
  /// What differs from `before`.
  Products since(const Products& before) const;

 private:
  std::map<std::type_index, std::shared_ptr<const void>> values_;
};

/// A change by hand to the folds of one layer in one phase.
struct LayerFoldEdit {
  int phase = 0, layer = 0;  // from 0, layers from the bottom
  FoldEdit edit;
};

/// A stage's input that begins so is a raster.
inline constexpr std::string_view kRasterInput = "rasters.";

/// What a recipe gives beside its stages.
struct RecipeInputs {
  std::shared_ptr<const VectorMap> map;  // may be missing
  std::vector<MotionPhase> phases;       // may be empty
  std::optional<StratigraphicColumn> column;
  std::vector<LayerFoldEdit> fold_edits;   // may be empty
  std::optional<CornerMap> rain;           // only ratios count; the same everywhere if missing
  GivenRasters rasters;                    // may be empty
  std::vector<FeatureCurve> features;      // may be empty
  std::vector<RiverSource> river_sources;  // may be empty
  PlantTables plants;                      // the built-in ones, with the recipe's changes

  bool has(std::string_view input) const;
  /// A raster on the terrain's grid; empty if the recipe has none of that name.
  Raster<float> raster(std::string_view name, const Grid& grid, const Context& context) const;
  /// A raster of labels, likewise.
  Raster<std::int32_t> labels(std::string_view name, const Grid& grid) const;
};

/// What a stage works on.
struct PipelineState {
  RecipeInputs inputs;
  std::uint32_t seed = 0;
  Terrain terrain;
  Products products;
  GrowthWatch* watch = nullptr;  // looks on while mountains grow, or water wears them
};

/// Parameters by name; those not named keep their defaults.
using ParameterSet = std::map<std::string, ParameterValue, std::less<>>;

/// The default recipes that a stage is part of, as bits.
enum DefaultFor : unsigned { None = 0, Maps = 1, Collisions = 2, Heights = 4, Islands = 8 };

struct Stage {
  const StageInfo* info = nullptr;
  std::vector<ParameterInfo> parameters;
  unsigned by_default = DefaultFor::Maps;
  double cost = 1.0;                    // time beside the other stages', for progress
  double working_bytes_per_cell = 0.0;  // held while it runs, beside the fields it writes
  double product_bytes_per_cell = 0.0;  // held afterwards, beside them

  /// Every parameter with its value. InputError, beginning with `place`, if one is unknown, of a
  /// wrong type or out of range.
  std::function<ParameterSet(const ParameterSet&, std::string_view place)> complete;
  /// `parameters` are complete.
  std::function<void(PipelineState&, const ParameterSet& parameters, Context&)> run;
};

std::span<const Stage> stages();

/// nullptr if there is none of that name.
const Stage* find_stage(std::string_view name);

}  // namespace orogen
