// orogen.sculpting: relief that agrees with the map.
#include "arrays.h"
#include "foundation/distance_transform.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"
#include "sculpting/combination.h"
#include "sculpting/map_law.h"
#include "sculpting/sea_floor.h"

namespace orogen::python {

namespace {

void bind_combination(py::module_& room) {
  define(
      room,
      {.name = "combine_relief",
       .summary = "Combines folds and watershed map by the distance to rivers.",
       .arguments = {{"fold_relief", "array (ny, nx) of float32", "In metres."},
                     {"watershed", "WatershedMap", "From `orogen.hydrology.watershed_map`."},
                     {"land", "array (ny, nx) of bool or int", "Not 0 on land."},
                     threads_argument()},
       .parameters = describe_parameters<CombinationParameters>(),
       .return_type = "array (ny, nx) of float32",
       .returns = "combined_relief in metres; 0 at sea.",
       .citation = std::string(combination_stage().citation)},
      [](const py::object& fold_relief, const WatershedMap& watershed, const py::object& land,
         int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<CombinationParameters>(keywords);
        const Grid& grid = watershed.elevation.grid();
        const auto folds = to_raster<float>(fold_relief, "fold_relief", grid);
        const auto mask = to_mask(land, "land", grid);
        return to_array(interruptible(threads, [&](Context& context) {
          return combine_relief(folds, watershed, mask, parameters, context);
        }));
      },
      py::arg("fold_relief"), py::arg("watershed"), py::arg("land"), py::arg("threads") = 0);
}

void bind_sea_floor(py::module_& room) {
  define(
      room,
      {.name = "lay_sea_floor",
       .summary = "Lays the sea floor from the coast down to the deep.",
       .arguments = {elevation_argument(),
                     {"land", "array (ny, nx) of bool or int", "Not 0 on land."},
                     cell_size_argument(),
                     seed_argument(),
                     threads_argument()},
       .parameters = describe_parameters<SeaFloorParameters>(),
       .return_type = "array (ny, nx) of float32",
       .returns = "Elevation in metres with the floor of the sea below 0.",
       .citation = std::string(sea_floor_stage().citation)},
      [](const py::object& elevation, const py::object& land, double cell_size, std::uint32_t seed,
         int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<SeaFloorParameters>(keywords);
        auto z = to_raster<float>(elevation, "elevation", cell_size);
        const auto mask = to_mask(land, "land", z.grid());
        run_interruptible(py::none(), threads, [&](Context& context) {
          context.run([&] {
            lay_sea_floor(z, mask, distance_transform(mask, context), parameters, seed, context);
          });
        });
        return to_array(std::move(z));
      },
      py::arg("elevation"), py::arg("land"), py::arg("cell_size"), py::arg("seed") = 0,
      py::arg("threads") = 0);
}

void bind_map_law(py::module_& room) {
  define(
      room,
      {.name = "enforce_map",
       .summary = "Brings coast, peaks and rivers to agree with the map to the cell.",
       .arguments = {elevation_argument(),
                     map_argument(),
                     {"land", "array (ny, nx) of bool or int", "Not 0 on land."},
                     {"beds", "RiverBeds", "From `orogen.hydrology.lay_river_beds`."},
                     threads_argument()},
       .parameters = describe_parameters<MapLawParameters>(),
       .return_type = "tuple of two arrays (ny, nx) of float32",
       .returns = "Elevation in metres, and drainage area in m2.",
       .citation = std::string(map_law_stage().citation)},
      [](const py::object& elevation, const VectorMap& map, const py::object& land,
         const RiverBeds& beds, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<MapLawParameters>(keywords);
        const Grid& grid = beds.river.grid();
        auto z = to_raster<float>(elevation, "elevation", grid);
        const auto mask = to_mask(land, "land", grid);
        auto made = interruptible(threads, [&](Context& context) {
          return enforce_map(z, map, mask, beds, parameters, context);
        });
        return py::make_tuple(to_array(std::move(z)), to_array(std::move(made.drainage_area)));
      },
      py::arg("elevation"), py::arg("map"), py::arg("land"), py::arg("beds"),
      py::arg("threads") = 0);
}

}  // namespace

void bind_sculpting(py::module_& module) {
  py::module_ room = module.def_submodule("sculpting", "Relief that agrees with the map.");
  bind_combination(room);
  bind_sea_floor(room);
  bind_map_law(room);
}

}  // namespace orogen::python
