#include "inputs/segment_tree.h"

#include <algorithm>
#include <cmath>

#include "inputs/test_maps.h"

namespace orogen {
namespace {

using test::Dice;

std::vector<Segment> random_segments(Dice& dice, int n) {
  std::vector<Segment> segments;
  for (int i = 0; i < n; ++i) {
    const glm::dvec2 a(dice.uniform(-1e3, 1e3), dice.uniform(-1e3, 1e3));
    const double reach = dice.below(5) ? 30.0 : 900.0;
    const bool point = dice.below(10) == 0;
    const glm::dvec2 d(dice.uniform(-reach, reach), dice.uniform(-reach, reach));
    segments.push_back({a, point ? a : a + d, i % 7, i});
  }
  return segments;
}

double slow_distance(const Segment& s, glm::dvec2 p) {
  const glm::dvec2 u = s.b - s.a;
  const double length2 = glm::dot(u, u);
  const double t = length2 > 0.0 ? glm::dot(p - s.a, u) / length2 : 0.0;
  return glm::length(s.a + std::clamp(t, 0.0, 1.0) * u - p);
}

TEST(SegmentTree, FindsTheNearestAndWhatMeetsABox) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Dice dice(seed);
    const int sizes[] = {1, 2, 7, 8, 9, 64, 65, 301};
    const SegmentTree tree(random_segments(dice, sizes[dice.below(8)]));
    for (int k = 0; k < 20; ++k) {
      const glm::dvec2 p(dice.uniform(-2e3, 2e3), dice.uniform(-2e3, 2e3));
      double best = 1e300, best_third = 1e300;
      for (const Segment& s : tree.segments()) {
        best = std::fmin(best, slow_distance(s, p));
        if (s.line == 3) best_third = std::fmin(best_third, slow_distance(s, p));
      }
      const auto hit = tree.nearest(p);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->distance, best, 1e-9);
      EXPECT_NEAR(glm::length(hit->point - p), best, 1e-9);
      const auto third = tree.nearest(p, 1e9, [](const Segment& s) { return s.line == 3; });
      EXPECT_EQ(third.has_value(), best_third < 1e300);
      EXPECT_NEAR(third ? third->distance : 1e300, best_third, 1e-9);
      EXPECT_FALSE(tree.nearest(p, 0.99 * best, [](const Segment&) { return true; }));

      const Box box{p, p + glm::dvec2(dice.uniform(0.0, 500.0), dice.uniform(0.0, 500.0))};
      std::vector<std::size_t> met, expected;
      tree.visit(box, [&](std::size_t i) { met.push_back(i); });
      for (std::size_t i = 0; i < tree.segments().size(); ++i) {
        Box b;
        b.add(tree.segments()[i].a);
        b.add(tree.segments()[i].b);
        if (b.meets(box)) expected.push_back(i);
      }
      EXPECT_EQ(met, expected);
    }
  }
}

TEST(SegmentTree, MayBeEmpty) {
  const SegmentTree tree(std::vector<Segment>{});
  EXPECT_FALSE(tree.nearest({0, 0}));
  EXPECT_FALSE(inside_even_odd(tree, {0, 0}));
}

}  // namespace
}  // namespace orogen
