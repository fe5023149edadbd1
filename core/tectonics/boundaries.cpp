#include "tectonics/boundaries.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "foundation/distance_transform.h"
#include "foundation/gaussian_blur.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

double length(glm::dvec2 v) {
  return std::hypot(v.x, v.y);
}

// Sides of the same two plates, joined end to end; each runs on with the same plate to its left.
std::vector<std::vector<PlateSide>> join_sides(std::vector<PlateSide> sides, double tolerance) {
  for (PlateSide& s : sides)
    if (s.left > s.right) s = {s.b, s.a, s.right, s.left};
  std::erase_if(sides, [&](const PlateSide& s) { return length(s.b - s.a) <= tolerance; });
  std::map<std::pair<int, int>, std::vector<PlateSide>> by_plates;
  for (const PlateSide& s : sides) by_plates[{s.left, s.right}].push_back(s);
  std::vector<std::vector<PlateSide>> lines;
  const auto meet = [&](glm::dvec2 p, glm::dvec2 q) { return length(p - q) <= 4.0 * tolerance; };
  for (auto& [plates, pool] : by_plates)
    while (!pool.empty()) {
      std::vector<PlateSide> line{pool.front()};
      pool.erase(pool.begin());
      const auto extend = [&](bool forward) {
        const auto next = std::find_if(pool.begin(), pool.end(), [&](const PlateSide& s) {
          return forward ? meet(s.a, line.back().b) : meet(s.b, line.front().a);
        });
        if (next == pool.end()) return false;
        line.insert(forward ? line.end() : line.begin(), *next);
        pool.erase(next);
        return true;
      };
      while (extend(true) || extend(false)) {
      }
      lines.push_back(std::move(line));
    }
  return lines;
}

// A place q with q + bend(q) = p, near enough where the bend is gentle.
Polyline unbend(const Polyline& points, const BoundaryBend& bend) {
  if (bend.roughness <= 0.0) return points;
  const int n = int(points.size());
  std::vector<double> x(n), y(n);
  std::vector<float> dx(n), dy(n);
  for (int i = 0; i < n; ++i) x[i] = points[i].x, y[i] = points[i].y;
  for (int round = 0; round < 24; ++round) {
    bend.displacements(x.data(), y.data(), dx.data(), dy.data(), n);
    for (int i = 0; i < n; ++i) {  // half steps: the iteration settles where bends are steep, too
      x[i] += 0.5 * (points[i].x - dx[i] - x[i]);
      y[i] += 0.5 * (points[i].y - dy[i] - y[i]);
    }
  }
  Polyline result(n);
  for (int i = 0; i < n; ++i) result[i] = {x[i], y[i]};
  return result;
}

// Normal and tangential relative velocity along a boundary.
struct RelativeMotion {
  std::vector<double> at, normal, tangential;  // at: arc length, m
};

// Weighted by a Gaussian of arc length, cut off at 3 standard deviations.
std::vector<double> smooth_along(const std::vector<double>& at, const std::vector<double>& values,
                                 double deviation) {
  std::vector<double> result(values.size());
  std::size_t low = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    while (at[i] - at[low] > 3.0 * deviation) ++low;
    double sum = 0.0, weights = 0.0;
    for (std::size_t j = low; j < values.size() && at[j] - at[i] <= 3.0 * deviation; ++j) {
      const double x = (at[j] - at[i]) / deviation, w = std::exp(-0.5 * x * x);
      sum += w * values[j];
      weights += w;
    }
    result[i] = sum / weights;
  }
  return result;
}

PlateBoundary make_boundary(const std::vector<PlateSide>& line, const PlateMap& plates,
                            const BoundaryParameters& parameters, double step) {
  PlateBoundary boundary{line.front().left, line.front().right, {}, {}, {}};
  const Plate &left = plates.plates[boundary.left], &right = plates.plates[boundary.right];
  Polyline straight;
  RelativeMotion motion;
  double start = 0.0;
  const auto add = [&](const PlateSide& side, double t) {
    const glm::dvec2 along = side.b - side.a, p = side.a + t * along;
    const double l = length(along);
    const glm::dvec2 unit = along / l, v = right.velocity_at(p) - left.velocity_at(p);
    straight.push_back(p);
    motion.at.push_back(start + t * l);
    motion.normal.push_back(v.x * unit.y - v.y * unit.x);  // n: a quarter turn right of the way
    motion.tangential.push_back(v.x * unit.x + v.y * unit.y);
  };
  for (const PlateSide& side : line) {
    const double l = length(side.b - side.a);
    const int pieces = std::max(1, int(std::ceil(l / step)));
    for (int i = 0; i < pieces; ++i) add(side, double(i) / pieces);
    if (&side == &line.back()) add(side, 1.0);
    start += l;
  }
  const auto normal = smooth_along(motion.at, motion.normal, parameters.fade_length);
  const auto tangential = smooth_along(motion.at, motion.tangential, parameters.fade_length);
  const double slow = parameters.slow_speed * plates.plate_speed;
  for (std::size_t i = 0; i < normal.size(); ++i) {
    const double squared = normal[i] * normal[i] + tangential[i] * tangential[i];
    const double whole = squared + slow * slow;
    boundary.convergence.push_back(whole > 0.0 ? float(-normal[i] * std::sqrt(squared) / whole)
                                               : 0.0f);
    boundary.kind.push_back(std::fabs(tangential[i]) >= std::fabs(normal[i])
                                ? PlateBoundaryKind::Transform
                            : normal[i] < 0.0 ? PlateBoundaryKind::Convergent
                                              : PlateBoundaryKind::Divergent);
  }
  boundary.points = unbend(straight, plates.bend);
  return boundary;
}

