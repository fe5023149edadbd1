// Where rivers may run and peaks may stand: questions to a checked map's coasts, lakes and frame.
#pragma once

#include "inputs/segment_tree.h"
#include "inputs/vector_map.h"

namespace orogen {

class LandRegion {
 public:
  /// Coasts, lakes and frame of the map are checked.
  explicit LandRegion(const VectorMap& map);

  bool in_frame(glm::dvec2 p) const;
  bool on_land(glm::dvec2 p) const;  // inside a coast, in the frame or not; lakes count as land
  int lake_at(glm::dvec2 p) const;   // -1: none

  const SegmentTree& rings() const { return rings_; }  // all coasts' rings, line: coast
  const SegmentTree& coast() const { return coast_; }  // what is truly coast
  const SegmentTree& lakes() const { return lakes_; }  // line: lake
  const SegmentTree& frame() const { return frame_; }  // its four sides

 private:
  Frame rectangle_;
  bool all_land_;
  SegmentTree rings_, coast_, lakes_, frame_;
};

}  // namespace orogen
