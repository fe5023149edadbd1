#include "folding/segment_buckets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace orogen {

namespace {

constexpr double kPerBucket = 2.0;  // segments, about

}  // namespace

SegmentBuckets::SegmentBuckets(std::span<const Segment> segments) : segments_(segments) {
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const Segment& s : segments) {
    low = glm::min(low, glm::min(s.a, s.b));
    high = glm::max(high, glm::max(s.a, s.b));
  }
  const glm::dvec2 size = high - low;
  // Segments all on one line have no area.
  const double longer = std::max({size.x, size.y, 1e-3});
  const double area = longer * std::max(std::min(size.x, size.y), 1e-3 * longer);
  const double bucket =
      std::max(std::sqrt(area * kPerBucket / double(segments.size())), longer / 4096);
  grid_ = {int(size.x / bucket) + 1, int(size.y / bucket) + 1, bucket, low};
  first_.assign(grid_.size() + 1, 0);
  const auto for_places = [&](auto&& body) {
    for (int i = 0; i < int(segments.size()); ++i) {
      const Segment& s = segments[i];
      const Box box = box_around(glm::min(s.a, s.b), glm::max(s.a, s.b));
      for (int r = box.row0; r <= box.row1; ++r)
        for (int c = box.column0; c <= box.column1; ++c) body(grid_.index(r, c), i);
    }
  };
  for_places([&](std::size_t place, int) { ++first_[place + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  members_.resize(first_.back());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for_places([&](std::size_t place, int i) { members_[next[place]++] = i; });
}

SegmentBuckets::Box SegmentBuckets::box_around(glm::dvec2 low, glm::dvec2 high) const {
  const auto index = [&](double length, int n) {
    return int(std::clamp(std::floor(length / grid_.cell_size), 0.0, n - 1.0));
  };
  return {index(low.y - grid_.origin.y, grid_.ny), index(high.y - grid_.origin.y, grid_.ny),
          index(low.x - grid_.origin.x, grid_.nx), index(high.x - grid_.origin.x, grid_.nx)};
}

template <class Body>
void SegmentBuckets::for_bucket(int row, int column, Body&& body) const {
  const std::size_t place = grid_.index(row, column);
  for (int i = first_[place]; i < first_[place + 1]; ++i) body(members_[i]);
}

double SegmentBuckets::distance(glm::dvec2 p) const {
  const Box home = box_around(p, p);
  // From p the buckets of ring k about the home bucket begin at least this far away.
  const glm::dvec2 middle = grid_.center(home.row0, home.column0);
  const double shift = std::max(std::fabs(p.x - middle.x), std::fabs(p.y - middle.y));
  double least = std::numeric_limits<double>::infinity();
  const int rings = std::max(grid_.nx, grid_.ny);
  for (int k = 0; k <= rings; ++k) {
    if (least <= (k - 0.5) * grid_.cell_size - shift) break;
    const int r0 = std::max(home.row0 - k, 0), r1 = std::min(home.row0 + k, grid_.ny - 1);
    const int c0 = home.column0 - k, c1 = home.column0 + k;
    for (int r = r0; r <= r1; ++r) {
      const bool whole = r == home.row0 - k || r == home.row0 + k;
      const int step = whole || k == 0 ? 1 : 2 * k;
      for (int c = c0; c <= c1; c += step)
        if (c >= 0 && c < grid_.nx)
          for_bucket(r, c, [&](int i) { least = std::min(least, distance_to(segments_[i], p)); });
    }
  }
  return least;
}

void SegmentBuckets::candidates(glm::dvec2 center, double radius,
                                std::vector<Segment>& result) const {
  result.clear();
  // A little more, for rounding.
  const double reach = (distance(center) + 2.0 * radius) * (1.0 + 1e-9);
  const Box box = box_around(center - glm::dvec2(reach), center + glm::dvec2(reach));
  for (int r = box.row0; r <= box.row1; ++r)
    for (int c = box.column0; c <= box.column1; ++c)
      for_bucket(r, c, [&](int i) {
        const Segment& s = segments_[i];
        const Box own = box_around(glm::min(s.a, s.b), glm::max(s.a, s.b));
        // It stands in several buckets: taken from the first of them alone.
        if (r == std::max(own.row0, box.row0) && c == std::max(own.column0, box.column0) &&
            distance_to(s, center) <= reach)
          result.push_back(s);
      });
}

}  // namespace orogen
