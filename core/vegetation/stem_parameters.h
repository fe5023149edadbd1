// Parameters of one level of stems of a tree: 0 the trunk, 1 its branches, 2 theirs, 3 twigs
// (Weber and Penn 1995, "Creation and Rendering of Realistic Trees", appendix). Leaves take the
// angles of the level that follows the last one of stems, or of level 3.
//
// Angles are in degrees, as published. A value named `…_variation` is the V of the paper: what is
// drawn lies evenly within plus and minus it. Negative values have the paper's meanings:
//   down_angle_variation_deg < 0  the angle changes along the parent instead of by chance
//   rotate_deg < 0                children stand on alternate sides of the parent
//   curve_variation_deg < 0       the stem is a helix that leans by that angle
#pragma once

#include <tuple>

#include "foundation/parameters.h"

namespace orogen {

struct StemParameters {
  double down_angle_deg = 0.0;
  double down_angle_variation_deg = 0.0;
  double rotate_deg = 0.0;
  double rotate_variation_deg = 0.0;
  int branches = 0;
  double length = 1.0;
  double length_variation = 0.0;
  double taper = 1.0;
  double segment_splits = 0.0;
  double split_angle_deg = 0.0;
  double split_angle_variation_deg = 0.0;
  int curve_resolution = 1;
  double curve_deg = 0.0;
  double curve_back_deg = 0.0;
  double curve_variation_deg = 0.0;
};

constexpr auto parameter_table(const StemParameters*) {
  using P = StemParameters;
  return std::tuple{
      real("down_angle_deg", &P::down_angle_deg, -180.0, 180.0, "deg",
           "Angle between a stem and its parent (nDownAngle)."),
      real("down_angle_variation_deg", &P::down_angle_variation_deg, -180.0, 180.0, "deg",
           "Its variation; negative: from plus this much at the parent's foot to less at its tip."),
      real("rotate_deg", &P::rotate_deg, -360.0, 360.0, "deg",
           "Turn about the parent from child to child; negative: on alternate sides (nRotate)."),
      real("rotate_variation_deg", &P::rotate_variation_deg, -360.0, 360.0, "deg",
           "Its variation."),
      integer("branches", &P::branches, 0, 2000, "",
              "Most stems of this level on one parent (nBranches)."),
      real("length", &P::length, 0.0, 10.0, "1",
           "Length beside the parent's, of the trunk beside the tree's scale (nLength)."),
      real("length_variation", &P::length_variation, 0.0, 10.0, "1", "Its variation."),
      real("taper", &P::taper, 0.0, 3.0, "1",
           "0: as thick at the tip, 1: a cone, 2: a round tip, 3: beads (nTaper)."),
      real("segment_splits", &P::segment_splits, 0.0, 4.0, "1",
           "Forks at each segment, on average (nSegSplits)."),
      real("split_angle_deg", &P::split_angle_deg, -180.0, 180.0, "deg",
           "Angle by which forks part (nSplitAngle)."),
      real("split_angle_variation_deg", &P::split_angle_variation_deg, -180.0, 180.0, "deg",
           "Its variation."),
      integer("curve_resolution", &P::curve_resolution, 1, 60, "",
              "Segments of a stem (nCurveRes)."),
      real("curve_deg", &P::curve_deg, -720.0, 720.0, "deg",
           "Bend of the whole stem away from its parent's direction (nCurve)."),
      real("curve_back_deg", &P::curve_back_deg, -720.0, 720.0, "deg",
           "If not 0, the bend of its second half, `curve_deg` that of the first (nCurveBack)."),
      real("curve_variation_deg", &P::curve_variation_deg, -720.0, 720.0, "deg",
           "Variation of the bend; negative: a helix (nCurveV)."),
  };
}

}  // namespace orogen
