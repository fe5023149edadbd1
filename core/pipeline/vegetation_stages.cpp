#include "pipeline/vegetation_stages.h"

#include "pipeline/make_stage.h"
#include "pipeline/stage_lists.h"

namespace orogen {

namespace {

const StageInfo& vegetation_stage() {
  static const StageInfo info{
      "vegetation",
      "Says how many trees and plants of the ground grow where; they are placed when asked for.",
      "Weiss 2015, VII-B and VII-C3; Matern 1960",
      {"elevation", "biome"},
      {"tree_density", "ground_cover_density"},
      {"plants"},
      {"water_depth", "snow_cover"}};
  return info;
}

void run_vegetation(PipelineState& state, Context& context,
                    const VegetationParameters& parameters) {
  const PlantGround ground = plant_ground(state.terrain);
  const Planting planting{state.inputs.plants, parameters, stage_seed(state.seed, "vegetation")};
  const auto density = [&](PlantLayer layer) {
    return plant_density(ground, table_of(planting, layer), {factor_of(planting, layer)}, context);
  };
  Raster<float> trees = density(PlantLayer::Trees), cover = density(PlantLayer::GroundCover);
  state.terrain.set("tree_density", std::move(trees));
  state.terrain.set("ground_cover_density", std::move(cover));
  state.products.set(planting);
}

}  // namespace

PlantGround plant_ground(const Terrain& terrain) {
  const auto find = [&](std::string_view name) {
    return terrain.has(name) ? &terrain.real(name) : nullptr;
  };
  return {terrain.real("elevation"), terrain.integer("biome"), find("water_depth"),
          find("snow_cover")};
}

void add_vegetation_stages(std::vector<Stage>& list) {
  list.push_back(make_stage(vegetation_stage(), {.by_default = DefaultFor::None, .cost = 0.1},
                            run_vegetation));
}

}  // namespace orogen
