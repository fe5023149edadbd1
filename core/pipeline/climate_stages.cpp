// Climate, lakes and biomes of any terrain, by its heights as they are by then.
#include "climate/biome_map.h"
#include "climate/climate.h"
#include "hydrology/lakes.h"
#include "hydrology/sea.h"
#include "pipeline/make_stage.h"
#include "pipeline/stage_lists.h"

namespace orogen {

namespace {

const StageInfo& lakes_stage() {
  static const StageInfo info{"lakes",
                              "Fills hollows of the ground with lakes, up to their lowest way out.",
                              "Barnes, Lehman and Mulla 2014",
                              {"elevation"},
                              {"water_depth"},
                              {},
                              {"land", "water_depth"}};
  return info;
}

const StageInfo& climate_stage() {
  static const StageInfo info{
      "climate",
      "Makes temperature, rain, snow and moisture from heights, wind and waters.",
      "Smith and Barstad 2004; Holdridge 1967; Hock 2003; Weiss 2015, IV-D and IV-E",
      {"elevation"},
      {"air_temperature", "biotemperature", "rainfall", "snow_cover", "temperature", "moisture"},
      {"rasters.temperature_change", "rasters.moisture_change"},
      {"water_depth", "drainage_area"}};
  return info;
}

const StageInfo& biomes_stage() {
  static const StageInfo info{
      "biomes",
      "Settles biomes by climate, heights and waters as they are, and by what is painted.",
      "Weiss 2015, VII-A; Whittaker 1975; Holdridge 1967",
      {"elevation", "temperature", "moisture"},
      {"biome"},
      {"rasters.biome"},
      {"land", "water_depth", "air_temperature", "biotemperature", "rainfall", "snow_cover"}};
  return info;
}

const Raster<float>* find_real(const Terrain& terrain, std::string_view name) {
  return terrain.has(name) ? &terrain.real(name) : nullptr;
}

void run_lakes(PipelineState& state, Context& context, const LakeParameters& parameters) {
  const Raster<float>& elevation = state.terrain.real("elevation");
  Raster<std::uint8_t> sea(elevation.grid());
  if (state.terrain.has("land")) {
    const Raster<std::int32_t>& land = state.terrain.integer("land");
    for (std::size_t i = 0; i < sea.size(); ++i) sea[i] = !land[i];
    const Raster<std::uint8_t> dry = land_beside_sea(elevation, sea);
    for (std::size_t i = 0; i < sea.size(); ++i) sea[i] = !dry[i];
  }
  state.terrain.set(
      "water_depth",
      lake_depth(elevation, sea, find_real(state.terrain, "water_depth"), parameters, context));
}

void run_climate(PipelineState& state, Context& context, const ClimateParameters& parameters,
                 const OrographicRainParameters& rain) {
  const Terrain& terrain = state.terrain;
  const auto change = [&](std::string_view name) {
    return state.inputs.raster(name, terrain.grid(), context);
  };
  Climate made = make_climate({terrain.real("elevation"), find_real(terrain, "water_depth"),
                               find_real(terrain, "drainage_area"), change("temperature_change"),
                               change("moisture_change")},
                              parameters, rain, context);
  state.terrain.set("air_temperature", std::move(made.air_temperature));
  state.terrain.set("biotemperature", std::move(made.biotemperature));
  state.terrain.set("rainfall", std::move(made.rainfall));
  state.terrain.set("snow_cover", std::move(made.snow_cover));
  state.terrain.set("temperature", std::move(made.temperature));
  state.terrain.set("moisture", std::move(made.moisture));
}

void run_biomes(PipelineState& state, Context& context, const BiomeParameters& parameters) {
  const Terrain& terrain = state.terrain;
  const Raster<std::int32_t> painted = state.inputs.labels("biome", terrain.grid());
  const BiomeInputs inputs{
      .elevation = terrain.real("elevation"),
      .land = terrain.has("land") ? &terrain.integer("land") : nullptr,
      .water_depth = find_real(terrain, "water_depth"),
      .temperature = &terrain.real("temperature"),
      .moisture = &terrain.real("moisture"),
      .air_temperature = find_real(terrain, "air_temperature"),
      .biotemperature = find_real(terrain, "biotemperature"),
      .rainfall = find_real(terrain, "rainfall"),
      .snow_cover = find_real(terrain, "snow_cover"),
      .painted = painted.empty() ? nullptr : &painted,
  };
  state.terrain.set("biome", map_biomes(inputs, parameters, context));
}

}  // namespace

void add_climate_stages(std::vector<Stage>& list) {
  list.push_back(make_stage(
      lakes_stage(),
      {.by_default = DefaultFor::Islands, .cost = 0.2, .working_bytes_per_cell = 40.0}, run_lakes));
  list.push_back(make_stage(
      climate_stage(),
      {.by_default = DefaultFor::None, .cost = 0.3, .working_bytes_per_cell = 24.0}, run_climate));
  list.push_back(
      make_stage(biomes_stage(),
                 {.by_default = DefaultFor::Islands, .cost = 0.1, .working_bytes_per_cell = 24.0},
                 run_biomes));
}

}  // namespace orogen
