// Which plants grow in which biome, how close together, and where no more (paper B, VII-C3).
//
// A table holds kinds of plants, each with its share of every biome's plants, and how many plants a
// biome has. Two are there from the start: `tree_table`, whose kinds are species of
// vegetation/tree_species.h, and `ground_cover_table`, whose kinds are those of ground_cover.h. The
// paper prints neither; densities are those of forests and grounds of that sort, rounded.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "climate/biomes.h"
#include "foundation/parameters.h"

namespace orogen {

using OfBiomes = std::array<double, kBiomes>;

struct PlantKind {
  std::string name;
  OfBiomes weight{};     // beside the other kinds' in that biome; 0: it does not grow there
  double spacing = 2.0;  // m
  double max_slope_deg = 40.0;
  double min_altitude = -500.0;  // m
  double max_altitude = 9000.0;  // m
  double min_scale = 0.7;
  double max_scale = 1.2;
};

constexpr auto parameter_table(const PlantKind*) {
  using P = PlantKind;
  return std::tuple{
      real("spacing", &P::spacing, 0.0, 100.0, "m",
           "Two plants stand no nearer than half the sum of theirs."),
      real("max_slope_deg", &P::max_slope_deg, 0.0, 90.0, "deg",
           "It grows on no steeper ground, and seldom on ground nearly as steep."),
      real("min_altitude", &P::min_altitude, -12e3, 12e3, "m", "It grows no lower."),
      real("max_altitude", &P::max_altitude, -12e3, 12e3, "m",
           "It grows no higher, and seldom nearly as high."),
      real("min_scale", &P::min_scale, 0.001, 1000.0, "1", "Its smallest beside its usual size."),
      real("max_scale", &P::max_scale, 0.001, 1000.0, "1", "Its largest beside its usual size."),
  };
}

struct PlantTable {
  OfBiomes density{};  // plants a hectare
  std::vector<PlantKind> kinds;
};

inline constexpr double kMostPlants = 1e6;  // a hectare
inline constexpr std::size_t kMostKinds = 256;

const PlantTable& tree_table();
const PlantTable& ground_cover_table();

/// InputError, beginning with the place, for a number out of range, more than 256 kinds, a name
/// given twice, or a scale or altitude whose least is above its most.
void check_plant_table(const PlantTable& table, std::string_view place);

}  // namespace orogen
