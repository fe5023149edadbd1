#include "folding/segment_buckets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace orogen {

namespace {

constexpr double kPerBucket = 2.0;       // segments, about
constexpr double kMostBuckets = 4096.0;  // along a side

Grid buckets_over(std::span<const Segment> segments) {
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const Segment& s : segments) {
    low = glm::min(low, glm::min(s.a, s.b));
    high = glm::max(high, glm::max(s.a, s.b));
  }
  const glm::dvec2 size = high - low;
  // Segments along one line have no area, and a single point no length.
  const double longer = std::max({size.x, size.y, 1e-3});
  const double shorter = std::max(std::min(size.x, size.y), 1e-3 * longer);
  const double bucket = std::max(std::sqrt(longer * shorter * kPerBucket / double(segments.size())),
                                 longer / kMostBuckets);
  return {int(size.x / bucket) + 1, int(size.y / bucket) + 1, bucket, low};
}

}  // namespace

SegmentBuckets::SegmentBuckets(std::span<const Segment> segments)
    : grid_(buckets_over(segments)), first_(grid_.size() + 1, 0) {
  const auto for_places = [&](auto&& body) {
    for (const Segment& s : segments) {
      const Box box = box_around(glm::min(s.a, s.b), glm::max(s.a, s.b));
      for (int r = box.row0; r <= box.row1; ++r)
        for (int c = box.column0; c <= box.column1; ++c)
          body(grid_.index(r, c), Member{s, box.row0, box.column0});
    }
  };
  for_places([&](std::size_t place, const Member&) { ++first_[place + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  members_.resize(first_.back());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for_places([&](std::size_t place, const Member& member) { members_[next[place]++] = member; });
}

SegmentBuckets::Box SegmentBuckets::box_around(glm::dvec2 low, glm::dvec2 high) const {
  const auto index = [&](double length, int n) {
    return int(std::clamp(length / grid_.cell_size, 0.0, n - 1.0));
  };
  return {index(low.y - grid_.origin.y, grid_.ny), index(high.y - grid_.origin.y, grid_.ny),
          index(low.x - grid_.origin.x, grid_.nx), index(high.x - grid_.origin.x, grid_.nx)};
}

double SegmentBuckets::distance(glm::dvec2 p) const {
  const Box home = box_around(p, p);
  // From p the buckets of ring k about the home bucket begin at least this far away.
  const glm::dvec2 middle = grid_.center(home.row0, home.column0);
  const double shift = std::max(std::fabs(p.x - middle.x), std::fabs(p.y - middle.y));
  double least = std::numeric_limits<double>::infinity();
  const int rings = std::max(grid_.nx, grid_.ny);
  for (int k = 0; k <= rings && least > (k - 0.5) * grid_.cell_size - shift; ++k) {
    const int r0 = std::max(home.row0 - k, 0), r1 = std::min(home.row0 + k, grid_.ny - 1);
    for (int r = r0; r <= r1; ++r) {
      const bool whole = k == 0 || r == home.row0 - k || r == home.row0 + k;
      for (int c = home.column0 - k; c <= home.column0 + k; c += whole ? 1 : 2 * k) {
        if (c < 0 || c >= grid_.nx) continue;
        const std::size_t place = grid_.index(r, c);
        for (int i = first_[place]; i < first_[place + 1]; ++i)
          least = std::min(least, distance_to(members_[i].segment, p));
      }
    }
  }
  return least;
}

}  // namespace orogen
