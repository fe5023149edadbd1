#include "inputs/ring_arrangement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "inputs/test_maps.h"

namespace orogen {
namespace {

using test::Dice;

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
bool on_segment(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  return turn(a, b, p) == 0.0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}
/// Closed segments with a common point; exact for small whole numbers.
bool meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  if (turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0) return true;
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
}

/// Every pair of edges.
bool touches_slowly(const std::vector<const Ring*>& rings) {
  struct Edge {
    std::size_t ring, index;
    glm::dvec2 a, b;
  };
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r]->size(); ++i)
      edges.push_back({r, i, (*rings[r])[i], (*rings[r])[(i + 1) % rings[r]->size()]});
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge &s = edges[i], &t = edges[j];
      const std::size_t n = rings[s.ring]->size();
      if (s.ring == t.ring && (s.index + 1) % n == t.index) {
        if (on_segment(s.a, s.b, t.b) || on_segment(t.a, t.b, s.a)) return true;
      } else if (s.ring == t.ring && (t.index + 1) % n == s.index) {
        if (on_segment(s.a, s.b, t.a) || on_segment(t.a, t.b, s.b)) return true;
      } else if (meet(s.a, s.b, t.a, t.b)) {
        return true;
      }
    }
  return false;
}

Ring star(Dice& dice, int n, glm::dvec2 centre, double low, double high) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.1) / n;
    ring.push_back(on_lattice(centre + dice.uniform(low, high) *
                                           glm::dvec2(std::cos(angle), std::sin(angle))));
  }
  return ring;
}

TEST(ArrangeRings, AgreesWithEveryPairOnSmallLattices) {
  int touching = 0, apart = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Dice dice(seed);
    const int span = 4 + dice.below(12);
    std::vector<Ring> rings(1 + dice.below(2));
    for (Ring& ring : rings) {
      const int n = 3 + dice.below(4);
      while (int(ring.size()) < n) {
        const glm::dvec2 p(dice.below(span), dice.below(span));
        if (ring.empty() || (ring.back() != p && (int(ring.size()) + 1 < n || ring.front() != p)))
          ring.push_back(p);
      }
    }
    std::vector<const Ring*> pointers;
    bool flat = false;
    for (const Ring& ring : rings) {
      pointers.push_back(&ring);
      flat = flat || signed_area(ring) == 0.0;
    }
    if (flat) continue;
    const bool expected = touches_slowly(pointers);
    ASSERT_EQ(arrange_rings(pointers).contact.has_value(), expected) << seed;
    (expected ? touching : apart)++;
  }
  EXPECT_GT(touching, 300);
  EXPECT_GT(apart, 300);
}

TEST(ArrangeRings, FindsWhichRingLiesInWhich) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Dice dice(seed);
    // Nested stars: sizes shrink so that each lies inside the one before, or beside it.
    std::vector<Ring> rings;
    std::vector<int> parent;
    const auto add = [&](glm::dvec2 centre, double radius, int around) {
      rings.push_back(star(dice, 3 + dice.below(30), centre, 0.9 * radius, radius));
      if (dice.below(2)) std::reverse(rings.back().begin(), rings.back().end());
      parent.push_back(around);
      return int(rings.size()) - 1;
    };
    for (int k = 0; k < 3; ++k) {
      const glm::dvec2 centre(3000.0 * k, dice.uniform(-100.0, 100.0));
      const int outer = add(centre, 1000.0, -1);
      const int left = add(centre - glm::dvec2(200.0, 0.0), 120.0, outer);
      add(centre + glm::dvec2(200.0, 30.0), 120.0, outer);
      add(centre - glm::dvec2(200.0, 0.0), 40.0, left);
    }
    std::vector<const Ring*> pointers;
    for (const Ring& ring : rings) pointers.push_back(&ring);
    const RingArrangement found = arrange_rings(pointers);
    ASSERT_FALSE(found.contact) << seed;
    EXPECT_EQ(found.parent, parent) << seed;
  }
}

TEST(ArrangeRings, NamesTheEdgesAndThePlace) {
  const Ring bow{{0, 0}, {10, 10}, {10, 0}, {0, 10.5}};
  const Ring* rings[] = {&bow};
  const auto contact = arrange_rings(rings).contact;
  ASSERT_TRUE(contact);
  EXPECT_EQ(std::min(contact->edge_a, contact->edge_b), 0u);
  EXPECT_EQ(std::max(contact->edge_a, contact->edge_b), 2u);
  EXPECT_NEAR(contact->place.x, 10.5 / 2.05, 0.01);
}

TEST(ArrangeRings, IsNotSlowOnAComb) {
  // Teeth whose boxes all overlap: every pair of edges would be 5·10⁹ comparisons.
  Ring comb;
  const int n = 50000;
  for (int i = 0; i < n; ++i) comb.push_back({i * 2.0 + (i % 2 ? 1e5 : 0.0), i % 2 ? 1e5 : 0.0});
  comb.push_back({3e5, 2e5});
  comb.push_back({-1e3, 2e5});
  comb.push_back({-1e3, -1.0});
  const Ring* rings[] = {&comb};
  (void)arrange_rings(rings);
}

}  // namespace
}  // namespace orogen
