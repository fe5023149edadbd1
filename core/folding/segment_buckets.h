// Many segments, found by place.
//
// They lie in a grid of square buckets; each stands in every bucket that its bounding box touches.
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "folding/segment.h"
#include "foundation/grid.h"

namespace orogen {

class SegmentBuckets {
 public:
  /// At least one segment.
  explicit SegmentBuckets(std::span<const Segment> segments);

  /// From p to the nearest segment, m.
  double distance(glm::dvec2 p) const;

  /// body(segment) once for each segment whose bounding box meets the rectangle, and for some
  /// others near it, in a fixed order.
  template <class Body>
  void for_near(glm::dvec2 low, glm::dvec2 high, Body&& body) const {
    const Box box = box_around(low, high);
    for (int r = box.row0; r <= box.row1; ++r)
      for (int c = box.column0; c <= box.column1; ++c) {
        const std::size_t place = grid_.index(r, c);
        for (int i = first_[place]; i < first_[place + 1]; ++i) {
          const Member& member = members_[i];
          // It stands in several buckets: taken from the first of them alone.
          if (r == std::max(member.row0, box.row0) && c == std::max(member.column0, box.column0))
            body(member.segment);
        }
      }
  }

 private:
  struct Member {
    Segment segment;
    int row0, column0;  // its first bucket
  };
  struct Box {
    int row0, row1, column0, column1;  // buckets, inclusive
  };
  Box box_around(glm::dvec2 low, glm::dvec2 high) const;

  Grid grid_;
  std::vector<int> first_;
  std::vector<Member> members_;  // by bucket
};

}  // namespace orogen
