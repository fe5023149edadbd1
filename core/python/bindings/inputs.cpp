// orogen.inputs: vector maps and their rasters.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "inputs/geojson.h"
#include "inputs/map_rasters.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"

namespace orogen::python {

namespace {

py::tuple pair(glm::dvec2 p) {
  return py::make_tuple(p.x, p.y);
}

py::list points(const std::vector<glm::dvec2>& line) {
  py::list list;
  for (const glm::dvec2 p : line) list.append(pair(p));
  return list;
}

template <class T>
py::object or_none(const std::optional<T>& value) {
  return value ? py::cast(*value) : py::none();
}

py::list peaks_of(const VectorMap& map) {
  py::list list;
  for (const Peak& peak : map.peaks) {
    py::dict item;
    item["position"] = pair(peak.position);
    item["height_m"] = or_none(peak.height_m);
    item["name"] = peak.name;
    list.append(item);
  }
  return list;
}

py::list rivers_of(const VectorMap& map) {
  constexpr const char* kEnds[] = {"sea", "river", "lake", "frame"};
  py::list list;
  for (const River& river : map.rivers) {
    py::dict item;
    item["points"] = points(river.points);
    item["end"] = kEnds[int(river.end)];
    item["joins"] = river.joins;
    item["end_height_m"] = or_none(river.end_height_m);
    item["name"] = river.name;
    list.append(item);
  }
  return list;
}

py::list coasts_of(const VectorMap& map) {
  py::list list;
  for (const Coast& coast : map.coasts) {
    py::list holes;
    for (const Ring& hole : coast.holes) holes.append(points(hole));
    py::dict item;
    item["outer"] = points(coast.outer);
    item["holes"] = holes;
    item["clipped"] = coast.clipped;
    item["name"] = coast.name;
    list.append(item);
  }
  return list;
}

void bind_vector_map(py::module_& module) {
  py::class_<VectorMap, std::shared_ptr<VectorMap>>(
      module, "VectorMap", "Coasts, rivers, peaks and lakes in metres, checked and in order.")
      .def_static(
          "read",
          [](const std::string& text, bool strict) {
            return read_geojson(text, {.strict = strict});
          },
          py::arg("text"), py::arg("strict") = false,
          "Reads GeoJSON text; `strict` refuses what would be mended. Raises InputError.")
      .def_static(
          "load",
          [](const std::filesystem::path& file, bool strict) {
            return read_geojson_file(file, {.strict = strict});
          },
          py::arg("file"), py::arg("strict") = false,
          "Reads a GeoJSON file; `strict` refuses what would be mended. Raises InputError.")
      .def("to_geojson", &write_geojson, "Planar GeoJSON text in metres.")
      .def("grid", &grid_for, py::arg("resolution"),
           "The grid over the map's frame, `resolution` cells along the longer side.")
      .def_readonly("name", &VectorMap::name)
      .def_property_readonly("origin", [](const VectorMap& m) { return pair(m.frame.origin); })
      .def_property_readonly("size", [](const VectorMap& m) { return pair(m.frame.size); })
      .def_property_readonly("projection", [](const VectorMap& m) { return m.frame.proj4; })
      .def_property_readonly("coasts", &coasts_of, "List of dict: outer, holes, clipped, name.")
      .def_property_readonly("rivers", &rivers_of,
                             "List of dict: points from source to mouth, end, joins, end_height_m, "
                             "name.")
      .def_property_readonly("peaks", &peaks_of, "List of dict: position, height_m, name.")
      .def_property_readonly(
          "warnings", [](const VectorMap& m) { return py::cast(m.warnings); },
          "What was mended, and where.");
}

}  // namespace

void bind_inputs(py::module_& module) {
  py::module_ room = module.def_submodule("inputs", "Vector maps and their rasters.");
  bind_vector_map(room);
  define(
      room,
      {.name = "land_mask",
       .summary = "Marks the cells whose centres lie inside the map's coasts.",
       .arguments = {map_argument(), {"grid", "Grid", "Where to look."}, threads_argument()},
       .return_type = "array (ny, nx) of uint8",
       .returns = "1 on land (lakes too), 0 at sea."},
      [](const VectorMap& map, const Grid& grid, int threads) {
        return to_array(interruptible(
            threads, [&](Context& context) { return land_mask(map, grid, context); }));
      },
      py::arg("map"), py::arg("grid"), py::arg("threads") = 0);
}

}  // namespace orogen::python
