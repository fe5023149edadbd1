// orogen.vegetation: tables of plants, and plants placed on the ground.
#include "plants.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "arrays.h"
#include "interruptible.h"
#include "json_argument.h"
#include "module.h"
#include "parameters.h"
#include "pipeline/plant_inputs.h"
#include "vegetation/placement.h"

namespace orogen::python {

namespace {

PlantTable to_table(const py::object& table) {
  if (table.is_none()) return tree_table();
  const nlohmann::json document = to_json(table, "table");
  return read_plant_table({document, "table"}, {});
}

/// Fields of the ground as arguments.
struct GroundArgument {
  Raster<float> elevation;
  Raster<std::int32_t> biome;
  Raster<float> water_depth, snow_cover;  // may be empty

  PlantGround ground() const {
    const auto if_given = [](const Raster<float>& field) {
      return field.empty() ? nullptr : &field;
    };
    return {elevation, biome, if_given(water_depth), if_given(snow_cover)};
  }
};

GroundArgument to_ground(const py::object& elevation, const py::object& biome, double cell_size,
                         const py::object& water_depth, const py::object& snow_cover) {
  GroundArgument made{to_raster<float>(elevation, "elevation", cell_size), {}, {}, {}};
  const Grid& grid = made.elevation.grid();
  made.biome = to_raster<std::int32_t>(biome, "biome", grid);
  if (!water_depth.is_none()) made.water_depth = to_raster<float>(water_depth, "water_depth", grid);
  if (!snow_cover.is_none()) made.snow_cover = to_raster<float>(snow_cover, "snow_cover", grid);
  return made;
}

void bind_cloud(py::module_& room) {
  py::class_<PlantCloud> cloud(room, "PlantCloud", "Plants on the ground, n of them.");
  vector_property<float>(cloud, "positions", &PlantCloud::positions,
                         "(n, 3): metres east and north of the terrain's lower-left corner, and "
                         "above the sea.");
  vector_property<std::uint8_t>(cloud, "kinds", &PlantCloud::kinds,
                                "(n): places in the table's `kinds`.");
  vector_property<float>(cloud, "scales", &PlantCloud::scales,
                         "(n): size beside the kind's usual one.");
  vector_property<float>(cloud, "rotations", &PlantCloud::rotations,
                         "(n): about the upward axis, radians.");
  cloud.def_readonly("density_share", &PlantCloud::density_share,
                     "Below 1 where `most_plants` lowered all densities.");
  cloud.def("__len__", [](const PlantCloud& self) { return self.kinds.size(); });
}

Argument ground_array(const char* name, const char* text) {
  return {name, "array (ny, nx) of float32 or None", text, "None"};
}

}  // namespace

std::optional<PlantRegion> to_region(const py::object& region) {
  if (region.is_none()) return {};
  const auto corners = to_points(region, "region");
  if (corners.size() != 2) throw InputError("region: two corners, (low, high), are wanted");
  return PlantRegion{corners[0], corners[1]};
}

void bind_plants(py::module_& room) {
  bind_cloud(room);
  const char* const of_table =
      "density, plants a hectare by biome, and kinds: dicts of name, biomes (weights) and limits.";
  define(room,
         {.name = "tree_table",
          .summary = "Which trees grow in which biome, unless a recipe's `plants` say otherwise.",
          .return_type = "dict[str, Any]",
          .returns = of_table,
          .citation = "Weiss 2015, VII-C3"},
         [] { return from_json(write_plant_table(tree_table())); });
  define(room,
         {.name = "ground_cover_table",
          .summary = "The same for grasses, ferns and flowers.",
          .return_type = "dict[str, Any]",
          .returns = of_table,
          .citation = "Weiss 2015, VII-B"},
         [] { return from_json(write_plant_table(ground_cover_table())); });
  define(
      room,
      {.name = "place_plants",
       .summary = "Places plants by biome, spacing, slope and altitude.",
       .arguments = {elevation_argument(),
                     {"biome", "array (ny, nx) of int32", "Numbers into `orogen.island.biomes()`."},
                     cell_size_argument(),
                     {"table", "dict or None", "As `tree_table` gives it; None: that one.", "None"},
                     ground_array("water_depth", "Of lakes, metres."),
                     ground_array("snow_cover", "Share of the year; nothing grows at 1."),
                     {"region", "tuple or None",
                      "Corners ((x, y), (x, y)) of a part, metres from the lower-left corner.",
                      "None"},
                     seed_argument(),
                     threads_argument()},
       .parameters = describe_parameters<PlacementParameters>(),
       .return_type = "PlantCloud",
       .returns = "The same at any resolution of the same ground.",
       .citation = "Weiss 2015, VII-C3; Matern 1960"},
      [](const py::object& elevation, const py::object& biome, double cell_size,
         const py::object& table, const py::object& water_depth, const py::object& snow_cover,
         const py::object& region, std::uint32_t seed, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<PlacementParameters>(keywords);
        const PlantTable plants = to_table(table);
        const auto ground = to_ground(elevation, biome, cell_size, water_depth, snow_cover);
        const auto where = to_region(region);
        return interruptible(threads, [&](Context& context) {
          return place_plants(ground.ground(), plants, parameters, where, seed, context);
        });
      },
      py::arg("elevation"), py::arg("biome"), py::arg("cell_size"), py::arg("table") = py::none(),
      py::arg("water_depth") = py::none(), py::arg("snow_cover") = py::none(),
      py::arg("region") = py::none(), py::arg("seed") = 0, py::arg("threads") = 0);
}

}  // namespace orogen::python
