// The module orogen._core: one submodule a room. No algorithm lives here.
#include "module.h"

#include <pybind11/stl.h>

#include <cmath>
#include <utility>

#include "foundation/errors.h"
#include "pipeline/pipeline.h"

namespace orogen::python {

namespace {

/// Exceptions are known by their public names.
template <class E>
void bind_exception(py::module_& module, const char* name, PyObject* base, const char* text) {
  py::register_exception<E>(module, name, base);
  const py::object type = module.attr(name);
  type.attr("__module__") = "orogen";
  type.attr("__doc__") = text;
}

Grid make_grid(int nx, int ny, double cell_size, const std::pair<double, double>& origin) {
  const auto refuse = [](const char* name, double value, const char* wanted) {
    throw InputError(std::string(name) + ": " + detail::format_number(value) + " is not allowed; " +
                     wanted + " is wanted");
  };
  constexpr double kMost = kMaxResolution;
  if (!(nx >= 1 && nx <= kMost)) refuse("nx", nx, "1 to 65536");
  if (!(ny >= 1 && ny <= kMost)) refuse("ny", ny, "1 to 65536");
  if (!(cell_size > 0.0 && cell_size <= 1e7))
    refuse("cell_size", cell_size, "above 0, up to 1e7 m");
  if (!std::isfinite(origin.first)) refuse("origin[0]", origin.first, "a finite number");
  if (!std::isfinite(origin.second)) refuse("origin[1]", origin.second, "a finite number");
  return {nx, ny, cell_size, {origin.first, origin.second}};
}

void bind_grid(py::module_& module) {
  py::class_<Grid>(module, "Grid", "A regular grid of square cells; row 0 is the southern row.")
      .def(py::init(&make_grid), py::arg("nx"), py::arg("ny"), py::arg("cell_size"),
           py::arg("origin") = py::make_tuple(0.0, 0.0))
      .def_readonly("nx", &Grid::nx, "Columns.")
      .def_readonly("ny", &Grid::ny, "Rows.")
      .def_readonly("cell_size", &Grid::cell_size, "Side of a cell in metres.")
      .def_property_readonly(
          "origin", [](const Grid& g) { return py::make_tuple(g.origin.x, g.origin.y); },
          "Lower-left corner (x, y) in metres, in the map's projection.")
      .def_property_readonly(
          "shape", [](const Grid& g) { return py::make_tuple(g.ny, g.nx); },
          "(ny, nx), the shape of its arrays.")
      .def("__repr__", [](const Grid& g) {
        return "Grid(nx=" + std::to_string(g.nx) + ", ny=" + std::to_string(g.ny) +
               ", cell_size=" + detail::format_number(g.cell_size) + ", origin=(" +
               detail::format_number(g.origin.x) + ", " + detail::format_number(g.origin.y) + "))";
      });
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "Orogen's compiled core.";
  module.attr("__version__") = OROGEN_VERSION;
  bind_exception<InputError>(module, "InputError", PyExc_ValueError,
                             "Input that cannot be used; the message names field and place.");
  bind_exception<Cancelled>(module, "Cancelled", PyExc_Exception,
                            "The work was stopped on request; nothing was changed.");
  bind_exception<MemoryLimitError>(module, "MemoryLimitError", PyExc_MemoryError,
                                   "The work would need more memory than is allowed.");
  bind_grid(module);
  bind_inputs(module);
  bind_tectonics(module);
  bind_folding(module);
  bind_strata(module);
  bind_hydrology(module);
  bind_climate(module);
  bind_island(module);
  bind_sculpting(module);
  bind_erosion(module);
  bind_vegetation(module);
  bind_pipeline(module);
}

}  // namespace orogen::python
