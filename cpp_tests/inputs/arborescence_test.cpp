#include "inputs/arborescence.h"

#include <algorithm>

#include "inputs/test_maps.h"

namespace orogen {
namespace {

using test::Dice;

/// Least cost over every choice of one hanging a vertex.
double slowly(int n, const std::vector<std::vector<Hanging>>& ways, std::vector<int>& parent,
              std::vector<double>& cost, int v) {
  if (v == n) {
    double sum = 0.0;
    for (int k = 1; k < n; ++k) {
      int u = k, steps = 0;
      while (u != 0 && ++steps <= n) u = parent[u];
      if (u != 0) return 1e300;
      sum += cost[k];
    }
    return sum;
  }
  double best = 1e300;
  for (const Hanging& h : ways[v]) {
    parent[v] = h.parent;
    cost[v] = h.cost;
    best = std::min(best, slowly(n, ways, parent, cost, v + 1));
  }
  return best;
}

TEST(CheapestArborescence, IsAsCheapAsTheBestOfAllChoices) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Dice dice(seed);
    const int n = 2 + dice.below(6);
    std::vector<Hanging> hangings;
    std::vector<std::vector<Hanging>> ways(n);
    const auto add = [&](int parent, int child, double cost) {
      hangings.push_back({parent, child, cost});
      if (child != 0) ways[child].push_back(hangings.back());
    };
    for (int v = 1; v < n; ++v) add(0, v, dice.uniform(5.0, 20.0));
    for (int k = dice.below(16); k-- > 0;) add(dice.below(n), dice.below(n), dice.below(8));
    const auto chosen = cheapest_arborescence(n, 0, hangings);
    double sum = 0.0;
    ASSERT_EQ(chosen[0], -1);
    for (int v = 1; v < n; ++v) {
      ASSERT_GE(chosen[v], 0);
      ASSERT_EQ(hangings[chosen[v]].child, v);
      sum += hangings[chosen[v]].cost;
      int u = v, steps = 0;
      while (u != 0 && ++steps <= n) u = hangings[chosen[u]].parent;
      ASSERT_EQ(u, 0) << "no way to the root, seed " << seed;
    }
    std::vector<int> parent(n);
    std::vector<double> cost(n);
    EXPECT_NEAR(sum, slowly(n, ways, parent, cost, 1), 1e-9) << seed;
  }
}

}  // namespace
}  // namespace orogen
