// The rooms' bindings, in the order in which they are registered.
#pragma once

#include <pybind11/pybind11.h>

namespace orogen::python {

namespace py = pybind11;

void bind_inputs(py::module_& module);
void bind_tectonics(py::module_& module);
void bind_folding(py::module_& module);
void bind_strata(py::module_& module);
void bind_hydrology(py::module_& module);
void bind_climate(py::module_& module);
void bind_island(py::module_& module);
void bind_sculpting(py::module_& module);
void bind_erosion(py::module_& module);
void bind_vegetation(py::module_& module);
void bind_pipeline(py::module_& module);

// Parts of rooms, for the rooms to call.
void bind_collision(py::module_& tectonics);
void bind_isostasy(py::module_& tectonics);
void bind_fold_layers(py::module_& folding);
void bind_tin(py::module_& erosion);
void bind_plants(py::module_& vegetation);

/// Dicts of name, amplitude, roughness and color of each biome.
py::list biome_table();

}  // namespace orogen::python
