// Where the ground came from: the transport field between rigid plates (paper C, section 4.2).
//
//   Φ⁻¹(p) = T_i⁻¹ p                                                inside T_i(A_i)         (1)
//   Φ⁻¹(p) = p + Σ_i w_i (T_i⁻¹ π_i − π_i) / Σ_i w_i,  w_i = d_i^−e      elsewhere          (2)
//
// p: a place after the move (m); T_i, A_i: motion and rigid part of plate i (rigid_plate.h);
// π_i, d_i: projection of p on the moved hull T_i(A_i) and distance to it (m); e: falloff exponent.
// The paper's text takes distances to A_i; to the moved hull, as its Fig. 6 draws them, (2) tends
// to (1) at the hull's border and there is no jump.
//
// Within a disc of radius r about c every projection lies within r of π(c) (projecting on a convex
// set brings no two points farther apart), so that a Patch keeps only the sides that come so near.
//
// Limits: with e < 1 the field is continuous but has a steep slope at the hulls' borders; where
// plates pass through each other it folds. The last digits of a place may differ between patches.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <tuple>
#include <vector>

#include "foundation/parameters.h"
#include "tectonics/rigid_plate.h"

namespace orogen {

struct TransportParameters {
  double falloff_exponent = 0.9;
};

constexpr auto parameter_table(const TransportParameters*) {
  return std::tuple{real("falloff_exponent", &TransportParameters::falloff_exponent, 0.1, 4.0, "",
                         "How quickly the influence of a plate falls with the distance to it.")};
}

class TransportField {
 public:
  /// InputError for a parameter out of range. Without plates the ground stays where it is.
  explicit TransportField(std::vector<RigidPlate> plates,
                          const TransportParameters& parameters = {});

  const std::vector<RigidPlate>& plates() const { return plates_; }

  /// Φ⁻¹(p).
  glm::dvec2 inverse(glm::dvec2 p) const;

  /// How plate i moves the ground it acts upon at p: π − T⁻¹ π, m a step.
  glm::dvec2 plate_displacement(int i, glm::dvec2 p) const;

  /// Distance (m) from p to the moved hull of plate i; 0 inside.
  double distance(int i, glm::dvec2 p) const { return distance_to_hull(plates_[i].moved_hull, p); }

  /// Influence region: the plate whose moved hull is nearest to p (the first of several).
  int nearest_plate(glm::dvec2 p) const;

  class Patch;

 private:
  struct Side {  // of a moved hull, from a along e (m)
    double ax, ay, ex, ey, per_length2;
  };
  struct Hull {
    std::vector<Side> sides;
    bool has_inside;
    double cos_minus_1, sine, shift_x, shift_y;  // T⁻¹ p − p
  };
  std::vector<RigidPlate> plates_;
  std::vector<Hull> hulls_;
  double falloff_exponent_;
};

/// The field within a disc, for many places at once.
class TransportField::Patch {
 public:
  static constexpr int kMost = 64;  // places a call

  Patch(const TransportField& field, glm::dvec2 center, double radius);

  /// Φ⁻¹ at the places (x[j], y), n <= kMost, all within the disc.
  void inverse(const double* x, double y, double* from_x, double* from_y, int n) const;

  /// The plate whose moved hull is nearest to each of the places; -1 if there are no plates.
  void nearest_plate(const double* x, double y, std::int32_t* plate, int n) const;

 private:
  struct Part {
    const Hull* hull;
    int begin, end;   // of sides_
    double distance;  // from the disc's centre, m
  };
  const TransportField* field_;
  std::vector<Side> sides_;
  std::vector<Part> parts_;
  const Hull* within_ = nullptr;  // the hull that holds the whole disc
  std::vector<int> nearest_;      // plates that are nearest somewhere in the disc (or a few more)
};

}  // namespace orogen
