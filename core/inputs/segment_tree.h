// Line segments in a tree of boxes: the nearest to a point, and those that meet a box.
//
// Leaves hold up to 8 segments in Morton order of their middles; the tree is a heap of boxes over
// them. O(n log n) to build, about O(log n) a question for segments spread like those of a map.
#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "inputs/vector_map.h"

namespace orogen {

struct Segment {
  glm::dvec2 a, b;  // m
  int line;         // whatever the maker numbers lines by
  int index;        // of the segment in its line
};

struct Box {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};
  void add(glm::dvec2 p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool meets(const Box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y;
  }
  double distance2(glm::dvec2 p) const {
    const glm::dvec2 d = glm::max(glm::max(low - p, p - high), glm::dvec2(0.0));
    return glm::dot(d, d);
  }
};

/// The segments of a polyline (or ring) as line `line`, appended.
void append_segments(std::vector<Segment>& segments, const std::vector<glm::dvec2>& points,
                     bool closed, int line);

class SegmentTree {
 public:
  struct Hit {
    std::size_t segment;  // position in segments()
    glm::dvec2 point;     // nearest point
    double t;             // 0 at a, 1 at b
    double distance;      // m
  };

  SegmentTree() = default;
  explicit SegmentTree(std::vector<Segment> segments);

  const std::vector<Segment>& segments() const { return segments_; }

  /// The segment nearest to p among those closer than `limit` for which keep(segment) holds.
  template <class Keep>
  std::optional<Hit> nearest(glm::dvec2 p, double limit, Keep&& keep) const;
  std::optional<Hit> nearest(glm::dvec2 p) const {
    return nearest(p, std::numeric_limits<double>::infinity(), [](const Segment&) { return true; });
  }

  /// visit(position in segments()) for every segment whose box meets `box`, in that order.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const;

 private:
  static constexpr std::size_t kLeaf = 8;
  static Hit hit(const Segment& s, std::size_t i, glm::dvec2 p);

  std::vector<Segment> segments_;
  std::vector<Box> boxes_;      // heap: children of n at 2n + 1 and 2n + 2
  std::size_t first_leaf_ = 0;  // heap index of leaf 0
};

template <class Keep>
std::optional<SegmentTree::Hit> SegmentTree::nearest(glm::dvec2 p, double limit,
                                                     Keep&& keep) const {
  std::optional<Hit> best;
  double best2 = limit * limit;
  struct Entry {
    std::size_t node;
    double distance2;
  };
  std::vector<Entry> stack;
  if (!boxes_.empty()) stack.push_back({0, boxes_[0].distance2(p)});
  while (!stack.empty()) {
    const Entry entry = stack.back();
    stack.pop_back();
    if (!(entry.distance2 < best2)) continue;
    if (entry.node >= first_leaf_) {
      const std::size_t begin = (entry.node - first_leaf_) * kLeaf;
      for (std::size_t i = begin; i < begin + kLeaf && i < segments_.size(); ++i) {
        const Hit h = hit(segments_[i], i, p);
        if (h.distance * h.distance < best2 && keep(segments_[i])) {
          best = h;
          best2 = h.distance * h.distance;
        }
      }
      continue;
    }
    const std::size_t left = 2 * entry.node + 1;
    const Entry a{left, boxes_[left].distance2(p)}, b{left + 1, boxes_[left + 1].distance2(p)};
    if (a.distance2 < b.distance2) {
      stack.push_back(b);
      stack.push_back(a);
    } else {
      stack.push_back(a);
      stack.push_back(b);
    }
  }
  return best;
}

template <class Visit>
void SegmentTree::visit(const Box& box, Visit&& visit) const {
  std::vector<std::size_t> stack;
  if (!boxes_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const std::size_t node = stack.back();
    stack.pop_back();
    if (!boxes_[node].meets(box)) continue;
    if (node < first_leaf_) {
      stack.push_back(2 * node + 2);
      stack.push_back(2 * node + 1);
      continue;
    }
    const std::size_t begin = (node - first_leaf_) * kLeaf;
    for (std::size_t i = begin; i < begin + kLeaf && i < segments_.size(); ++i) {
      Box b;
      b.add(segments_[i].a);
      b.add(segments_[i].b);
      if (b.meets(box)) visit(i);
    }
  }
}

/// Even-odd: is p inside the closed lines of the tree?
bool inside_even_odd(const SegmentTree& tree, glm::dvec2 p);

}  // namespace orogen
