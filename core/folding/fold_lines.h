// The folds of a skeleton as lines, to be drawn, picked and counted.
//
// Segments that share an end are joined through nodes where just two meet; a line ends where one
// ends or three or more meet. A line's id is a hash of the places of its first two points, so it
// stays when other folds are edited, and from run to run.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "folding/segment.h"

namespace orogen {

struct FoldLine {
  std::uint64_t id = 0;
  bool closed = false;             // the last point joins the first
  std::vector<glm::dvec2> points;  // m; the lower end (by x, then y) first
};

/// Lines in the order of their first points.
std::vector<FoldLine> fold_lines(std::span<const Segment> segments);

}  // namespace orogen
