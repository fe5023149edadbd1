#include "folding/fold_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "folding/compression_fields.h"
#include "folding/fold_skeleton.h"

namespace orogen {
namespace {

using Place = std::pair<double, double>;
Place place_of(glm::dvec2 p) {
  return {p.x, p.y};
}

TEST(FoldLines, EverySegmentLiesInOneLineThatEndsWhereItMust) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(60e3), 40);
  for (int seed = 0; seed < 100; ++seed) {
    const auto skeleton =
        fold_skeleton(test::random_field(grid, seed), FoldWavelength(4e3), {}, seed, context);
    for (const auto* segments : {&skeleton.top, &skeleton.bottom}) {
      std::multiset<std::pair<Place, Place>> left;
      std::map<Place, int> degree;
      for (const Segment& s : *segments) {
        left.insert(std::minmax(place_of(s.a), place_of(s.b)));
        ++degree[place_of(s.a)];
        ++degree[place_of(s.b)];
      }
      std::set<std::uint64_t> ids;
      for (const FoldLine& line : fold_lines(*segments)) {
        ids.insert(line.id);
        const std::size_t n = line.points.size();
        ASSERT_GE(n, 2u);
        for (std::size_t i = 0; i + 1 < n + line.closed; ++i) {
          const auto found =
              left.find(std::minmax(place_of(line.points[i]), place_of(line.points[(i + 1) % n])));
          ASSERT_NE(found, left.end());
          left.erase(found);
        }
        for (std::size_t i = 1; i + 1 < n; ++i) ASSERT_EQ(degree[place_of(line.points[i])], 2);
        if (!line.closed) {
          ASSERT_LE(place_of(line.points.front()), place_of(line.points.back()));
          ASSERT_NE(degree[place_of(line.points.front())], 2);
          ASSERT_NE(degree[place_of(line.points.back())], 2);
        }
      }
      ASSERT_TRUE(left.empty());
      ASSERT_EQ(ids.size(), fold_lines(*segments).size());
    }
  }
}

TEST(FoldLines, IdsStayWhenAnotherFoldIsRemoved) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(60e3), 40);
  const auto skeleton =
      fold_skeleton(test::uniform_field(grid, 0.2), FoldWavelength(4e3), {}, 1, context);
  const auto before = fold_lines(skeleton.top);
  std::vector<Segment> fewer;
  for (const Segment& s : skeleton.top)
    if (s.a.x > 20e3 && s.b.x > 20e3) fewer.push_back(s);
  int kept = 0;
  for (const FoldLine& line : fold_lines(fewer))
    for (const FoldLine& old : before) kept += old.points == line.points && old.id == line.id;
  int whole = 0;
  for (const FoldLine& line : before)
    whole += std::all_of(line.points.begin(), line.points.end(),
                         [](glm::dvec2 p) { return p.x > 24e3; });
  EXPECT_GE(kept, whole);
  EXPECT_GT(whole, 20);
}

TEST(FoldLines, RingsAndNothing) {
  EXPECT_TRUE(fold_lines({}).empty());
  const Segment ring[] = {{{1, 1}, {2, 1}}, {{2, 2}, {2, 1}}, {{2, 2}, {1, 1}}};
  const auto lines = fold_lines(ring);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_EQ(lines[0].points.size(), 3u);
  EXPECT_EQ(lines[0].points[0], glm::dvec2(1, 1));
}

}  // namespace
}  // namespace orogen
