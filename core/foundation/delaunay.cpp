#include "foundation/delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "foundation/hilbert.h"

namespace orogen {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::int32_t, Kernel>;
using Face = CGAL::Triangulation_face_base_with_info_2<std::int32_t, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;

constexpr std::size_t kChunk = 4096;

Delaunay insert(std::span<const glm::dvec2> points, const Context& context) {
  Delaunay delaunay;
  Delaunay::Face_handle near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kChunk == 0) context.check();
    const auto vertex = delaunay.insert({points[i].x, points[i].y}, near);
    vertex->info() = std::int32_t(i);
    near = vertex->face();
  }
  return delaunay;
}

struct Found {
  std::array<std::int32_t, 3> corners;
  Delaunay::Face_handle face;
  int first;  // of the face's corners
};

Found lowest_first(Delaunay::Face_handle face) {
  int first = 0;
  for (int k = 1; k < 3; ++k)
    if (face->vertex(k)->info() < face->vertex(first)->info()) first = k;
  Found found{{}, face, first};
  for (int k = 0; k < 3; ++k) found.corners[k] = face->vertex((first + k) % 3)->info();
  return found;
}

/// Every triangle, in order of its corners.
std::vector<Found> in_order(const Delaunay& delaunay, std::size_t points) {
  std::vector<std::int32_t> begin(points + 1, 0);
  for (const auto face : delaunay.finite_face_handles()) ++begin[lowest_first(face).corners[0] + 1];
  for (std::size_t i = 0; i < points; ++i) begin[i + 1] += begin[i];
  std::vector<Found> all(begin.back());
  std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
  for (const auto face : delaunay.finite_face_handles()) {
    const Found found = lowest_first(face);
    all[next[found.corners[0]]++] = found;
  }
  for (std::size_t i = 0; i < points; ++i)
    std::sort(all.begin() + begin[i], all.begin() + begin[i + 1],
              [](const Found& a, const Found& b) { return a.corners < b.corners; });
  return all;
}

}  // namespace

Triangulation delaunay(std::span<const glm::dvec2> points, const Context& context) {
  const Delaunay made = insert(points, context);
  if (made.dimension() < 2) return {};
  const std::vector<Found> all = in_order(made, points.size());
  for (std::size_t t = 0; t < all.size(); ++t) all[t].face->info() = std::int32_t(t);
  Triangulation result;
  result.triangles.reserve(all.size());
  result.across.reserve(all.size());
  for (const Found& found : all) {
    std::array<std::int32_t, 3> across{};
    for (int k = 0; k < 3; ++k) {
      const auto other = found.face->neighbor((found.first + k + 2) % 3);  // opposite corner k + 2
      across[k] = made.is_infinite(other) ? -1 : other->info();
    }
    result.triangles.push_back(found.corners);
    result.across.push_back(across);
  }
  return result;
}

void sort_along_curve(std::vector<glm::dvec2>& points, glm::dvec2 origin, double side) {
  struct Keyed {
    std::uint32_t key;
    glm::dvec2 point;
  };
  const double scale = 65536.0 / side;
  const auto cell = [&](double along) {
    return std::uint32_t(std::clamp(along * scale, 0.0, 65535.0));
  };
  std::vector<Keyed> keyed;
  keyed.reserve(points.size());
  for (const glm::dvec2 p : points)
    keyed.push_back({hilbert_key(cell(p.x - origin.x), cell(p.y - origin.y)), p});
  std::sort(keyed.begin(), keyed.end(), [](const Keyed& a, const Keyed& b) {
    if (a.key != b.key) return a.key < b.key;
    return a.point.x != b.point.x ? a.point.x < b.point.x : a.point.y < b.point.y;
  });
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = keyed[i].point;
}

}  // namespace orogen
