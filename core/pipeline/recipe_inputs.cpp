#include "pipeline/recipe_inputs.h"

#include <algorithm>
#include <iterator>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr double kFarthest = 1e8;  // m
constexpr std::size_t kMostPhases = 100;

glm::dvec2 read_place(const JsonValue& place) {
  if (place.array_size() != 2) place.refuse("two numbers are wanted");
  return {place.element(0).number(-kFarthest, kFarthest),
          place.element(1).number(-kFarthest, kFarthest)};
}

std::vector<glm::dvec2> read_places(const JsonValue& list) {
  std::vector<glm::dvec2> places;
  for (std::size_t i = 0; i < list.array_size(); ++i) places.push_back(read_place(list.element(i)));
  return places;
}

bool read_flag(const JsonValue& value) {
  if (!value.json().is_boolean()) value.refuse("true or false is wanted");
  return value.json().get<bool>();
}

PlateGesture read_gesture(const JsonValue& plate) {
  plate.only_members({"name", "points", "arrows", "crust", "stable"});
  PlateGesture gesture;
  gesture.points = read_places(plate.member("points"));
  gesture.arrows = read_places(plate.member("arrows"));
  if (plate.has("name")) gesture.name = plate.member("name").text(200);
  if (plate.has("crust")) {
    const JsonValue crust = plate.member("crust");
    if (crust.text() == "oceanic")
      gesture.crust = PlateCrust::Oceanic;
    else if (crust.text() != "continental")
      crust.refuse("continental or oceanic is wanted");
  }
  return gesture;
}

FoldEdit read_fold_edit(const JsonValue& item) {
  constexpr std::string_view kinds[] = {"add", "remove", "scale", "set"};
  FoldEdit edit;
  const std::string kind = item.member("edit").text();
  const auto found = std::find(std::begin(kinds), std::end(kinds), kind);
  if (found == std::end(kinds)) item.member("edit").refuse("add, remove, scale or set is wanted");
  edit.kind = FoldEditKind(found - std::begin(kinds));
  edit.a = read_place(item.member("from"));
  edit.b = read_place(item.member("to"));
  if (item.has("value")) edit.value = item.member("value").number(0.0, 20e3);
  return edit;
}

MotionPhase read_phase(const JsonValue& item) {
  item.only_members({"years", "plates"});
  MotionPhase phase;
  if (item.has("years")) phase.years = item.member("years").number(1e3, 1e9);
  const JsonValue plates = item.member("plates");
  phase.plates = read_plates(plates);
  for (std::size_t i = 0; i < phase.plates.size(); ++i) {
    const JsonValue plate = plates.element(i);
    if (!plate.has("stable") || !read_flag(plate.member("stable"))) continue;
    if (phase.stable_plate >= 0) plate.refuse("another plate of the phase is stable already");
    phase.stable_plate = int(i);
  }
  return phase;
}

SubLayer read_sub_layer(const JsonValue& item) {
  item.only_members({"lithology", "share", "resistance"});
  SubLayer sub_layer;
  const JsonValue lithology = item.member("lithology");
  std::string names;
  bool found = false;
  for (const LithologyInfo& info : known_lithologies()) {
    names += (names.empty() ? "" : ", ") + std::string(info.name);
    if (info.name != lithology.text()) continue;
    sub_layer.lithology = Lithology(&info - known_lithologies().data());
    found = true;
  }
  if (!found) lithology.refuse("no such rock; there are " + names);
  if (item.has("share")) sub_layer.share = item.member("share").number(1e-3, 1e3);
  if (item.has("resistance")) sub_layer.resistance = item.member("resistance").number(0.0, 1.0);
  return sub_layer;
}

Layer read_layer(const JsonValue& item) {
  item.only_members({"name", "thickness", "viscosity", "fold_wavelength", "fold_share",
                     "sub_layers", "thickness_map"});
  Layer layer;
  if (item.has("name")) layer.name = item.member("name").text(200);
  const auto number = [&](const char* name, double& value) {
    if (item.has(name)) value = item.member(name).number(0.0, 1e30);
  };
  number("thickness", layer.thickness);
  number("viscosity", layer.viscosity);
  number("fold_wavelength", layer.fold_wavelength);
  number("fold_share", layer.fold_share);
  const JsonValue parts = item.member("sub_layers");
  for (std::size_t i = 0; i < parts.array_size(); ++i)
    layer.sub_layers.push_back(read_sub_layer(parts.element(i)));
  if (item.has("thickness_map"))
    layer.thickness_map = read_rows<CornerMap>(item.member("thickness_map"), 0.0, 50e3);
  return layer;
}

