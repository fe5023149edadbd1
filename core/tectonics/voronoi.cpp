#include "tectonics/voronoi.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orogen {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

// The part of the cell that is nearer to p than to q; the new side faces `neighbour`.
void clip(VoronoiCell& cell, glm::dvec2 p, glm::dvec2 q, int neighbour) {
  const glm::dvec2 middle = 0.5 * (p + q), normal = q - p;
  const auto beyond = [&](glm::dvec2 a) {
    return (a.x - middle.x) * normal.x + (a.y - middle.y) * normal.y;
  };
  VoronoiCell kept;
  const std::size_t n = cell.polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 a = cell.polygon[i], b = cell.polygon[(i + 1) % n];
    const double da = beyond(a), db = beyond(b);
    if (da <= 0.0) {
      kept.polygon.push_back(a);
      kept.neighbours.push_back(cell.neighbours[i]);
    }
    if ((da <= 0.0) != (db <= 0.0)) {
      kept.polygon.push_back(a + (b - a) * (da / (da - db)));
      kept.neighbours.push_back(da <= 0.0 ? neighbour : cell.neighbours[i]);
    }
  }
  if (kept.polygon.size() < 3) kept = {};
  cell = std::move(kept);
}

}  // namespace

std::vector<VoronoiCell> voronoi_cells(std::span<const glm::dvec2> points, glm::dvec2 low,
                                       glm::dvec2 high) {
  std::vector<std::pair<Kernel::Point_2, int>> sites;
  for (const auto& p : points) sites.push_back({{p.x, p.y}, int(sites.size())});
  // Lexicographic, then by number: the first of several points at one place goes in first.
  std::sort(sites.begin(), sites.end());
  sites.erase(std::unique(sites.begin(), sites.end(),
                          [](const auto& a, const auto& b) { return a.first == b.first; }),
              sites.end());
  const Delaunay delaunay(sites.begin(), sites.end());
  std::vector<std::vector<int>> neighbours(points.size());
  for (auto edge = delaunay.finite_edges_begin(); edge != delaunay.finite_edges_end(); ++edge) {
    const int a = edge->first->vertex(Delaunay::ccw(edge->second))->info();
    const int b = edge->first->vertex(Delaunay::cw(edge->second))->info();
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<VoronoiCell> cells(points.size());
  for (const auto& site : sites) {
    const int i = site.second;
    cells[i] = {{low, {high.x, low.y}, high, {low.x, high.y}}, {-1, -1, -1, -1}};
    std::sort(neighbours[i].begin(), neighbours[i].end());
    for (int j : neighbours[i]) clip(cells[i], points[i], points[j], j);
  }
  return cells;
}

double ring_area(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

glm::dvec2 ring_centroid(const Ring& ring) {
  glm::dvec2 moment{0.0, 0.0}, mean{0.0, 0.0};
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    const double cross = a.x * b.y - a.y * b.x;
    twice += cross;
    moment += cross * (a + b);
    mean += ring[i] / double(ring.size());
  }
  return twice == 0.0 ? mean : ring[0] + moment / (3.0 * twice);
}

}  // namespace orogen
