// Which of many segments may be the nearest one to some place in a disc.
//
// Segments lie in a grid of square buckets; each stands in every bucket that its bounding box
// touches. Of a disc of radius h about c, the nearest segment to any place in it is within
// d(c) + 2 h of c, with d(c) the distance from c to the nearest segment: those are the candidates,
// and the least distance to them is exact.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "folding/segment.h"
#include "foundation/grid.h"

namespace orogen {

class SegmentBuckets {
 public:
  /// At least one segment; kept by reference.
  explicit SegmentBuckets(std::span<const Segment> segments);

  double distance(glm::dvec2 p) const;

  /// The candidates for the disc, in a fixed order.
  void candidates(glm::dvec2 center, double radius, std::vector<Segment>& result) const;

 private:
  struct Box {
    int row0, row1, column0, column1;  // buckets, inclusive
  };
  Box box_around(glm::dvec2 low, glm::dvec2 high) const;
  template <class Body>
  void for_bucket(int row, int column, Body&& body) const;

  std::span<const Segment> segments_;
  Grid grid_;
  std::vector<int> first_, members_;
};

}  // namespace orogen
