// Plates that move as rigid bodies, made from gestures (paper C, section 4.1).
//
//   A: convex hull of the gesture's points c_k      T: p -> R p + t, rotation and translation
//   T = argmin Σ_k |Φ(c_k) − T c_k|²
//
// In closed form (Kabsch in the plane): with both sets taken about their means,
//   tan θ = Σ c'_k × Φ'_k / Σ c'_k · Φ'_k,  t = mean Φ − R mean c
// One point, or points that the arrows bring to one place, give a translation. The arrows are then
// drawn anew from T. Hulls may be a point or a segment.
//
// Limits: hulls must lie apart before the move and after it (exact test; touching is refused), but
// nothing is said about the way between: plates that change places fold the transport field.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "inputs/plate_gesture.h"
#include "inputs/vector_map.h"

namespace orogen {

struct RigidMotion {
  double cosine = 1.0, sine = 0.0;   // of the angle, anticlockwise about the map's origin
  glm::dvec2 translation{0.0, 0.0};  // m, after the rotation

  double angle() const;  // rad
  glm::dvec2 apply(glm::dvec2 p) const {
    return {cosine * p.x - sine * p.y + translation.x, sine * p.x + cosine * p.y + translation.y};
  }
  glm::dvec2 inverse(glm::dvec2 p) const {
    const glm::dvec2 d = p - translation;
    return {cosine * d.x + sine * d.y, cosine * d.y - sine * d.x};
  }
};

/// The least-squares T of points and the arrows that start from them; as many of both, at least
/// one.
RigidMotion fit_rigid_motion(std::span<const glm::dvec2> points,
                             std::span<const glm::dvec2> arrows);

struct RigidPlate {
  Ring hull;        // A, m, anticlockwise; one point or two where the gesture has no area
  Ring moved_hull;  // T(A)
  RigidMotion motion;
  std::vector<glm::dvec2> arrows;  // m, T c_k − c_k
  double residual_m = 0.0;         // root of the mean of |Φ(c_k) − T c_k|²
  PlateCrust crust = PlateCrust::Continental;
  std::string name;

  double displacement() const;  // m, root of the mean square of the arrows
};

/// The plate of a gesture that check_gestures accepts.
RigidPlate rigid_plate(const PlateGesture& gesture);

/// Two plates whose rigid parts meet or touch.
struct PlateMeeting {
  int first = 0, second = 0;  // numbers, first < second
  bool after = false;         // the move; else before it
};

/// The first such pair; nothing where all plates lie apart. Exact.
std::optional<PlateMeeting> meeting_plates(std::span<const RigidPlate> plates);

/// One plate a gesture, in order. InputError (beginning with `place`) for gestures that cannot make
/// plates or plates that overlap.
std::vector<RigidPlate> rigid_plates(std::span<const PlateGesture> gestures,
                                     std::string_view place = "plates");

/// π(p): the point of a convex hull (anticlockwise, not empty) that is nearest to p; p if inside.
glm::dvec2 nearest_on_hull(const Ring& hull, glm::dvec2 p);

/// Distance (m) from p to a convex hull; 0 inside.
double distance_to_hull(const Ring& hull, glm::dvec2 p);

}  // namespace orogen
