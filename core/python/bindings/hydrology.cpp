// orogen.hydrology: depressions, flow, drainage area, the watershed map.
#include "arrays.h"
#include "hydrology/depressions.h"
#include "hydrology/drainage.h"
#include "hydrology/flow_graph.h"
#include "hydrology/river_beds.h"
#include "hydrology/watershed_map.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"

namespace orogen::python {

namespace {

void bind_flow_graph(py::module_& room) {
  py::class_<FlowGraph>(room, "FlowGraph", "Where water goes, from each cell down to base level.")
      .def_property_readonly("grid", &FlowGraph::grid)
      .def_property_readonly("pit_count", &FlowGraph::pit_count, "Local minima that were drained.")
      .def(
          "receivers",
          [](const FlowGraph& flow) {
            return to_array(
                interruptible(0, [&](Context& context) { return flow.receivers(context); }));
          },
          "Array (ny, nx) of int32: the cell (row * nx + column) that water flows to; a base-level "
          "cell's is itself.");
  define(
      room,
      {.name = "route_flow",
       .summary = "Finds where water goes, out of depressions too.",
       .arguments = {elevation_argument(), base_level_argument(), cell_size_argument(),
                     threads_argument()},
       .return_type = "FlowGraph",
       .returns = "For `drainage_area` and others.",
       .citation = "Cordonnier, Bovy and Braun 2019; O'Callaghan and Mark 1984"},
      [](const py::object& elevation, const py::object& base_level, double cell_size, int threads) {
        const auto z = to_raster<float>(elevation, "elevation", cell_size);
        const auto base = to_mask(base_level, "base_level", z.grid());
        auto flow = std::make_unique<FlowGraph>(base);
        run_interruptible(py::none(), threads,
                          [&](Context& context) { context.run([&] { flow->route(z, context); }); });
        return flow;
      },
      py::arg("elevation"), py::arg("base_level"), py::arg("cell_size"), py::arg("threads") = 0);
}

void bind_drainage(py::module_& room) {
  define(
      room,
      {.name = "drainage_area",
       .summary = "Sums the area that drains through each cell, itself included.",
       .arguments = {{"flow", "FlowGraph", "From `route_flow`."}, threads_argument()},
       .return_type = "array (ny, nx) of float32",
       .returns = "Drainage area in m2.",
       .citation = std::string(drainage_stage().citation)},
      [](const FlowGraph& flow, int threads) {
        return to_array(
            interruptible(threads, [&](Context& context) { return drainage_area(flow, context); }));
      },
      py::arg("flow"), py::arg("threads") = 0);
  define(
      room,
      {.name = "strahler_order",
       .summary = "Horton-Strahler order of the streams.",
       .arguments = {{"flow", "FlowGraph", "From `route_flow`."},
                     {"drainage_area", "array (ny, nx) of float32", "In m2."},
                     {"least_area_m2", "float", "Drainage area from which a stream counts."},
                     threads_argument()},
       .return_type = "array (ny, nx) of int32",
       .returns = "Order from 1; 0 where there is no stream."},
      [](const FlowGraph& flow, const py::object& area, double least_area_m2, int threads) {
        const auto raster = to_raster<float>(area, "drainage_area", flow.grid());
        return to_array(interruptible(threads, [&](Context& context) {
          return strahler_order(flow, raster, least_area_m2, context);
        }));
      },
      py::arg("flow"), py::arg("drainage_area"), py::arg("least_area_m2"), py::arg("threads") = 0);
  define(
      room,
      {.name = "watershed_labels",
       .summary = "Number of the watershed that each cell belongs to.",
       .arguments = {{"flow", "FlowGraph", "From `route_flow`."}, threads_argument()},
       .return_type = "array (ny, nx) of int32",
       .returns = "Numbers of the outlets, counted from 0; -1 in other base-level cells."},
      [](const FlowGraph& flow, int threads) {
        return to_array(interruptible(
            threads, [&](Context& context) { return watershed_labels(flow, context); }));
      },
      py::arg("flow"), py::arg("threads") = 0);
}

void bind_depressions(py::module_& room) {
  define(
      room,
      {.name = "fill_depressions",
       .summary = "Raises closed hollows to their spill level.",
       .arguments = {elevation_argument(),
                     base_level_argument(),
                     cell_size_argument(),
                     {"epsilon", "float",
                      "How far each cell stands above its receiver, in metres; 0 leaves lakes "
                      "level.",
                      "0.0"},
                     threads_argument()},
       .return_type = "array (ny, nx) of float32",
       .returns = "Filled elevation in metres.",
       .citation = "Barnes, Lehman and Mulla 2014"},
      [](const py::object& elevation, const py::object& base_level, double cell_size,
         double epsilon, int threads) {
        auto z = to_raster<float>(elevation, "elevation", cell_size);
        const auto base = to_mask(base_level, "base_level", z.grid());
        run_interruptible(py::none(), threads, [&](Context& context) {
          context.run([&] { fill_depressions(z, base, epsilon, context); });
        });
        return to_array(std::move(z));
      },
      py::arg("elevation"), py::arg("base_level"), py::arg("cell_size"), py::arg("epsilon") = 0.0,
      py::arg("threads") = 0);
  define(
      room,
      {.name = "carve_to_drain",
       .summary = "Lowers ground so that water falls along every path to base level.",
       .arguments = {elevation_argument(),
                     base_level_argument(),
                     cell_size_argument(),
                     {"least_slope", "float", "Least fall along paths.", "1e-05"},
                     threads_argument()},
       .return_type = "array (ny, nx) of float32",
       .returns = "Carved elevation in metres."},
      [](const py::object& elevation, const py::object& base_level, double cell_size,
         double least_slope, int threads) {
        auto z = to_raster<float>(elevation, "elevation", cell_size);
        const auto base = to_mask(base_level, "base_level", z.grid());
        run_interruptible(py::none(), threads, [&](Context& context) {
          context.run([&] { carve_to_drain(z, base, least_slope, context); });
        });
        return to_array(std::move(z));
      },
      py::arg("elevation"), py::arg("base_level"), py::arg("cell_size"),
      py::arg("least_slope") = 1e-5, py::arg("threads") = 0);
}

void bind_river_beds(py::module_& room) {
  py::class_<RiverBeds> type(room, "RiverBeds", "The map's rivers on a grid.");
  raster_property(type, "river", &RiverBeds::river,
                  "1 + number of the river whose bed lies here; 0 elsewhere.");
  define(
      room,
      {.name = "lay_river_beds",
       .summary = "Lays the beds of the map's rivers from cell to cell.",
       .arguments = {map_argument(),
                     {"grid", "Grid", "Where `land` lies."},
                     {"land", "array (ny, nx) of bool or int", "Not 0 on land."},
                     {"wander", "float", "How far beds meander sideways, in metres.", "0.0"},
                     {"wander_wavelength", "float", "In metres.", "2500.0"},
                     seed_argument()},
       .return_type = "RiverBeds",
       .returns = "Raster `river`, and the order of the beds' cells."},
      [](const VectorMap& map, const Grid& grid, const py::object& land, double wander,
         double wander_wavelength, std::uint32_t seed) {
        const auto mask = to_mask(land, "land", grid);
        return interruptible(0, [&](Context&) {
          return lay_river_beds(map, mask, wander, wander_wavelength, seed);
        });
      },
      py::arg("map"), py::arg("grid"), py::arg("land"), py::arg("wander") = 0.0,
      py::arg("wander_wavelength") = 2500.0, py::arg("seed") = 0);
}

void bind_watershed_map(py::module_& room) {
  py::class_<WatershedMap> type(room, "WatershedMap", "The watershed map of paper A.");
  raster_property(type, "elevation", &WatershedMap::elevation, "Height in metres; 0 at sea.");
  raster_property(type, "river_distance", &WatershedMap::river_distance,
                  "Distance to the nearest river, lake or coast in metres.");
  define(
      room,
      {.name = "watershed_map",
       .summary = "Raises heights along rivers from their mouths, and hillslopes beside them.",
       .arguments = {map_argument(),
                     {"beds", "RiverBeds", "From `lay_river_beds`."},
                     {"land", "array (ny, nx) of bool or int", "Not 0 on land."},
                     {"peak_distance", "array (ny, nx) of float32",
                      "Distance to the nearest peak in metres."},
                     threads_argument()},
       .parameters = describe_parameters<WatershedParameters>(),
       .return_type = "WatershedMap",
       .returns = "Rasters `elevation` and `river_distance`.",
       .citation = std::string(watershed_stage().citation)},
      [](const VectorMap& map, const RiverBeds& beds, const py::object& land,
         const py::object& peak_distance, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<WatershedParameters>(keywords);
        const Grid& grid = beds.river.grid();
        const auto mask = to_mask(land, "land", grid);
        const auto distance = to_raster<float>(peak_distance, "peak_distance", grid);
        return interruptible(threads, [&](Context& context) {
          return watershed_map(map, beds, mask, distance, parameters, context);
        });
      },
      py::arg("map"), py::arg("beds"), py::arg("land"), py::arg("peak_distance"),
      py::arg("threads") = 0);
}

}  // namespace

void bind_hydrology(py::module_& module) {
  py::module_ room = module.def_submodule("hydrology", "Depressions, flow and drainage area.");
  bind_flow_graph(room);
  bind_drainage(room);
  bind_depressions(room);
  bind_river_beds(room);
  bind_watershed_map(room);
}

}  // namespace orogen::python
