// Ground that is given rather than grown: what starts from it, and what puts it back.
#include <algorithm>
#include <cmath>

#include "erosion/fitted_growth.h"
#include "erosion/river_erosion.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"
#include "pipeline/make_stage.h"
#include "pipeline/stage_lists.h"
#include "sculpting/kept_region.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 65536;
constexpr int kOctaves = 8;
constexpr double kGain = 0.6;

struct GivenElevationParameters {
  double sea_level = 0.0;
  double vertical_scale = 1.0;
  double roughness = 120.0;
  double roughness_wavelength = 5000.0;
};

constexpr auto parameter_table(const GivenElevationParameters*) {
  using P = GivenElevationParameters;
  return std::tuple{
      real("sea_level", &P::sea_level, -12e3, 12e3, "m",
           "Height of the sea in the given heights; ground at or below it is sea."),
      real("vertical_scale", &P::vertical_scale, 0.001, 1000.0, "1",
           "What heights above and depths below the sea are multiplied by."),
      real("roughness", &P::roughness, 0.0, 1e3, "m",
           "Height of the unevenness that is added to land, so that rivers find their ways."),
      real("roughness_wavelength", &P::roughness_wavelength, 100.0, 100e3, "m",
           "Wavelength of the widest unevenness."),
  };
}

struct EvenRateParameters {
  double uplift_rate = 0.0;   // m/yr
  double erodibility = 3e-6;  // 1/yr
  double erodibility_variation = 0.4;
  double rock_wavelength = 6000.0;  // m
};

constexpr auto parameter_table(const EvenRateParameters*) {
  using P = EvenRateParameters;
  return std::tuple{
      real("uplift_rate", &P::uplift_rate, 0.0, 0.1, "m/yr", "Rate at which rock rises."),
      real("erodibility", &P::erodibility, 1e-9, 1e-2, "1/yr",
           "Stream-power erodibility k at area exponent 0.5; the median of rock."),
      real("erodibility_variation", &P::erodibility_variation, 0.0, 2.5, "1",
           "Standard deviation of the logarithm of erodibility."),
      real("rock_wavelength", &P::rock_wavelength, 100.0, 200e3, "m",
           "Wavelength of the widest variations of erodibility."),
  };
}

const StageInfo& given_elevation_stage() {
  static const StageInfo info{"given_elevation",
                              "Takes the raster `elevation` for the ground.",
                              "Orogen: rasters of a recipe",
                              {},
                              {"elevation", "land"},
                              {"rasters.elevation"}};
  return info;
}

const StageInfo& even_rates_stage() {
  static const StageInfo info{
      "even_rates",
      "Gives rock one uplift rate and an erodibility that varies, times what is given.",
      "Orogen: rasters of a recipe",
      {},
      {"uplift_rate", "erodibility"},
      {"rasters.uplift_factor", "rasters.erodibility_factor"}};
  return info;
}

/// Unevenness of land, less near the shore, which stays where it is.
void roughen(Raster<float>& elevation, const GivenElevationParameters& parameters,
             std::uint32_t seed, const Context& context) {
  if (parameters.roughness == 0.0) return;
  const Raster<float> noise = fbm({.seed = seed,
                                   .wavelength = parameters.roughness_wavelength,
                                   .octaves = kOctaves,
                                   .gain = kGain},
                                  elevation.grid(), context);
  const float deviation = float(0.5 * parameters.roughness);
  for (std::size_t i = 0; i < noise.size(); ++i)
    if (const float z = elevation[i]; z > 0.0f)
      elevation[i] += deviation * std::max(noise[i], -3.9f) * z / (z + 4.0f * deviation);
}

void multiply(Raster<float>& field, const Raster<float>& factor) {  // which may be empty
  for (std::size_t i = 0; i < factor.size(); ++i) field[i] *= factor[i];
}

