#include "tectonics/rigid_plate.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "foundation/errors.h"

namespace orogen {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

Ring convex_hull(const std::vector<glm::dvec2>& points) {
  std::vector<Point> places, hull;
  for (const glm::dvec2& p : points) places.emplace_back(p.x, p.y);
  CGAL::convex_hull_2(places.begin(), places.end(), std::back_inserter(hull));
  Ring ring;
  for (const Point& p : hull) ring.emplace_back(p.x(), p.y());
  return ring;
}

double dot(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.x + a.y * b.y;
}
double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// Exact: which side of a -> b the point c lies on (1: left).
int side(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return int(CGAL::orientation(Point(a.x, a.y), Point(b.x, b.y), Point(c.x, c.y)));
}

bool ranges_meet(double a, double b, double c, double d) {
  return std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b);
}

/// Exact, also where a segment is a point.
bool segments_meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  return ranges_meet(a.x, b.x, c.x, d.x) && ranges_meet(a.y, b.y, c.y, d.y) &&
         side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

bool contains(const Ring& hull, glm::dvec2 p) {
  if (hull.size() < 3) return false;
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (side(hull[i], hull[(i + 1) % hull.size()], p) < 0) return false;
  return true;
}

bool hulls_meet(const Ring& a, const Ring& b) {
  glm::dvec2 low = b[0], high = b[0];
  for (const glm::dvec2 p : b) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec2 from = a[i], to = a[(i + 1) % a.size()];
    if (!ranges_meet(from.x, to.x, low.x, high.x) || !ranges_meet(from.y, to.y, low.y, high.y))
      continue;
    for (std::size_t j = 0; j < b.size(); ++j)
      if (segments_meet(from, to, b[j], b[(j + 1) % b.size()])) return true;
  }
  return contains(a, b[0]) || contains(b, a[0]);
}

}  // namespace

RigidPlate rigid_plate(const PlateGesture& gesture) {
  RigidPlate plate;
  plate.crust = gesture.crust;
  plate.name = gesture.name;
  plate.hull = convex_hull(gesture.points);
  plate.motion = fit_rigid_motion(gesture.points, gesture.arrows);
  for (const glm::dvec2& p : plate.hull) plate.moved_hull.push_back(plate.motion.apply(p));
  double squares = 0.0;
  for (std::size_t k = 0; k < gesture.points.size(); ++k) {
    plate.arrows.push_back(plate.motion.apply(gesture.points[k]) - gesture.points[k]);
    const glm::dvec2 rest = gesture.arrows[k] - plate.arrows[k];
    squares += dot(rest, rest);
  }
  plate.residual_m = std::sqrt(squares / double(gesture.points.size()));
  return plate;
}

double RigidMotion::angle() const {
  return std::atan2(sine, cosine);
}

double RigidPlate::displacement() const {
  double mean = 0.0;
  for (const glm::dvec2 a : arrows) mean += dot(a, a) / double(arrows.size());
  return std::sqrt(mean);
}

RigidMotion fit_rigid_motion(std::span<const glm::dvec2> points,
                             std::span<const glm::dvec2> arrows) {
  const double n = double(points.size());
  glm::dvec2 mean{0.0, 0.0}, mean_arrow{0.0, 0.0};
  for (std::size_t k = 0; k < points.size(); ++k) {
    mean += points[k] / n;
    mean_arrow += arrows[k] / n;
  }
  double along = 0.0, across = 0.0, size = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const glm::dvec2 from = points[k] - mean, to = from + (arrows[k] - mean_arrow);
    along += dot(from, to);
    across += cross(from, to);
    size += dot(from, from) + dot(to, to);
  }
  RigidMotion motion;
  const double length = std::sqrt(along * along + across * across);
  if (length > 1e-12 * size) {
    motion.cosine = along / length;
    motion.sine = across / length;
  }
  motion.translation = mean + mean_arrow - motion.apply(mean);
  return motion;
}

std::vector<RigidPlate> rigid_plates(std::span<const PlateGesture> gestures,
                                     std::string_view place) {
  check_gestures(gestures, place);
  std::vector<RigidPlate> plates;
  for (const PlateGesture& gesture : gestures) plates.push_back(rigid_plate(gesture));
  if (const auto met = meeting_plates(plates))
    throw InputError(std::string(place) + "[" + std::to_string(met->first) + "] and [" +
                     std::to_string(met->second) + "]: their rigid parts meet " +
                     (met->after ? "after the move; shorten their arrows, so that they stay apart"
                                 : "before the move; set their points apart"));
  return plates;
}

std::optional<PlateMeeting> meeting_plates(std::span<const RigidPlate> plates) {
  for (int j = 1; j < int(plates.size()); ++j)
    for (int i = 0; i < j; ++i) {
      if (hulls_meet(plates[i].hull, plates[j].hull)) return PlateMeeting{i, j, false};
      if (hulls_meet(plates[i].moved_hull, plates[j].moved_hull)) return PlateMeeting{i, j, true};
    }
  return {};
}

glm::dvec2 nearest_on_hull(const Ring& hull, glm::dvec2 p) {
  bool outside = hull.size() < 3;
  double best = std::numeric_limits<double>::infinity();
  glm::dvec2 nearest = p;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 a = hull[i], e = hull[(i + 1) % hull.size()] - a, r = p - a;
    const double squared = dot(e, e);
    const double t = squared > 0.0 ? std::clamp(dot(r, e) / squared, 0.0, 1.0) : 0.0;
    const glm::dvec2 rest = r - t * e;
    if (cross(e, r) < 0.0) outside = true;
    if (dot(rest, rest) < best) {
      best = dot(rest, rest);
      nearest = p - rest;
    }
  }
  return outside ? nearest : p;
}

double distance_to_hull(const Ring& hull, glm::dvec2 p) {
  const glm::dvec2 d = p - nearest_on_hull(hull, p);
  return std::sqrt(dot(d, d));
}

}  // namespace orogen
