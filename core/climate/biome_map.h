// Biomes of a terrain as it stands: by its last heights, waters and climate.
//
// Sea is ground at or below 0 that hangs together with the sea; ground that rose out of it is land,
// and what sank into it is sea. Where lakes' water stands is lake. Flat land near the sea is beach:
// lower than `beach_height`, nearer than `beach_width` and no steeper than `beach_slope_deg`. Above
// the snow line is snow; other land goes by the classification. What is painted stands before all
// but water.
#pragma once

#include <cstdint>
#include <string_view>
#include <tuple>

#include "climate/biomes.h"
#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"

namespace orogen {

enum class Classification { Paper, Whittaker, Holdridge };
inline constexpr std::string_view kClassifications[] = {"paper", "whittaker", "holdridge"};

struct BiomeParameters {
  Classification classification = Classification::Paper;
  double beach_height = 10.0;  // m
  double beach_width = 150.0;  // m
  double beach_slope_deg = 12.0;
};

constexpr auto parameter_table(const BiomeParameters*) {
  using P = BiomeParameters;
  return std::tuple{
      choice("classification", &P::classification, kClassifications,
             "By temperature and moisture as in the paper, or by degrees and rain as Whittaker or "
             "Holdridge have them."),
      real("beach_height", &P::beach_height, 0.0, 100.0, "m", "Beaches lie lower than this."),
      real("beach_width", &P::beach_width, 0.0, 10e3, "m",
           "Beaches lie nearer to the sea than this."),
      real("beach_slope_deg", &P::beach_slope_deg, 0.0, 60.0, "deg",
           "Beaches are no steeper than this."),
  };
}

/// What biomes go by. nullptr: not known.
struct BiomeInputs {
  const Raster<float>& elevation;                  // m
  const Raster<std::int32_t>* land = nullptr;      // 0 where the sea was; none: no sea
  const Raster<float>* water_depth = nullptr;      // m, of lakes
  const Raster<float>* temperature = nullptr;      // 0 to 1, for the paper's classification
  const Raster<float>* moisture = nullptr;         // 0 to 1, for the paper's classification
  const Raster<float>* air_temperature = nullptr;  // °C, for Whittaker's
  const Raster<float>* biotemperature = nullptr;   // °C, for Holdridge's
  const Raster<float>* rainfall = nullptr;         // m/yr, for both
  const Raster<float>* snow_cover = nullptr;       // share of the year
  const Raster<std::int32_t>* painted = nullptr;   // kinds of dry land; below 0: not painted
};

/// Numbers as Biome counts. InputError if what the classification goes by is missing.
Raster<std::int32_t> map_biomes(const BiomeInputs& inputs, const BiomeParameters& parameters,
                                const Context& context);

}  // namespace orogen
