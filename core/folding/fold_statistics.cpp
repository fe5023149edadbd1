#include "folding/fold_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace orogen {

namespace {

constexpr int kMostFaces = 100;  // crossed on the way to the next crest

double cross(glm::dvec2 p, glm::dvec2 q) {
  return p.x * q.y - p.y * q.x;
}

// How far it is from the middle of an edge in a direction (unit) to the next chosen edge.
std::optional<double> way_to_next_crest(const FoldSkeleton& skeleton, int edge,
                                        glm::dvec2 direction) {
  const FoldMesh& mesh = skeleton.mesh;
  const glm::dvec2 from = mesh.middle(edge);
  int face =
      cross(mesh.along(edge), direction) > 0.0 ? mesh.edges[edge].left : mesh.edges[edge].right;
  for (int step = 0; step < kMostFaces && face >= 0; ++step) {
    const auto& edges = mesh.faces[face].edges;
    const auto leaves_by = std::find_if(edges.begin(), edges.end(), [&](int e) {
      const glm::dvec2 a = mesh.points[mesh.edges[e].a] - from;
      const glm::dvec2 b = mesh.points[mesh.edges[e].b] - from;
      return e != edge && (cross(direction, a) > 0.0) != (cross(direction, b) > 0.0);
    });
    if (leaves_by == edges.end()) return {};
    edge = *leaves_by;
    const glm::dvec2 along = mesh.along(edge);
    if (skeleton.choice[edge] != FoldChoice::None)
      return cross(mesh.points[mesh.edges[edge].a] - from, along) / cross(direction, along);
    face = mesh.edges[edge].left == face ? mesh.edges[edge].right : mesh.edges[edge].left;
  }
  return {};
}

template <std::size_t N>
void add(std::array<double, N>& histogram, double place, double weight) {
  histogram[std::size_t(std::clamp(int(place), 0, int(N) - 1))] += weight;
}

template <std::size_t N>
void normalise(std::array<double, N>& histogram) {
  double sum = 0.0;
  for (const double v : histogram) sum += v;
  for (double& v : histogram) v /= std::max(sum, 1e-300);
}

}  // namespace

FoldStatistics fold_statistics(const CompressionField& field, const FoldWavelength& wavelength,
                               const FoldSkeleton& skeleton) {
  const Grid& grid = field.compression_x.grid();
  const FoldMesh& mesh = skeleton.mesh;
  const auto inside = [&](glm::dvec2 p) {
    return p.x >= grid.origin.x && p.x <= grid.origin.x + grid.width() && p.y >= grid.origin.y &&
           p.y <= grid.origin.y + grid.height();
  };
  FoldStatistics result;
  std::vector<int> degree(mesh.points.size(), 0);
  double length = 0.0, distances = 0.0, weights = 0.0;  // the first two over λ
  for (int e = 0; e < int(mesh.edges.size()); ++e) {
    if (skeleton.choice[e] == FoldChoice::None) continue;
    ++degree[mesh.edges[e].a];
    ++degree[mesh.edges[e].b];
    const glm::dvec2 middle = mesh.middle(e), along = mesh.along(e);
    if (!inside(middle)) continue;
    const double lambda = wavelength.at(middle);
    length += glm::length(along) / lambda;
    const glm::dvec2 c = compression_at(field, middle);
    if (c == glm::dvec2(0.0)) continue;
    const glm::dvec2 way = c / glm::length(c);
    const double across = std::fabs(cross(along, way));
    const double angle = std::atan2(std::fabs(glm::dot(along, way)), across);
    add(result.angle, angle * (180.0 / std::numbers::pi) / 5.0, 1.0);
    for (const double sign : {-1.0, 1.0})
      if (const auto distance = way_to_next_crest(skeleton, e, sign * way)) {
        distances += across * *distance / lambda;
        weights += across;
        add(result.wavelength, 10.0 * *distance / lambda, across);
      }
  }
  int around = 0;  // crests at ends and joints
  for (std::size_t p = 0; p < degree.size(); ++p) {
    if (degree[p] == 0 || !inside(mesh.points[p])) continue;
    ++result.nodes;
    result.ends += degree[p] == 1;
    result.joints += degree[p] >= 3;
    if (degree[p] != 2) around += degree[p];
  }
  if (around > 0) result.mean_length = 2.0 * length / around;
  if (weights > 0.0) result.mean_wavelength = distances / weights;
  normalise(result.angle);
  normalise(result.wavelength);
  return result;
}

}  // namespace orogen
