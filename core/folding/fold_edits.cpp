#include "folding/fold_edits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <string>
#include <utility>

#include "folding/segment_buckets.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr double kAgreement = std::numbers::sqrt2 / 2.0;  // cosine of 45°
constexpr double kRoom = 0.75;  // that a drawn fold takes to each side, over λ
constexpr double kHighestFactor = 100.0, kHighestFold = 20e3;

int nearest_point(const FoldMesh& mesh, glm::dvec2 p) {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < int(mesh.points.size()); ++i) {
    const double d = glm::distance(mesh.points[i], p);
    if (d < least) {
      least = d;
      best = i;
    }
  }
  return best;
}

// Numbers of the edges at each point, in order: those of point p are edges[first[p], first[p + 1]).
struct Fans {
  std::vector<int> first, edges;

  explicit Fans(const FoldMesh& mesh) : first(mesh.points.size() + 1, 0) {
    for (const auto& e : mesh.edges) {
      ++first[e.a + 1];
      ++first[e.b + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    edges.resize(2 * mesh.edges.size());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (int e = 0; e < int(mesh.edges.size()); ++e) {
      edges[next[mesh.edges[e].a]++] = e;
      edges[next[mesh.edges[e].b]++] = e;
    }
  }
};

// The edges of the path that follows the drawn line (Dijkstra).
std::vector<int> path_along(const FoldMesh& mesh, const FoldWavelength& wavelength,
                            const Segment& line) {
  const int from = nearest_point(mesh, line.a), to = nearest_point(mesh, line.b);
  std::vector<int> path;
  if (from == to) return path;
  const Fans fans(mesh);
  std::vector<double> cost(mesh.points.size(), std::numeric_limits<double>::infinity());
  std::vector<int> through(mesh.points.size(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  cost[from] = 0.0;
  front.push({0.0, from});
  const auto other_end = [&](int edge, int p) {
    return mesh.edges[edge].a == p ? mesh.edges[edge].b : mesh.edges[edge].a;
  };
  while (!front.empty()) {
    const auto [reached, p] = front.top();
    front.pop();
    if (p == to) break;
    if (reached > cost[p]) continue;
    for (int i = fans.first[p]; i < fans.first[p + 1]; ++i) {
      const int e = fans.edges[i], q = other_end(e, p);
      const glm::dvec2 middle = mesh.middle(e);
      const double aside = 2.0 * distance_to(line, middle) / wavelength.at(middle);
      const double there = reached + glm::length(mesh.along(e)) * (1.0 + aside * aside);
      if (there >= cost[q]) continue;
      cost[q] = there;
      through[q] = e;
      front.push({there, q});
    }
  }
  for (int p = to; p != from && through[p] >= 0; p = other_end(through[p], p))
    path.push_back(through[p]);
  return path;
}

// Makes the path a fold of its own: no crest beside it, so that it has troughs.
void draw_fold(const FoldMesh& mesh, const FoldWavelength& wavelength, const std::vector<int>& path,
               std::vector<FoldChoice>& choice) {
  std::vector<Segment> fold;
  std::vector<int> passes(mesh.points.size(), 0);
  for (const int e : path) {
    const auto& edge = mesh.edges[e];
    fold.push_back({mesh.points[edge.a], mesh.points[edge.b]});
    ++passes[edge.a];
    ++passes[edge.b];
  }
  std::vector<glm::dvec2> ends;
  for (std::size_t p = 0; p < passes.size(); ++p)
    if (passes[p] == 1) ends.push_back(mesh.points[p]);
  const SegmentBuckets buckets(fold);
  for (int e = 0; e < int(mesh.edges.size()); ++e) {
    if (choice[e] != FoldChoice::ByEnergy) continue;
    const glm::dvec2 middle = mesh.middle(e);
    const double d = buckets.distance(middle);
    const bool beyond = std::any_of(ends.begin(), ends.end(), [&](glm::dvec2 end) {
      return glm::distance(middle, end) <= d * (1.0 + 1e-9);
    });
    if (d < kRoom * wavelength.at(middle) && !beyond) choice[e] = FoldChoice::None;
  }
  for (const int e : path) choice[e] = FoldChoice::ByHand;
}

std::vector<int> crests_along(const FoldMesh& mesh, const FoldWavelength& wavelength,
                              std::span<const FoldChoice> choice, const Segment& line) {
  std::vector<int> result;
  const glm::dvec2 way = line.b - line.a;
  for (int e = 0; e < int(mesh.edges.size()); ++e) {
    if (choice[e] == FoldChoice::None) continue;
    const glm::dvec2 middle = mesh.middle(e), along = mesh.along(e);
    if (distance_to(line, middle) > 0.5 * wavelength.at(middle)) continue;
    // A mere point agrees with every direction.
    if (std::fabs(glm::dot(along, way)) >= kAgreement * glm::length(along) * glm::length(way))
      result.push_back(e);
  }
  return result;
}

bool of_height(FoldEditKind kind) {
  return kind == FoldEditKind::Scale || kind == FoldEditKind::Set;
}

// Weight of a height edit in a cell.
double weight_at(const FoldMesh& mesh, const std::vector<int>& crests,
                 const FoldWavelength& wavelength, glm::dvec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int e : crests) {
    const auto& edge = mesh.edges[e];
    nearest = std::min(nearest, distance_to({mesh.points[edge.a], mesh.points[edge.b]}, p));
  }
  const double x = nearest / wavelength.at(p), y = std::max(0.0, 1.0 - x * x);
  return y * y;
}

void blend_height(const FoldMesh& mesh, const std::vector<int>& crests,
                  const FoldWavelength& wavelength, const FoldEdit& edit, double folding_time,
                  Raster<float>& speed, const Context& context) {
  const Grid& grid = speed.grid();
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const int e : crests)
    for (const int p : {mesh.edges[e].a, mesh.edges[e].b}) {
      low = glm::min(low, mesh.points[p] - glm::dvec2(wavelength.highest()));
      high = glm::max(high, mesh.points[p] + glm::dvec2(wavelength.highest()));
    }
  const int r0 = std::max(0, grid.row_of(low.y)), r1 = std::min(grid.ny - 1, grid.row_of(high.y));
  const int c0 = std::max(0, grid.column_of(low.x));
  const int c1 = std::min(grid.nx - 1, grid.column_of(high.x));
  if (r0 > r1 || c0 > c1) return;
  parallel_rows(context, r1 - r0 + 1, [&](int row) {
    for (int r = r0 + row, c = c0; c <= c1; ++c) {
      const double w = weight_at(mesh, crests, wavelength, grid.center(r, c));
      const double old = speed(r, c);
      const double wanted =
          edit.value * (edit.kind == FoldEditKind::Set ? 1.0 / folding_time : old);
      speed(r, c) = float(old + w * (wanted - old));
    }
  });
}

}  // namespace

void check_fold_edits(std::span<const FoldEdit> edits, const std::string& place) {
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const FoldEdit& edit = edits[i];
    const std::string name =
        (place.empty() ? "" : place + ".") + "edits[" + std::to_string(i) + "]: ";
    for (const double v : {edit.a.x, edit.a.y, edit.b.x, edit.b.y})
      if (!std::isfinite(v)) throw InputError(name + "a and b must be finite places, in metres");
    const double highest = edit.kind == FoldEditKind::Set ? kHighestFold : kHighestFactor;
    if (of_height(edit.kind) && !(edit.value >= 0.0 && edit.value <= highest))
      throw InputError(name + "value must lie within 0 and " +
                       (edit.kind == FoldEditKind::Set ? "20000 m" : "100"));
  }
}

