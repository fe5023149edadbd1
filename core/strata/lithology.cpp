#include "strata/lithology.h"

#include <algorithm>
#include <cmath>

namespace orogen {

namespace {

constexpr LithologyInfo kLithologies[] = {
    {"sediment", 0.0, 0xf6efb4, 0xcdbf9c},  {"clay", 0.03, 0xb9c98f, 0x9a8d7c},
    {"marl", 0.12, 0x9fd3d6, 0x8d8c88},     {"shale", 0.15, 0xa9bfa4, 0x6e6a66},
    {"salt", 0.0, 0xe6a9d1, 0xd9cfc8},      {"gypsum", 0.08, 0xdcb6e0, 0xe2ddd2},
    {"flysch", 0.3, 0xb4c56f, 0x8b8371},    {"molasse", 0.25, 0xf2d98a, 0xb39b74},
    {"sandstone", 0.5, 0xf7dc5e, 0xc28f5c}, {"conglomerate", 0.6, 0xe7a04f, 0xa98562},
    {"limestone", 0.8, 0x5aa9de, 0xd8d2c2}, {"dolomite", 0.85, 0x7d8fd6, 0xcbbda6},
    {"chalk", 0.4, 0xa6e0ee, 0xeeece2},     {"tuff", 0.2, 0xd9b08c, 0xb7a08a},
    {"basalt", 0.85, 0x8a5a83, 0x4a4745},   {"andesite", 0.7, 0xb5768f, 0x7b7470},
    {"slate", 0.45, 0x86a58c, 0x57595c},    {"schist", 0.5, 0x9fb98a, 0x7a7a6c},
    {"marble", 0.8, 0x79c4e8, 0xe4e0dc},    {"quartzite", 1.0, 0xf4e9a0, 0xc9b9ab},
    {"gneiss", 0.9, 0xe79aa6, 0x948b84},    {"granite", 1.0, 0xf08a80, 0xb3a198},
};

/// `value` of 0 to 255, moved towards white or black.
std::uint32_t shaded(std::uint32_t value, double shade) {
  const double towards = shade > 0.0 ? 255.0 : 0.0;
  return std::uint32_t(std::lround(value + (towards - value) * std::fabs(shade)));
}

}  // namespace

std::span<const LithologyInfo> known_lithologies() {
  return kLithologies;
}

std::uint32_t lithology_color(Lithology lithology, StrataPalette palette) {
  const LithologyInfo& info = lithology_info(lithology);
  return palette == StrataPalette::Map ? info.map : info.natural;
}

std::uint32_t shaded_color(std::uint32_t color, double shade) {
  shade = std::clamp(shade, -1.0, 1.0);
  return shaded(color >> 16 & 255u, shade) << 16 | shaded(color >> 8 & 255u, shade) << 8 |
         shaded(color & 255u, shade);
}

}  // namespace orogen
