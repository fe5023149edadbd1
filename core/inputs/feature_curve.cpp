#include "inputs/feature_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "foundation/errors.h"

namespace orogen {

namespace {

double mix(double a, double b, double t) {
  return a + t * (b - a);
}

FeatureSample sample_at(const FeaturePoint& p) {
  return {p.position, double(p.elevation), p.plateau, p.left, p.right};
}

/// One tangent a point; those of the ends make the outermost pieces quadratic.
std::vector<glm::dvec3> tangents(const std::vector<FeaturePoint>& points) {
  const std::size_t n = points.size();
  std::vector<glm::dvec3> result(n, points[1].position - points[0].position);
  if (n == 2) return result;
  for (std::size_t i = 1; i + 1 < n; ++i)
    result[i] = 0.5 * (points[i + 1].position - points[i - 1].position);
  result[0] = 2.0 * (points[1].position - points[0].position) - result[1];
  result[n - 1] = 2.0 * (points[n - 1].position - points[n - 2].position) - result[n - 2];
  return result;
}

struct Piece {
  glm::dvec3 from, to, from_tangent, to_tangent;

  glm::dvec3 at(double t) const {
    const double t2 = t * t, t3 = t2 * t;
    return (2.0 * t3 - 3.0 * t2 + 1.0) * from + (t3 - 2.0 * t2 + t) * from_tangent +
           (3.0 * t2 - 2.0 * t3) * to + (t3 - t2) * to_tangent;
  }
  /// Most that the place may move a unit of t, in the plane: a bound by the control polygon.
  double fastest() const {
    const glm::dvec3 b1 = from + from_tangent / 3.0, b2 = to - to_tangent / 3.0;
    const auto length = [](glm::dvec3 way) { return std::hypot(way.x, way.y); };
    return 3.0 * std::max({length(b1 - from), length(b2 - b1), length(to - b2)});
  }
};

}  // namespace

FeatureSide mix(const FeatureSide& a, const FeatureSide& b, double t) {
  return {mix(a.slope_size, b.slope_size, t), mix(a.slope_angle, b.slope_angle, t),
          mix(a.envelope, b.envelope, t)};
}

FeatureSample mix(const FeatureSample& a, const FeatureSample& b, double t) {
  return {a.position + t * (b.position - a.position), mix(a.elevation, b.elevation, t),
          mix(a.plateau, b.plateau, t), mix(a.left, b.left, t), mix(a.right, b.right, t)};
}

std::vector<FeatureSample> sample_curve(const FeatureCurve& curve, double spacing) {
  const auto& points = curve.points;
  const std::vector<glm::dvec3> tangent = tangents(points);
  std::vector<FeatureSample> samples;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Piece piece{points[i].position, points[i + 1].position, tangent[i], tangent[i + 1]};
    const int steps = std::max(1, int(std::ceil(piece.fastest() / spacing)));
    for (int k = 0; k < steps; ++k) {
      const double t = double(k) / steps;
      samples.push_back(mix(sample_at(points[i]), sample_at(points[i + 1]), t));
      samples.back().position = piece.at(t);
    }
  }
  samples.push_back(sample_at(points.back()));
  return samples;
}

void check_curve(const FeatureCurve& curve, const std::string& place) {
  if (curve.points.size() < 2) throw InputError(place + ": a curve has two points or more");
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const FeaturePoint& p = curve.points[i];
    const std::string where = place + ".points[" + std::to_string(i) + "]";
    for (const double v : {p.position.x, p.position.y, p.position.z})
      if (!std::isfinite(v)) throw InputError(where + ": not finite");
    for (const double v :
         {p.plateau, p.left.slope_size, p.left.envelope, p.right.slope_size, p.right.envelope})
      if (!(v >= 0.0 && v < 1e7)) throw InputError(where + ": sizes are 0 to 1e7 m");
    for (const double v : {p.left.slope_angle, p.right.slope_angle})
      if (!(std::fabs(v) <= 89.0 * std::numbers::pi / 180.0))
        throw InputError(where + ": slope angles are -89 to 89 degrees");
  }
}

}  // namespace orogen
