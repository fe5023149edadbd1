#include "island/clipped_dual.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orogen {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum Side { South, East, North, West };  // anticlockwise

/// Where a line enters or leaves the rectangle.
struct Crossing {
  Side side = South;
  double along = 0.0;        // m, anticlockwise from the side's beginning; -1: its beginning
  std::int32_t corner = -1;  // of the map
  std::int32_t before = -1, after = -1;  // centers, before and after it; -1: a rectangle's corner
};

/// From one circumcentre to another, or on without end.
struct Line {
  glm::dvec2 from, way;
  double reach;
  bool begins_inside, ends_inside;
};

/// A part of a line, in multiples of its way; the Side where it enters or leaves the rectangle, -1
/// if it begins or ends inside.
struct Span {
  double begin, end;
  int enters = -1, leaves = -1;
};

glm::dvec2 circumcentre(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  const glm::dvec2 u = b - a, v = c - a;
  const double uu = u.x * u.x + u.y * u.y, vv = v.x * v.x + v.y * v.y;
  const double twice = 2.0 * (u.x * v.y - u.y * v.x);
  return a + glm::dvec2(v.y * uu - u.y * vv, u.x * vv - v.x * uu) / twice;
}

class Clipper {
 public:
  Clipper(const Triangulation& triangulation, PolygonMap& map)
      : triangulation_(triangulation), map_(map) {}

  void run() {
    place_circumcentres();
    for (std::int32_t t = 0; t < std::int32_t(triangulation_.triangles.size()); ++t)
      for (int k = 0; k < 3; ++k)
        if (triangulation_.across[t][k] < t) add_dual(t, k);  // each pair once; -1: the hull
    close_sides();
  }

 private:
  glm::dvec2 center(std::int32_t i) const { return map_.centers[i]; }

  std::int32_t add_corner(glm::dvec2 place) {
    map_.corners.push_back(place);
    return std::int32_t(map_.corners.size()) - 1;
  }

  void add_edge(std::int32_t center, std::int32_t other, std::int32_t from, std::int32_t to) {
    map_.edge_centers.push_back({center, other});
    map_.edge_corners.push_back({from, to});
  }

  void place_circumcentres() {
    const glm::dvec2 low = map_.low, high = map_.high;
    for (const auto& t : triangulation_.triangles) {
      const glm::dvec2 p = circumcentre(center(t[0]), center(t[1]), center(t[2]));
      const bool inside = p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y;
      circumcentres_.push_back(p);
      corner_of_.push_back(inside ? add_corner(p) : -1);
    }
  }

  /// The edge across side k of triangle t. It runs to the right of the side, out of t, and so
  /// anticlockwise about the side's end and clockwise about its beginning.
  void add_dual(std::int32_t t, int k) {
    const std::int32_t a = triangulation_.triangles[t][k];
    const std::int32_t b = triangulation_.triangles[t][(k + 1) % 3];
    const std::int32_t other = triangulation_.across[t][k];
    const glm::dvec2 from = circumcentres_[t], side = center(b) - center(a);
    const bool ray = other < 0;
    const glm::dvec2 way = ray ? glm::dvec2(side.y, -side.x) : circumcentres_[other] - from;
    const Line line{from, way, ray ? kInfinity : 1.0, corner_of_[t] >= 0,
                    !ray && corner_of_[other] >= 0};
    const Span span = clip(line);
    if (!(span.begin < span.end && span.begin < line.reach && span.end > 0.0)) return;
    const auto corner = [&](double at, int crossed, std::int32_t triangle) {
      return crossed < 0 ? corner_of_[triangle] : cross(from + at * way, crossed, a, b);
    };
    const std::int32_t first = corner(span.begin, span.enters, t);
    const std::int32_t last = corner(span.end, span.leaves, other);
    add_edge(b, a, first, last);
  }

  /// The part of a line inside the rectangle (Liang and Barsky); empty where it begins at or after
  /// its end. Which circumcentres lie inside was decided before: rounding does not change it.
  Span clip(const Line& line) const {
    Span span{line.begins_inside ? 0.0 : -kInfinity, line.ends_inside ? line.reach : kInfinity};
    const double inward[4] = {line.way.y, -line.way.x, -line.way.y, line.way.x};
    const double depth[4] = {line.from.y - map_.low.y, map_.high.x - line.from.x,
                             map_.high.y - line.from.y, line.from.x - map_.low.x};
    for (int side = 0; side < 4; ++side) {
      const double at = -depth[side] / inward[side];
      if (inward[side] == 0.0) {
        if (depth[side] <= 0.0) return {1.0, 0.0};
      } else if (inward[side] > 0.0) {
        if (!line.begins_inside && at > span.begin) span.begin = at, span.enters = side;
      } else if (!line.ends_inside && at < span.end) {
        span.end = at, span.leaves = side;
      }
    }
    return span;
  }

  /// A new corner where the edge between the cells of a and b crosses a side.
  std::int32_t cross(glm::dvec2 p, int side, std::int32_t a, std::int32_t b) {
    const glm::dvec2 low = map_.low, high = map_.high, size = high - low;
    const double along[4] = {p.x - low.x, p.y - low.y, high.x - p.x, high.y - p.y};
    const double s = std::clamp(along[side], 0.0, side % 2 ? size.y : size.x);
    const glm::dvec2 way = center(b) - center(a);
    const double ahead[4] = {way.x, way.y, -way.x, -way.y};  // how far b lies before a
    const std::int32_t corner = add_corner(place(side, s));
    if (ahead[side] < 0.0) std::swap(a, b);
    crossings_.push_back({Side(side), s, corner, a, b});
    return corner;
  }

  glm::dvec2 place(int side, double s) const {
    const glm::dvec2 low = map_.low, high = map_.high;
    const glm::dvec2 places[4] = {
        {low.x + s, low.y}, {high.x, low.y + s}, {high.x - s, high.y}, {low.x, high.y - s}};
    return places[side];
  }

  /// Edges along the rectangle's sides. Every stretch belongs to the cell before the next crossing.
  void close_sides() {
    for (const Side side : {South, East, North, West})
      crossings_.push_back({side, -1.0, add_corner(place(side, 0.0))});
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
      return a.side != b.side ? a.side < b.side : a.along < b.along;
    });
    const std::size_t n = crossings_.size();
    std::size_t next = 0;  // the first crossing of two cells
    while (next < n && crossings_[next].before < 0) ++next;
    std::int32_t owner = next < n ? crossings_[next].before : 0;
    for (std::size_t i = 0; i < n; ++i) {
      Crossing& end = crossings_[i];
      settle(i, owner);
      const std::size_t last = (i + n - 1) % n;
      add_edge(owner, -1, crossings_[last].corner, end.corner);
      if (end.after >= 0) owner = end.after;
    }
  }

  /// Crossings at one place, as those of a corner on the side: puts first what the owner ends at.
  void settle(std::size_t i, std::int32_t owner) {
    if (crossings_[i].before < 0 || crossings_[i].before == owner) return;
    for (std::size_t k = i + 1; k < crossings_.size() && crossings_[k].side == crossings_[i].side;
         ++k)
      if (crossings_[k].before == owner) return std::swap(crossings_[i], crossings_[k]);
  }

  const Triangulation& triangulation_;
  PolygonMap& map_;
  std::vector<glm::dvec2> circumcentres_;
  std::vector<std::int32_t> corner_of_;  // of each triangle; -1: outside
  std::vector<Crossing> crossings_;
};

}  // namespace

void clip_dual(const Triangulation& triangulation, PolygonMap& map) {
  Clipper(triangulation, map).run();
}

}  // namespace orogen