void run_given_elevation(PipelineState& state, Context& context,
                         const GivenElevationParameters& parameters) {
  const Grid& grid = state.terrain.grid();
  Raster<float> elevation = state.inputs.raster("elevation", grid, context);
  Raster<std::uint8_t> land(grid);
  const float sea_level = float(parameters.sea_level), scale = float(parameters.vertical_scale);
  parallel_chunks(context, grid.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      elevation[i] = scale * (elevation[i] - sea_level);
      land[i] = elevation[i] > 0.0f;
    }
  });
  roughen(elevation, parameters, stage_seed(state.seed, "given_elevation"), context);
  set_land(state, std::move(land), context);
  state.terrain.set("elevation", std::move(elevation));
}

void run_even_rates(PipelineState& state, Context& context, const EvenRateParameters& parameters) {
  const Grid& grid = state.terrain.grid();
  Raster<float> uplift(grid, float(parameters.uplift_rate));
  const FbmParameters rock{.seed = stage_seed(state.seed, "even_rates"),
                           .wavelength = parameters.rock_wavelength,
                           .octaves = kOctaves,
                           .gain = kGain};
  Raster<float> erodibility = fbm(rock, grid, context);
  const float median = float(parameters.erodibility);
  const float spread = float(parameters.erodibility_variation);
  for (float& k : erodibility.values()) k = median * std::exp(spread * k);
  multiply(uplift, state.inputs.raster("uplift_factor", grid, context));
  multiply(erodibility, state.inputs.raster("erodibility_factor", grid, context));
  state.terrain.set("uplift_rate", std::move(uplift));
  state.terrain.set("erodibility", std::move(erodibility));
}

void run_river_erosion(PipelineState& state, Context& context,
                       const RiverErosionParameters& parameters) {
  auto made = erode_by_rivers(state.terrain.real("elevation"), state.terrain.integer("land"),
                              state.terrain.real("uplift_rate"), state.terrain.real("erodibility"),
                              parameters, context);
  state.terrain.set("drainage_area", std::move(made.drainage_area));
  state.terrain.set("elevation", std::move(made.elevation));
}

void run_fitted_growth(PipelineState& state, Context& context,
                       const FittedGrowthParameters& parameters) {
  Raster<float> aim = state.terrain.real("elevation");
  const Raster<float> factor = state.inputs.raster("uplift_factor", aim.grid(), context);
  for (std::size_t i = 0; i < factor.size(); ++i)
    if (aim[i] > 0.0f) aim[i] *= factor[i];
  auto made = grow_towards(aim, state.terrain.integer("land"), state.terrain.real("erodibility"),
                           parameters, context);
  state.terrain.set("uplift_rate", std::move(made.uplift_rate));
  state.terrain.set("drainage_area", std::move(made.drainage_area));
  state.terrain.set("elevation", std::move(made.elevation));
}

void run_keep_region(PipelineState& state, Context& context,
                     const KeptRegionParameters& parameters) {
  const Grid& grid = state.terrain.grid();
  Raster<float> elevation = state.terrain.real("elevation");
  keep_region(elevation, state.inputs.raster("kept", grid, context),
              state.inputs.raster("kept_elevation", grid, context), parameters, context);
  state.terrain.set("elevation", std::move(elevation));
}

}  // namespace

void add_given_stages(std::vector<Stage>& list) {
  const auto by_default = DefaultFor::Heights;
  list.push_back(make_stage(given_elevation_stage(),
                            {.by_default = by_default, .cost = 0.02, .product_bytes_per_cell = 1.0},
                            run_given_elevation));
  list.push_back(
      make_stage(even_rates_stage(), {.by_default = by_default, .cost = 0.02}, run_even_rates));
  list.push_back(make_stage(river_erosion_stage(),
                            {.by_default = by_default, .cost = 2.0, .working_bytes_per_cell = 90.0},
                            run_river_erosion));
  list.push_back(
      make_stage(fitted_growth_stage(),
                 {.by_default = DefaultFor::None, .cost = 3.0, .working_bytes_per_cell = 130.0},
                 run_fitted_growth));
  list.push_back(
      make_stage(keep_region_stage(),
                 {.by_default = DefaultFor::None, .cost = 0.05, .working_bytes_per_cell = 16.0},
                 run_keep_region));
}

}  // namespace orogen
