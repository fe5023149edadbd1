#include <algorithm>
#include <cmath>

#include "inputs/map_checks.h"
#include "inputs/ring_arrangement.h"
#include "inputs/segment_tree.h"

namespace orogen {
namespace {

/// Which vertices of a clipped coast stand on the frame's sides, and how they are carried past.
class FrameSides {
 public:
  explicit FrameSides(const Frame& f)
      : low_(f.origin),
        high_(f.origin + f.size),
        near_(std::fmin(50.0, 0.001 * std::fmax(f.size.x, f.size.y))) {}

  /// Outward per axis: -1 west or south, 1 east or north, 0 inside.
  glm::ivec2 beyond(glm::dvec2 p) const {
    return {p.x <= low_.x + near_    ? -1
            : p.x >= high_.x - near_ ? 1
                                     : 0,
            p.y <= low_.y + near_    ? -1
            : p.y >= high_.y - near_ ? 1
                                     : 0};
  }

  /// A run of vertices along the sides: the first and the last onto the side, and between them the
  /// way round outside, `reach` beyond. A run that already goes beyond stays as it is.
  void carry_past(const std::vector<glm::dvec2>& run, double reach, Ring& result) const {
    Box box{low_, high_};
    for (const glm::dvec2 p : run)
      if (box.distance2(p) > 0.25 * reach * reach) {
        result.insert(result.end(), run.begin(), run.end());
        return;
      }
    result.push_back(onto(run.front()));
    result.push_back(outside(run.front(), reach));
    for (std::size_t i = 1; i < run.size(); ++i) {
      const glm::ivec2 a = beyond(run[i - 1]), b = beyond(run[i]);
      const bool side_to_side = a.x * b.x == 0 && a.y * b.y == 0 && a + b != a && a + b != b;
      if (b.x != 0 && b.y != 0 && i + 1 < run.size())
        result.push_back(outside(run[i], reach));
      else if (side_to_side)  // the corner between is not drawn
        result.push_back(corner(a + b, run[i]) + reach * glm::dvec2(a + b));
    }
    result.push_back(outside(run.back(), reach));
    result.push_back(onto(run.back()));
  }

 private:
  glm::dvec2 corner(glm::ivec2 b, glm::dvec2 p) const {
    return {b.x < 0 ? low_.x : b.x > 0 ? high_.x : p.x, b.y < 0 ? low_.y : b.y > 0 ? high_.y : p.y};
  }
  glm::dvec2 onto(glm::dvec2 p) const { return corner(beyond(p), p); }
  glm::dvec2 outside(glm::dvec2 p, double reach) const {
    return onto(p) + reach * glm::dvec2(beyond(p));
  }

  glm::dvec2 low_, high_;
  double near_;
};

/// Carries a coast's stretches along the frame's sides on to beyond the frame.
void carry_past_frame(Coast& coast, const Frame& frame) {
  const FrameSides sides(frame);
  const double reach = std::floor(std::fmax(frame.size.x, frame.size.y) / 8.0);
  const std::size_t n = coast.outer.size();
  std::size_t start = 0;  // a vertex that is no side's, so that runs do not wrap around
  while (start < n && sides.beyond(coast.outer[start]) != glm::ivec2(0)) ++start;
  if (start == n) return;
  Ring result;
  for (std::size_t k = 0; k < n;) {
    const std::size_t first = (start + k) % n;
    std::size_t run = 0;
    while (run < n && sides.beyond(coast.outer[(first + run) % n]) != glm::ivec2(0)) ++run;
    if (run < 2) {
      result.push_back(coast.outer[first]);
      ++k;
      continue;
    }
    std::vector<glm::dvec2> side;
    for (std::size_t i = 0; i < run; ++i) side.push_back(coast.outer[(first + i) % n]);
    sides.carry_past(side, reach, result);
    k += run;
  }
  coast.outer = std::move(result);
}

bool rings_apart(const VectorMap& map) {
  std::vector<const Ring*> rings;
  for (const Coast& coast : map.coasts) {
    rings.push_back(&coast.outer);
    for (const Ring& hole : coast.holes) rings.push_back(&hole);
  }
  return !arrange_rings(rings).contact;
}

}  // namespace

void carry_clipped_coasts(VectorMap& map, MapReport& report) {
  if (std::none_of(map.coasts.begin(), map.coasts.end(), [](const Coast& c) { return c.clipped; }))
    return;
  std::vector<Ring> drawn;
  for (const Coast& coast : map.coasts) drawn.push_back(coast.outer);
  for (Coast& coast : map.coasts)
    if (coast.clipped) carry_past_frame(coast, map.frame);
  if (rings_apart(map)) return;
  for (std::size_t i = 0; i < drawn.size(); ++i) map.coasts[i].outer = std::move(drawn[i]);
  report.warn(
      "coasts: what is clipped could not be carried past the frame without crossing itself; "
      "left as drawn");
}

std::vector<Polyline> shorelines(const VectorMap& map) {
  std::vector<Polyline> lines;
  const FrameSides sides(map.frame);
  const auto whole = [&](const Ring& ring) {
    lines.emplace_back(ring.begin(), ring.end());
    lines.back().push_back(ring.front());
  };
  for (const Coast& coast : map.coasts) {
    for (const Ring& hole : coast.holes) whole(hole);
    const std::size_t n = coast.outer.size();
    const auto drawn = [&](std::size_t i) {  // is the edge from vertex i true coast?
      const glm::ivec2 a = sides.beyond(coast.outer[i]), b = sides.beyond(coast.outer[(i + 1) % n]);
      return !coast.clipped || a == glm::ivec2(0) || b == glm::ivec2(0);
    };
    std::size_t start = 0;
    while (start < n && drawn(start)) ++start;
    if (start == n) {
      whole(coast.outer);
      continue;
    }
    bool open = false;
    for (std::size_t k = 1; k <= n; ++k) {
      const std::size_t i = (start + k) % n;
      if (drawn(i)) {
        if (!open) lines.push_back({coast.outer[i]});
        lines.back().push_back(coast.outer[(i + 1) % n]);
      }
      open = drawn(i);
    }
  }
  return lines;
}

}  // namespace orogen