nlohmann::json write_layer(const Layer& layer) {
  nlohmann::json parts = nlohmann::json::array();
  for (const SubLayer& s : layer.sub_layers) {
    parts.push_back({{"lithology", lithology_info(s.lithology).name}, {"share", s.share}});
    if (s.resistance) parts.back()["resistance"] = *s.resistance;
  }
  nlohmann::json item{{"name", layer.name},
                      {"thickness", layer.thickness},
                      {"viscosity", layer.viscosity},
                      {"fold_wavelength", layer.fold_wavelength},
                      {"fold_share", layer.fold_share},
                      {"sub_layers", std::move(parts)}};
  if (layer.thickness_map) {
    const CornerMap& map = *layer.thickness_map;
    nlohmann::json rows = nlohmann::json::array();
    for (int r = 0; r < map.rows; ++r)
      rows.push_back(std::vector(map.values.begin() + r * map.columns,
                                 map.values.begin() + (r + 1) * map.columns));
    item["thickness_map"] = std::move(rows);
  }
  return item;
}

}  // namespace

nlohmann::json write_column(const StratigraphicColumn& column) {
  nlohmann::json layers = nlohmann::json::array();
  for (const Layer& layer : column.layers) layers.push_back(write_layer(layer));
  return {{"basement", write_layer(column.basement)}, {"layers", std::move(layers)}};
}

CornerMap read_rain(const JsonValue& rows) {
  CornerMap rain = read_rows<CornerMap>(rows, 0.0, 1e6);
  if (std::ranges::all_of(rain.values, [](double v) { return v == 0.0; }))
    rows.refuse("all are 0; somewhere it must rain");
  return rain;
}

std::vector<FoldEdit> read_layer_edits(const JsonValue& list) {
  std::vector<FoldEdit> edits;
  for (std::size_t i = 0; i < list.array_size(); ++i) {
    list.element(i).only_members({"edit", "from", "to", "value"});
    edits.push_back(read_fold_edit(list.element(i)));
  }
  check_fold_edits(edits, list.place());
  return edits;
}

std::vector<LayerFoldEdit> read_fold_edits(const JsonValue& list) {
  std::vector<LayerFoldEdit> edits;
  std::vector<FoldEdit> plain;
  for (std::size_t i = 0; i < list.array_size(); ++i) {
    const JsonValue item = list.element(i);
    item.only_members({"edit", "layer", "phase", "from", "to", "value"});
    LayerFoldEdit& one = edits.emplace_back();
    one.edit = plain.emplace_back(read_fold_edit(item));
    one.layer = int(item.member("layer").integer(1, 40)) - 1;
    if (item.has("phase")) one.phase = int(item.member("phase").integer(1, kMostPhases)) - 1;
  }
  check_fold_edits(plain, list.place());
  return edits;
}

void check_fold_edit_places(const RecipeInputs& inputs) {
  const int layers = inputs.column ? int(inputs.column->layers.size()) : 0;
  const int phases = std::max(1, int(inputs.phases.size()));
  for (std::size_t i = 0; i < inputs.fold_edits.size(); ++i) {
    const auto check = [&](const char* member, int number, int count, const char* what) {
      if (number >= 0 && number < count) return;
      throw InputError("fold_edits[" + std::to_string(i) + "]." + member + ": " +
                       std::to_string(number + 1) + " is not allowed; the recipe's " + what +
                       (count ? " count from 1 to " + std::to_string(count) : " are missing"));
    };
    check("layer", inputs.fold_edits[i].layer, layers, "layers");
    check("phase", inputs.fold_edits[i].phase, phases, "phases");
  }
}

std::vector<PlateGesture> read_plates(const JsonValue& list) {
  std::vector<PlateGesture> plates;
  for (std::size_t i = 0; i < list.array_size(); ++i)
    plates.push_back(read_gesture(list.element(i)));
  check_gestures(plates, list.place());
  return plates;
}

std::vector<MotionPhase> read_phases(const JsonValue& list) {
  if (list.array_size() < 1 || list.array_size() > kMostPhases)
    list.refuse("1 to " + std::to_string(kMostPhases) + " phases are wanted");
  std::vector<MotionPhase> phases;
  for (std::size_t i = 0; i < list.array_size(); ++i) phases.push_back(read_phase(list.element(i)));
  return phases;
}

StratigraphicColumn read_column(const JsonValue& column) {
  if (column.has("preset")) {
    column.only_members({"preset"});
    const JsonValue preset = column.member("preset");
    return preset_column(preset.text(), preset.place());
  }
  column.only_members({"basement", "layers"});
  StratigraphicColumn result;
  result.basement = read_layer(column.member("basement"));
  const JsonValue layers = column.member("layers");
  for (std::size_t i = 0; i < layers.array_size(); ++i)
    result.layers.push_back(read_layer(layers.element(i)));
  check_column(result, column.place());
  return result;
}

}  // namespace orogen
