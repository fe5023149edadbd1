// orogen.tectonics: how the crust sinks under a load.
#include "tectonics/isostasy.h"

#include "arrays.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"

namespace orogen::python {

namespace {

/// A function of the parameters alone.
void define_number(py::module_& room, const char* name, const char* summary, const char* returns,
                   double (*function)(const IsostasyParameters&)) {
  define(room,
         {.name = name,
          .summary = summary,
          .parameters = describe_parameters<IsostasyParameters>(),
          .return_type = "float",
          .returns = returns,
          .citation = "Turcotte and Schubert, Geodynamics"},
         [function](const py::kwargs& keywords) {
           return function(from_keywords<IsostasyParameters>(keywords));
         });
}

}  // namespace

void bind_isostasy(py::module_& tectonics) {
  define_number(tectonics, "airy_uplift_share",
                "Rise of floating ground over the thickening of the crust below it.",
                "1 - crust_density / mantle_density.", &airy_uplift_share);
  define_number(tectonics, "airy_root_share",
                "Depth of a floating mountain's root over the mountain's height.",
                "crust_density / (mantle_density - crust_density).", &airy_root_share);
  define_number(tectonics, "flexural_parameter", "Length over which an elastic plate bends.",
                "In metres.", [](const IsostasyParameters& p) { return flexural_parameter(p); });
  define(
      tectonics,
      {.name = "flexural_deflection",
       .summary = "Bends an elastic plate under a load of rock.",
       .arguments = {{"load", "array (ny, nx) of float32", "Thickness of rock in metres."},
                     cell_size_argument(),
                     threads_argument()},
       .parameters = describe_parameters<IsostasyParameters>(),
       .return_type = "array (ny, nx) of float32",
       .returns = "Deflection in metres, downwards.",
       .citation = "Turcotte and Schubert, Geodynamics"},
      [](const py::object& load, double cell_size, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<IsostasyParameters>(keywords);
        const auto rock = to_raster<float>(load, "load", cell_size);
        return to_array(interruptible(threads, [&](Context& context) {
          return flexural_deflection(rock, parameters, context);
        }));
      },
      py::arg("load"), py::arg("cell_size"), py::arg("threads") = 0);
  define(
      tectonics,
      {.name = "isostatic_uplift",
       .summary = "How fast the ground rises where crust that floats thickens.",
       .arguments = {{"thickening", "array (ny, nx) of float32", "In m/yr."},
                     cell_size_argument(),
                     threads_argument()},
       .parameters = describe_parameters<IsostasyParameters>(),
       .return_type = "array (ny, nx) of float32",
       .returns = "In m/yr; below 0 where the ground sinks.",
       .citation = "Turcotte and Schubert, Geodynamics"},
      [](const py::object& thickening, double cell_size, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<IsostasyParameters>(keywords);
        const auto rate = to_raster<float>(thickening, "thickening", cell_size);
        return to_array(interruptible(threads, [&](Context& context) {
          return isostatic_uplift(rate, parameters, context);
        }));
      },
      py::arg("thickening"), py::arg("cell_size"), py::arg("threads") = 0);
}

}  // namespace orogen::python
