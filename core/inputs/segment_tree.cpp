#include "inputs/segment_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orogen {
namespace {

/// Bits of x and y interleaved, 16 each.
std::uint32_t morton(double x, double y) {
  const auto spread = [](double v) {
    std::uint32_t b = std::uint32_t(std::clamp(v, 0.0, 1.0) * 65535.0);
    b = (b | (b << 8)) & 0x00ff00ffu;
    b = (b | (b << 4)) & 0x0f0f0f0fu;
    b = (b | (b << 2)) & 0x33333333u;
    return (b | (b << 1)) & 0x55555555u;
  };
  return spread(x) | (spread(y) << 1);
}

}  // namespace

void append_segments(std::vector<Segment>& segments, const std::vector<glm::dvec2>& points,
                     bool closed, int line) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    segments.push_back({points[i], points[i + 1], line, int(i)});
  if (closed && points.size() > 1)
    segments.push_back({points.back(), points.front(), line, int(points.size() - 1)});
}

SegmentTree::SegmentTree(std::vector<Segment> segments) {
  if (segments.empty()) return;
  Box all;
  for (const Segment& s : segments) {
    all.add(s.a);
    all.add(s.b);
  }
  const glm::dvec2 size = glm::max(all.high - all.low, glm::dvec2(1e-9));
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const glm::dvec2 middle = (0.5 * (segments[i].a + segments[i].b) - all.low) / size;
    order[i] = {morton(middle.x, middle.y), std::uint32_t(i)};
  }
  std::sort(order.begin(), order.end());
  segments_.reserve(segments.size());
  for (const auto& [key, i] : order) segments_.push_back(segments[i]);

  std::size_t leaves = 1;
  while (leaves * kLeaf < segments_.size()) leaves *= 2;
  first_leaf_ = leaves - 1;
  boxes_.resize(2 * leaves - 1);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    boxes_[first_leaf_ + i / kLeaf].add(segments_[i].a);
    boxes_[first_leaf_ + i / kLeaf].add(segments_[i].b);
  }
  for (std::size_t n = first_leaf_; n-- > 0;)
    for (const Box& child : {boxes_[2 * n + 1], boxes_[2 * n + 2]})
      if (child.low.x <= child.high.x) {
        boxes_[n].add(child.low);
        boxes_[n].add(child.high);
      }
}

SegmentTree::Hit SegmentTree::hit(const Segment& s, std::size_t i, glm::dvec2 p) {
  const glm::dvec2 u = s.b - s.a;
  const double length2 = glm::dot(u, u);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(p - s.a, u) / length2, 0.0, 1.0) : 0.0;
  const glm::dvec2 q = t == 1.0 ? s.b : s.a + t * u;
  return {i, q, t, glm::length(p - q)};
}

bool inside_even_odd(const SegmentTree& tree, glm::dvec2 p) {
  bool inside = false;
  Box ray;
  ray.low = p;
  ray.high = {std::numeric_limits<double>::infinity(), p.y};
  tree.visit(ray, [&](std::size_t i) {
    glm::dvec2 a = tree.segments()[i].a, b = tree.segments()[i].b;
    if ((a.y > p.y) == (b.y > p.y)) return;
    if (a.y > b.y) std::swap(a, b);
    const double cross = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    if (cross > 0.0) inside = !inside;  // the edge crosses the ray east of p
  });
  return inside;
}

}  // namespace orogen
