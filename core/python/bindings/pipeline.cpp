// orogen.Recipe, orogen.generate, orogen.schema.
#include "pipeline/pipeline.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <exception>

#include "arrays.h"
#include "erosion/mountain_growth.h"
#include "foundation/fields.h"
#include "interruptible.h"
#include "island/island.h"
#include "json_argument.h"
#include "module.h"
#include "parameters.h"
#include "pipeline/collision_products.h"
#include "pipeline/ground_volume.h"
#include "pipeline/plant_inputs.h"
#include "pipeline/recipe.h"
#include "pipeline/recipe_inputs.h"
#include "pipeline/stages.h"
#include "pipeline/vegetation_stages.h"
#include "plants.h"
#include "rocks.h"
#include "strata/layer_parameters.h"

namespace orogen::python {

namespace {

std::string projection_of(const Recipe& recipe) {
  return recipe.inputs.map ? recipe.inputs.map->frame.proj4 : std::string();
}

std::vector<std::string> warnings_of(const Recipe& recipe) {
  return recipe.inputs.map ? recipe.inputs.map->warnings : std::vector<std::string>();
}

void bind_recipe(py::module_& module) {
  py::class_<Recipe>(module, "Recipe")
      .def_static(
          "read",
          [](const std::string& json, const std::filesystem::path& folder, const std::string& name,
             bool strict) {
            return read_recipe(json, {folder, name, {.strict = strict}});
          },
          py::arg("json"), py::arg("folder"), py::arg("name"), py::arg("strict"))
      .def_static(
          "load",
          [](const std::filesystem::path& file, bool strict) {
            return load_recipe(file, {.strict = strict});
          },
          py::arg("file"), py::arg("strict"))
      .def("to_json", &write_recipe, py::arg("indent") = -1)
      .def("hash", &recipe_hash)
      .def("grid", &recipe_grid, py::arg("resolution") = 0)
      .def_readonly("name", &Recipe::name)
      .def_readonly("seed", &Recipe::seed)
      .def_readonly("resolution", &Recipe::resolution)
      .def_property_readonly("proj4", &projection_of)
      .def_property_readonly("warnings", &warnings_of);
}

py::list names_of(const Generated& generated) {
  py::list names;
  for (const FieldInfo& info : known_fields())
    if (generated.terrain.has(info.name)) names.append(info.name);
  return names;
}

py::array field_of(const Generated& generated, const std::string& name) {
  const auto found = generated.terrain.fields().find(name);
  if (found == generated.terrain.fields().end()) throw py::key_error(name);
  return to_array(found->second);
}

/// None unless the stages made rocks.
std::optional<Rocks> rocks_of(const Generated& generated) {
  auto strata = generated.products.find<Strata>();
  if (!strata) return {};
  return Rocks{std::move(strata), std::get<RealField>(generated.terrain.field("elevation"))};
}

/// Growth as a sequence: years, elevation and strata_color of each frame.
py::list frames_of(const Generated& generated) {
  py::list list;
  const auto kept = generated.products.find<GrowthFrames>();
  const auto strata = generated.products.find<Strata>();
  if (!kept || !strata) return list;
  for (const GrowthFrame& frame : kept->frames) {
    py::dict item;
    item["years"] = frame.years;
    item["elevation"] = to_array(RealField(kept, &frame.elevation));
    Raster<std::int32_t> colors = frame.rock;
    for (std::int32_t& rock : colors.values()) rock = std::int32_t(strata->rocks.color_of(rock));
    item["strata_color"] = to_array(std::move(colors));
    list.append(item);
  }
  return list;
}

/// None unless mountains grew.
std::optional<std::shared_ptr<GrownTin>> tin_of(const Generated& generated) {
  const auto grown = generated.products.find<GrownTin>();
  if (!grown) return {};
  return std::const_pointer_cast<GrownTin>(grown);  // read-only in Python
}

/// None unless an island was made.
std::optional<std::shared_ptr<Island>> island_of(const Generated& generated) {
  const auto made = generated.products.find<Island>();
  if (!made) return {};
  return std::const_pointer_cast<Island>(made);  // read-only in Python
}

/// Views of what `generated` keeps.
py::list folds_of(const py::object& generated) {
  py::list list;
  const Products& products = generated.cast<const Generated&>().products;
  const auto folds = products.find<FoldedPhases>();
  const auto collision = products.find<CollisionPhases>();
  if (!folds || !collision) return list;
  for (std::size_t p = 0; p < folds->phases.size(); ++p)
    for (std::size_t k = 0; k < folds->phases[p].size(); ++k) {
      const FoldedLayer& layer = folds->phases[p][k];
      if (layer.speed.empty()) continue;
      py::dict d;
      d["phase"] = p + 1;
      d["layer"] = k + 1;
      d["years"] = collision->phases[p].years;
      d["speed"] = array_view(layer.speed.grid(), layer.speed.data(), generated, false);
      d["skeleton"] =
          py::cast(&layer.skeleton, py::return_value_policy::reference_internal, generated);
      list.append(d);
    }
  return list;
}

/// The tables of plants; None unless they are settled.
py::object planting_of(const Generated& generated) {
  const auto planting = generated.products.find<Planting>();
  if (!planting) return py::none();
  py::dict tables;
  tables["trees"] = from_json(write_plant_table(planting->tables.trees));
  tables["ground_cover"] = from_json(write_plant_table(planting->tables.ground_cover));
  return tables;
}

PlantCloud place(const Generated& generated, const std::string& layer, const py::object& region,
                 int most_plants, int threads) {
  const auto planting = generated.products.find<Planting>();
  if (!planting) throw InputError("plants: the recipe lacks the stage 'vegetation'");
  const auto which = PlantLayer(detail::to_choice(layer, kPlantLayers, 2, "plants", "layer"));
  const auto where = to_region(region);
  return interruptible(threads, [&](Context& context) {
    return plants_of(*planting, which, plant_ground(generated.terrain), where, most_plants,
                     context);
  });
}

py::list times_of(const Generated& generated) {
  py::list times;
  for (const StageTime& time : generated.stages)
    times.append(py::make_tuple(time.stage, time.seconds, time.cached));
  return times;
}

void bind_generated(py::module_& module) {
  py::class_<Cache, std::shared_ptr<Cache>>(
      module, "Cache", "Results of stages, kept for the next run that can use them.")
      .def(py::init<std::size_t>(), py::arg("capacity_bytes"))
      .def("clear", &Cache::clear, "Drops everything.")
      .def_property_readonly("bytes", &Cache::bytes, "Memory of what is kept.")
      .def_property_readonly("capacity_bytes", &Cache::capacity, "Most memory it may keep.")
      .def("__len__", &Cache::size);
  py::class_<Generated>(module, "Generated")
      .def_property_readonly("fields", &names_of)
      .def("field", &field_of, py::arg("name"))
      .def(
          "write_ground",
          [](const Generated& g, const std::filesystem::path& file, int threads) {
            run_interruptible(py::none(), threads, [&](Context& context) {
              context.run(
                  [&] { write_ground_volume(file, g.terrain.real("elevation"), {}, context); });
            });
          },
          py::arg("file"), py::arg("threads"))
      .def_property_readonly("grid", [](const Generated& g) { return g.terrain.grid(); })
      .def_property_readonly("rocks", &rocks_of)
      .def_property_readonly("frames", &frames_of)
      .def_property_readonly("tin", &tin_of)
      .def_property_readonly("island", &island_of)
      .def_property_readonly("folds", &folds_of)
      .def_property_readonly("planting", &planting_of)
      .def("plants", &place, py::arg("layer"), py::arg("region"), py::arg("most_plants"),
           py::arg("threads"))
      .def_property_readonly("stages", &times_of)
      .def_readonly("seed", &Generated::seed)
      .def_readonly("warnings", &Generated::warnings)
      .def_readonly("estimated_bytes", &Generated::estimated_bytes);
}

py::dict fields_of(const WatchedGround& ground) {
  py::dict fields;
  const auto add = [&](const char* name, const Raster<float>& values) {
    if (!values.empty()) fields[name] = to_array(Raster<float>(values));
  };
  add("elevation", ground.elevation);
  add("water_depth", ground.water_depth);
  add("change", ground.change);
  return fields;
}

Generated run_generate(const Recipe& recipe, int resolution, std::optional<std::uint32_t> seed,
                       int threads, const py::object& progress, std::size_t memory_limit_bytes,
                       const std::shared_ptr<Cache>& cache, const py::object& watch) {
  std::optional<Generated> result;
  std::exception_ptr of_watch;
  const auto work = [&](Context& context) {
    GrowthWatch looking([&](double years, const WatchedGround& ground) {
      const py::gil_scoped_acquire gil;
      try {
        watch(years, fields_of(ground), ground.elevation.grid());
      } catch (py::error_already_set&) {
        of_watch = std::current_exception();
        context.cancel();
      }
    });
    const GenerateOptions options{resolution, seed, memory_limit_bytes,
                                  watch.is_none() ? nullptr : &looking};
    result.emplace(generate(recipe, options, context, cache.get()));
  };
  try {
    run_interruptible(progress, threads, work);
  } catch (...) {
    if (of_watch) std::rethrow_exception(of_watch);
    throw;
  }
  return std::move(*result);
}

py::list to_list(const std::vector<std::string_view>& names) {
  py::list list;
  for (const auto name : names) list.append(name);
  return list;
}

/// What columns are made of: the numbers of a layer, the rocks, and whole columns by name.
void describe_columns(py::dict& result) {
  py::list lithologies;
  py::dict columns;
  for (const LithologyInfo& info : known_lithologies()) {
    py::dict item;
    item["name"] = info.name;
    item["resistance"] = info.resistance;
    item["map"] = info.map;
    item["natural"] = info.natural;
    lithologies.append(item);
  }
  for (const auto name : column_names())
    columns[py::str(name)] = from_json(write_column(preset_column(name)));
  result["layer"] = schema_of<Layer>();
  result["lithologies"] = lithologies;
  result["columns"] = columns;
}

/// Tables of plants, and the numbers of a kind.
void describe_plants(py::dict& result) {
  py::dict plants;
  plants["trees"] = from_json(write_plant_table(tree_table()));
  plants["ground_cover"] = from_json(write_plant_table(ground_cover_table()));
  result["plant_kind"] = schema_of<PlantKind>();
  result["plants"] = plants;
}

py::dict schema() {
  py::list stage_list, field_list;
  for (const Stage& stage : stages()) {
    py::list parameters;
    for (const ParameterInfo& info : stage.parameters) parameters.append(to_dict(info));
    py::dict item;
    item["name"] = stage.info->name;
    item["text"] = stage.info->text;
    item["citation"] = stage.info->citation;
    item["reads"] = to_list(stage.info->reads);
    item["writes"] = to_list(stage.info->writes);
    item["may_read"] = to_list(stage.info->may_read);
    item["inputs"] = to_list(stage.info->inputs);
    item["parameters"] = parameters;
    stage_list.append(item);
  }
  for (const FieldInfo& info : known_fields()) {
    py::dict item;
    item["name"] = info.name;
    item["type"] = info.type == FieldType::Real ? "float32" : "int32";
    item["unit"] = info.unit;
    item["description"] = info.text;
    field_list.append(item);
  }
  py::list raster_list;
  for (const GivenRasterInfo& info : known_given_rasters()) {
    py::dict item;
    item["name"] = info.name;
    item["unit"] = info.unit;
    item["description"] = info.text;
    item["min"] = info.least;
    item["max"] = info.most;
    item["otherwise"] = info.otherwise;
    raster_list.append(item);
  }
  const auto names_of_default = [](DefaultFor recipe) {
    py::list names;
    for (const RecipeStage& item : default_stages(recipe)) names.append(item.stage);
    return names;
  };
  py::dict result;
  result["orogen"] = kRecipeVersion;
  result["stages"] = stage_list;
  result["default_stages"] = names_of_default(DefaultFor::Maps);
  result["collision_stages"] = names_of_default(DefaultFor::Collisions);
  result["height_stages"] = names_of_default(DefaultFor::Heights);
  result["island_stages"] = names_of_default(DefaultFor::Islands);
  describe_columns(result);
  describe_plants(result);
  result["river_source"] = schema_of<RiverSource>();
  result["fields"] = field_list;
  result["biomes"] = biome_table();
  result["rasters"] = raster_list;
  result["resolution"] = py::make_tuple(kMinResolution, kMaxResolution);
  return result;
}

}  // namespace

void bind_pipeline(py::module_& module) {
  bind_recipe(module);
  bind_generated(module);
  module.def("generate", &run_generate, py::arg("recipe"), py::arg("resolution"), py::arg("seed"),
             py::arg("threads"), py::arg("progress"), py::arg("memory_limit_bytes"),
             py::arg("cache"), py::arg("watch"));
  module.def("schema", &schema);
  module.def("available_memory", &available_memory);
}

}  // namespace orogen::python
