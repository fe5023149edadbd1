// Paper C: mountains that grow and erode, and the rock that crops out.
#include <algorithm>
#include <cmath>

#include "erosion/mountain_growth.h"
#include "folding/fold_pattern.h"
#include "folding/warped_folds.h"
#include "foundation/raster_sums.h"
#include "pipeline/collision_products.h"
#include "pipeline/make_stage.h"
#include "pipeline/stage_lists.h"
#include "strata/map_strata.h"
#include "strata/outcrop.h"
#include "strata/rock_detail.h"

namespace orogen {

namespace {

const StageInfo& layered_folds_stage() {
  static const StageInfo info{
      "layered_folds",
      "Makes the relief of a map's folds from the folds of its layers.",
      "Michel, Emilien and Cani 2015, section 5; folds of Cordonnier et al. 2018, section 5",
      {"plate", "peak_distance", "boundary_distance", "convergence", "velocity_x", "velocity_y",
       "fold_uplift_rate"},
      {"fold_relief"},
      {"map"}};
  return info;
}

void run_layered_folds(PipelineState& state, Context& context, const FoldParameters& parameters) {
  const Products& made = state.products;
  const Raster<float> pattern = fold_pattern(state.terrain.real("fold_uplift_rate"));
  state.terrain.set("fold_relief",
                    warped_folds(*state.inputs.map, made.get<PlateMap>(), made.get<BoundaryMap>(),
                                 made.get<VelocityMap>(), parameters,
                                 stage_seed(state.seed, "folds"), context, &pattern));
}

/// Where a stage before drew the sea; empty: nowhere.
Raster<std::uint8_t> drawn_sea(const Terrain& terrain) {
  if (!terrain.has("land")) return {};
  const Raster<std::int32_t>& land = terrain.integer("land");
  Raster<std::uint8_t> sea(land.grid());
  for (std::size_t i = 0; i < sea.size(); ++i) sea[i] = land[i] == 0;
  return sea;
}

/// A recipe's rain, over its mean; empty: the same everywhere.
Raster<float> relative_rain(const std::optional<CornerMap>& rain, const Grid& grid,
                            const Context& context) {
  if (!rain) return {};
  Raster<float> weights = on_grid(*rain, grid, context);
  double sum = 0.0;
  for (const float weight : weights.values()) sum += weight;
  for (float& weight : weights.values()) weight *= float(double(grid.size()) / sum);
  return weights;
}

void run_mountain_growth(PipelineState& state, Context& context,
                         const MountainGrowthParameters& parameters,
                         const RockStrengthParameters& strength) {
  const StratigraphicColumn& column = *state.inputs.column;
  const auto& collision = state.products.get<CollisionPhases>();
  const auto& folds = state.products.get<FoldedPhases>();
  const HorizonStack horizons = initial_horizons(column, state.terrain.grid(), context);
  const RockTable rocks(column, strength, StrataPalette::Natural);
  MountainGrowthInput input{horizons, rocks, {}};
  input.isostasy = collision.isostasy;
  input.watch = state.watch;
  const Raster<std::uint8_t> sea = drawn_sea(state.terrain);
  const Raster<float> rain = relative_rain(state.inputs.rain, state.terrain.grid(), context);
  if (!sea.empty()) input.sea = &sea;
  if (!rain.empty()) input.rain = &rain;
  const Grid& grid = state.terrain.grid();
  const Raster<float> uplift_factor = state.inputs.raster("uplift_factor", grid, context);
  const Raster<float> rock_factor = state.inputs.raster("erodibility_factor", grid, context);
  if (!uplift_factor.empty()) input.uplift_factor = &uplift_factor;
  if (!rock_factor.empty()) input.erodibility_factor = &rock_factor;
  for (std::size_t p = 0; p < collision.phases.size(); ++p) {
    UpliftPhase& phase = input.phases.emplace_back();
    phase.years = collision.phases[p].years;
    phase.crust = &collision.phases[p].rise;
    if (const auto& motion = collision.phases[p].motion) {
      phase.velocity_x = &motion->velocity_x;
      phase.velocity_y = &motion->velocity_y;
    }
    for (const FoldedLayer& layer : folds.phases[p])
      phase.folds.push_back(layer.speed.empty() ? nullptr : &layer.speed);
  }
  auto made = grow_mountains(input, parameters, stage_seed(state.seed, "mountain_growth"), context);
  GrownHorizons grown{std::move(made.horizons), strength, made.years};
  if (parameters.deposition_coefficient > 0.0) {
    grown.sediment = made.sediment_thickness;
    grown.sediment_erodibility =
        parameters.sediment_erodibility_factor * rocks.erodibility(loose_sediment(rocks));
  }
  state.products.set(std::move(grown));
  state.products.set(GrowthFrames{std::move(made.frames)});
  state.products.set(std::move(made.tin));
  state.terrain.set("elevation", std::move(made.elevation));
  state.terrain.set("uplift_rate", std::move(made.uplift_rate));
  state.terrain.set("drainage_area", std::move(made.drainage_area));
  state.terrain.set("exhumation", std::move(made.exhumation));
  state.terrain.set("sediment_thickness", std::move(made.sediment_thickness));
}

void run_rock_detail(PipelineState& state, Context& context,
                     const RockDetailParameters& parameters) {
  const auto& grown = state.products.get<GrownHorizons>();
  const StratigraphicColumn& column = *state.inputs.column;
  const RockTable rocks(column, grown.strength, StrataPalette::Natural);
  const Raster<float>& smooth = state.terrain.real("elevation");
  Raster<float> detailed = add_rock_detail({grown.horizons, rocks, smooth}, column, parameters,
                                           stage_seed(state.seed, "rock_detail"), context);
  for (std::size_t i = 0; i < grown.sediment.size(); ++i) {  // which lies smoothly over ledges
    const float hidden = std::min(grown.sediment[i] / kHidingSediment, 1.0f);
    detailed[i] += hidden * (smooth[i] - detailed[i]);
  }
  state.terrain.set("elevation", std::move(detailed));
}

/// Sediment that rivers laid down, where it hides the rock.
void cover_outcrop(OutcropMap& map, const GrownHorizons& grown, const RockTable& rocks) {
  const Rock loose = loose_sediment(rocks);
  for (std::size_t i = 0; i < grown.sediment.size(); ++i) {
    if (grown.sediment[i] < kHidingSediment) continue;
    map.rock_layer[i] = loose.layer;
    map.rock_sublayer[i] = loose.sub_layer;
    map.strata_color[i] = std::int32_t(rocks.color(loose));
    map.erodibility[i] = float(grown.sediment_erodibility);
    map.age[i] = 0.0f;
  }
}

/// Sediment that is deep enough to be seen; empty if there is none.
Raster<float> seen_sediment(Raster<float> sediment) {
  for (float& depth : sediment.values())
    if (depth < kHidingSediment) depth = 0.0f;
  return sediment;
}

void run_outcrop(PipelineState& state, Context& context, const OutcropParameters& parameters) {
  const auto& grown = state.products.get<GrownHorizons>();
  const auto strata =
      state.products.set(Strata{*state.inputs.column,
                                {*state.inputs.column, grown.strength, parameters.palette},
                                grown.horizons,
                                seen_sediment(grown.sediment)});
  OutcropMap map = outcrop_map(strata->horizons, strata->rocks, state.terrain.real("elevation"),
                               grown.years, parameters, context);
  cover_outcrop(map, grown, strata->rocks);
  state.terrain.set("rock_layer", std::move(map.rock_layer));
  state.terrain.set("rock_sublayer", std::move(map.rock_sublayer));
  state.terrain.set("strata_color", std::move(map.strata_color));
  state.terrain.set("erodibility", std::move(map.erodibility));
  state.terrain.set("age", std::move(map.age));
}

void run_map_strata(PipelineState& state, Context& context, const MapStrataParameters& parameters,
                    const RockStrengthParameters& strength) {
  const auto& collision = state.products.get<CollisionPhases>();
  const StratigraphicColumn& column = *state.inputs.column;
  std::vector<Raster<float>> folds;
  for (std::size_t k = 0; k < column.layers.size(); ++k) {
    Raster<float>& height = folds.emplace_back(state.terrain.grid());
    for (std::size_t p = 0; p < collision.phases.size(); ++p) {
      const Raster<float>& speed = state.products.get<FoldedPhases>().phases[p][k].speed;
      if (!speed.empty()) add_weighted(height, speed, collision.phases[p].years);
    }
  }
  HorizonStack horizons =
      map_horizons(column, state.terrain.real("elevation"), folds, parameters, context);
  Raster<float> exhumation = horizons.heights.back();
  const Raster<float>& ground = state.terrain.real("elevation");
  for (std::size_t i = 0; i < exhumation.size(); ++i)
    exhumation[i] = std::max(exhumation[i] - ground[i], 0.0f);
  state.terrain.set("exhumation", std::move(exhumation));
  state.products.set(GrownHorizons{std::move(horizons), strength, collision.years()});
}

}  // namespace

void add_layered_folds_stage(std::vector<Stage>& list) {
  list.push_back(
      make_stage(layered_folds_stage(),
                 {.by_default = DefaultFor::None, .cost = 0.07, .working_bytes_per_cell = 16.0},
                 run_layered_folds));
}

void add_mountain_stages(std::vector<Stage>& list) {
  const auto by_default = DefaultFor::Collisions;
  list.push_back(make_stage(map_strata_stage(),
                            {.by_default = DefaultFor::None,
                             .cost = 0.1,
                             .working_bytes_per_cell = 40.0,
                             .product_bytes_per_cell = 20.0},
                            run_map_strata));
  list.push_back(make_stage(mountain_growth_stage(),
                            {.by_default = by_default,
                             .cost = 30.0,
                             .working_bytes_per_cell = 400.0,
                             .product_bytes_per_cell = 150.0},
                            run_mountain_growth));
  list.push_back(make_stage(rock_detail_stage(),
                            {.by_default = by_default, .cost = 0.3, .working_bytes_per_cell = 8.0},
                            run_rock_detail));
  list.push_back(make_stage(outcrop_stage(),
                            {.by_default = by_default,
                             .cost = 0.1,
                             .working_bytes_per_cell = 4.0,
                             .product_bytes_per_cell = 20.0},
                            run_outcrop));
}

}  // namespace orogen
