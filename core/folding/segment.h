// A straight piece of a line, and the distance to it.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace orogen {

struct Segment {
  glm::dvec2 a{0.0, 0.0}, b{0.0, 0.0};  // m
  bool operator==(const Segment&) const = default;
};

inline double distance_to(const Segment& s, glm::dvec2 p) {
  const glm::dvec2 d = s.b - s.a, e = p - s.a;
  const double square = glm::dot(d, d);
  const double t = square > 0.0 ? std::clamp(glm::dot(e, d) / square, 0.0, 1.0) : 0.0;
  return glm::length(e - t * d);
}

}  // namespace orogen
