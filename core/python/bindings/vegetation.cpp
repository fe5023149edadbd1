// orogen.vegetation: trees after Weber and Penn, and ground cover.
#include "arrays.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"
#include "vegetation/ground_cover.h"
#include "vegetation/tree_mesh.h"
#include "vegetation/tree_species.h"
#include "vegetation/tree_statistics.h"

namespace orogen::python {

namespace {

template <class P>
py::dict values_of(const P& parameters) {
  py::dict result;
  for (const auto& [name, value] : parameter_values(parameters))
    result[py::str(name)] = to_python(value);
  return result;
}

py::dict tree_dict(const TreeParameters& parameters) {
  py::dict result = values_of(parameters);
  py::list stems;
  for (const StemParameters& stem : parameters.stems) stems.append(values_of(stem));
  result["stems"] = stems;
  return result;
}

py::list species_table() {
  py::list table;
  for (const TreeSpecies& species : tree_species()) {
    py::dict item;
    item["name"] = species.name;
    item["scientific"] = species.scientific;
    item["bark_color"] = species.bark_color;
    item["leaf_color"] = species.leaf_color;
    item["other_leaf_color"] = species.other_leaf_color;
    item["parameters"] = tree_dict(species.parameters);
    table.append(item);
  }
  return table;
}

py::list cover_table() {
  py::list table;
  for (const GroundCover& species : ground_cover()) {
    py::dict item;
    item["name"] = species.name;
    item["scientific"] = species.scientific;
    item["stem_color"] = species.stem_color;
    item["leaf_color"] = species.leaf_color;
    item["other_leaf_color"] = species.other_leaf_color;
    item["petal_color"] = species.petal_color;
    item["centre_color"] = species.centre_color;
    item["parameters"] = values_of(species.parameters);
    table.append(item);
  }
  return table;
}

py::dict parameter_schema() {
  py::dict schema;
  schema["tree"] = schema_of<TreeParameters>();
  schema["stem"] = schema_of<StemParameters>();
  schema["ground_cover"] = schema_of<GroundCoverParameters>();
  return schema;
}

template <class P>
void assign(P& target, const py::handle& name, const py::handle& value, const std::string& place) {
  const auto key = py::cast<std::string>(py::str(name));
  set_parameter(target, key, to_parameter_value(value, place + "." + key), place);
}

void assign_stems(TreeParameters& target, const py::handle& stems) {
  if (!py::isinstance<py::sequence>(stems) || py::len(stems) > kStemLevels)
    throw InputError("species.stems: up to " + std::to_string(kStemLevels) +
                     " dictionaries are wanted, one a level");
  std::size_t level = 0;
  for (const py::handle& stem : stems) {
    const std::string place = "species.stems[" + std::to_string(level) + "]";
    if (!py::isinstance<py::dict>(stem)) throw InputError(place + ": a dictionary is wanted");
    for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(stem))
      assign(target.stems[level], name, value, place);
    ++level;
  }
}

/// A species by its name, or parameters as `tree_species` lists them.
TreeParameters to_tree(const py::object& species) {
  if (py::isinstance<py::str>(species))
    return find_tree_species(species.cast<std::string>()).parameters;
  if (!py::isinstance<py::dict>(species))
    throw InputError("species: a name or a dictionary of parameters is wanted");
  TreeParameters result;
  for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(species))
    if (py::str(name).equal(py::str("stems")))
      assign_stems(result, value);
    else
      assign(result, name, value, "species");
  return result;
}

py::dict statistics_dict(const TreeStatistics& statistics) {
  py::dict result;
  result["height"] = statistics.height;
  result["crown_radius"] = statistics.crown_radius;
  result["trunk_radius"] = statistics.trunk_radius;
  result["leaves"] = statistics.leaves;
  py::list levels;
  for (const StemStatistics& level : statistics.levels) {
    py::dict item;
    item["stems"] = level.stems;
    item["forks"] = level.forks;
    item["shortest"] = level.shortest;
    item["mean"] = level.mean;
    item["longest"] = level.longest;
    levels.append(item);
  }
  result["levels"] = levels;
  return result;
}

/// Ground cover by its name, or parameters as `ground_cover` lists them.
GroundCoverParameters to_cover(const py::object& species) {
  if (py::isinstance<py::str>(species))
    return find_ground_cover(species.cast<std::string>()).parameters;
  if (!py::isinstance<py::dict>(species))
    throw InputError("species: a name or a dictionary of parameters is wanted");
  GroundCoverParameters result;
  for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(species))
    assign(result, name, value, "species");
  return result;
}

