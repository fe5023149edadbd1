// Gestures that make moving plates (paper C, section 4.1): what a hand does on the map.
//
// c_k: where a finger touches the ground (m); Φ(c_k) − c_k: the arrow it draws (m), which is the
// way the ground takes during one geological step. The convex hull of one gesture's points is the
// rigid part of one plate; tectonics/rigid_plate.h makes plates of them.
//
// Limits: 1 to 10,000 points a gesture, 1000 gestures, 100,000 points in all; numbers finite and
// within 1e8 m.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace orogen {

enum class PlateCrust { Continental, Oceanic };
inline constexpr std::string_view kPlateCrusts[] = {"continental", "oceanic"};

struct PlateGesture {
  std::vector<glm::dvec2> points;  // c_k, m
  std::vector<glm::dvec2> arrows;  // Φ(c_k) − c_k, m; one a point
  PlateCrust crust = PlateCrust::Continental;
  std::string name;
};

/// A stretch of time during which plates keep their motion: the arrows are those of the whole
/// phase.
struct MotionPhase {
  double years = 5e6;
  std::vector<PlateGesture> plates;
  int stable_plate = -1;  // the plate that faults end at; -1: the slowest
};

/// InputError for a gesture that cannot make a plate; `place` (such as "plates") begins the
/// message.
void check_gestures(std::span<const PlateGesture> gestures, std::string_view place);

}  // namespace orogen
