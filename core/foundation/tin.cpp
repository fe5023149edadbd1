#include "foundation/tin.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "foundation/delaunay.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

using Triangle = std::array<std::int32_t, 3>;

constexpr std::size_t kMostVertices = 100'000'000;
constexpr std::size_t kChunk = 4096;

std::string describe(glm::dvec2 p) {
  return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
}

std::uint8_t sides_of(const TinDomain& domain, glm::dvec2 p) {
  const glm::dvec2 low = domain.origin, high = domain.far_corner();
  return std::uint8_t((p.x == low.x ? kWestSide : 0) | (p.x == high.x ? kEastSide : 0) |
                      (p.y == low.y ? kSouthSide : 0) | (p.y == high.y ? kNorthSide : 0));
}

void check_points(const TinDomain& domain, const std::vector<glm::dvec2>& sorted) {
  if (sorted.size() > kMostVertices)
    throw InputError("points: " + std::to_string(sorted.size()) + " are given, at most " +
                     std::to_string(kMostVertices) + " are allowed");
  const glm::dvec2 low = domain.origin, high = domain.far_corner();
  unsigned corners = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const glm::dvec2 p = sorted[i];
    if (!(p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y))
      throw InputError("points: " + describe(p) + " lies outside the domain " + describe(low) +
                       " to " + describe(high));
    if (i > 0 && p == sorted[i - 1]) throw InputError("points: " + describe(p) + " is given twice");
    const std::uint8_t sides = sides_of(domain, p);
    corners += (sides & (kWestSide | kEastSide)) && (sides & (kSouthSide | kNorthSide));
  }
  if (corners < 4) throw InputError("points: a corner of the domain is missing");
}

/// Neighbours of each vertex, from both ends of the triangles' sides, each once.
void join_neighbors(Tin& tin, const Context& context) {
  const std::size_t n = tin.size();
  std::vector<std::int32_t> begin(n + 1, 0);
  for (const Triangle& t : tin.triangles)
    for (std::int32_t v : t) begin[v + 1] += 2;
  for (std::size_t i = 0; i < n; ++i) begin[i + 1] += begin[i];
  std::vector<std::int32_t> both(begin.back()), next(begin.begin(), begin.end() - 1);
  for (const Triangle& t : tin.triangles)
    for (int k = 0; k < 3; ++k) {
      both[next[t[k]]++] = t[(k + 1) % 3];
      both[next[t[k]]++] = t[(k + 2) % 3];
    }
  tin.first_edge.assign(n + 1, 0);
  parallel_chunks(context, n, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto from = both.begin() + begin[i], to = both.begin() + begin[i + 1];
      std::sort(from, to);
      tin.first_edge[i + 1] = std::int32_t(std::unique(from, to) - from);
    }
  });
  for (std::size_t i = 0; i < n; ++i) tin.first_edge[i + 1] += tin.first_edge[i];
  tin.neighbors.resize(tin.first_edge.back());
  tin.edge_lengths.resize(tin.first_edge.back());
  parallel_chunks(context, n, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      for (std::int32_t e = tin.first_edge[i], b = begin[i]; e < tin.first_edge[i + 1]; ++e, ++b) {
        const glm::dvec2 way = tin.points[both[b]] - tin.points[i];
        tin.neighbors[e] = both[b];
        tin.edge_lengths[e] = float(std::sqrt(way.x * way.x + way.y * way.y));
      }
  });
}

}  // namespace

void TinDomain::check() const {
  for (double v : {origin.x, origin.y, size.x, size.y})
    if (!std::isfinite(v)) throw InputError("domain: not finite");
  if (!(size.x > 0.0 && size.y > 0.0))
    throw InputError("domain: size " + describe(size) + " m is not above 0");
}

Tin triangulate(const TinDomain& domain, std::vector<glm::dvec2> points, const Context& context) {
  domain.check();
  sort_along_curve(points, domain.origin, std::fmax(domain.size.x, domain.size.y));
  check_points(domain, points);
  Tin tin{.domain = domain, .points = std::move(points)};
  tin.triangles = delaunay(tin.points, context).triangles;
  join_neighbors(tin, context);
  tin.cell_areas.assign(tin.size(), 0.0);
  for (const Triangle& t : tin.triangles) {
    const glm::dvec2 a = tin.points[t[1]] - tin.points[t[0]];
    const glm::dvec2 b = tin.points[t[2]] - tin.points[t[0]];
    for (std::int32_t v : t) tin.cell_areas[v] += (a.x * b.y - a.y * b.x) / 6.0;
  }
  tin.sides.resize(tin.size());
  for (std::size_t i = 0; i < tin.size(); ++i) tin.sides[i] = sides_of(domain, tin.points[i]);
  return tin;
}

double spacing_for(const TinDomain& domain, double vertices) {
  domain.check();
  if (!(vertices >= 4.0 && vertices <= double(kMostVertices)))
    throw InputError("vertices: " + std::to_string(vertices) + " is not within 4 to " +
                     std::to_string(kMostVertices));
  return std::sqrt(domain.area() * 2.0 / (std::sqrt(3.0) * vertices));
}

std::vector<std::uint8_t> side_mask(const Tin& tin, unsigned sides) {
  std::vector<std::uint8_t> mask(tin.size());
  for (std::size_t i = 0; i < tin.size(); ++i) mask[i] = (tin.sides[i] & sides) != 0;
  return mask;
}

}  // namespace orogen
