#include "tectonics/transport_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "gestures.h"

namespace orogen {
namespace {

glm::dvec2 somewhere(std::uint64_t seed, int k) {
  return {120e3 * random_uniform(seed, 21, k) - 10e3, 120e3 * random_uniform(seed, 22, k) - 10e3};
}

bool holds(const Ring& hull, glm::dvec2 p) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 a = hull[i], b = hull[(i + 1) % hull.size()];
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0.0) return false;
  }
  return hull.size() > 2;
}

// Equations 1 and 2 as they are printed, with the library's pow.
glm::dvec2 reference(const std::vector<RigidPlate>& plates, double e, glm::dvec2 p) {
  glm::dvec2 sum{0.0, 0.0};
  double weights = 0.0;
  for (const RigidPlate& plate : plates) {
    Ring moved;
    for (const glm::dvec2 v : plate.hull) moved.push_back(plate.motion.apply(v));
    if (holds(moved, p)) return plate.motion.inverse(p);
    glm::dvec2 foot = moved[0];
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const glm::dvec2 a = moved[i], d = moved[(i + 1) % moved.size()] - a;
      const double n = d.x * d.x + d.y * d.y;
      const double t = n > 0.0 ? ((p - a).x * d.x + (p - a).y * d.y) / n : 0.0;
      const glm::dvec2 q = a + std::min(1.0, std::max(0.0, t)) * d;
      if (std::hypot(p.x - q.x, p.y - q.y) < std::hypot(p.x - foot.x, p.y - foot.y)) foot = q;
    }
    const double w = 1.0 / std::pow(std::hypot(p.x - foot.x, p.y - foot.y), e);
    sum += w * (plate.motion.inverse(foot) - foot);
    weights += w;
  }
  return p + sum / weights;
}

TEST(TransportField, IsEquations1And2) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const double e = seed % 2 ? 0.9 : 0.1 + 3.9 * random_uniform(seed, 20, 0);
    const TransportField field(rigid_plates(test::random_plates(seed)), {e});
    for (int k = 0; k < 50; ++k) {
      const glm::dvec2 p = somewhere(seed, k),
                       d = field.inverse(p) - reference(field.plates(), e, p);
      EXPECT_NEAR(std::hypot(d.x, d.y), 0.0, 1e-5) << seed;  // 1e-9 of the arrows
    }
  }
}

TEST(TransportField, InsideAMovedHullItIsThePlatesOwnMotion) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const TransportField field(rigid_plates(test::random_plates(seed)));
    for (const RigidPlate& plate : field.plates()) {
      glm::dvec2 middle{0.0, 0.0};
      for (const glm::dvec2 v : plate.moved_hull) middle += v / double(plate.moved_hull.size());
      for (const glm::dvec2 v : plate.moved_hull)
        for (double t : {0.0, 0.3, 0.9}) {
          const glm::dvec2 p = middle + t * (v - middle);
          if (plate.hull.size() < 3 && t != 0.0) continue;
          const glm::dvec2 d = field.inverse(p) - plate.motion.inverse(p);
          EXPECT_NEAR(std::hypot(d.x, d.y), 0.0, plate.hull.size() < 3 ? 1e-3 : 1e-10);
        }
    }
  }
}

// 1e-6 m outside the border the others' share is at most some (1e-6 / 1e3)^0.9.
TEST(TransportField, DoesNotJumpAtTheBordersOfHulls) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const TransportField field(rigid_plates(test::random_plates(seed)));
    for (const RigidPlate& plate : field.plates())
      for (std::size_t i = 0; i < plate.moved_hull.size(); ++i) {
        const Ring& hull = plate.moved_hull;
        const glm::dvec2 a = hull[i], b = hull[(i + 1) % hull.size()];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length < 1.0) continue;
        const glm::dvec2 out = 1e-6 / length * glm::dvec2(b.y - a.y, a.x - b.x);
        for (double t : {0.0, 0.37, 1.0}) {
          const glm::dvec2 p = a + t * (b - a), d = field.inverse(p + out) - field.inverse(p - out);
          EXPECT_LT(std::hypot(d.x, d.y), 1e-2);
        }
      }
  }
}

TEST(TransportField, PatchesGiveWhatSinglePlacesGive) {
  constexpr int kMost = TransportField::Patch::kMost;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const TransportField field(rigid_plates(test::random_plates(seed)));
    const glm::dvec2 center = somewhere(seed, 0);
    const double radius = 15e3 * random_uniform(seed, 23, 0);
    const TransportField::Patch patch(field, center, radius);
    const int n = 1 + int(seed) % kMost;
    const double y = center.y + 0.6 * radius * random_uniform(seed, 24, 0);
    double x[kMost], from_x[kMost], from_y[kMost];
    std::int32_t plate[kMost];
    for (int j = 0; j < n; ++j)
      x[j] = center.x + 1.6 * radius * (random_uniform(seed, 25, j) - 0.5);
    patch.inverse(x, y, from_x, from_y, n);
    patch.nearest_plate(x, y, plate, n);
    for (int j = 0; j < n; ++j) {
      const glm::dvec2 p{x[j], y}, single = field.inverse(p);
      EXPECT_NEAR(from_x[j], single.x, 1e-8);
      EXPECT_NEAR(from_y[j], single.y, 1e-8);
      EXPECT_NEAR(field.distance(plate[j], p), field.distance(field.nearest_plate(p), p), 1e-9);
    }
  }
}

TEST(TransportField, ManyPointsOnACircleActLikeADisc) {
  PlateGesture ring;
  for (int k = 0; k < 10'000; ++k)
    ring.points.push_back(
        {20e3 * std::cos(k * 6.283185307179586e-4), 20e3 * std::sin(k * 6.283185307179586e-4)});
  ring.arrows.assign(10'000, {3e3, 0.0});
  const TransportField field(
      rigid_plates(std::vector{ring, test::box({60e3, -5e3}, {70e3, 5e3}, {0.0, 0.0})}));
  const glm::dvec2 from = field.inverse({33e3, 0.0});  // 10 km from the disc, 27 km from the box
  const double w = std::pow(10.0, -0.9), v = std::pow(27.0, -0.9);
  EXPECT_NEAR(from.x, 33e3 - 3e3 * w / (w + v), 1e-3);
}

TEST(TransportField, WithoutPlatesNothingMoves) {
  const TransportField field({});
  EXPECT_EQ(field.inverse({3e3, 4e3}), glm::dvec2(3e3, 4e3));
  EXPECT_EQ(field.nearest_plate({3e3, 4e3}), -1);
}

TEST(TransportField, RefusesExponentsOutOfRange) {
  for (double e : {0.0, 0.09, 4.1, std::nan("")}) EXPECT_THROW(TransportField({}, {e}), InputError);
}

}  // namespace
}  // namespace orogen