std::vector<int> edit_choice(const FoldMesh& mesh, const FoldWavelength& wavelength,
                             std::span<const FoldEdit> edits, std::vector<FoldChoice>& choice) {
  std::vector<int> without_effect;
  for (int i = 0; i < int(edits.size()); ++i) {
    if (of_height(edits[i].kind)) continue;
    const Segment line{edits[i].a, edits[i].b};
    std::vector<int> changed;
    if (edits[i].kind == FoldEditKind::Add) {
      changed = path_along(mesh, wavelength, line);
      if (!changed.empty()) draw_fold(mesh, wavelength, changed, choice);
    } else {
      changed = crests_along(mesh, wavelength, choice, line);
      for (const int e : changed) choice[e] = FoldChoice::None;
    }
    if (changed.empty()) without_effect.push_back(i);
  }
  return without_effect;
}

std::vector<int> edit_heights(const FoldMesh& mesh, const FoldWavelength& wavelength,
                              std::span<const FoldChoice> choice, std::span<const FoldEdit> edits,
                              double folding_time, Raster<float>& crest_speed,
                              const Context& context) {
  std::vector<int> without_effect;
  for (int i = 0; i < int(edits.size()); ++i) {
    if (!of_height(edits[i].kind)) continue;
    const auto crests = crests_along(mesh, wavelength, choice, {edits[i].a, edits[i].b});
    if (crests.empty())
      without_effect.push_back(i);
    else
      blend_height(mesh, crests, wavelength, edits[i], folding_time, crest_speed, context);
  }
  return without_effect;
}

}  // namespace orogen
