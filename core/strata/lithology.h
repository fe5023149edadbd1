// Kinds of rock: how well each resists erosion, and its colours.
//
// Resistance runs from 0 (weakest) to 1 (hardest); erodibility and talus angle follow from it
// (RockStrength). Two palettes: `Map`, after the hues that geological maps give to lithologies
// (blue limestone, yellow sandstone, pink granite), and `Natural`, weathered outcrops.
// Values of resistance are typical ones in a temperate climate; a column may give its own.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace orogen {

enum class Lithology : std::int32_t {
  Sediment,  // loose
  Clay,
  Marl,
  Shale,
  Salt,
  Gypsum,
  Flysch,
  Molasse,
  Sandstone,
  Conglomerate,
  Limestone,
  Dolomite,
  Chalk,
  Tuff,
  Basalt,
  Andesite,
  Slate,
  Schist,
  Marble,
  Quartzite,
  Gneiss,
  Granite
};

enum class StrataPalette { Map, Natural };
inline constexpr std::string_view kStrataPaletteNames[] = {"map", "natural"};

struct LithologyInfo {
  std::string_view name;
  double resistance;      // 0 to 1
  std::uint32_t map;      // sRGB, 0xRRGGBB
  std::uint32_t natural;  // sRGB, 0xRRGGBB
};

/// By number of Lithology.
std::span<const LithologyInfo> known_lithologies();

inline const LithologyInfo& lithology_info(Lithology lithology) {
  return known_lithologies()[std::size_t(lithology)];
}

/// sRGB, 0xRRGGBB.
std::uint32_t lithology_color(Lithology lithology, StrataPalette palette);

/// A colour made lighter (shade > 0) or darker (shade < 0), within -1 to 1.
std::uint32_t shaded_color(std::uint32_t color, double shade);

}  // namespace orogen
