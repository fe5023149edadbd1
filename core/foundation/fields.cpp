#include "foundation/fields.h"

#include <stdexcept>
#include <string>

namespace orogen {

namespace {

constexpr auto R = FieldType::Real;
constexpr auto I = FieldType::Integer;

constexpr FieldInfo kFields[] = {
    {"elevation", R, "m", "Height of the ground above the sea; below 0 the sea floor."},
    {"land", I, "", "1 on land, 0 at sea, as the map's coasts say."},
    {"plate", I, "", "Number of the plate a place lies on."},
    {"velocity_x", R, "m/yr", "Eastward part of the smoothed plate velocity."},
    {"velocity_y", R, "m/yr", "Northward part of the smoothed plate velocity."},
    {"convergence", R, "1",
     "How far the nearest plate boundary converges (1) or parts (-1); 0 where it slides or ends."},
    {"boundary_kind", I, "",
     "Kind of plate boundary nearby: 0 none, 1 convergent, 2 divergent, 3 transform."},
    {"boundary_distance", R, "m", "Distance to the nearest plate boundary."},
    {"peak_distance", R, "m", "Distance to the nearest peak of the map."},
    {"fold_relief", R, "m", "Relief of the warped folds (paper A, section 5)."},
    {"river_distance", R, "m", "Distance to the nearest drawn river, lake or coast."},
    {"watershed_elevation", R, "m", "Height of the watershed map (paper A, section 6)."},
    {"combined_relief", R, "m", "Folds and watershed map combined by river distance."},
    {"uplift_rate", R, "m/yr", "Rate at which rock rises."},
    {"erodibility", R, "1/yr", "Stream-power erodibility k at area exponent 0.5."},
    {"drainage_area", R, "m2", "Area that drains through a cell, itself included."},
    {"slope", R, "1", "Steepness of the ground: rise over run."},
    {"sediment_thickness", R, "m", "Thickness of loose sediment on the rock."},
    {"wear", R, "m", "Height that hydraulic erosion took away."},
    {"deposition", R, "m", "Height that hydraulic erosion laid down."},
    {"influence", I, "", "Number of the moving plate whose rigid part is nearest (paper C)."},
    {"crust_uplift_rate", R, "m/yr",
     "Rate at which thickening crust lifts its basement (paper C)."},
    {"compression", R, "1",
     "Strength of the crust's compression: 1 - ν₁ of its stretch (paper C)."},
    {"fault", R, "m", "Distance to the fault; below 0 on the stable plate's side."},
    {"fold_uplift_rate", R, "m/yr", "Rate at which folds lift the top of the column (paper C)."},
    {"exhumation", R, "m", "Height of rock that erosion has taken off."},
    {"rock_layer", I, "",
     "Layer at the surface: 0 basement, then the column's layers upwards, then loose sediment."},
    {"rock_sublayer", I, "", "Sub-layer at the surface, from its layer's bottom."},
    {"strata_color", I, "", "Colour of the rock at the surface: sRGB, 0xRRGGBB."},
    {"age", R, "yr", "Years since the rock at the surface was laid down."},
    {"water_depth", R, "m", "Depth of the water of lakes."},
    {"air_temperature", R, "degC", "Mean temperature of the air over the year."},
    {"biotemperature", R, "degC",
     "Mean over the year of temperatures held within 0 to 30 degC, in which plants grow."},
    {"rainfall", R, "m/yr", "Rain and snow, as water, that fall in a year."},
    {"snow_cover", R, "1", "Share of the year in which snow lies; 1 above the snow line."},
    {"temperature", R, "1", "Warmth of the climate, from 0, cold, to 1, hot (paper B)."},
    {"moisture", R, "1", "Moisture of the climate, from 0, dry, to 1, wet (paper B)."},
    {"biome", I, "",
     "Kind of country (paper B, Table I): 0 snow, 1 tundra, 2 bare, 3 scorched, 4 taiga, "
     "5 shrubland, 6 temperate desert, 7 temperate rain forest, 8 deciduous forest, 9 grassland, "
     "10 tropical rain forest, 11 tropical seasonal forest, 12 subtropical desert, 13 beach, "
     "14 lake, 15 ocean."},
    {"tree_density", R, "1/ha", "Trees that grow on a hectare."},
    {"ground_cover_density", R, "1/ha", "Grasses, ferns and flowers that grow on a hectare."},
    {"river", I, "", "1 + number of the map's river whose bed lies here; 0 elsewhere."},
};

}  // namespace

std::span<const FieldInfo> known_fields() {
  return kFields;
}

const FieldInfo& field_info(std::string_view name) {
  for (const FieldInfo& field : kFields)
    if (field.name == name) return field;
  throw std::out_of_range("no field is called '" + std::string(name) + "'");
}

}  // namespace orogen