void bind_mesh(py::module_& room) {
  py::class_<PlantMesh> mesh(room, "PlantMesh",
                             "A plant's mesh of v vertices and f faces with c corners in all, in "
                             "metres, its foot at 0. Arrays are views.");
  vector_property<float>(mesh, "positions", &PlantMesh::positions, "Vertices (v, 3).");
  vector_property<std::int32_t>(mesh, "corners", &PlantMesh::corners,
                                "The vertex of each corner (c), face after face, anticlockwise.");
  vector_property<std::int32_t>(mesh, "face_starts", &PlantMesh::face_starts,
                                "Where each face's corners begin, and c at the end (f + 1).");
  vector_property<float>(mesh, "uvs", &PlantMesh::uvs, "Texture coordinates of corners (c, 2).");
  vector_property<std::uint8_t>(mesh, "materials", &PlantMesh::materials,
                                "Of faces (f): 0 stem, 1 leaf, 2 petal, 3 centre of a flower.");
  vector_property<std::uint8_t>(mesh, "levels", &PlantMesh::levels,
                                "Of faces (f): 0 what rises from the ground, 1 its branches and so "
                                "on, leaves last.");
}

Argument species_argument() {
  return {"species", "str or dict", "A name, or parameters as `tree_species` lists them."};
}

void bind_trees(py::module_& room) {
  define(room,
         {.name = "tree_species",
          .summary = "The species of trees and shrubs, in the order of their numbers.",
          .return_type = "list[dict[str, Any]]",
          .returns = "dicts of name, scientific name, colours (sRGB, 0xRRGGBB) and parameters.",
          .citation = "Weber and Penn 1995, appendix"},
         &species_table);
  define(room,
         {.name = "plant_parameters",
          .summary = "What the parameters of plants mean, with their defaults and ranges.",
          .return_type = "dict[str, Any]",
          .returns =
              "Lists: 'tree', of the whole, 'stem', of each of its four levels, 'ground_cover'.",
          .citation = "Weber and Penn 1995, appendix"},
         &parameter_schema);
  define(
      room,
      {.name = "make_tree",
       .summary = "Grows a tree and meshes it.",
       .arguments = {species_argument(), seed_argument(), threads_argument()},
       .parameters = describe_parameters<TreeMeshParameters>(),
       .return_type = "PlantMesh",
       .returns = "Stems as tubes, leaves as flat polygons.",
       .citation = "Weber and Penn 1995; Weiss 2015, VII-C"},
      [](const py::object& species, std::uint32_t seed, int threads, const py::kwargs& keywords) {
        const TreeParameters parameters = to_tree(species);
        const auto meshing = from_keywords<TreeMeshParameters>(keywords);
        return interruptible(threads, [&](Context& context) {
          return mesh_tree(grow_tree(parameters, seed, context), meshing, context);
        });
      },
      py::arg("species"), py::arg("seed") = 0, py::arg("threads") = 0);
  define(
      room,
      {.name = "tree_statistics",
       .summary = "Grows a tree and measures it.",
       .arguments = {species_argument(), seed_argument()},
       .return_type = "dict[str, Any]",
       .returns =
           "height, crown_radius and trunk_radius in metres; leaves; levels, each with its "
           "number of stems and forks and their shortest, mean and longest length in metres.",
       .citation = "Weber and Penn 1995"},
      [](const py::object& species, std::uint32_t seed) {
        const TreeParameters parameters = to_tree(species);
        return statistics_dict(interruptible(0, [&](Context& context) {
          return tree_statistics(grow_tree(parameters, seed, context));
        }));
      },
      py::arg("species"), py::arg("seed") = 0);
}

void bind_cover(py::module_& room) {
  define(room,
         {.name = "ground_cover",
          .summary = "The species of grass, ferns and flowers, in the order of their numbers.",
          .return_type = "list[dict[str, Any]]",
          .returns = "dicts of name, scientific name, colours (sRGB, 0xRRGGBB) and parameters.",
          .citation = "Weiss 2015, VII-B"},
         &cover_table);
  define(
      room,
      {.name = "make_ground_cover",
       .summary = "Makes a tuft of grass, a fern or a flower.",
       .arguments = {{"species", "str or dict",
                      "A name, or parameters as `ground_cover` lists them."},
                     seed_argument(),
                     {"crossed_quads", "bool",
                      "Two upright rectangles at right angles, for a picture with transparency.",
                      "False"}},
       .return_type = "PlantMesh",
       .returns = "Blades, fronds, stalks and petals.",
       .citation = "Weiss 2015, VII-B and Fig. 10"},
      [](const py::object& species, std::uint32_t seed, bool crossed_quads) {
        const GroundCoverParameters parameters = to_cover(species);
        const py::gil_scoped_release released;
        return make_ground_cover(parameters, seed, crossed_quads);
      },
      py::arg("species"), py::arg("seed") = 0, py::arg("crossed_quads") = false);
}

}  // namespace

void bind_vegetation(py::module_& module) {
  py::module_ room = module.def_submodule("vegetation", "Plants as meshes (paper B, VII).");
  bind_mesh(room);
  bind_plants(room);
  bind_trees(room);
  bind_cover(room);
}

}  // namespace orogen::python
