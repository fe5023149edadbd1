#include "inputs/land_region.h"

#include "inputs/check_map.h"

namespace orogen {

LandRegion::LandRegion(const VectorMap& map)
    : rectangle_(map.frame), all_land_(map.coasts.empty()) {
  std::vector<Segment> rings, coast, lakes, frame;
  for (std::size_t i = 0; i < map.coasts.size(); ++i) {
    append_segments(rings, map.coasts[i].outer, true, int(i));
    for (const Ring& hole : map.coasts[i].holes) append_segments(rings, hole, true, int(i));
  }
  for (const Polyline& line : shorelines(map)) append_segments(coast, line, false, 0);
  for (std::size_t i = 0; i < map.lakes.size(); ++i) {
    append_segments(lakes, map.lakes[i].outer, true, int(i));
    for (const Ring& island : map.lakes[i].islands) append_segments(lakes, island, true, int(i));
  }
  const glm::dvec2 low = map.frame.origin, high = low + map.frame.size;
  append_segments(frame, {low, {high.x, low.y}, high, {low.x, high.y}}, true, 0);
  rings_ = SegmentTree(std::move(rings));
  coast_ = SegmentTree(std::move(coast));
  lakes_ = SegmentTree(std::move(lakes));
  frame_ = SegmentTree(std::move(frame));
}

bool LandRegion::in_frame(glm::dvec2 p) const {
  const glm::dvec2 q = p - rectangle_.origin;
  return q.x >= 0.0 && q.y >= 0.0 && q.x <= rectangle_.size.x && q.y <= rectangle_.size.y;
}

bool LandRegion::on_land(glm::dvec2 p) const {
  return all_land_ || inside_even_odd(rings_, p);
}

int LandRegion::lake_at(glm::dvec2 p) const {
  if (!inside_even_odd(lakes_, p)) return -1;
  const auto hit = lakes_.nearest(p);
  return hit ? lakes_.segments()[hit->segment].line : -1;
}

}  // namespace orogen
