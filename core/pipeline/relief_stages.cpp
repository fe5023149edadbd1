// Land and sea, and the first relief.
#include "foundation/parallel.h"
#include "hydrology/river_beds.h"
#include "hydrology/watershed_map.h"
#include "inputs/map_rasters.h"
#include "pipeline/make_stage.h"
#include "pipeline/stage_lists.h"
#include "sculpting/combination.h"

namespace orogen {

namespace {

const StageInfo& land_stage() {
  static const StageInfo info{"land",
                              "Marks the cells whose centres lie inside the map's coasts.",
                              "Michel, Emilien and Cani 2015, section 3, step 1",
                              {},
                              {"land"},
                              {"map"}};
  return info;
}

const StageInfo& rivers_stage() {
  static const StageInfo info{"rivers",
                              "Lays the beds of the map's rivers from cell to cell.",
                              "Michel, Emilien and Cani 2015, section 3, step 4",
                              {"land"},
                              {"river"},
                              {"map"}};
  return info;
}

const StageInfo& combined_ground_stage() {
  static const StageInfo info{"combined_ground",
                              "Takes the combined relief as it is for the ground.",
                              "Michel, Emilien and Cani 2015, section 6",
                              {"combined_relief"},
                              {"elevation"}};
  return info;
}

void run_land(PipelineState& state, Context& context) {
  set_land(state, land_mask(*state.inputs.map, state.terrain.grid(), context), context);
}

void run_rivers(PipelineState& state, Context& context, const RiverBedParameters& parameters) {
  context.check();
  const auto made = state.products.set(lay_river_beds(
      *state.inputs.map, state.products.get<LandMask>().land, parameters.river_wander,
      parameters.wander_wavelength, stage_seed(state.seed, "rivers")));
  state.terrain.set("river", part_of(made, made->river));
}

void run_watershed(PipelineState& state, Context& context, const WatershedParameters& parameters) {
  const auto made = state.products.set(watershed_map(
      *state.inputs.map, state.products.get<RiverBeds>(), state.products.get<LandMask>().land,
      state.terrain.real("peak_distance"), parameters, context));
  state.terrain.set("watershed_elevation", part_of(made, made->elevation));
  state.terrain.set("river_distance", part_of(made, made->river_distance));
}

void run_combination(PipelineState& state, Context& context,
                     const CombinationParameters& parameters) {
  state.terrain.set(
      "combined_relief",
      combine_relief(state.terrain.real("fold_relief"), state.products.get<WatershedMap>(),
                     state.products.get<LandMask>().land, parameters, context));
}

void run_combined_ground(PipelineState& state, Context& context) {
  context.check();
  state.terrain.set("elevation", state.terrain.field("combined_relief"));
}

}  // namespace

void set_land(PipelineState& state, Raster<std::uint8_t> land, const Context& context) {
  const auto made = state.products.set(LandMask{std::move(land)});
  Raster<std::int32_t> field(made->land.grid());
  parallel_chunks(context, field.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) field[i] = made->land[i];
  });
  state.terrain.set("land", std::move(field));
}

void add_land_stages(std::vector<Stage>& list) {
  list.push_back(make_stage(land_stage(), {.cost = 0.02, .product_bytes_per_cell = 1.0}, run_land));
  list.push_back(
      make_stage(rivers_stage(), {.cost = 0.02, .working_bytes_per_cell = 8.0}, run_rivers));
}

void add_relief_stages(std::vector<Stage>& list) {
  list.push_back(make_stage(
      watershed_stage(),
      {.cost = 0.5, .working_bytes_per_cell = 44.0, .product_bytes_per_cell = 4.0}, run_watershed));
  list.push_back(make_stage(combination_stage(), {.cost = 0.15, .working_bytes_per_cell = 32.0},
                            run_combination));
  list.push_back(make_stage(combined_ground_stage(), {.by_default = DefaultFor::None, .cost = 0.01},
                            run_combined_ground));
}

}  // namespace orogen
