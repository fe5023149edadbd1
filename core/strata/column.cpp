#include "strata/column.h"

#include <cmath>
#include <numbers>

#include "foundation/errors.h"
#include "foundation/units.h"
#include "strata/layer_parameters.h"

namespace orogen {

namespace {

constexpr std::size_t kMostLayers = 40, kMostSubLayers = 10;
constexpr std::size_t kMostMapValues = 1 << 20;

[[noreturn]] void refuse(const std::string& place, const std::string& why) {
  throw InputError(place + ": " + why);
}

void check_range(double value, double low, double high, const std::string& place,
                 const char* unit) {
  if (value >= low && value <= high) return;
  refuse(place, detail::format_number(value) + " is not allowed; " + detail::format_number(low) +
                    " to " + detail::format_number(high) + (*unit ? " " : "") + unit +
                    " is wanted");
}

void check_map(const CornerMap& map, const std::string& place) {
  if (map.rows < 2 || map.columns < 2)
    refuse(place, "at least 2 rows and 2 columns of heights are wanted");
  if (map.values.size() != std::size_t(map.rows) * map.columns)
    refuse(place, "every row must have the same number of heights");
  if (map.values.size() > kMostMapValues)
    refuse(place, std::to_string(map.values.size()) + " heights are too many; at most " +
                      std::to_string(kMostMapValues));
  for (std::size_t i = 0; i < map.values.size(); ++i)
    check_range(map.values[i], 0.0, 50e3,
                place + "[" + std::to_string(i / map.columns) + "][" +
                    std::to_string(i % map.columns) + "]",
                "m");
}

void check_layer(const Layer& layer, const std::string& place) {
  check_parameters(layer, place);
  if (layer.fold_wavelength != 0.0)
    check_range(layer.fold_wavelength, 100.0, 200e3, place + ".fold_wavelength", "m");
  if (layer.fold_share != 0.0) check_range(layer.fold_share, 0.01, 0.5, place + ".fold_share", "");
  if (layer.sub_layers.empty() || layer.sub_layers.size() > kMostSubLayers)
    refuse(place + ".sub_layers",
           std::to_string(layer.sub_layers.size()) + " are not allowed; 1 to 10 are wanted");
  for (std::size_t i = 0; i < layer.sub_layers.size(); ++i) {
    const std::string at = place + ".sub_layers[" + std::to_string(i) + "]";
    check_range(layer.sub_layers[i].share, 1e-3, 1e3, at + ".share", "");
    check_range(resistance_of(layer.sub_layers[i]), 0.0, 1.0, at + ".resistance", "");
  }
  if (layer.thickness_map) check_map(*layer.thickness_map, place + ".thickness_map");
}

}  // namespace

double resistance_of(const SubLayer& sub_layer) {
  return sub_layer.resistance.value_or(lithology_info(sub_layer.lithology).resistance);
}

double erodibility_of(double resistance, const RockStrengthParameters& strength) {
  return strength.soft_erodibility *
         std::pow(strength.hard_erodibility / strength.soft_erodibility, resistance);
}

double talus_slope_of(double resistance, const RockStrengthParameters& strength) {
  return std::tan(radians(strength.soft_talus_deg +
                          (strength.hard_talus_deg - strength.soft_talus_deg) * resistance));
}

void check_column(const StratigraphicColumn& column, std::string_view place) {
  const std::string at(place);
  check_layer(column.basement, at + ".basement");
  if (column.layers.empty() || column.layers.size() > kMostLayers)
    refuse(at + ".layers",
           std::to_string(column.layers.size()) + " are not allowed; 1 to 40 are wanted");
  for (std::size_t i = 0; i < column.layers.size(); ++i)
    check_layer(column.layers[i], at + ".layers[" + std::to_string(i) + "]");
}

std::vector<double> fold_wavelengths(const StratigraphicColumn& column) {
  std::vector<double> result;
  const Layer* below = &column.basement;
  for (const Layer& layer : column.layers) {
    const double buckling = 2.0 * std::numbers::pi * std::sqrt(layer.thickness * below->thickness) *
                            std::pow(layer.viscosity / (6.0 * below->viscosity), 1.0 / 6.0);
    result.push_back(layer.fold_wavelength > 0.0 ? layer.fold_wavelength : buckling);
    below = &layer;
  }
  return result;
}

}  // namespace orogen
