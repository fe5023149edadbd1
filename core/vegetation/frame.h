// An orthonormal frame that travels along a stem: z where the stem grows, x and y across it.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace orogen {

struct Frame {
  glm::dvec3 x{1.0, 0.0, 0.0}, z{0.0, 0.0, 1.0};

  glm::dvec3 y() const { return glm::cross(z, x); }

  /// Turned by `angle` (radians) about its own x: z leans towards -y.
  Frame about_x(double angle) const { return {x, std::cos(angle) * z - std::sin(angle) * y()}; }
  /// Turned about its own y: z leans towards x.
  Frame about_y(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * x - s * z, c * z + s * x};
  }
  /// Turned about its own z: x goes to y.
  Frame about_z(double angle) const { return {std::cos(angle) * x + std::sin(angle) * y(), z}; }
  /// Turned about a unit vector of space.
  Frame about(glm::dvec3 axis, double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](glm::dvec3 v) {
      return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
    };
    return {turned(x), turned(z)};
  }
  /// z turned towards the sky by `angle`, or away from it, but never past the vertical.
  Frame towards_sky(double angle) const {
    const double across = std::hypot(z.x, z.y);
    if (across < 1e-9) return *this;
    const double lean = std::atan2(across, z.z), opposite = lean - std::numbers::pi;
    const double turn = angle > lean ? lean : angle < opposite ? opposite : angle;
    return about(glm::dvec3(z.y, -z.x, 0.0) / across, turn);
  }
};

/// The frame along `direction` whose x is as near to `side` as can be.
inline Frame frame_along(glm::dvec3 direction, glm::dvec3 side) {
  const glm::dvec3 z = glm::normalize(direction);
  const glm::dvec3 across = side - glm::dot(side, z) * z;
  const double length = glm::length(across);
  if (length > 1e-9) return {across / length, z};
  return frame_along(z,
                     std::abs(z.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0));
}

}  // namespace orogen
