// orogen.folding, paper C: the folds of a column's layers, their lines and measures.
#include "folding/fold_layers.h"

#include <pybind11/stl.h>

#include <deque>

#include "arrays.h"
#include "folding/fold_lines.h"
#include "folding/fold_statistics.h"
#include "foundation/errors.h"
#include "interruptible.h"
#include "json_argument.h"
#include "module.h"
#include "parameters.h"
#include "pipeline/recipe_inputs.h"

namespace orogen::python {

namespace {

/// Layers from dictionaries, and the rasters that they refer to.
struct LayerArguments {
  std::vector<FoldLayer> layers;
  std::deque<Raster<float>> maps;

  LayerArguments(const py::list& given, const Grid& grid) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      const std::string place = "layers[" + std::to_string(i) + "]";
      if (!py::isinstance<py::dict>(given[i])) throw InputError(place + ": a dictionary is wanted");
      layers.push_back(read(given[i].cast<py::dict>(), place, grid));
    }
  }

 private:
  FoldLayer read(const py::dict& given, const std::string& place, const Grid& grid) {
    FoldLayer layer;
    for (const auto& [key, value] : given) {
      const auto name = py::str(key).cast<std::string>();
      const std::string at = place + "." + name;
      if (name == "edits") {
        layer.edits = read_layer_edits({to_json(value, at), at});
      } else if (name == "wavelength_map") {
        layer.wavelength_map = &maps.emplace_back(to_raster<float>(value, at.c_str(), grid));
      } else {
        set_parameter(layer, name, to_parameter_value(value, at), place);
      }
    }
    return layer;
  }
};

void bind_skeleton(py::module_& room) {
  py::class_<FoldLine> line(room, "FoldLine", "A fold from one end or joint to the next.");
  vector_property<double>(line, "points", &FoldLine::points, "(n, 2) in metres.");
  line.def_readonly("id", &FoldLine::id, "Stays when other folds are edited.")
      .def_readonly("closed", &FoldLine::closed, "Whether the last point joins the first.");

  py::class_<FoldSkeleton> skeleton(room, "FoldSkeleton", "Crest and trough lines of a layer.");
  skeleton
      .def_property_readonly(
          "top", [](const FoldSkeleton& s) { return fold_lines(s.top); }, "Crest lines.")
      .def_property_readonly(
          "bottom", [](const FoldSkeleton& s) { return fold_lines(s.bottom); }, "Trough lines.")
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            return to_array<double>(self.cast<const FoldSkeleton&>().mesh.points, self);
          },
          "Points (n, 2) of the mesh in metres.")
      .def_property_readonly(
          "edges",
          [](const py::object& self) {
            return to_array<std::int32_t>(self.cast<const FoldSkeleton&>().mesh.edges, self);
          },
          "Edges (n, 4) of the mesh: two points, and the faces to the left and right; -1: none.");
  vector_property<std::uint8_t>(
      skeleton, "choice", &FoldSkeleton::choice,
      "How each edge became a crest: 0 it is none, 1 by its energy, 2 by hand.");
}

void bind_statistics(py::module_& room) {
  py::class_<FoldStatistics>(room, "FoldStatistics", "Measures of a layer's folds.")
      .def_readonly("nodes", &FoldStatistics::nodes, "Points where crests begin, bend or meet.")
      .def_readonly("ends", &FoldStatistics::ends, "Nodes with one crest.")
      .def_readonly("joints", &FoldStatistics::joints, "Nodes with three crests or more.")
      .def_readonly("mean_length", &FoldStatistics::mean_length, "Of a fold, over the wavelength.")
      .def_readonly("mean_wavelength", &FoldStatistics::mean_wavelength,
                    "From crest to crest, over the wavelength.")
      .def_readonly("angle", &FoldStatistics::angle,
                    "Shares by 5 degrees between the compression and across the folds.")
      .def_readonly("wavelength", &FoldStatistics::wavelength,
                    "Shares by 0.1 wavelengths from crest to crest.");
  define(
      room,
      {.name = "fold_statistics",
       .summary = "Measures the folds of a layer within the map.",
       .arguments = {{"field", "CompressionField", "What they were made by."},
                     {"skeleton", "FoldSkeleton", "A layer's, from `fold_layers`."},
                     {"fold_wavelength", "float or array (ny, nx) of float32",
                      "The layer's, in metres."}},
       .return_type = "FoldStatistics",
       .returns = "Numbers of ends and joints, means, and histograms.",
       .citation = "Cordonnier et al. 2018, section 7.3, Table 3 and Fig. 16"},
      [](const CompressionField& field, const FoldSkeleton& skeleton,
         const py::object& fold_wavelength) {
        const VaryingArgument wavelength(fold_wavelength, "fold_wavelength", field.crust.grid());
        return interruptible(0, [&](Context&) {
          return fold_statistics(field, FoldWavelength(wavelength.varying()), skeleton);
        });
      },
      py::arg("field"), py::arg("skeleton"), py::arg("fold_wavelength"));
}

}  // namespace

void bind_fold_layers(py::module_& folding) {
  bind_skeleton(folding);
  bind_statistics(folding);
  py::class_<FoldedLayer> type(folding, "FoldedLayer", "The folds of one layer.");
  raster_property(type, "speed", &FoldedLayer::speed, "How fast the folds rise, in m/yr.");
  type.def_readonly("skeleton", &FoldedLayer::skeleton)
      .def_readonly("edits_without_effect", &FoldedLayer::edits_without_effect,
                    "Numbers of the edits that changed nothing.");
  define(
      folding,
      {.name = "fold_layers",
       .summary = "Folds layers of rock, each at its own wavelength.",
       .arguments = {{"field", "CompressionField", "From `orogen.tectonics.compression_field`."},
                     {"layers", "list[dict[str, Any]]",
                      "For each layer fold_wavelength in metres, speed_share (speed of its folds "
                      "over the uplift rate), wavelength_map (array (ny, nx) in metres, in place "
                      "of fold_wavelength) and edits (as fold_edits of recipes, without layer and "
                      "phase); all optional."},
                     seed_argument(),
                     threads_argument()},
       .parameters = describe_parameters<FoldLayersParameters>(),
       .return_type = "list[FoldedLayer]",
       .returns = "One for each layer, in order.",
       .citation = "Cordonnier et al. 2018, section 5, equations 3 and 4"},
      [](const CompressionField& field, const py::list& layers, std::uint32_t seed, int threads,
         const py::kwargs& keywords) {
        const auto parameters = from_keywords<FoldLayersParameters>(keywords);
        const LayerArguments given(layers, field.crust.grid());
        return interruptible(threads, [&](Context& context) {
          return fold_layers(field, given.layers, parameters, seed, context);
        });
      },
      py::arg("field"), py::arg("layers"), py::arg("seed") = 0, py::arg("threads") = 0);
}

}  // namespace orogen::python
