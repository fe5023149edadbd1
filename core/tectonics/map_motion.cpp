#include "tectonics/map_motion.h"

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "tectonics/rigid_plate.h"

namespace orogen {

namespace {

constexpr double kLargestShare = 0.8, kShareStep = 0.1;

MotionPhase drawn_in(const PlateMap& plates, const MapMotionParameters& parameters, double share) {
  MotionPhase phase;
  phase.years = parameters.years;
  double fastest = 0.0;
  for (const Plate& plate : plates.plates) {
    PlateGesture& gesture = phase.plates.emplace_back();
    for (const Ring& piece : plate.pieces)
      for (const glm::dvec2 corner : piece) {
        gesture.points.push_back(plate.centroid + share * (corner - plate.centroid));
        gesture.arrows.push_back(plate.velocity_at(gesture.points.back()));
        fastest = std::max(fastest, std::hypot(gesture.arrows.back().x, gesture.arrows.back().y));
      }
  }
  for (PlateGesture& gesture : phase.plates)
    for (glm::dvec2& arrow : gesture.arrows)
      arrow *= fastest > 0.0 ? parameters.travel / fastest : 0.0;
  return phase;
}

bool apart(const MotionPhase& phase) {
  check_gestures(phase.plates, "plates");
  std::vector<RigidPlate> plates;
  for (const PlateGesture& gesture : phase.plates) plates.push_back(rigid_plate(gesture));
  return !meeting_plates(plates);
}

}  // namespace

MotionPhase motion_of(const PlateMap& plates, const MapMotionParameters& parameters) {
  check_parameters(parameters);
  for (int i = 0; i < 8; ++i) {
    MotionPhase phase = drawn_in(plates, parameters, kLargestShare - i * kShareStep);
    if (apart(phase)) return phase;
  }
  throw InputError("travel: " + detail::format_number(parameters.travel) +
                   " m is too far; the map's plates would run into each other");
}

}  // namespace orogen
