// orogen.folding: the relief of folds.
#include "arrays.h"
#include "folding/warped_folds.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"

namespace orogen::python {

void bind_folding(py::module_& module) {
  py::module_ room = module.def_submodule("folding", "The relief of folds.");
  bind_fold_layers(room);
  define(
      room,
      {.name = "warped_folds",
       .summary = "Makes the relief of folds by noise warped along plate velocities.",
       .arguments = {map_argument(),
                     {"plates", "PlateMap", "From `orogen.tectonics.infer_plates`."},
                     {"boundaries", "BoundaryMap", "From `plate_boundaries`."},
                     {"velocity", "VelocityMap", "From `velocity_map`."},
                     seed_argument(),
                     threads_argument()},
       .parameters = describe_parameters<FoldParameters>(),
       .return_type = "array (ny, nx) of float32",
       .returns = "fold_relief in metres.",
       .citation = std::string(folds_stage().citation)},
      [](const VectorMap& map, const PlateMap& plates, const BoundaryMap& boundaries,
         const VelocityMap& velocity, std::uint32_t seed, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<FoldParameters>(keywords);
        return to_array(interruptible(threads, [&](Context& context) {
          return warped_folds(map, plates, boundaries, velocity, parameters, seed, context);
        }));
      },
      py::arg("map"), py::arg("plates"), py::arg("boundaries"), py::arg("velocity"),
      py::arg("seed") = 0, py::arg("threads") = 0);
}

}  // namespace orogen::python
