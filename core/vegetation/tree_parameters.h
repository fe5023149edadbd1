// Parameters of a tree as a whole (Weber and Penn 1995, appendix), beside those of its levels of
// stems. Names in brackets are the paper's.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "foundation/parameters.h"
#include "vegetation/stem_parameters.h"

namespace orogen {

inline constexpr int kStemLevels = 4;

/// The crown's outline: how long branches are by their height (Shape 0 to 8).
enum class CrownShape {
  Conical,
  Spherical,
  Hemispherical,
  Cylindrical,
  TaperedCylindrical,
  Flame,
  InverseConical,
  TendFlame,
  Envelope,
};

inline constexpr std::string_view kCrownShapes[] = {
    "conical", "spherical",       "hemispherical", "cylindrical", "tapered_cylindrical",
    "flame",   "inverse_conical", "tend_flame",    "envelope"};

/// Outline of a leaf (tree_mesh.h).
enum class LeafShape { Oval, Triangle, Lobed, Maple, Needle, Rectangle };

inline constexpr std::string_view kLeafShapes[] = {"oval",  "triangle", "lobed",
                                                   "maple", "needle",   "rectangle"};

struct TreeParameters {
  CrownShape shape = CrownShape::TendFlame;
  double base_size = 0.4;
  double scale = 13.0;
  double scale_variation = 0.0;
  double z_scale = 1.0;
  double z_scale_variation = 0.0;
  int levels = 3;
  double ratio = 0.015;
  double ratio_power = 1.2;
  int lobes = 0;
  double lobe_depth = 0.0;
  double flare = 0.0;
  double trunk_scale = 1.0;
  double trunk_scale_variation = 0.0;
  int base_splits = 0;
  int leaves = 0;
  LeafShape leaf_shape = LeafShape::Oval;
  double leaf_scale = 0.15;
  double leaf_scale_x = 1.0;
  double leaf_bend = 0.0;
  double attraction_up = 0.0;
  double prune_ratio = 0.0;
  double prune_width = 0.5;
  double prune_width_peak = 0.5;
  double prune_power_low = 0.5;
  double prune_power_high = 0.5;
  std::array<StemParameters, kStemLevels> stems{};
};

constexpr auto parameter_table(const TreeParameters*) {
  using P = TreeParameters;
  return std::tuple{
      choice("shape", &P::shape, kCrownShapes,
             "Outline of the crown: how long branches are by their height (Shape)."),
      real("base_size", &P::base_size, 0.0, 0.99, "1",
           "Share of the height below the crown, without branches (BaseSize)."),
      real("scale", &P::scale, 0.01, 200.0, "m", "Height of the tree (Scale)."),
      real("scale_variation", &P::scale_variation, 0.0, 200.0, "m", "Its variation, below it."),
      real("z_scale", &P::z_scale, 0.1, 10.0, "1", "Stretch of the whole tree upwards (ZScale)."),
      real("z_scale_variation", &P::z_scale_variation, 0.0, 10.0, "1",
           "Its variation, below the stretch."),
      integer("levels", &P::levels, 1, kStemLevels, "", "Levels of stems, the trunk too (Levels)."),
      real("ratio", &P::ratio, 0.0005, 0.5, "1", "Radius of the trunk beside its length (Ratio)."),
      real("ratio_power", &P::ratio_power, 0.1, 10.0, "1",
           "How much thinner shorter stems are (RatioPower)."),
      integer("lobes", &P::lobes, 0, 30, "", "Ribs around the trunk (Lobes)."),
      real("lobe_depth", &P::lobe_depth, 0.0, 0.9, "1",
           "Their height beside its radius (LobeDepth)."),
      real("flare", &P::flare, 0.0, 10.0, "1", "How much wider the trunk is at its foot (Flare)."),
      real("trunk_scale", &P::trunk_scale, 0.01, 10.0, "1", "Factor of its radius (0Scale)."),
      real("trunk_scale_variation", &P::trunk_scale_variation, 0.0, 10.0, "1",
           "Its variation, below the factor."),
      integer("base_splits", &P::base_splits, 0, 10, "",
              "Forks at the top of the trunk's first segment (BaseSplits)."),
      integer("leaves", &P::leaves, -500, 500, "",
              "Most leaves on a stem of the last level; negative: as a fan at its tip (Leaves)."),
      choice("leaf_shape", &P::leaf_shape, kLeafShapes, "Outline of a leaf (LeafShape)."),
      real("leaf_scale", &P::leaf_scale, 0.001, 10.0, "m", "Length of a leaf (LeafScale)."),
      real("leaf_scale_x", &P::leaf_scale_x, 0.005, 5.0, "1",
           "Width of a leaf beside its length (LeafScaleX)."),
      real("leaf_bend", &P::leaf_bend, 0.0, 1.0, "1",
           "How much leaves turn outwards and up, to the light (LeafBend)."),
      real("attraction_up", &P::attraction_up, -10.0, 10.0, "1",
           "How much stems from level 2 on bend upwards; negative: hang (AttractionUp)."),
      real("prune_ratio", &P::prune_ratio, 0.0, 1.0, "1",
           "How strictly stems keep within the envelope; 0: not at all (PruneRatio)."),
      real("prune_width", &P::prune_width, 0.01, 5.0, "1",
           "Radius of the envelope beside the tree's height (PruneWidth)."),
      real("prune_width_peak", &P::prune_width_peak, 0.01, 0.99, "1",
           "Where it is widest, from 0 at the crown's foot to 1 at its top (PruneWidthPeak)."),
      real("prune_power_low", &P::prune_power_low, 0.0, 10.0, "1",
           "Curvature of the envelope below its widest (PrunePowerLow)."),
      real("prune_power_high", &P::prune_power_high, 0.0, 10.0, "1",
           "The same above it (PrunePowerHigh)."),
  };
}

/// Level of the angles that leaves take.
inline int leaf_level(const TreeParameters& parameters) {
  return parameters.levels < kStemLevels ? parameters.levels : kStemLevels - 1;
}

/// How much a tree holds at most, with as many forks as are expected.
struct TreeSize {
  double stems = 0.0;  // without their forks
  double nodes = 0.0;  // ends of segments, with forks
  double leaves = 0.0;
};

TreeSize largest_size(const TreeParameters& parameters);

/// InputError naming what is out of range, contradicts, or makes a tree that is too large (more
/// than 10 million nodes or leaves).
void check_tree(const TreeParameters& parameters, std::string_view place = "");

/// The share of the longest branch's length at height `ratio`: 1 at the crown's foot, 0 at its top
/// (ShapeRatio).
double shape_ratio(const TreeParameters& parameters, CrownShape shape, double ratio);

}  // namespace orogen
