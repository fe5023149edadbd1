// Columns by name. Thicknesses and successions are those of textbook sections, rounded; what
// matters is the order of strong and weak beds.
#include <functional>

#include "foundation/errors.h"
#include "strata/column.h"

namespace orogen {

namespace {

using L = Lithology;

struct Preset {
  std::string_view name;
  StratigraphicColumn (*make)();
};

Layer layer(std::string name, double thickness, double viscosity, double wavelength, double share,
            std::vector<SubLayer> sub_layers) {
  return {std::move(name), thickness, viscosity, wavelength, share, std::move(sub_layers), {}};
}

/// `pairs` times a weak bed under a hard one.
std::vector<SubLayer> alternating(L weak, L hard, int pairs, double weak_share = 1.0) {
  std::vector<SubLayer> beds;
  for (int i = 0; i < pairs; ++i) {
    beds.push_back({weak_share, weak, {}});
    beds.push_back({1.0, hard, {}});
  }
  return beds;
}

StratigraphicColumn jura() {
  return {
      layer("basement", 6000, 1e22, 0, 0, {{1, L::Gneiss, {}}}),
      {layer("Keuper evaporites", 500, 1e18, 20e3, 0.0,
             {{2, L::Salt, {}}, {1, L::Gypsum, {}}, {1, L::Marl, {}}}),
       layer("Lias and Dogger", 800, 1e20, 7000, 0.5,
             {{2, L::Marl, {}}, {1, L::Limestone, {}}, {1, L::Marl, {}}, {1.5, L::Limestone, {}}}),
       layer(
           "Malm", 700, 3e20, 3000, 0.12,
           {{1, L::Marl, {}}, {1.5, L::Limestone, {}}, {0.5, L::Marl, {}}, {2, L::Limestone, {}}}),
       layer("Molasse", 500, 1e19, 2000, 0.02, {{1, L::Molasse, {}}, {1, L::Sandstone, {}}})}};
}

StratigraphicColumn zagros() {
  return {
      layer("basement", 8000, 1e22, 0, 0, {{1, L::Gneiss, {}}}),
      {layer("Hormuz salt", 1000, 1e17, 20e3, 0.0, {{3, L::Salt, {}}, {1, L::Gypsum, {}}}),
       layer("Competent group", 2500, 1e21, 12e3, 0.5,
             {{2, L::Sandstone, {}},
              {1, L::Shale, {}},
              {3, L::Dolomite, {}},
              {1, L::Marl, {}},
              {3, L::Limestone, {}}}),
       layer("Gachsaran evaporites", 400, 1e18, 6000, 0.0, {{2, L::Gypsum, {}}, {1, L::Marl, {}}}),
       layer("Agha Jari and Bakhtyari", 800, 1e20, 4000, 0.05,
             {{2, L::Sandstone, {}}, {1, L::Marl, {}}, {1, L::Conglomerate, {}}})}};
}

StratigraphicColumn alps() {
  return {
      layer("crystalline basement", 8000, 1e22, 0, 0, {{1, L::Gneiss, {}}}),
      {layer("Mesozoic base", 900, 1e20, 15e3, 0.4,
             {{1, L::Gypsum, {}}, {2, L::Dolomite, {}}, {1, L::Shale, {}}}),
       layer("Helvetic limestones", 1200, 5e20, 6000, 0.3,
             {{1, L::Marl, {}}, {3, L::Limestone, {}}, {1.5, L::Marl, {}}, {2, L::Limestone, {}}}),
       layer("Flysch", 900, 1e19, 3000, 0.08, alternating(L::Shale, L::Sandstone, 4)),
       layer("Molasse", 500, 1e19, 2500, 0.02, {{1, L::Molasse, {}}, {1, L::Conglomerate, {}}})}};
}

StratigraphicColumn andes() {
  return {
      layer("Palaeozoic slates", 6000, 1e22, 0, 0, {{2, L::Slate, {}}, {1, L::Quartzite, {}}}),
      {layer("Cretaceous", 1200, 1e20, 10e3, 0.5,
             {{1, L::Shale, {}}, {2, L::Sandstone, {}}, {0.6, L::Limestone, {}}, {1, L::Marl, {}}}),
       layer("red beds", 1300, 3e20, 5000, 0.25,
             {{1, L::Shale, {}},
              {1, L::Sandstone, {}},
              {0.7, L::Shale, {}},
              {1.4, L::Conglomerate, {}}}),
       layer("tuffs", 500, 1e19, 2500, 0.03, {{2, L::Tuff, {}}, {1, L::Andesite, {}}})}};
}

StratigraphicColumn digne() {
  return {layer("basement", 6000, 1e22, 0, 0, {{1, L::Schist, {}}}),
          {layer("Triassic", 400, 1e18, 20e3, 0.0, {{1, L::Gypsum, {}}, {1, L::Dolomite, {}}}),
           layer("Jurassic", 1500, 2e20, 9000, 0.5, alternating(L::Marl, L::Limestone, 5, 1.4)),
           layer("Oligocene and Miocene", 1800, 1e20, 6000, 0.25,
                 alternating(L::Marl, L::Conglomerate, 5, 1.6))}};
}

StratigraphicColumn schist() {
  return {layer("greywacke", 8000, 1e22, 0, 0, {{1, L::Schist, 0.55}}),
          {layer("schist", 6000, 1e22, 15e3, 0.02, {{1, L::Schist, {}}})}};
}

constexpr Preset kPresets[] = {{"jura", jura},   {"zagros", zagros}, {"alps", alps},
                               {"andes", andes}, {"digne", digne},   {"schist", schist}};

}  // namespace

std::vector<std::string_view> column_names() {
  std::vector<std::string_view> names;
  for (const Preset& preset : kPresets) names.push_back(preset.name);
  return names;
}

StratigraphicColumn preset_column(std::string_view name, std::string_view place) {
  std::string names;
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return preset.make();
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw InputError(std::string(place) + ": there is no column '" + std::string(name.substr(0, 60)) +
                   "'; there are " + names);
}

}  // namespace orogen
