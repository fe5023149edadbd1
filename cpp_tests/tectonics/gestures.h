// Gestures for tests of colliding plates.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "foundation/random.h"
#include "tectonics/rigid_plate.h"

namespace orogen::test {

/// A box as a gesture, moved by one arrow.
inline PlateGesture box(glm::dvec2 low, glm::dvec2 high, glm::dvec2 arrow,
                        PlateCrust crust = PlateCrust::Continental) {
  return {{low, {high.x, low.y}, high, {low.x, high.y}}, std::vector(4, arrow), crust, ""};
}

/// Two long plates that face each other over the line x = 50 km, 40 km apart; `push` (m) is how far
/// each comes towards it.
inline std::vector<PlateGesture> facing_pair(double push) {
  return {box({10e3, -100e3}, {30e3, 200e3}, {push, 0.0}),
          box({70e3, -100e3}, {90e3, 200e3}, {-push, 0.0})};
}

/// `count` points within `radius` of the centre, with arrows that turn them by `angle` about it and
/// shift them, and `noise` (m) on the arrows.
inline PlateGesture random_gesture(std::uint64_t seed, glm::dvec2 center, double radius, int count,
                                   double angle, glm::dvec2 shift, double noise = 0.0) {
  PlateGesture gesture;
  for (int k = 0; k < count; ++k) {
    const double r = radius * std::sqrt(random_uniform(seed, 1, k));
    const double at = 6.283185307 * random_uniform(seed, 2, k);
    const glm::dvec2 d{r * std::cos(at), r * std::sin(at)};
    const glm::dvec2 turned{std::cos(angle) * d.x - std::sin(angle) * d.y,
                            std::sin(angle) * d.x + std::cos(angle) * d.y};
    gesture.points.push_back(center + d);
    gesture.arrows.push_back(turned - d + shift +
                             noise *
                                 glm::dvec2(random_normal(seed, 3, k), random_normal(seed, 4, k)));
  }
  return gesture;
}

/// One to five plates with 1, 2, 3 or many points, well apart, in a square of 100 km.
inline std::vector<PlateGesture> random_plates(std::uint64_t seed) {
  const glm::dvec2 places[] = {
      {20e3, 20e3}, {80e3, 20e3}, {50e3, 50e3}, {20e3, 80e3}, {80e3, 80e3}};
  const int counts[] = {1, 2, 3, 7, 40};
  std::vector<PlateGesture> gestures;
  const int plates = 1 + int(5 * random_uniform(seed, 11, 0));
  for (int i = 0; i < plates; ++i) {
    const auto u = [&](int k) { return random_uniform(seed, 12, 10 * i + k); };
    gestures.push_back(random_gesture(seed * 7 + i, places[i], 3e3 + 8e3 * u(0),
                                      counts[int(5 * u(1))], 0.6 * (u(2) - 0.5),
                                      {6e3 * (u(3) - 0.5), 6e3 * (u(4) - 0.5)}));
  }
  return gestures;
}

}  // namespace orogen::test
