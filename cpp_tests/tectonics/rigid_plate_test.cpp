#include "tectonics/rigid_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "gestures.h"
#include "tectonics/voronoi.h"

namespace orogen {
namespace {

using test::box;
using test::random_gesture;

double length(glm::dvec2 v) {
  return std::hypot(v.x, v.y);
}

struct Fit {
  double angle = 0.0, x = 0.0, y = 0.0, cost = 0.0;
};

// Gauss and Newton on (angle, x, y), from one start; the slow reference.
Fit descend(const PlateGesture& g, double angle) {
  Fit f{angle};
  for (int round = 0; round < 200; ++round) {
    double a[3][4] = {};
    f.cost = 0.0;
    for (std::size_t k = 0; k < g.points.size(); ++k) {
      const double c = std::cos(f.angle), s = std::sin(f.angle);
      const glm::dvec2 p = g.points[k], to = p + g.arrows[k];
      const double rest[2] = {c * p.x - s * p.y + f.x - to.x, s * p.x + c * p.y + f.y - to.y};
      const double slope[2][3] = {{-s * p.x - c * p.y, 1.0, 0.0}, {c * p.x - s * p.y, 0.0, 1.0}};
      for (int e = 0; e < 2; ++e) {
        f.cost += rest[e] * rest[e];
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) a[i][j] += slope[e][i] * slope[e][j];
          a[i][3] -= slope[e][i] * rest[e];
        }
      }
    }
    for (int i = 0; i < 3; ++i)
      for (int r = 0; r < 3; ++r)
        if (r != i) {
          const double factor = a[r][i] / a[i][i];
          for (int j = 0; j < 4; ++j) a[r][j] -= factor * a[i][j];
        }
    f.angle += a[0][3] / a[0][0];
    f.x += a[1][3] / a[1][1];
    f.y += a[2][3] / a[2][2];
  }
  return f;
}

TEST(RigidPlate, MotionIsThatOfANumericMinimiser) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const double angle = 6.2 * (random_uniform(seed, 5, 0) - 0.5);
    const auto g = random_gesture(seed, {1e3, -2e3}, 10e3, 2 + int(seed % 9), angle, {5e3, -8e3},
                                  seed % 3 ? 800.0 : 0.0);
    Fit best = descend(g, 0.0);
    for (double start : {1.5, 3.0, -1.5})
      if (const Fit f = descend(g, start); f.cost < best.cost - 1e-6) best = f;
    const RigidPlate plate = rigid_plates(std::vector{g}).front();
    EXPECT_NEAR(std::remainder(plate.motion.angle() - best.angle, 2.0 * 3.14159265358979), 0.0,
                1e-9);
    for (const glm::dvec2 p : g.points) {
      const glm::dvec2 q{std::cos(best.angle) * p.x - std::sin(best.angle) * p.y + best.x,
                         std::sin(best.angle) * p.x + std::cos(best.angle) * p.y + best.y};
      EXPECT_NEAR(length(plate.motion.apply(p) - q), 0.0, 1e-9 * 2e4);
      EXPECT_NEAR(length(plate.motion.inverse(plate.motion.apply(p)) - p), 0.0, 1e-10 * 2e4);
    }
    EXPECT_NEAR(plate.residual_m, std::sqrt(best.cost / double(g.points.size())), 1e-5);
  }
}

TEST(RigidPlate, ArrowsAreDrawnAnewFromTheMotion) {
  const auto g = random_gesture(3, {0.0, 0.0}, 10e3, 6, 0.3, {5e3, 0.0}, 500.0);
  const RigidPlate plate = rigid_plates(std::vector{g}).front();
  ASSERT_EQ(plate.arrows.size(), 6u);
  double squares = 0.0;
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(plate.arrows[k], plate.motion.apply(g.points[k]) - g.points[k]);
    squares += std::pow(length(plate.arrows[k] - g.arrows[k]), 2);
  }
  EXPECT_GT(plate.residual_m, 100.0);
  EXPECT_NEAR(plate.residual_m, std::sqrt(squares / 6.0), 1e-9);
}

