// The species of ground cover, Orogen's own parameter sets.
#include <string>

#include "foundation/errors.h"
#include "vegetation/ground_cover.h"

namespace orogen {

namespace {

constexpr GroundCoverParameters kMeadowGrass{.blades = 45,
                                             .height = 0.34,
                                             .height_variation = 0.35,
                                             .spread = 0.07,
                                             .lean_deg = 16,
                                             .lean_variation_deg = 14,
                                             .droop_deg = 60,
                                             .blade_width = 0.006,
                                             .stalks = 3,
                                             .stalk_height = 0.45,
                                             .petal_length = 0.06,
                                             .petal_width = 0.2};

constexpr GroundCoverParameters kBigBluestem{.blades = 70,
                                             .height = 1.0,
                                             .height_variation = 0.35,
                                             .spread = 0.12,
                                             .lean_deg = 14,
                                             .lean_variation_deg = 12,
                                             .droop_deg = 75,
                                             .blade_width = 0.01,
                                             .blade_segments = 6,
                                             .stalks = 14,
                                             .stalk_height = 1.5,
                                             .petal_length = 0.12,
                                             .petal_width = 0.12};

constexpr GroundCoverParameters kDryTussock{.blades = 160,
                                            .height = 0.55,
                                            .height_variation = 0.3,
                                            .spread = 0.1,
                                            .lean_deg = 38,
                                            .lean_variation_deg = 34,
                                            .droop_deg = 45,
                                            .blade_width = 0.005};

constexpr GroundCoverParameters kTundraSedge{.blades = 60,
                                             .height = 0.16,
                                             .height_variation = 0.3,
                                             .spread = 0.06,
                                             .lean_deg = 24,
                                             .lean_variation_deg = 20,
                                             .droop_deg = 35,
                                             .blade_width = 0.004,
                                             .stalks = 5,
                                             .stalk_height = 0.2,
                                             .petal_length = 0.025,
                                             .petal_width = 0.35};

constexpr GroundCoverParameters kMaleFern{.blades = 11,
                                          .height = 0.85,
                                          .height_variation = 0.2,
                                          .spread = 0.05,
                                          .lean_deg = 32,
                                          .lean_variation_deg = 12,
                                          .droop_deg = 55,
                                          .blade_width = 0.24,
                                          .blade_segments = 10,
                                          .pinnae = 26};

constexpr GroundCoverParameters kCommonPoppy{.blades = 12,
                                             .height = 0.22,
                                             .height_variation = 0.3,
                                             .spread = 0.05,
                                             .lean_deg = 45,
                                             .lean_variation_deg = 25,
                                             .droop_deg = 40,
                                             .blade_width = 0.07,
                                             .blade_segments = 6,
                                             .pinnae = 7,
                                             .stalks = 5,
                                             .stalk_height = 0.5,
                                             .petals = 4,
                                             .petal_length = 0.04,
                                             .petal_width = 1.3,
                                             .petal_lift_deg = 32};

constexpr GroundCoverParameters kOxeyeDaisy{.blades = 26,
                                            .height = 0.14,
                                            .height_variation = 0.3,
                                            .spread = 0.06,
                                            .lean_deg = 45,
                                            .lean_variation_deg = 25,
                                            .droop_deg = 35,
                                            .blade_width = 0.016,
                                            .stalks = 7,
                                            .stalk_height = 0.45,
                                            .petals = 20,
                                            .petal_length = 0.027,
                                            .petal_width = 0.28,
                                            .petal_lift_deg = 6};

constexpr GroundCover kTable[] = {
    {"meadow_grass", "Poa pratensis", 0x8a9a55, 0x5f8a36, 0x86a84c, 0xa79a68, 0xa79a68,
     kMeadowGrass},
    {"big_bluestem", "Andropogon gerardi", 0x9a7a52, 0x7f8f45, 0xa98a52, 0x8a5f46, 0x8a5f46,
     kBigBluestem},
    {"dry_tussock", "Themeda triandra", 0xb39a5f, 0xb79c58, 0xd0bd7c, 0xb79c58, 0xb79c58,
     kDryTussock},
    {"tundra_sedge", "Carex bigelowii", 0x8a8a52, 0x7d8748, 0xa69a58, 0x4c4034, 0x4c4034,
     kTundraSedge},
    {"male_fern", "Dryopteris filix-mas", 0x6a6a3a, 0x4a7a32, 0x659440, 0x4a7a32, 0x4a7a32,
     kMaleFern},
    {"common_poppy", "Papaver rhoeas", 0x66803e, 0x5a7f3c, 0x76944c, 0xcf2a1c, 0x2a2420,
     kCommonPoppy},
    {"oxeye_daisy", "Leucanthemum vulgare", 0x5f8040, 0x4f7a38, 0x6a8f48, 0xf4f3ec, 0xe7b52a,
     kOxeyeDaisy},
};

}  // namespace

std::span<const GroundCover> ground_cover() {
  return kTable;
}

const GroundCover& find_ground_cover(std::string_view name) {
  std::string known;
  for (const GroundCover& species : kTable) {
    if (species.name == name) return species;
    known += (known.empty() ? "" : ", ") + std::string(species.name);
  }
  throw InputError("species: '" + std::string(name.substr(0, 60)) + "' is not known; one of " +
                   known + " is wanted");
}

}  // namespace orogen
