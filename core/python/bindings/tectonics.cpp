// orogen.tectonics: plates, their boundaries and velocities.
#include "arrays.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"
#include "tectonics/boundaries.h"
#include "tectonics/sub_plates.h"
#include "tectonics/velocity_map.h"

namespace orogen::python {

namespace {

py::list plates_of(const PlateMap& map) {
  py::list list;
  for (const Plate& plate : map.plates) {
    py::dict item;
    item["area"] = plate.area;
    item["centroid"] = py::make_tuple(plate.centroid.x, plate.centroid.y);
    item["velocity"] = py::make_tuple(plate.velocity.x, plate.velocity.y);
    item["angular_velocity"] = plate.angular_velocity;
    py::list peaks;
    for (const int peak : plate.peaks) peaks.append(peak);
    item["peaks"] = peaks;
    list.append(item);
  }
  return list;
}

py::list volcanoes_of(const PlateMap& map) {
  py::list list;
  for (const int peak : map.volcanoes) list.append(peak);
  return list;
}

void bind_results(py::module_& room) {
  py::class_<PlateMap> plates(room, "PlateMap", "Plates inferred from the peaks of a map.");
  raster_property(plates, "plate", &PlateMap::plate, "Number of the plate each cell lies on.");
  raster_property(plates, "peak_distance", &PlateMap::peak_distance,
                  "Distance to the nearest peak in metres.");
  plates
      .def_property_readonly("plates", &plates_of,
                             "List of dict: area (m2), centroid (m), velocity (m/yr), "
                             "angular_velocity (rad/yr), peaks.")
      .def_property_readonly("volcanoes", &volcanoes_of, "Numbers of the isolated peaks.");

  py::class_<BoundaryMap> boundaries(room, "BoundaryMap", "Boundaries between plates.");
  raster_property(boundaries, "boundary_distance", &BoundaryMap::boundary_distance,
                  "Distance to the nearest plate boundary in metres.");
  raster_property(boundaries, "convergence", &BoundaryMap::convergence,
                  "1: plates meet head on, -1: they part, 0: they slide or rest.");
  raster_property(boundaries, "boundary_kind", &BoundaryMap::boundary_kind,
                  "0 none nearby, 1 convergent, 2 divergent, 3 transform.");

  py::class_<VelocityMap> velocity(room, "VelocityMap", "Smoothed velocity of the plates.");
  raster_property(velocity, "velocity_x", &VelocityMap::velocity_x, "Eastward part in m/yr.");
  raster_property(velocity, "velocity_y", &VelocityMap::velocity_y, "Northward part in m/yr.");
}

const Argument kPlates{"plates", "PlateMap", "From `infer_plates`."};

}  // namespace

void bind_tectonics(py::module_& module) {
  py::module_ room = module.def_submodule("tectonics", "Plates, their boundaries and velocities.");
  bind_results(room);
  bind_collision(room);
  bind_isostasy(room);
  define(
      room,
      {.name = "infer_plates",
       .summary = "Infers plates and their velocities from the map's peaks.",
       .arguments = {map_argument(),
                     {"grid", "Grid", "Where the rasters lie."},
                     seed_argument(),
                     threads_argument()},
       .parameters = describe_parameters<PlateParameters>(),
       .return_type = "PlateMap",
       .returns = "Plates, and the rasters `plate` and `peak_distance`.",
       .citation = std::string(plates_stage().citation)},
      [](const VectorMap& map, const Grid& grid, std::uint32_t seed, int threads,
         const py::kwargs& keywords) {
        const auto parameters = from_keywords<PlateParameters>(keywords);
        return interruptible(threads, [&](Context& context) {
          return infer_plates(map, grid, parameters, seed, context);
        });
      },
      py::arg("map"), py::arg("grid"), py::arg("seed") = 0, py::arg("threads") = 0);
  define(
      room,
      {.name = "plate_boundaries",
       .summary = "Finds where plates converge, part or slide past each other.",
       .arguments = {kPlates, threads_argument()},
       .parameters = describe_parameters<BoundaryParameters>(),
       .return_type = "BoundaryMap",
       .returns = "Rasters `boundary_distance`, `convergence` and `boundary_kind`.",
       .citation = std::string(boundaries_stage().citation)},
      [](const PlateMap& plates, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<BoundaryParameters>(keywords);
        return interruptible(threads, [&](Context& context) {
          return plate_boundaries(plates, parameters, context);
        });
      },
      py::arg("plates"), py::arg("threads") = 0);
  define(
      room,
      {.name = "velocity_map",
       .summary = "Smooths the velocities of the plates.",
       .arguments = {kPlates, threads_argument()},
       .parameters = describe_parameters<VelocityParameters>(),
       .return_type = "VelocityMap",
       .returns = "Rasters `velocity_x` and `velocity_y`.",
       .citation = std::string(velocity_stage().citation)},
      [](const PlateMap& plates, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<VelocityParameters>(keywords);
        return interruptible(
            threads, [&](Context& context) { return velocity_map(plates, parameters, context); });
      },
      py::arg("plates"), py::arg("threads") = 0);
}

}  // namespace orogen::python