TEST(RigidPlate, OnePointOrPointsBroughtTogetherGiveATranslation) {
  PlateGesture one{{{3e3, 4e3}}, {{-1e3, 2e3}}, PlateCrust::Oceanic, "one"};
  PlateGesture same{{{30e3, 4e3}, {30e3, 4e3}}, {{1e3, 0.0}, {3e3, 0.0}}, {}, ""};
  PlateGesture together{{{60e3, 0.0}, {64e3, 0.0}, {62e3, 3e3}}, {}, {}, ""};
  for (const auto& p : together.points) together.arrows.push_back(glm::dvec2(62e3, 9e3) - p);
  const auto plates = rigid_plates(std::vector{one, same, together});
  for (const RigidPlate& plate : plates) EXPECT_EQ(plate.motion.angle(), 0.0);
  EXPECT_EQ(plates[0].hull, Ring({{3e3, 4e3}}));
  EXPECT_EQ(plates[0].motion.translation, glm::dvec2(-1e3, 2e3));
  EXPECT_EQ(plates[0].crust, PlateCrust::Oceanic);
  EXPECT_EQ(plates[0].name, "one");
  EXPECT_EQ(plates[1].hull.size(), 1u);
  EXPECT_EQ(plates[1].motion.translation, glm::dvec2(2e3, 0.0));
  EXPECT_NEAR(plates[1].residual_m, 1e3, 1e-9);
  EXPECT_EQ(plates[2].hull.size(), 3u);
}

TEST(RigidPlate, HullHoldsEveryPointAndRunsAnticlockwise) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto g = random_gesture(seed, {5e6, -4e6}, 10e3, 3 + int(seed), 0.1, {1e3, 0.0});
    const RigidPlate plate = rigid_plates(std::vector{g}).front();
    EXPECT_GT(ring_area(plate.hull), 0.0);
    EXPECT_NEAR(ring_area(plate.moved_hull), ring_area(plate.hull), 1e-9 * 3e8);
    for (const glm::dvec2 p : g.points) EXPECT_LT(distance_to_hull(plate.hull, p), 1e-8);
    for (const glm::dvec2 v : plate.hull)
      EXPECT_NE(std::find(g.points.begin(), g.points.end(), v), g.points.end());
  }
  PlateGesture line;
  for (double x : {3e3, 1e3, 2e3, 5e3}) line.points.push_back({x, 2.0 * x});
  line.arrows.assign(4, {0.0, 1e3});
  EXPECT_EQ(rigid_plates(std::vector{line})[0].hull, Ring({{1e3, 2e3}, {5e3, 10e3}}));
}

TEST(RigidPlate, ProjectionIsTheNearestPointOfTheHull) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const int count = 1 + int(seed % 8);
    const auto g = random_gesture(seed, {0.0, 0.0}, 10e3, count, 0.0, {0.0, 0.0});
    const Ring hull = rigid_plates(std::vector{g})[0].hull;
    for (int k = 0; k < 20; ++k) {
      const glm::dvec2 p{40e3 * (random_uniform(seed, 6, k) - 0.5),
                         40e3 * (random_uniform(seed, 7, k) - 0.5)};
      const glm::dvec2 foot = nearest_on_hull(hull, p);
      EXPECT_NEAR(distance_to_hull(hull, p), length(p - foot), 1e-9);
      EXPECT_NEAR(distance_to_hull(hull, foot), 0.0, 1e-9);
      // Of a convex set: all of it lies beyond the line through the foot across p - foot.
      for (const glm::dvec2 v : hull)
        EXPECT_LE((p - foot).x * (v - foot).x + (p - foot).y * (v - foot).y, 1e-3);
    }
  }
  const Ring square{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}};
  EXPECT_EQ(nearest_on_hull(square, {1.0, 0.5}), glm::dvec2(1.0, 0.5));
  EXPECT_EQ(nearest_on_hull(square, {1.0, -3.0}), glm::dvec2(1.0, 0.0));
  EXPECT_EQ(distance_to_hull(square, {5.0, 6.0}), 5.0);
}

