// What wears the relief down, and the last word of the map.
#include "erosion/relief_growth.h"
#include "erosion/virtual_pipes.h"
#include "foundation/distance_transform.h"
#include "pipeline/make_stage.h"
#include "pipeline/stage_lists.h"
#include "sculpting/map_law.h"
#include "sculpting/sea_floor.h"

namespace orogen {

namespace {

void run_relief_growth(PipelineState& state, Context& context,
                       const ReliefGrowthParameters& parameters) {
  const Grid& grid = state.terrain.grid();
  const Raster<float> aim = state.inputs.raster("uplift_factor", grid, context);
  const Raster<float> rock = state.inputs.raster("erodibility_factor", grid, context);
  auto made = grow_relief(*state.inputs.map, state.terrain.real("combined_relief"),
                          state.products.get<LandMask>().land, state.products.get<RiverBeds>(),
                          parameters, stage_seed(state.seed, "relief_growth"), context,
                          {aim.empty() ? nullptr : &aim, rock.empty() ? nullptr : &rock});
  state.terrain.set("elevation", std::move(made.elevation));
  state.terrain.set("uplift_rate", std::move(made.uplift_rate));
  state.terrain.set("erodibility", std::move(made.erodibility));
  state.terrain.set("drainage_area", std::move(made.drainage_area));
}

/// Land that grew out of the sea counts as land.
void raise_land(PipelineState& state, const PipeErosionResult& made, const Context& context) {
  Raster<std::uint8_t> land = state.products.get<LandMask>().land;
  for (std::size_t i = 0; i < land.size(); ++i)
    if (made.deposition[i] > 0.0f && made.elevation[i] > 0.0f) land[i] = 1;
  set_land(state, std::move(land), context);
}

void run_hydraulic_erosion(PipelineState& state, Context& context, const PipeParameters& given) {
  PipeParameters parameters = given;
  parameters.seed ^= int(stage_seed(state.seed, "hydraulic_erosion") & 0x7fffffff);
  PipeForcing forcing;
  forcing.land = &state.products.get<LandMask>().land;
  if (state.terrain.has("moisture")) forcing.moisture = &state.terrain.real("moisture");
  if (state.terrain.has("temperature")) forcing.temperature = &state.terrain.real("temperature");
  forcing.watch = state.watch;
  const Raster<float>& elevation = state.terrain.real("elevation");
  const Grid& grid = elevation.grid();
  for (const RiverSource& source :
       state.inputs.river_sources)  // one drowned meanwhile adds nothing
    if ((*forcing.land)(grid.row_of(source.position.y), grid.column_of(source.position.x)))
      forcing.sources.push_back(source);
  auto made = erode_virtual_pipes(elevation, forcing, parameters, context);
  raise_land(state, made, context);
  state.terrain.set("elevation", std::move(made.elevation));
  state.terrain.set("wear", std::move(made.wear));
  state.terrain.set("deposition", std::move(made.deposition));
  state.terrain.set("sediment_thickness", std::move(made.sediment_thickness));
}

void run_map_law(PipelineState& state, Context& context, const MapLawParameters& parameters) {
  Raster<float> elevation = state.terrain.real("elevation");
  auto made = enforce_map(elevation, *state.inputs.map, state.products.get<LandMask>().land,
                          state.products.get<RiverBeds>(), parameters, context);
  state.terrain.set("elevation", std::move(elevation));
  state.terrain.set("drainage_area", std::move(made.drainage_area));
}

void run_sea_floor(PipelineState& state, Context& context, const SeaFloorParameters& parameters) {
  const Raster<std::uint8_t>& land = state.products.get<LandMask>().land;
  Raster<float> elevation = state.terrain.real("elevation");
  lay_sea_floor(elevation, land, distance_transform(land, context), parameters,
                stage_seed(state.seed, "sea_floor"), context);
  state.terrain.set("elevation", std::move(elevation));
}

}  // namespace

void add_erosion_stages(std::vector<Stage>& list) {
  list.push_back(make_stage(relief_growth_stage(), {.cost = 3.0, .working_bytes_per_cell = 96.0},
                            run_relief_growth));
  list.push_back(make_stage(hydraulic_erosion_stage(),
                            {.by_default = DefaultFor::Maps | DefaultFor::Islands,
                             .cost = 3.0,
                             .working_bytes_per_cell = 92.0},
                            run_hydraulic_erosion));
}

void add_law_stages(std::vector<Stage>& list) {
  list.push_back(
      make_stage(map_law_stage(), {.cost = 0.2, .working_bytes_per_cell = 64.0}, run_map_law));
  list.push_back(
      make_stage(sea_floor_stage(), {.cost = 0.2, .working_bytes_per_cell = 32.0}, run_sea_floor));
}

}  // namespace orogen
