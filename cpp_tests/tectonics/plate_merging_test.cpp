#include "tectonics/plate_merging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "foundation/random.h"

namespace orogen {
namespace {

struct Case {
  std::vector<SubPlate> sub_plates;
  std::vector<std::pair<int, int>> neighbours;
};

Case random_case(std::uint64_t seed) {
  Case c;
  const int side = 2 + int(seed % 7);
  for (int i = 0; i < side * side; ++i) {
    SubPlate s;
    s.area = 1e6 * std::exp(4.0 * random_uniform(seed, 1, i));
    if (i % 11 != 10)
      s.velocity = {random_uniform(seed, 2, i) - 0.5, random_uniform(seed, 3, i) - 0.5};
    c.sub_plates.push_back(s);
    if (i % side) c.neighbours.push_back({i - 1, i});
    if (i >= side) c.neighbours.push_back({i - side, i});
  }
  if (seed % 3 == 0) c.sub_plates[0].opposite = 1, c.sub_plates[1].opposite = 0;
  return c;
}

TEST(PlateMerging, LeavesNoPairThatShouldHaveMerged) {
  for (int seed = 0; seed < 100; ++seed) {
    const Case c = random_case(seed);
    const MergeThresholds t{.direction = 0.1 * (seed % 10), .area = 0.05 * (seed % 5)};
    const auto plate = merge_plates(c.sub_plates, c.neighbours, t);
    ASSERT_EQ(plate.size(), c.sub_plates.size());
    const int count = 1 + *std::max_element(plate.begin(), plate.end());
    std::vector<double> area(count);
    std::vector<glm::dvec2> velocity(count, glm::dvec2(0.0));
    double fastest = 0.0;
    for (std::size_t i = 0; i < plate.size(); ++i) {
      area[plate[i]] += c.sub_plates[i].area;
      velocity[plate[i]] += c.sub_plates[i].area * c.sub_plates[i].velocity;
      fastest =
          std::max(fastest, std::hypot(c.sub_plates[i].velocity.x, c.sub_plates[i].velocity.y));
    }
    std::map<int, std::set<int>> around;
    for (auto [a, b] : c.neighbours)
      if (plate[a] != plate[b])
        around[plate[a]].insert(plate[b]), around[plate[b]].insert(plate[a]);
    const auto apart = [&](int a, int b) {
      return c.sub_plates[0].opposite == 1 &&
             ((plate[0] == a && plate[1] == b) || (plate[0] == b && plate[1] == a));
    };
    for (auto& [a, near] : around)
      for (int b : near) {
        if (apart(a, b)) continue;
        EXPECT_GE(area[a] / area[b], t.area * (1.0 - 1e-9));
        const glm::dvec2 u = velocity[a] / area[a], v = velocity[b] / area[b];
        const double lu = std::hypot(u.x, u.y), lv = std::hypot(v.x, v.y);
        if (lu > 1e-5 * fastest && lv > 1e-5 * fastest) {
          EXPECT_LE((u.x * v.x + u.y * v.y) / (lu * lv), t.direction + 1e-9);
        }
      }
    if (c.sub_plates[0].opposite == 1) {
      EXPECT_NE(plate[0], plate[1]);
    }
  }
}

TEST(PlateMerging, NumbersPlatesByFirstMemberAndKeepsThemConnected) {
  for (int seed = 0; seed < 50; ++seed) {
    const Case c = random_case(seed);
    const auto plate = merge_plates(c.sub_plates, c.neighbours, {});
    int next = 0;
    for (int p : plate) {
      ASSERT_LE(p, next);
      next = std::max(next, p + 1);
    }
    std::vector<int> group(plate.size());
    for (std::size_t i = 0; i < group.size(); ++i) group[i] = int(i);
    for (std::size_t k = 0; k < plate.size(); ++k)
      for (auto [a, b] : c.neighbours)
        if (plate[a] == plate[b]) group[a] = group[b] = std::min(group[a], group[b]);
    for (std::size_t i = 0; i < plate.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (plate[i] == plate[j]) {
          EXPECT_EQ(group[i], group[j]);
        }
  }
}

TEST(PlateMerging, RestingPlatesMergeByAreaAlone) {
  const std::vector<SubPlate> rest{{1.0, {0.0, 0.0}, -1}, {1.0, {0.0, 0.0}, -1}};
  EXPECT_EQ(merge_plates(rest, {{0, 1}}, {}), (std::vector<int>{0, 1}));
  const std::vector<SubPlate> small{{0.05, {0.0, 0.0}, -1}, {1.0, {1.0, 0.0}, -1}};
  EXPECT_EQ(merge_plates(small, {{0, 1}}, {}), (std::vector<int>{0, 0}));
  EXPECT_TRUE(merge_plates({}, {}, {}).empty());
}

}  // namespace
}  // namespace orogen
