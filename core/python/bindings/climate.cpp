// orogen.climate: rain by mountains, and biomes by climate.
#include "arrays.h"
#include "climate/biome_map.h"
#include "climate/holdridge.h"
#include "climate/orographic_rain.h"
#include "climate/whittaker.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"

namespace orogen::python {

namespace {

/// What a classification makes of two numbers.
Biome (*rule_of(Classification classification))(double, double) {
  switch (classification) {
    case Classification::Paper:
      return biome_of;
    case Classification::Whittaker:
      return whittaker_biome;
    case Classification::Holdridge:
      return holdridge_biome;
  }
  return nullptr;
}

Raster<std::int32_t> classify(const Raster<float>& warmth, const Raster<float>& water,
                              const std::string& by) {
  const auto rule = rule_of(Classification(
      detail::to_choice(by, kClassifications, std::size(kClassifications), "", "classification")));
  Raster<std::int32_t> biome(warmth.grid());
  for (std::size_t i = 0; i < biome.size(); ++i) biome[i] = std::int32_t(rule(warmth[i], water[i]));
  return biome;
}

}  // namespace

void bind_climate(py::module_& module) {
  py::module_ room = module.def_submodule("climate", "Rain and biomes.");
  define(
      room,
      {.name = "orographic_rain",
       .summary = "Rain that a wind drops on mountains.",
       .arguments = {elevation_argument(), cell_size_argument(), threads_argument()},
       .parameters = describe_parameters<OrographicRainParameters>(),
       .return_type = "array (ny, nx) of float32",
       .returns = "Rain in m/yr.",
       .citation = "Smith and Barstad 2004, doi:10.1175/1520-0469(2004)061<1377:ALTOOP>2.0.CO;2"},
      [](const py::object& elevation, double cell_size, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<OrographicRainParameters>(keywords);
        const auto ground = to_raster<float>(elevation, "elevation", cell_size);
        return to_array(interruptible(threads, [&](Context& context) {
          return orographic_rain(ground, parameters, context);
        }));
      },
      py::arg("elevation"), py::arg("cell_size"), py::arg("threads") = 0);
  define(
      room,
      {.name = "classify_biomes",
       .summary = "Biomes of dry land by climate.",
       .arguments = {{"warmth", "array (ny, nx) of float32",
                      "paper: temperature, 0 to 1; whittaker: mean temperature of the year, degC; "
                      "holdridge: biotemperature, degC."},
                     {"water", "array (ny, nx) of float32",
                      "paper: moisture, 0 to 1; else precipitation, m/yr."},
                     {"classification", "{'paper', 'whittaker', 'holdridge'}", "Whose limits hold.",
                      "'paper'"}},
       .return_type = "array (ny, nx) of int32",
       .returns = "Numbers into `orogen.island.biomes()`.",
       .citation = "Weiss 2015, Fig. 8; Whittaker 1975; Holdridge 1967"},
      [](const py::object& warmth, const py::object& water, const std::string& by) {
        const auto warm = to_raster<float>(warmth, "warmth", 1.0);
        return to_array(classify(warm, to_raster<float>(water, "water", warm.grid()), by));
      },
      py::arg("warmth"), py::arg("water"), py::arg("classification") = "paper");
}

}  // namespace orogen::python
