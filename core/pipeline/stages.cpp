#include "pipeline/stages.h"

#include "pipeline/stage_lists.h"

namespace orogen {

void Products::add(const Products& other) {
  for (const auto& [type, value] : other.values_) values_.insert_or_assign(type, value);
}

Products Products::since(const Products& before) const {
  Products result;
  for (const auto& [type, value] : values_) {
    const auto old = before.values_.find(type);
    if (old == before.values_.end() || old->second != value) result.values_.emplace(type, value);
  }
  return result;
}

bool RecipeInputs::has(std::string_view input) const {
  if (input == "map") return map != nullptr;
  if (input == "phases") return !phases.empty();
  if (input == "column") return column.has_value();
  if (input == "fold_edits" || input == "rain" || input == "features" || input == "river_sources" ||
      input == "plants")
    return true;  // there may be none
  if (input.starts_with(kRasterInput)) {
    const std::string_view name = input.substr(kRasterInput.size());
    return rasters.contains(name) || find_given_raster(name)->otherwise;
  }
  throw std::logic_error("recipes have no input '" + std::string(input) + "'");
}

Raster<float> RecipeInputs::raster(std::string_view name, const Grid& grid,
                                   const Context& context) const {
  const auto found = rasters.find(name);
  return found == rasters.end() ? Raster<float>() : on_grid(*found->second, grid, context);
}

Raster<std::int32_t> RecipeInputs::labels(std::string_view name, const Grid& grid) const {
  const auto found = rasters.find(name);
  return found == rasters.end() ? Raster<std::int32_t>() : labels_on_grid(*found->second, grid);
}

std::span<const Stage> stages() {
  static const std::vector<Stage> all = [] {
    std::vector<Stage> list;
    add_land_stages(list);
    add_tectonics_stages(list);
    add_collision_stages(list);
    add_layered_folds_stage(list);
    add_relief_stages(list);
    add_island_stages(list);
    add_erosion_stages(list);
    add_law_stages(list);
    add_mountain_stages(list);
    add_given_stages(list);
    add_climate_stages(list);
    add_vegetation_stages(list);
    return list;
  }();
  return all;
}

const Stage* find_stage(std::string_view name) {
  for (const Stage& stage : stages())
    if (stage.info->name == name) return &stage;
  return nullptr;
}

}  // namespace orogen
