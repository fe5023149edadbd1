#include "vegetation/tree_species.h"

#include <string>
#include <vector>

#include "foundation/errors.h"

namespace orogen {

namespace {

using Crown = CrownShape;
using Leaf = LeafShape;

// Levels of stems in the paper's order: down angle and its variation, rotation and its variation,
// branches, length and its variation, taper; splits of a segment, their angle and its variation;
// segments, curve, curve back, variation of the curve.
// clang-format off

// Weber and Penn's four.

TreeParameters quaking_aspen() {
  return {
      .shape = Crown::TendFlame, .base_size = 0.4, .scale = 13, .scale_variation = 3, .levels = 3,
      .ratio = 0.015, .ratio_power = 1.2, .lobes = 5, .lobe_depth = 0.07, .flare = 0.6,
      .leaves = 25, .leaf_shape = Leaf::Oval, .leaf_scale = 0.17, .leaf_scale_x = 1,
      .attraction_up = 0.5,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,     1,    0,    0,    0,   3,    0,    0,   20},
          {   60,  -50,   140,   0,   50,   0.3,     0,     1,    0,    0,    0,   5,  -40,    0,   50},
          {   45,   10,   140,   0,   30,   0.6,     0,     1,    0,    0,    0,   3,  -40,    0,   75},
          {   45,   10,    77,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

TreeParameters black_tupelo() {
  return {
      .shape = Crown::TaperedCylindrical, .base_size = 0.2, .scale = 23, .scale_variation = 5,
      .levels = 4, .ratio = 0.015, .ratio_power = 1.3, .lobes = 3, .lobe_depth = 0.1, .flare = 1,
      .leaves = 6, .leaf_shape = Leaf::Oval, .leaf_scale = 0.3, .leaf_scale_x = 0.5,
      .attraction_up = 0.5,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,   1.1,    0,    0,    0,  10,    0,    0,   40},
          {   60,  -40,   140,   0,   50,   0.3,  0.05,     1,    0,    0,    0,  10,    0,    0,   90},
          {   30,   10,   140,   0,   25,   0.6,   0.1,     1,    0,    0,    0,  10,  -10,    0,  150},
          {   45,   10,   140,   0,   12,   0.4,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

TreeParameters weeping_willow() {
  return {
      .shape = Crown::Cylindrical, .base_size = 0.05, .scale = 15, .scale_variation = 5,
      .levels = 4, .ratio = 0.03, .ratio_power = 2, .lobes = 9, .lobe_depth = 0.03, .flare = 0.75,
      .base_splits = 2, .leaves = 15, .leaf_shape = Leaf::Needle, .leaf_scale = 0.12,
      .leaf_scale_x = 0.2, .attraction_up = -3, .prune_ratio = 1, .prune_width = 0.4,
      .prune_width_peak = 0.6, .prune_power_low = 0.001, .prune_power_high = 0.5,
      .stems = {{
          {    0,    0,     0,   0,    0,   0.8,     0,     1,  0.1,    3,    0,   8,    0,   20,  120},
          {   20,   10,  -120,  30,   25,   0.5,   0.1,     1,  0.2,   30,   10,  16,   40,   80,   90},
          {   30,   10,  -120,  30,   10,   1.5,     0,     1,  0.2,   45,   20,  12,    0,    0,    0},
          {   20,   10,   140,   0,  300,   0.1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

TreeParameters black_oak() {
  return {
      .shape = Crown::Hemispherical, .base_size = 0.13, .scale = 10, .scale_variation = 3,
      .levels = 3, .ratio = 0.018, .ratio_power = 1.3, .lobes = 5, .lobe_depth = 0.1,
      .flare = 1.2, .base_splits = 2, .leaves = 30, .leaf_shape = Leaf::Lobed, .leaf_scale = 0.12,
      .leaf_scale_x = 0.66, .attraction_up = 0.8,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,  0.95,  0.4,   10,    0,   8,    0,    0,   90},
          {   30,  -30,    80,   0,   60,   0.8,   0.1,     1,  0.2,   10,   10,  10,   40,  -70,  150},
          {   45,   10,   140,   0,  120,   0.2,  0.05,     1,  0.1,   10,   10,   3,    0,    0,  -30},
          {   45,   10,   140,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

// Orogen's own.

TreeParameters scots_pine() {
  return {
      .shape = Crown::Spherical, .base_size = 0.5, .scale = 19, .scale_variation = 3,
      .levels = 3, .ratio = 0.014, .ratio_power = 1.3, .flare = 0.5, .leaves = 90,
      .leaf_shape = Leaf::Needle, .leaf_scale = 0.27, .leaf_scale_x = 0.09, .attraction_up = 0.9,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,   0.8,    0,    0,    0,  10,    0,    0,   60},
          {   75,  -45,   140,  40,   38,   0.3,   0.1,     1, 0.15,   35,   10,   8,  -35,    0,  110},
          {   50,   20,   140,  20,   46,  0.26,   0.1,     1,    0,    0,    0,   3,  -30,    0,   60},
          {   50,   25,   137,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

TreeParameters norway_spruce() {
  return {
      .shape = Crown::Conical, .base_size = 0.05, .scale = 25, .scale_variation = 4, .levels = 3,
      .ratio = 0.012, .ratio_power = 1.4, .flare = 0.4, .leaves = 44, .leaf_shape = Leaf::Needle,
      .leaf_scale = 0.22, .leaf_scale_x = 0.13, .attraction_up = -0.3,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,     1,    0,    0,    0,  10,    0,    0,    5},
          {   85,  -35,   140,  20,  170,  0.21,  0.03,     1,    0,    0,    0,   6,   20,  -45,   20},
          {   55,   10,  -190,  25,   36,  0.38,  0.05,     1,    0,    0,    0,   3,  -20,    0,   30},
          {   50,   20,   137,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

TreeParameters european_beech() {
  return {
      .shape = Crown::TendFlame, .base_size = 0.18, .scale = 22, .scale_variation = 3,
      .levels = 4, .ratio = 0.02, .ratio_power = 1.5, .lobes = 4, .lobe_depth = 0.04,
      .flare = 0.8, .leaves = 9, .leaf_shape = Leaf::Oval, .leaf_scale = 0.2,
      .leaf_scale_x = 0.65, .leaf_bend = 0.4, .attraction_up = 0.4,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,     1, 0.08,   14,    5,  10,    0,    0,   35},
          {   62,  -32,   140,   0,   65,  0.38,  0.05,     1, 0.08,   20,    0,   8,  -35,    0,   70},
          {   45,   12,   140,   0,   32,  0.45,   0.1,     1,    0,    0,    0,   5,    0,    0,   80},
          {   45,   12,  -170,   0,   14,  0.35,     0,     1,    0,    0,    0,   2,    0,    0,    0}
      }}};
}

TreeParameters sugar_maple() {
  TreeParameters p = european_beech();
  p.scale = 19, p.scale_variation = 3, p.base_size = 0.18;
  p.leaf_shape = Leaf::Maple, p.leaf_scale = 0.26, p.leaf_scale_x = 1.1, p.leaves = 7;
  p.stems[0].segment_splits = 0.1;
  p.stems[1].down_angle_deg = 55, p.stems[1].length = 0.42;
  return p;
}

TreeParameters silver_birch() {
  return {
      .shape = Crown::TendFlame, .base_size = 0.25, .scale = 16, .scale_variation = 3,
      .levels = 4, .ratio = 0.011, .ratio_power = 1.5, .flare = 0.4, .leaves = 11,
      .leaf_shape = Leaf::Triangle, .leaf_scale = 0.11, .leaf_scale_x = 0.8,
      .attraction_up = -0.9,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,     1,    0,    0,    0,  10,    0,    0,   40},
          {   45,  -20,   140,   0,   45,   0.3,  0.05,     1,    0,    0,    0,   8,   10,   25,   60},
          {   40,   15,   140,   0,   24,   0.5,   0.1,     1,    0,    0,    0,   6,    0,    0,   60},
          {   35,   10,   140,   0,   14,   0.4,     0,     1,    0,    0,    0,   2,    0,    0,    0}
      }}};
}

TreeParameters italian_cypress() {
  return {
      .shape = Crown::TendFlame, .base_size = 0.03, .scale = 14, .scale_variation = 3, .levels = 3,
      .ratio = 0.016, .ratio_power = 1.4, .flare = 0.3, .leaves = 26, .leaf_shape = Leaf::Needle,
      .leaf_scale = 0.14, .leaf_scale_x = 0.3, .attraction_up = 1.2,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,     1,    0,    0,    0,   6,    0,    0,    6},
          {   30,    5,   140,   0,  170,  0.14,  0.03,     1,    0,    0,    0,   5,  -25,    0,   25},
          {   35,   10,   140,   0,   24,   0.4,   0.1,     1,    0,    0,    0,   3,    0,    0,   40},
          {   35,   10,   137,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

TreeParameters umbrella_acacia() {
  return {
      .shape = Crown::TaperedCylindrical, .base_size = 0.55, .scale = 8, .scale_variation = 1.5,
      .levels = 4, .ratio = 0.025, .ratio_power = 1.4, .flare = 0.3, .base_splits = 3,
      .leaves = 18, .leaf_shape = Leaf::Oval, .leaf_scale = 0.13, .leaf_scale_x = 0.4,
      .leaf_bend = 0.7,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,   0.9,  0.2,   34,    8,   6,    0,    0,   50},
          {   62,   10,   140,   0,   34,  0.55,  0.08,     1,  0.2,   20,   10,   8,   15,    0,   60},
          {   50,   12,  -180,  25,   36,  0.35,  0.08,     1,    0,    0,    0,   4,    0,    0,   60},
          {   45,   15,  -180,  30,   12,  0.45,     0,     1,    0,    0,    0,   2,    0,    0,    0}
      }}};
}

TreeParameters coconut_palm() {
  return {
      .shape = Crown::Cylindrical, .base_size = 0.97, .scale = 14, .scale_variation = 3,
      .levels = 2, .ratio = 0.013, .ratio_power = 1.6, .flare = 0.6, .leaves = 160,
      .leaf_shape = Leaf::Needle, .leaf_scale = 0.8, .leaf_scale_x = 0.07,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,   0.4,    0,    0,    0,  10,  -18,   14,   25},
          {   65,   60,   137,   0,   36,  0.34,  0.04,     1,    0,    0,    0,  10,   75,    0,   20},
          {   55,    8,  -160,   6,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0},
      }}};
}

TreeParameters hazel_bush() {
  return {
      .shape = Crown::Hemispherical, .base_size = 0.02, .scale = 4, .scale_variation = 1,
      .levels = 3, .ratio = 0.012, .ratio_power = 1, .base_splits = 7, .leaves = 14,
      .leaf_shape = Leaf::Oval, .leaf_scale = 0.11, .leaf_scale_x = 0.85, .leaf_bend = 0.3,
      .attraction_up = 0.4,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,     1,  0.1,   22,   12,   8,    0,    0,   60},
          {   45,   15,   140,   0,   90,  0.35,  0.08,     1,    0,    0,    0,   5,  -10,    0,   70},
          {   45,   10,   140,   0,   18,   0.4,   0.1,     1,    0,    0,    0,   3,    0,    0,   60},
          {   50,   10,   140,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

TreeParameters dwarf_juniper() {
  return {
      .shape = Crown::Hemispherical, .base_size = 0.02, .scale = 0.8, .scale_variation = 0.3,
      .levels = 3, .ratio = 0.02, .ratio_power = 1.1, .base_splits = 6, .leaves = 22,
      .leaf_shape = Leaf::Needle, .leaf_scale = 0.05, .leaf_scale_x = 0.22, .attraction_up = 0.3,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,     1,  0.2,   45,   20,   5,    0,    0,   90},
          {   55,   20,   140,   0,   60,   0.6,  0.15,     1,    0,    0,    0,   4,  -30,    0,   80},
          {   45,   10,   140,   0,   16,   0.4,     0,     1,    0,    0,    0,   2,    0,    0,   40},
          {   40,   10,   137,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

TreeParameters dead_snag() {
  return {
      .shape = Crown::TendFlame, .base_size = 0.15, .scale = 10, .scale_variation = 3, .levels = 3,
      .ratio = 0.022, .ratio_power = 1.3, .flare = 0.5, .leaves = 0,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,   0.7, 0.12,   20,    8,   7,    0,    0,   70},
          {   70,  -30,   140,  40,   34,  0.25,   0.2,   0.8, 0.15,   30,   15,   6,  -20,    0,  120},
          {   50,   20,   140,  30,   10,  0.35,   0.3,     1,    0,    0,    0,   3,    0,    0,   80},
          {    0,    0,     0,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

TreeParameters kapok() {
  return {
      .shape = Crown::TaperedCylindrical, .base_size = 0.62, .scale = 42, .scale_variation = 5,
      .levels = 4, .ratio = 0.02, .ratio_power = 1.5, .lobes = 6, .lobe_depth = 0.14, .flare = 2.2,
      .leaves = 12, .leaf_shape = Leaf::Oval, .leaf_scale = 0.4, .leaf_scale_x = 0.45,
      .leaf_bend = 0.5, .attraction_up = 0.3,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,   0.8,    0,    0,    0,  10,    0,    0,   30},
          {   65,  -15,   140,  20,   30,  0.36,  0.05,     1, 0.15,   25,   10,   9,  -15,    0,   80},
          {   50,   12,  -180,  30,   30,   0.4,   0.1,     1,    0,    0,    0,   5,    0,    0,   70},
          {   45,   15,   140,   0,   14,  0.35,     0,     1,    0,    0,    0,   2,    0,    0,    0}
      }}};
}

TreeParameters saguaro() {
  return {
      .shape = Crown::Conical, .base_size = 0.35, .scale = 7, .scale_variation = 1.5,
      .levels = 2, .ratio = 0.032, .ratio_power = 0.5, .lobes = 14, .lobe_depth = 0.1,
      .leaves = 0,
      .stems = {{
          {    0,    0,     0,   0,    0,     1,     0,     2,    0,    0,    0,   8,    0,    0,    8},
          {   80,   10,   140,  50,    5,   0.5,   0.2,     2,    0,    0,    0,  10,  -80,   -4,   15},
          {    0,    0,     0,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0},
          {    0,    0,     0,   0,    0,     1,     0,     1,    0,    0,    0,   1,    0,    0,    0}
      }}};
}

// clang-format on

std::vector<TreeSpecies> make_table() {
  return {
      {"quaking_aspen", "Populus tremuloides", 0xc9c6b4, 0x6f9437, 0x93ad4a, quaking_aspen()},
      {"black_tupelo", "Nyssa sylvatica", 0x5f5448, 0x3f6b2c, 0x5c8238, black_tupelo()},
      {"black_tupelo_fall", "Nyssa sylvatica", 0x5f5448, 0xb3261c, 0xe07a1f, black_tupelo()},
      {"weeping_willow", "Salix babylonica", 0x6d6250, 0x7d9a48, 0x9cb15e, weeping_willow()},
      {"black_oak", "Quercus kelloggii", 0x4a4038, 0x41692b, 0x5e8136, black_oak()},
      {"scots_pine", "Pinus sylvestris", 0x9a6544, 0x3c5a3a, 0x56714a, scots_pine()},
      {"norway_spruce", "Picea abies", 0x5e4a3c, 0x2c4a2e, 0x3d5d38, norway_spruce()},
      {"european_beech", "Fagus sylvatica", 0x8b8a84, 0x4b7a2e, 0x6a963c, european_beech()},
      {"sugar_maple_fall", "Acer saccharum", 0x6a5f54, 0xd0541b, 0xe8a02a, sugar_maple()},
      {"silver_birch", "Betula pendula", 0xe4e1d8, 0x6c9340, 0x87a852, silver_birch()},
      {"italian_cypress", "Cupressus sempervirens", 0x6e5a48, 0x263f26, 0x365233,
       italian_cypress()},
      {"umbrella_acacia", "Vachellia tortilis", 0x5d4c3c, 0x66803a, 0x82934a, umbrella_acacia()},
      {"coconut_palm", "Cocos nucifera", 0x8d7c66, 0x55803a, 0x7a9a48, coconut_palm()},
      {"hazel_bush", "Corylus avellana", 0x77624c, 0x5b8838, 0x789f49, hazel_bush()},
      {"dwarf_juniper", "Juniperus communis", 0x6b5746, 0x466045, 0x5f7558, dwarf_juniper()},
      {"dead_snag", "standing dead wood", 0x8a8279, 0x8a8279, 0x8a8279, dead_snag()},
      {"kapok", "Ceiba pentandra", 0x8f8a7c, 0x3d6e2c, 0x5a8a3a, kapok()},
      {"saguaro", "Carnegiea gigantea", 0x5f7a4a, 0x5f7a4a, 0x5f7a4a, saguaro()},
  };
}

}  // namespace

std::span<const TreeSpecies> tree_species() {
  static const std::vector<TreeSpecies> table = make_table();
  return table;
}

const TreeSpecies& find_tree_species(std::string_view name) {
  std::string known;
  for (const TreeSpecies& species : tree_species()) {
    if (species.name == name) return species;
    known += (known.empty() ? "" : ", ") + std::string(species.name);
  }
  throw InputError("species: '" + std::string(name.substr(0, 60)) + "' is not known; one of " +
                   known + " is wanted");
}

}  // namespace orogen
