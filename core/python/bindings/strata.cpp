// orogen.strata: columns of layers, and the rocks made of them.
#include <pybind11/stl.h>

#include "json_argument.h"
#include "module.h"
#include "parameters.h"
#include "pipeline/recipe_inputs.h"
#include "rocks.h"

namespace orogen::python {

namespace {

std::string names_of_columns() {
  std::string names;
  for (const std::string_view name : column_names())
    names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

}  // namespace

void bind_strata(py::module_& module) {
  py::module_ room = module.def_submodule("strata", "Layers of rock, and where they crop out.");
  define(
      room,
      {.name = "preset_column",
       .summary = "A stratigraphic column by name, as recipes have it.",
       .arguments = {{"name", "str", "One of " + names_of_columns() + "."}},
       .return_type = "dict[str, Any]",
       .returns = "Basement and layers, from the bottom up.",
       .citation = "Cordonnier et al. 2018, Table 2"},
      [](const std::string& name) { return from_json(write_column(preset_column(name, "name"))); },
      py::arg("name"));
  define(
      room,
      {.name = "fold_wavelengths",
       .summary = "Wavelengths of the folds of each layer of a column.",
       .arguments = {{"column", "dict[str, Any]", "A column as recipes have it."}},
       .return_type = "list[float]",
       .returns = "In metres, from the lowest layer up.",
       .citation = "Cordonnier et al. 2018, equation 3"},
      [](const py::object& column) {
        return fold_wavelengths(read_column({to_json(column, "column"), "column"}));
      },
      py::arg("column"));
  bind_rocks(room);
}

}  // namespace orogen::python