std::string refusal(const std::vector<PlateGesture>& gestures) {
  try {
    rigid_plates(gestures);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RigidPlate, RefusesPlatesThatMeet) {
  const glm::dvec2 still{0.0, 0.0};
  const auto a = box({0.0, 0.0}, {10e3, 10e3}, still);
  const std::string before =
      "plates[0] and [1]: their rigid parts meet before the move; set their points apart";
  const auto point = [&](double x, double y) { return PlateGesture{{{x, y}}, {still}, {}, ""}; };
  const auto segment = [&](glm::dvec2 p, glm::dvec2 q) {
    return PlateGesture{{p, q}, {still, still}, {}, ""};
  };
  EXPECT_EQ(refusal({a, a}), before);
  EXPECT_EQ(refusal({a, box({5e3, 5e3}, {15e3, 15e3}, still)}), before);
  EXPECT_EQ(refusal({a, box({10e3, 10e3}, {15e3, 15e3}, still)}), before);  // touching
  EXPECT_EQ(refusal({a, box({2e3, 2e3}, {3e3, 3e3}, still)}), before);      // within
  EXPECT_EQ(refusal({box({2e3, 2e3}, {3e3, 3e3}, still), a}), before);
  EXPECT_EQ(refusal({a, box({-5e3, 4e3}, {15e3, 6e3}, still)}), before);  // no corner inside
  EXPECT_EQ(refusal({a, point(5e3, 5e3)}), before);
  EXPECT_EQ(refusal({point(5e3, 5e3), point(5e3, 5e3)}), before);
  EXPECT_EQ(refusal({segment({0.0, 0.0}, {2e3, 0.0}), segment({1e3, 0.0}, {3e3, 0.0})}), before);
  EXPECT_EQ(refusal({segment({0.0, 0.0}, {2e3, 2e3}), point(1e3, 1e3)}), before);
  EXPECT_EQ(refusal({a, box({20e3, 0.0}, {30e3, 10e3}, {-10e3, 0.0})}),
            "plates[0] and [1]: their rigid parts meet after the move; shorten their arrows, so "
            "that they stay apart");
  EXPECT_EQ(refusal({a, box({10001.0, 0.0}, {15e3, 10e3}, still)}), "");
  EXPECT_EQ(refusal({a, point(11e3, 5e3), point(12e3, 5e3)}), "");
  EXPECT_EQ(refusal({segment({0.0, 0.0}, {2e3, 0.0}), segment({2001.0, 0.0}, {3e3, 0.0})}), "");
  EXPECT_EQ(refusal({segment({0.0, 0.0}, {2e3, 2e3}), point(1e3, 1001.0)}), "");
}

TEST(RigidPlate, PlatesThatMeetAreNamed) {
  const auto plates_of = [](const std::vector<PlateGesture>& gestures) {
    std::vector<RigidPlate> plates;
    for (const PlateGesture& gesture : gestures) plates.push_back(rigid_plate(gesture));
    return plates;
  };
  const PlateGesture west = box({0, 0}, {10, 10}, {0, 0});
  const PlateGesture east = box({20, 0}, {30, 10}, {-5, 0});
  EXPECT_FALSE(meeting_plates({}));
  EXPECT_FALSE(meeting_plates(plates_of({west, east})));
  const auto before = meeting_plates(plates_of({west, east, box({10, 5}, {12, 8}, {0, 0})}));
  ASSERT_TRUE(before);  // they touch
  EXPECT_EQ(before->first, 0);
  EXPECT_EQ(before->second, 2);
  EXPECT_FALSE(before->after);
  const auto after = meeting_plates(
      plates_of({west, box({40, 0}, {50, 10}, {0, 0}), box({20, 0}, {30, 10}, {15, 0})}));
  ASSERT_TRUE(after);
  EXPECT_EQ(after->first, 1);
  EXPECT_EQ(after->second, 2);
  EXPECT_TRUE(after->after);
}

}  // namespace
}  // namespace orogen
