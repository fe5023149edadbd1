#include "pipeline/recipe.h"

#include <fstream>
#include <set>
#include <sstream>

#include "inputs/geojson.h"
#include "pipeline/feature_inputs.h"
#include "pipeline/plant_inputs.h"
#include "pipeline/recipe_inputs.h"
#include "pipeline/sha256.h"
#include "pipeline/strict_json.h"

namespace orogen {

namespace {

using nlohmann::json;

constexpr double kFarthestExtent = 1e8;  // m
constexpr std::uintmax_t kLargestFile = std::uintmax_t(1) << 30;

std::string read_file(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  if (error || !stream) throw InputError(file.string() + ": the file cannot be read");
  if (size > kLargestFile)
    throw InputError(file.string() + ": " + std::to_string(size) + " bytes are too many; at most " +
                     std::to_string(kLargestFile));
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

json read_map_member(const JsonValue& map, const RecipeSource& source) {
  if (!map.has("file")) return map.json();
  map.only_members({"file"});
  const std::filesystem::path file = map.member("file").text();
  if (file.is_absolute()) map.member("file").refuse("a path relative to the recipe is wanted");
  return parse_strict_json(read_file(source.folder / file));
}

void set_map(Recipe& recipe, const json& geojson, const std::string& place,
             const ReadOptions& options) {
  const std::string& text = recipe.documents["map"] = geojson.dump();
  try {
    recipe.inputs.map = std::make_shared<const VectorMap>(read_geojson(text, options));
  } catch (const InputError& error) {
    throw InputError((place.empty() ? "" : place + ": ") + error.what());
  }
}

glm::dvec2 pair(const JsonValue& value, double low, double high) {
  if (value.array_size() != 2) value.refuse("two numbers are wanted");
  return {value.element(0).number(low, high), value.element(1).number(low, high)};
}

Extent read_extent(const JsonValue& extent) {
  extent.only_members({"origin", "size"});
  return {pair(extent.member("origin"), -kFarthestExtent, kFarthestExtent),
          pair(extent.member("size"), 1.0, kFarthestExtent)};
}

ParameterValue read_value(const JsonValue& value) {
  const json& j = value.json();
  if (j.is_boolean()) return j.get<bool>();
  if (j.is_string()) return value.text();
  if (j.is_number_float()) return j.get<double>();
  if (j.is_number()) return value.integer(INT64_MIN, INT64_MAX);
  value.refuse("a number, true, false or text is wanted");
}

std::vector<RecipeStage> read_stages(const JsonValue& list) {
  std::vector<RecipeStage> result;
  for (std::size_t i = 0; i < list.array_size(); ++i) {
    const JsonValue item = list.element(i);
    item.only_members({"stage", "parameters"});
    RecipeStage& stage = result.emplace_back(RecipeStage{item.member("stage").text(), {}});
    if (!item.has("parameters")) continue;
    const JsonValue parameters = item.member("parameters");
    if (!parameters.json().is_object()) parameters.refuse("an object is wanted");
    for (const auto& [name, value] : parameters.json().items())
      stage.parameters.emplace(name, read_value({value, parameters.place() + "." + name}));
  }
  return result;
}

void set_rasters(Recipe& recipe, const JsonValue& rasters) {
  recipe.inputs.rasters = read_rasters(rasters);
  for (const auto& [name, raster] : recipe.inputs.rasters)
    recipe.documents[std::string(kRasterInput) + name] = write_raster(*raster).dump();
}

Extent extent_of(const Recipe& recipe) {
  if (recipe.extent) return *recipe.extent;
  return {recipe.inputs.map->frame.origin, recipe.inputs.map->frame.size};
}

std::vector<RiverSource> read_river_sources(const JsonValue& list, const Extent& extent) {
  std::vector<RiverSource> sources;
  for (std::size_t i = 0; i < list.array_size(); ++i) {
    const JsonValue item = list.element(i), position = item.member("position");
    item.only_members({"name", "position", "discharge"});
    if (item.has("name")) item.member("name").text(200);  // for its readers
    const glm::dvec2 p = pair(position, -kFarthestExtent, kFarthestExtent);
    const glm::dvec2 within = p - extent.origin;
    if (within.x < 0.0 || within.y < 0.0 || within.x >= extent.size.x || within.y >= extent.size.y)
      position.refuse("lies outside the terrain's extent");
    sources.push_back({.position = p});
    set_parameter(sources.back(), "discharge", read_value(item.member("discharge")), item.place());
  }
  return sources;
}

/// Which default stages a recipe without stages gets.
DefaultFor kind_of(const JsonValue& document, const RecipeInputs& inputs) {
  if (document.has("map")) return DefaultFor::Maps;
  if (inputs.has("phases")) return DefaultFor::Collisions;
  return inputs.has("rasters.elevation") ? DefaultFor::Heights : DefaultFor::Islands;
}

Recipe read_whole_recipe(const JsonValue& document, const RecipeSource& source) {
  document.only_members({"orogen", "name", "seed", "resolution", "extent", "map", "phases",
                         "column", "rain", "rasters", "fold_edits", "features", "river_sources",
                         "plants", "stages"});
  document.member("orogen").integer(kRecipeVersion, kRecipeVersion);
  Recipe recipe;
  recipe.name = document.has("name") ? document.member("name").text(200) : source.name;
  if (document.has("seed"))
    recipe.seed = std::uint32_t(document.member("seed").integer(0, UINT32_MAX));
  if (document.has("resolution"))
    recipe.resolution = int(document.member("resolution").integer(kMinResolution, kMaxResolution));
  if (document.has("extent")) recipe.extent = read_extent(document.member("extent"));
  for (const char* input :
       {"phases", "column", "rain", "fold_edits", "features", "river_sources", "plants"})
    if (document.has(input)) recipe.documents[input] = document.member(input).json().dump();
  if (document.has("phases")) recipe.inputs.phases = read_phases(document.member("phases"));
  if (document.has("column")) recipe.inputs.column = read_column(document.member("column"));
  if (document.has("rain")) recipe.inputs.rain = read_rain(document.member("rain"));
  if (document.has("rasters")) set_rasters(recipe, document.member("rasters"));
  if (document.has("fold_edits"))
    recipe.inputs.fold_edits = read_fold_edits(document.member("fold_edits"));
  if (document.has("features")) recipe.inputs.features = read_features(document.member("features"));
  if (document.has("plants")) recipe.inputs.plants = read_plants(document.member("plants"));
  recipe.stages = document.has("stages") ? read_stages(document.member("stages"))
                                         : default_stages(kind_of(document, recipe.inputs));
  if (document.has("map")) {
    const JsonValue map = document.member("map");
    if (!map.json().is_object()) map.refuse("a GeoJSON object or {\"file\": path} is wanted");
    set_map(recipe, read_map_member(map, source), "map", source.map_options);
  } else if (!recipe.extent) {
    document.refuse("without a map, member 'extent' must say where the terrain lies");
  }
  if (document.has("river_sources"))
    recipe.inputs.river_sources =
        read_river_sources(document.member("river_sources"), extent_of(recipe));
  check_stages(recipe.stages, recipe.inputs);
  return recipe;
}

json write_value(const ParameterValue& value, const ParameterInfo& info) {
  const auto number = [&] {
    const auto* i = std::get_if<std::int64_t>(&value);
    return i ? double(*i) : std::get<double>(value);
  };
  switch (info.kind) {
    case ParameterKind::Boolean:
      return std::get<bool>(value);
    case ParameterKind::Integer:
      return std::int64_t(number());
    case ParameterKind::Real:
      return number();
    case ParameterKind::Choice:
      return std::get<std::string>(value);
  }
  return {};
}

json write_stage(const RecipeStage& item) {
  json parameters = json::object();
  for (const ParameterInfo& info : find_stage(item.stage)->parameters)
    if (const auto set = item.parameters.find(info.name); set != item.parameters.end())
      parameters[info.name] = write_value(set->second, info);
  return {{"stage", item.stage}, {"parameters", std::move(parameters)}};
}

}  // namespace

Recipe read_recipe(std::string_view text, const RecipeSource& source) {
  const json document = parse_strict_json(text);
  if (document.is_object() && document.contains("orogen"))
    return read_whole_recipe({document, ""}, source);
  if (!document.is_object() || !document.contains("features"))
    throw InputError(
        "neither a recipe (its member 'orogen' is missing) nor a GeoJSON FeatureCollection");
  Recipe recipe;
  set_map(recipe, document, "", source.map_options);
  recipe.name = recipe.inputs.map->name.empty() ? source.name : recipe.inputs.map->name;
  recipe.stages = default_stages();
  return recipe;
}

Recipe load_recipe(const std::filesystem::path& file, const ReadOptions& map_options) {
  std::string name = file.filename().string();
  name = name.substr(0, name.find('.'));
  return read_recipe(read_file(file), {file.parent_path(), name, map_options});
}

Recipe default_recipe(const VectorMap& map) {
  Recipe recipe;
  set_map(recipe, json::parse(write_geojson(map)), "", {});
  recipe.name = recipe.inputs.map->name;
  recipe.stages = default_stages();
  return recipe;
}

std::vector<RecipeStage> default_stages(DefaultFor recipe) {
  std::vector<RecipeStage> result;
  for (const Stage& stage : stages())
    if (stage.by_default & recipe) result.push_back({std::string(stage.info->name), {}});
  return result;
}

std::string write_recipe(const Recipe& recipe, int indent) {
  json stages = json::array();
  for (const RecipeStage& item : recipe.stages) stages.push_back(write_stage(item));
  json document{{"orogen", kRecipeVersion},
                {"name", recipe.name},
                {"seed", recipe.seed},
                {"resolution", recipe.resolution},
                {"stages", std::move(stages)}};
  for (const auto& [input, text] : recipe.documents) {
    const bool raster = input.starts_with(kRasterInput);
    json& place = raster ? document["rasters"][input.substr(kRasterInput.size())] : document[input];
    place = json::parse(text);
  }
  if (recipe.extent)
    document["extent"] = {{"origin", {recipe.extent->origin.x, recipe.extent->origin.y}},
                          {"size", {recipe.extent->size.x, recipe.extent->size.y}}};
  return document.dump(indent);
}

std::string recipe_hash(const Recipe& recipe) {
  return sha256(write_recipe(recipe));
}

Grid recipe_grid(const Recipe& recipe, int resolution) {
  if (resolution != 0 && (resolution < kMinResolution || resolution > kMaxResolution))
    throw InputError("resolution: " + std::to_string(resolution) +
                     " is not allowed; a whole number from " + std::to_string(kMinResolution) +
                     " to " + std::to_string(kMaxResolution) + " is wanted");
  const Extent extent = extent_of(recipe);
  return grid_over(extent.origin, extent.size, resolution ? resolution : recipe.resolution);
}

void check_stages(const std::vector<RecipeStage>& items, const RecipeInputs& inputs) {
  check_fold_edit_places(inputs);
  std::set<std::string_view> written;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string place = "stages[" + std::to_string(i) + "]";
    const Stage* stage = find_stage(items[i].stage);
    if (!stage) {
      std::string names;
      for (const Stage& s : stages())
        names += (names.empty() ? "" : ", ") + std::string(s.info->name);
      throw InputError(place + ".stage: there is no stage '" + items[i].stage.substr(0, 60) +
                       "'; there are " + names);
    }
    stage->complete(items[i].parameters, place + ".parameters");
    for (const std::string_view input : stage->info->inputs)
      if (!inputs.has(input))
        throw InputError(place + ": stage '" + items[i].stage + "' needs '" + std::string(input) +
                         "', which the recipe does not have");
    for (const std::string_view field : stage->info->reads) {
      if (written.contains(field)) continue;
      std::string writers;
      for (const Stage& s : stages())
        for (const std::string_view w : s.info->writes)
          if (w == field) writers += (writers.empty() ? "" : " or ") + std::string(s.info->name);
      throw InputError(place + ": stage '" + items[i].stage + "' reads the field '" +
                       std::string(field) + "', which no stage before it writes; " + writers +
                       " must come first");
    }
    written.insert(stage->info->writes.begin(), stage->info->writes.end());
  }
}

}  // namespace orogen
