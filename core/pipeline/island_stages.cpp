// Islands of paper B, from nothing or from a map's coasts.
#include "inputs/land_region.h"
#include "inputs/map_rasters.h"
#include "island/coast_fit.h"
#include "island/island_relief.h"
#include "pipeline/make_stage.h"
#include "pipeline/stage_lists.h"
#include "sculpting/feature_solver.h"

namespace orogen {

namespace {

constexpr double kLeastShoreSlope = 0.01;
constexpr const char* kSource = "Weiss 2015, chapter IV, eq. 1 to 4";

StageInfo island_info(std::string_view name, std::string_view text) {
  return {name,
          text,
          kSource,
          {},
          {"elevation", "land", "water_depth", "temperature", "moisture", "biome"},
          {"rasters.elevation_change", "rasters.temperature_change", "rasters.moisture_change"}};
}

const StageInfo& island_stage() {
  static const StageInfo info = island_info(
      "island", "Grows an island on a polygon map: heights, lakes, climate and biomes.");
  return info;
}

const StageInfo& mapped_island_stage() {
  static const StageInfo info = [] {
    StageInfo made =
        island_info("mapped_island", "Grows islands on a polygon map where the map has land.");
    made.inputs.push_back("map");
    return made;
  }();
  return info;
}

/// Changes by hand over the extent.
IslandInputs edits_of(const RecipeInputs& inputs, const Grid& grid) {
  const auto change = [&](std::string_view name) -> std::function<double(glm::dvec2)> {
    const auto found = inputs.rasters.find(name);
    if (found == inputs.rasters.end()) return {};
    return [given = found->second, grid](glm::dvec2 p) {
      return value_at(*given, (p - grid.origin) / glm::dvec2(grid.width(), grid.height()));
    };
  };
  return {{}, change("elevation_change"), change("temperature_change"), change("moisture_change")};
}

const StageInfo& feature_curves_stage() {
  static const StageInfo info{"feature_curves",
                              "Bends the ground to the feature curves that the recipe gives.",
                              "Weiss 2015, chapter V, eq. 5 to 9",
                              {"elevation", "land"},
                              {"elevation", "land"},
                              {"features"}};
  return info;
}

void set_relief(PipelineState& state, IslandRelief made, Context& context) {
  set_land(state, std::move(made.land), context);
  state.terrain.set("elevation", std::move(made.elevation));
  state.terrain.set("water_depth", std::move(made.water_depth));
  state.terrain.set("temperature", std::move(made.temperature));
  state.terrain.set("moisture", std::move(made.moisture));
  state.terrain.set("biome", std::move(made.biome));
}

IslandRelief grow(PipelineState& state, Context& context, const IslandInputs& inputs,
                  const IslandParameters& parameters, const IslandReliefParameters& relief) {
  const Grid& grid = state.terrain.grid();
  const glm::dvec2 high = grid.origin + glm::dvec2(grid.width(), grid.height());
  const auto made = state.products.set(make_island(
      parameters, grid.origin, high, stage_seed(state.seed, "island"), inputs, context));
  context.report(0.3);
  return island_relief(*made, relief, grid, stage_seed(state.seed, "island_relief"), context);
}

void run_island(PipelineState& state, Context& context, const IslandParameters& parameters,
                const IslandReliefParameters& relief) {
  const IslandInputs inputs = edits_of(state.inputs, state.terrain.grid());
  set_relief(state, grow(state, context, inputs, parameters, relief), context);
}

void run_mapped_island(PipelineState& state, Context& context, const IslandParameters& parameters,
                       const IslandReliefParameters& relief) {
  const Grid& grid = state.terrain.grid();
  const LandRegion region(*state.inputs.map);
  IslandInputs inputs = edits_of(state.inputs, grid);
  inputs.is_land = [&](glm::dvec2 p) { return region.on_land(p) && region.lake_at(p) < 0; };
  IslandRelief made = grow(state, context, inputs, parameters, relief);
  made.land = land_mask(*state.inputs.map, grid, context);
  const double polygon = std::sqrt(grid.width() * grid.height() / parameters.cells);
  fit_coast(made.elevation, made.land, polygon, kLeastShoreSlope, context);
  set_relief(state, std::move(made), context);
}

void run_feature_curves(PipelineState& state, Context& context,
                        const FeatureParameters& parameters) {
  context.check();
  Raster<float> elevation = state.terrain.real("elevation");
  Raster<std::uint8_t> land = state.products.get<LandMask>().land;
  const auto constraints =
      feature_constraints(state.inputs.features, state.terrain.grid(), context);
  apply_features(elevation, constraints, parameters, context);
  for (std::size_t i = 0; i < land.size(); ++i)
    if (constraints.zone[i] && elevation[i] > 0.0f) land[i] = 1;
  set_land(state, std::move(land), context);
  state.terrain.set("elevation", std::move(elevation));
}

}  // namespace

void add_island_stages(std::vector<Stage>& list) {
  constexpr double working = 60.0;
  list.push_back(make_stage(island_stage(),
                            {.by_default = DefaultFor::Islands,
                             .working_bytes_per_cell = working,
                             .product_bytes_per_cell = 1.0},
                            run_island));
  list.push_back(make_stage(mapped_island_stage(),
                            {.by_default = DefaultFor::None,
                             .working_bytes_per_cell = working,
                             .product_bytes_per_cell = 1.0},
                            run_mapped_island));
  list.push_back(make_stage(feature_curves_stage(),
                            {.by_default = DefaultFor::Islands,
                             .cost = 0.5,
                             .working_bytes_per_cell = 160.0,
                             .product_bytes_per_cell = 1.0},
                            run_feature_curves));
}

}  // namespace orogen