// All points of all boundaries in one row, so that the nearest can be looked up.
struct BoundaryPoints {
  std::vector<glm::dvec2> points;
  std::vector<float> convergence;
  std::vector<PlateBoundaryKind> kind;
  std::vector<char> last;  // of its boundary

  explicit BoundaryPoints(const std::vector<PlateBoundary>& boundaries) {
    for (const PlateBoundary& b : boundaries) {
      points.insert(points.end(), b.points.begin(), b.points.end());
      convergence.insert(convergence.end(), b.convergence.begin(), b.convergence.end());
      kind.insert(kind.end(), b.kind.begin(), b.kind.end());
      last.insert(last.end(), b.points.size(), 0);
      if (!last.empty()) last.back() = 1;
    }
  }
};

struct Foot {
  double distance;
  float convergence;
};

// The nearest place on the two stretches that meet at point `near`.
Foot foot_near(const BoundaryPoints& b, int near, glm::dvec2 p) {
  Foot foot{length(p - b.points[near]), b.convergence[near]};
  for (int i = near - 1; i <= near; ++i) {
    if (i < 0 || b.last[i]) continue;
    const glm::dvec2 a = b.points[i], along = b.points[i + 1] - a;
    const double squared = along.x * along.x + along.y * along.y;
    if (squared <= 0.0) continue;
    const double t =
        std::clamp(((p.x - a.x) * along.x + (p.y - a.y) * along.y) / squared, 0.0, 1.0);
    const double d = length(p - a - t * along);
    if (d < foot.distance)
      foot = {d, float((1.0 - t) * b.convergence[i] + t * b.convergence[i + 1])};
  }
  return foot;
}

}  // namespace

BoundaryMap plate_boundaries(const PlateMap& plates, const BoundaryParameters& parameters,
                             const Context& context) {
  check_parameters(parameters, "boundaries");
  const Grid& grid = plates.plate.grid();
  const double extent = grid.width() + grid.height();
  BoundaryMap result;
  const double step = std::max(std::min(1000.0, plates.bend.wavelength / 16.0), extent / 1000.0);
  for (const auto& line : join_sides(plates.sides, 1e-9 * extent)) {
    context.check();
    result.boundaries.push_back(make_boundary(line, plates, parameters, step));
  }
  const BoundaryPoints points(result.boundaries);
  result.convergence = Raster<float>(grid, 0.0f);
  result.boundary_kind = Raster<std::int32_t>(grid, 0);
  if (points.points.empty()) {
    result.boundary_distance = Raster<float>(grid, float(extent));
    return result;
  }
  NearestFeature nearest = nearest_point(points.points, grid, context);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const int near = nearest.nearest(r, c);
      const Foot foot = foot_near(points, near, grid.center(r, c));
      nearest.distance(r, c) = float(foot.distance);
      result.convergence(r, c) = foot.convergence;
      if (foot.distance <= parameters.fade_distance)
        result.boundary_kind(r, c) = std::int32_t(points.kind[near]);
    }
  });
  result.boundary_distance = std::move(nearest.distance);
  result.convergence = gaussian_blur(result.convergence, parameters.fade_length, context);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const float x = result.boundary_distance(r, c) / float(parameters.fade_distance);
      const float fade = 1.0f / (1.0f + x * x);
      result.convergence(r, c) = std::clamp(result.convergence(r, c) * fade * fade, -1.0f, 1.0f);
    }
  });
  return result;
}

const StageInfo& boundaries_stage() {
  static const StageInfo info{
      "boundaries",
      "Finds where plates converge, part or slide past each other.",
      "Michel, Emilien and Cani 2015, section 7 (divergent boundaries, fading)",
      {"plate"},
      {"boundary_distance", "convergence", "boundary_kind"}};
  return info;
}

}  // namespace orogen
