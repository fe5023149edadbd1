// orogen.island: polygon maps, islands on them, and their height maps.
#include "island/island.h"

#include "arrays.h"
#include "interruptible.h"
#include "island/island_relief.h"
#include "module.h"
#include "parameters.h"

namespace orogen::python {

namespace {

py::tuple to_tuple(const Lists& lists, const py::handle& owner) {
  return py::make_tuple(to_array<std::int32_t>(lists.first, owner),
                        to_array<std::int32_t>(lists.items, owner));
}

template <class Options>
void lists_property(Options& type, const char* name, Lists PolygonMap::*member, const char* text) {
  type.def_property_readonly(
      name,
      [member](const py::object& self) {
        return to_tuple(self.cast<const PolygonMap&>().*member, self);
      },
      text);
}

void bind_map(py::module_& room) {
  py::class_<PolygonMap> map(
      room, "PolygonMap",
      "Voronoi's cells of points on a rectangle, as a graph (paper B, IV-B). "
      "Lists are pairs (first, items): those of i are "
      "items[first[i]:first[i + 1]].");
  vector_property<double>(map, "centers", &PolygonMap::centers, "Points of cells, (n, 2), metres.");
  vector_property<double>(map, "corners", &PolygonMap::corners,
                          "Where cells meet, (m, 2), metres.");
  vector_property<std::int32_t>(map, "edge_centers", &PolygonMap::edge_centers,
                                "The two centers of each edge; the second -1 at the side.");
  vector_property<std::int32_t>(map, "edge_corners", &PolygonMap::edge_corners,
                                "The two corners of each edge.");
  lists_property(map, "center_edges", &PolygonMap::center_edges,
                 "Edges of centers, anticlockwise.");
  lists_property(map, "center_corners", &PolygonMap::center_corners,
                 "Corners of centers, anticlockwise.");
  lists_property(map, "corner_edges", &PolygonMap::corner_edges, "Edges of corners.");
  lists_property(map, "corner_centers", &PolygonMap::corner_centers, "Centers of corners.");
}

using IslandClass = py::class_<Island, std::shared_ptr<Island>>;

/// A property of centers or corners of an island.
template <class Number, class Item>
void values_property(IslandClass& type, const char* name, IslandValues Island::*where,
                     std::vector<Item> IslandValues::*member, const char* text) {
  type.def_property_readonly(
      name,
      [where, member](const py::object& self) {
        return to_array<Number>(self.cast<const Island&>().*where.*member, self);
      },
      text);
}

void bind_results(py::module_& room) {
  IslandClass island(room, "Island", "An island on a polygon map (paper B, IV).");
  island.def_property_readonly(
      "map", [](const Island& self) -> const PolygonMap& { return self.map; },
      py::return_value_policy::reference_internal, "The PolygonMap.");
  const auto centers = &Island::centers, corners = &Island::corners;
  values_property<std::uint8_t>(island, "center_water", centers, &IslandValues::water, "1: water.");
  values_property<std::uint8_t>(island, "center_ocean", centers, &IslandValues::ocean, "1: ocean.");
  values_property<float>(island, "center_elevation", centers, &IslandValues::elevation, "-1 to 1.");
  values_property<float>(island, "center_temperature", centers, &IslandValues::temperature,
                         "0 to 1.");
  values_property<float>(island, "center_moisture", centers, &IslandValues::moisture, "0 to 1.");
  values_property<float>(island, "corner_elevation", corners, &IslandValues::elevation, "-1 to 1.");
  values_property<float>(island, "corner_moisture", corners, &IslandValues::moisture, "0 to 1.");
  vector_property<std::uint8_t>(island, "coast", &Island::coast, "Of corners: 1 at the coast.");
  vector_property<std::int32_t>(island, "downstream", &Island::downstream,
                                "Of corners: the edge that water takes; -1: none.");
  vector_property<std::int32_t>(island, "corner_river", &Island::corner_river,
                                "What the river at each corner carries; 0: none.");
  vector_property<std::int32_t>(island, "edge_river", &Island::edge_river,
                                "What the river along each edge carries; 0: none.");
  vector_property<std::uint8_t>(island, "biomes", &Island::biomes,
                                "Of centers, numbers into `biomes()`.");

  py::class_<IslandRelief> relief(room, "IslandRelief", "Height map of an island (paper B, IV-F).");
  raster_property(relief, "elevation", &IslandRelief::elevation, "Ground in metres.");
  raster_property(relief, "water_depth", &IslandRelief::water_depth, "Depth of lakes in metres.");
  raster_property(relief, "temperature", &IslandRelief::temperature, "0 to 1.");
  raster_property(relief, "moisture", &IslandRelief::moisture, "0 to 1.");
  raster_property(relief, "biome", &IslandRelief::biome, "Numbers into `biomes()`.");
  raster_property(relief, "land", &IslandRelief::land, "1 on land, 0 at sea.");
}

}  // namespace

py::list biome_table() {
  py::list table;
  for (const BiomeInfo& biome : biomes()) {
    py::dict item;
    item["name"] = biome.name;
    item["amplitude"] = biome.amplitude;
    item["roughness"] = biome.roughness;
    item["color"] = biome.color;
    table.append(item);
  }
  return table;
}

void bind_island(py::module_& module) {
  py::module_ room = module.def_submodule("island", "Islands on polygon maps (paper B).");
  bind_map(room);
  bind_results(room);
  define(room,
         {.name = "biomes",
          .summary = "The sixteen kinds of country, in the order of their numbers.",
          .return_type = "list[dict[str, Any]]",
          .returns = "dicts of name, amplitude and roughness of relief, color (sRGB, 0xRRGGBB).",
          .citation = "Weiss 2015, Table I"},
         &biome_table);
  define(
      room,
      {.name = "make_island",
       .summary = "Makes an island on a map of random polygons.",
       .arguments = {{"grid", "Grid", "Its rectangle is the map's."},
                     seed_argument(),
                     threads_argument()},
       .parameters = describe_parameters<IslandParameters>(),
       .return_type = "Island",
       .returns = "Water, heights, rivers, climate and biomes of polygons.",
       .citation = "Weiss 2015, chapter IV, eq. 1 and 2"},
      [](const Grid& grid, std::uint32_t seed, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<IslandParameters>(keywords);
        const glm::dvec2 high = grid.origin + glm::dvec2(grid.width(), grid.height());
        return interruptible(threads, [&](Context& context) {
          return make_island(parameters, grid.origin, high, seed, {}, context);
        });
      },
      py::arg("grid"), py::arg("seed") = 0, py::arg("threads") = 0);
  define(
      room,
      {.name = "island_relief",
       .summary = "Draws an island as a height map.",
       .arguments = {{"island", "Island", "From `make_island`."},
                     {"grid", "Grid", "Where the rasters lie."},
                     seed_argument(),
                     threads_argument()},
       .parameters = describe_parameters<IslandReliefParameters>(),
       .return_type = "IslandRelief",
       .returns = "Ground, lakes, climate and biomes.",
       .citation = "Weiss 2015, chapter IV-F, eq. 3 and 4"},
      [](const Island& island, const Grid& grid, std::uint32_t seed, int threads,
         const py::kwargs& keywords) {
        const auto parameters = from_keywords<IslandReliefParameters>(keywords);
        return interruptible(threads, [&](Context& context) {
          return island_relief(island, parameters, grid, seed, context);
        });
      },
      py::arg("island"), py::arg("grid"), py::arg("seed") = 0, py::arg("threads") = 0);
}

}  // namespace orogen::python
