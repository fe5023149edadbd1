// orogen.tectonics, paper C: rigid plates, compression of the crust between them, uplift, margins.
#include <pybind11/stl.h>

#include "arrays.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "interruptible.h"
#include "json_argument.h"
#include "module.h"
#include "parameters.h"
#include "pipeline/recipe_inputs.h"
#include "tectonics/collision_uplift.h"
#include "tectonics/fault_dip.h"
#include "tectonics/plate_margins.h"
#include "tectonics/smoothed_compression.h"

namespace orogen::python {

namespace {

using Plates = std::vector<RigidPlate>;

const Argument kPlates{"plates", "list[RigidPlate]", "From `rigid_plates`."};
const Argument kField{"field", "CompressionField", "Of these plates, from `compression_field`."};

py::tuple pair(glm::dvec2 v) {
  return py::make_tuple(v.x, v.y);
}

void bind_plates(py::module_& room) {
  py::class_<RigidPlate> type(room, "RigidPlate", "A plate that moves as a rigid body.");
  vector_property<double>(type, "hull", &RigidPlate::hull,
                          "Corners (n, 2) before the move in metres, anticlockwise.");
  vector_property<double>(type, "moved_hull", &RigidPlate::moved_hull,
                          "Corners (n, 2) after the move in metres.");
  vector_property<double>(type, "arrows", &RigidPlate::arrows,
                          "How the rigid motion moves each point, (n, 2) in metres.");
  type.def_property_readonly(
          "angle", [](const RigidPlate& p) { return p.motion.angle(); },
          "Of the rotation about (0, 0) in radians, anticlockwise.")
      .def_property_readonly(
          "translation", [](const RigidPlate& p) { return pair(p.motion.translation); },
          "(x, y) in metres, after the rotation.")
      .def_property_readonly("displacement", &RigidPlate::displacement,
                             "Root mean square of the arrows in metres.")
      .def_readonly("residual_m", &RigidPlate::residual_m,
                    "Root mean square of what the drawn arrows have besides the rigid motion.")
      .def_property_readonly(
          "crust", [](const RigidPlate& p) { return kPlateCrusts[int(p.crust)]; },
          "continental or oceanic.")
      .def_readonly("name", &RigidPlate::name);
  define(
      room,
      {.name = "rigid_plates",
       .summary = "Fits a rigid motion to the points and arrows of each plate.",
       .arguments = {{"plates", "list[dict[str, Any]]",
                      "As recipes have them: points (n, 2) and arrows (n, 2) in metres, and "
                      "optionally name and crust ('continental' or 'oceanic')."}},
       .return_type = "list[RigidPlate]",
       .returns = "One for each plate, in order.",
       .citation = "Cordonnier et al. 2018, section 4.1"},
      [](const py::object& plates) {
        return rigid_plates(read_plates({to_json(plates, "plates"), "plates"}));
      },
      py::arg("plates"));
}

CompressionField field_from_arrays(const py::object& x, const py::object& y, const Grid& grid) {
  return {Raster<float>(grid, 1.0f), to_raster<float>(x, "compression_x", grid),
          to_raster<float>(y, "compression_y", grid), Raster<std::int32_t>(grid, -1),
          grid.width() * grid.height()};
}

void bind_compression(py::module_& room) {
  py::class_<CompressionField> type(room, "CompressionField",
                                    "How the crust is squeezed between moving plates.");
  raster_property(type, "crust", &CompressionField::crust,
                  "Amount of crust in each cell over that before the move.");
  raster_property(type, "compression_x", &CompressionField::compression_x,
                  "Eastward part of the compression, 0 to 1 in size; its sign has no meaning.");
  raster_property(type, "compression_y", &CompressionField::compression_y,
                  "Northward part of the compression.");
  raster_property(type, "influence", &CompressionField::plate,
                  "Number of the nearest plate; -1 if there are no plates.");
  type.def_readonly("source_area_m2", &CompressionField::source_area_m2,
                    "Area in m2 that the grid's crust came from.")
      .def_property_readonly("grid", [](const CompressionField& f) { return f.crust.grid(); })
      .def_static("from_arrays", &field_from_arrays, py::arg("compression_x"),
                  py::arg("compression_y"), py::arg("grid"),
                  "A field without plates from arrays (ny, nx), to be folded.");
  define(
      room,
      {.name = "compression_field",
       .summary = "Squeezes the crust between moving plates.",
       .arguments = {kPlates, {"grid", "Grid", "Where the rasters lie."}, threads_argument()},
       .parameters = describe_parameters<TransportParameters>(),
       .return_type = "CompressionField",
       .returns = "Rasters `crust`, `compression_x`, `compression_y` and `influence`.",
       .citation = "Cordonnier et al. 2018, sections 4.2 and 5.2, equations 1 and 2"},
      [](const Plates& plates, const Grid& grid, int threads, const py::kwargs& keywords) {
        const TransportField transport(plates, from_keywords<TransportParameters>(keywords));
        return interruptible(
            threads, [&](Context& context) { return compression_field(transport, grid, context); });
      },
      py::arg("plates"), py::arg("grid"), py::arg("threads") = 0);
  define(
      room,
      {.name = "smoothed_compression",
       .summary = "Spreads compression out as the crust does.",
       .arguments = {{"field", "CompressionField", "From `compression_field`."},
                     {"smoothing", "float", "Standard deviation of the blur in metres."},
                     threads_argument()},
       .return_type = "CompressionField",
       .returns = "The field with its compression smoothed."},
      [](const CompressionField& field, double smoothing, int threads) {
        return interruptible(threads, [&](Context& context) {
          return smoothed_compression(field, smoothing, context);
        });
      },
      py::arg("field"), py::arg("smoothing"), py::arg("threads") = 0);
}

void bind_transport(py::module_& room) {
  define(
      room,
      {.name = "transport_inverse",
       .summary = "Says where the ground at each place came from.",
       .arguments = {kPlates,
                     {"points", "array (n, 2) of float64", "Places after the move in metres."},
                     threads_argument()},
       .parameters = describe_parameters<TransportParameters>(),
       .return_type = "array (n, 2) of float64",
       .returns = "Places before the move in metres.",
       .citation = "Cordonnier et al. 2018, equations 1 and 2"},
      [](const Plates& plates, const py::object& points, int threads, const py::kwargs& keywords) {
        const TransportField transport(plates, from_keywords<TransportParameters>(keywords));
        auto places = to_points(points, "points");
        run_interruptible(py::none(), threads, [&](Context& context) {
          context.run([&] {
            parallel_chunks(context, places.size(), 1024, [&](std::size_t begin, std::size_t end) {
              for (std::size_t i = begin; i < end; ++i) places[i] = transport.inverse(places[i]);
            });
          });
        });
        return to_array<double>(places);
      },
      py::arg("plates"), py::arg("points"), py::arg("threads") = 0);
}

/// InputError unless the field names these plates alone.
void check_influence(const CompressionField& field, const Plates& plates) {
  const int count = int(plates.size());
  for (const std::int32_t plate : field.plate.values())
    if (plate >= count || plate < (count ? 0 : -1))
      throw InputError("field: lies in the influence of plate " + std::to_string(plate) +
                       "; it must be the compression of these " + std::to_string(count) +
                       " plates");
}

void bind_uplift(py::module_& room) {
  py::class_<CollisionUplift> uplift(room, "CollisionUplift", "Uplift of colliding plates.");
  raster_property(uplift, "uplift_rate", &CollisionUplift::uplift_rate, "In m/yr.");
  raster_property(uplift, "fault", &CollisionUplift::fault,
                  "Distance to the fault in metres, positive on the moving side; width + height "
                  "of the grid without a fault.");
  uplift
      .def_property_readonly(
          "fault_lines",
          [](const CollisionUplift& u) {
            py::list lines;
            for (const Polyline& line : u.fault_lines) lines.append(to_array<double>(line));
            return lines;
          },
          "Arrays (n, 2) in metres, the moving side on their left.")
      .def_readonly("stable_plate", &CollisionUplift::stable_plate,
                    "Number of the plate that the fault lies on; -1: there are no plates.");
  define(
      room,
      {.name = "collision_uplift",
       .summary = "Lifts the crust where plates thicken it, as far as a fault.",
       .arguments = {kPlates, kField, threads_argument()},
       .parameters = describe_parameters<CollisionParameters>(),
       .return_type = "CollisionUplift",
       .returns = "Rasters `uplift_rate` and `fault`, `fault_lines` and `stable_plate`.",
       .citation = "Cordonnier et al. 2018, section 4.3"},
      [](const Plates& plates, const CompressionField& field, int threads,
         const py::kwargs& keywords) {
        const auto parameters = from_keywords<CollisionParameters>(keywords);
        check_influence(field, plates);
        const TransportField transport(plates);
        return interruptible(threads, [&](Context& context) {
          const auto meet =
              plate_convergence(transport, field.crust.grid(), parameters.crust_smoothing, context);
          return collision_uplift(transport, field, meet, parameters, context);
        });
      },
      py::arg("plates"), py::arg("field"), py::arg("threads") = 0);
}

void bind_margins(py::module_& room) {
  py::class_<PlateMargins> margins(room, "PlateMargins", "Rifts, trenches and volcanic arcs.");
  raster_property(margins, "uplift_rate", &PlateMargins::uplift_rate,
                  "In m/yr, beside that of collision; negative where the ground sinks.");
  vector_property<double>(margins, "volcanoes", &PlateMargins::volcanoes,
                          "Places (n, 2) in metres.");
  define(
      room,
      {.name = "plate_margins",
       .summary = "Sinks rifts and trenches and raises volcanic arcs along plates' borders.",
       .arguments = {kPlates,
                     kField,
                     {"growth_time", "float", "Years in which they reach their sizes.",
                      "2000000.0"},
                     seed_argument(),
                     threads_argument()},
       .parameters = describe_parameters<MarginParameters>(),
       .return_type = "PlateMargins",
       .returns = "Raster `uplift_rate` and the places `volcanoes`."},
      [](const Plates& plates, const CompressionField& field, double growth_time,
         std::uint32_t seed, int threads, const py::kwargs& keywords) {
        auto parameters = from_keywords<MarginParameters>(keywords);
        if (!(growth_time > 0.0)) throw InputError("growth_time: more than 0 years are wanted");
        parameters.growth_time = growth_time;
        check_influence(field, plates);
        const TransportField transport(plates);
        return interruptible(threads, [&](Context& context) {
          return plate_margins(transport, field, parameters, seed, context);
        });
      },
      py::arg("plates"), py::arg("field"), py::arg("growth_time") = 2e6, py::arg("seed") = 0,
      py::arg("threads") = 0);
}

void bind_fault_motion(py::module_& room) {
  py::class_<FaultMotion> motion(room, "FaultMotion", "Horizontal motion above a dipping fault.");
  raster_property(motion, "velocity_x", &FaultMotion::velocity_x, "Eastward part in m/yr.");
  raster_property(motion, "velocity_y", &FaultMotion::velocity_y, "Northward part in m/yr.");
  define(
      room,
      {.name = "fault_motion",
       .summary = "Moves the rock above a dipping fault sideways, onto the stable plate.",
       .arguments = {{"uplift_rate", "array (ny, nx) of float32", "In m/yr."},
                     {"fault", "array (ny, nx) of float32",
                      "Distance to the fault in metres, positive on the moving side."},
                     cell_size_argument(),
                     threads_argument()},
       .parameters = describe_parameters<FaultDipParameters>(),
       .return_type = "FaultMotion",
       .returns = "Rasters `velocity_x` and `velocity_y`."},
      [](const py::object& uplift_rate, const py::object& fault, double cell_size, int threads,
         const py::kwargs& keywords) {
        const auto parameters = from_keywords<FaultDipParameters>(keywords);
        const auto u = to_raster<float>(uplift_rate, "uplift_rate", cell_size);
        const auto s = to_raster<float>(fault, "fault", u.grid());
        return interruptible(
            threads, [&](Context& context) { return fault_motion(u, s, parameters, context); });
      },
      py::arg("uplift_rate"), py::arg("fault"), py::arg("cell_size"), py::arg("threads") = 0);
}

}  // namespace

void bind_collision(py::module_& tectonics) {
  bind_plates(tectonics);
  bind_compression(tectonics);
  bind_transport(tectonics);
  bind_uplift(tectonics);
  bind_margins(tectonics);
  bind_fault_motion(tectonics);
}

}  // namespace orogen::python
