#include "inputs/feature_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/errors.h"

namespace orogen {
namespace {

FeatureCurve curve(std::vector<glm::dvec3> places) {
  FeatureCurve made;
  for (const glm::dvec3 place : places) made.points.push_back({.position = place});
  return made;
}

TEST(FeatureCurve, RunsThroughItsPointsInSmallSteps) {
  const FeatureCurve bent = curve({{0, 0, 5}, {1000, 300, 20}, {1500, 2000, 90}, {4000, 2100, 10}});
  const auto samples = sample_curve(bent, 20.0);
  for (const FeaturePoint& point : bent.points) {
    double nearest = 1e9;
    for (const FeatureSample& s : samples)
      nearest = std::min(nearest, glm::length(s.position - point.position));
    EXPECT_LT(nearest, 1e-9);
  }
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const glm::dvec3 way = samples[i + 1].position - samples[i].position;
    ASSERT_LE(std::hypot(way.x, way.y), 20.0 + 1e-9);
  }
}

TEST(FeatureCurve, IsSmooth) {
  const auto samples =
      sample_curve(curve({{0, 0, 0}, {1000, 300, 0}, {1500, 2000, 0}, {4000, 2100, 0}}), 1.0);
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const glm::dvec3 a = samples[i].position - samples[i - 1].position;
    const glm::dvec3 b = samples[i + 1].position - samples[i].position;
    ASSERT_GT(glm::dot(a, b) / (glm::length(a) * glm::length(b)), 0.9999);
  }
}

TEST(FeatureCurve, EndsAreQuadratic) {
  // Of three points on a parabola, each end's piece is that parabola.
  const auto samples = sample_curve(curve({{0, 0, 0}, {100, 100, 0}, {200, 400, 0}}), 5.0);
  for (const FeatureSample& s : samples)
    EXPECT_NEAR(s.position.y, s.position.x * s.position.x / 100.0, 1e-9);
}

TEST(FeatureCurve, BlendsWhatPointsAskFor) {
  FeatureCurve made = curve({{0, 0, 0}, {100, 0, 50}});
  made.points[0].elevation = false;
  made.points[1].plateau = 40.0;
  made.points[1].left = {30.0, 0.5, 20.0};
  for (const FeatureSample& s : sample_curve(made, 10.0)) {
    const double t = s.position.x / 100.0;
    EXPECT_NEAR(s.elevation, t, 1e-12);
    EXPECT_NEAR(s.position.z, 50.0 * t, 1e-9);
    EXPECT_NEAR(s.plateau, 40.0 * t, 1e-12);
    EXPECT_NEAR(s.left.slope_angle, 0.5 * t, 1e-12);
    EXPECT_NEAR(s.left.envelope, 20.0 * t, 1e-12);
    EXPECT_EQ(s.right.envelope, 0.0);
  }
}

TEST(FeatureCurve, RefusesWhatCannotBe) {
  const auto refused = [](auto&& spoil, const char* word) {
    FeatureCurve made = curve({{0, 0, 0}, {100, 0, 50}});
    spoil(made);
    try {
      check_curve(made, "features[3]");
      ADD_FAILURE() << word;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("features[3]"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused([](FeatureCurve& c) { c.points.pop_back(); }, "two points");
  refused([](FeatureCurve& c) { c.points[1].position.z = NAN; }, "points[1]: not finite");
  refused([](FeatureCurve& c) { c.points[0].plateau = -1.0; }, "sizes");
  refused([](FeatureCurve& c) { c.points[0].left.slope_angle = 1.6; }, "degrees");
}

}  // namespace
}  // namespace orogen
