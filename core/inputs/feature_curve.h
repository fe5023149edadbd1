// Feature curves: ridges, valleys, cliffs and river beds that a user draws (paper B, V-A).
//
// A curve runs through its control points as a cubic Hermite spline, quadratic towards its ends
// (tangents: half of the way between a point's neighbours). What a point asks for holds between
// points as a linear blend.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace orogen {

/// One side of a curve at a point.
struct FeatureSide {
  double slope_size = 0.0;   // m, from the plateau's rim; 0: no slope is asked for
  double slope_angle = 0.0;  // radians; above 0 the ground falls away from the curve
  double envelope = 0.0;     // m, beyond the slope: where ground is blended into what was there
};

struct FeaturePoint {
  glm::dvec3 position{0.0, 0.0, 0.0};  // m; z above the sea
  bool elevation = true;               // whether z is asked for
  double plateau = 0.0;                // m, half the width of the flat top
  FeatureSide left = {}, right = {};   // as seen along the curve
};

struct FeatureCurve {
  std::string name;
  std::vector<FeaturePoint> points;  // two or more
};

/// A place on a curve; `elevation` is the blend of 1 and 0.
struct FeatureSample {
  glm::dvec3 position{0.0, 0.0, 0.0};
  double elevation = 1.0, plateau = 0.0;
  FeatureSide left, right;
};

FeatureSide mix(const FeatureSide& a, const FeatureSide& b, double t);
/// Between two places in a straight line: a where t is 0, b where it is 1.
FeatureSample mix(const FeatureSample& a, const FeatureSample& b, double t);

/// Places along the curve, its control points among them, not more than `spacing` (m) apart in the
/// plane but for rounding.
std::vector<FeatureSample> sample_curve(const FeatureCurve& curve, double spacing);

/// InputError, beginning with `place`, for fewer than two points, numbers that are not finite,
/// sizes below 0, angles of 90 degrees or more.
void check_curve(const FeatureCurve& curve, const std::string& place);

}  // namespace orogen
