#include "inputs/river_network.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "inputs/check_map.h"
#include "inputs/map_rasters.h"
#include "inputs/test_maps.h"

namespace orogen {
namespace {

using namespace test;

Ring square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

/// A forest of rivers on an island of 100 km, true to its graph: mouths on the coast, tributaries
/// that end on a vertex of what they join; no two cross.
struct Forest {
  VectorMap map;
  std::vector<int> joins;
};

bool crosses(const Polyline& a, const Polyline& b) {
  const auto turn = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  for (std::size_t i = 0; i + 1 < a.size(); ++i)
    for (std::size_t j = 0; j + 1 < b.size(); ++j)
      if (turn(a[i], a[i + 1], b[j]) * turn(a[i], a[i + 1], b[j + 1]) < 0 &&
          turn(b[j], b[j + 1], a[i]) * turn(b[j], b[j + 1], a[i + 1]) < 0)
        return true;
  return false;
}

double gap(const Polyline& a, const Polyline& b, glm::dvec2 except) {
  double least = 1e300;
  for (const glm::dvec2 p : a)
    for (const glm::dvec2 q : b)
      if (p != except && q != except) least = std::fmin(least, glm::length(p - q));
  return least;
}

Forest random_forest(Dice& dice) {
  Forest forest;
  forest.map.coasts.push_back({square(0.0, 100e3), {}, false, "", -1});
  std::vector<River>& rivers = forest.map.rivers;
  const int wanted = 3 + dice.below(12);
  for (int attempt = 0; attempt < 4000 && int(rivers.size()) < wanted; ++attempt) {
    glm::dvec2 at;
    glm::dvec2 heading;
    int joins = -1;
    if (rivers.empty() || dice.below(3) == 0) {
      at = {dice.uniform(10e3, 90e3), 0.0};
      heading = {dice.uniform(-0.5, 0.5), 1.0};
    } else {
      joins = dice.below(int(rivers.size()));
      const Polyline& main = rivers[joins].points;
      if (main.size() < 6) continue;
      at = main[2 + dice.below(int(main.size()) - 5)];
      heading = {dice.below(2) ? 1.0 : -1.0, dice.uniform(-0.2, 0.6)};
    }
    Polyline upward{at};
    heading = glm::normalize(heading);
    for (int k = 8 + dice.below(12); k-- > 0;) {
      heading =
          glm::normalize(heading + glm::dvec2(dice.uniform(-0.3, 0.3), dice.uniform(-0.3, 0.3)));
      upward.push_back(upward.back() + heading * dice.uniform(2000.0, 3500.0));
    }
    bool good = std::all_of(upward.begin() + 1, upward.end(), [](glm::dvec2 p) {
      return p.x > 6e3 && p.y > 1e3 && p.x < 94e3 && p.y < 94e3;
    });
    for (std::size_t i = 0; i + 2 < upward.size() && good; ++i)
      for (std::size_t j = i + 2; j + 1 < upward.size() && good; ++j)
        good = !crosses({upward[i], upward[i + 1]}, {upward[j], upward[j + 1]});
    for (std::size_t r = 0; r < rivers.size() && good; ++r)
      good = !crosses(upward, rivers[r].points) &&
             gap(upward, rivers[r].points, at) > (int(r) == joins ? 1500.0 : 1500.0);
    if (!good) continue;
    std::reverse(upward.begin(), upward.end());
    rivers.push_back({upward,
                      joins < 0 ? RiverEnd::Sea : RiverEnd::River,
                      joins,
                      {},
                      0,
                      "r" + std::to_string(rivers.size()),
                      -1});
  }
  return forest;
}

/// What every network must hold.
void expect_forest(const VectorMap& map) {
  for (std::size_t i = 0; i < map.rivers.size(); ++i) {
    const River& river = map.rivers[i];
    ASSERT_GE(river.points.size(), 2u);
    for (std::size_t k = 0; k + 1 < river.points.size(); ++k)
      EXPECT_NE(river.points[k], river.points[k + 1]);
    if (river.end == RiverEnd::River) {
      ASSERT_GE(river.joins, 0);
      ASSERT_LT(river.joins, int(map.rivers.size()));
      const Polyline& main = map.rivers[river.joins].points;
      EXPECT_NE(std::find(main.begin(), main.end(), river.points.back()), main.end());
      int at = int(i), steps = 0;
      while (at >= 0 && map.rivers[at].end == RiverEnd::River && ++steps <= int(map.rivers.size()))
        at = map.rivers[at].joins;
      EXPECT_LE(steps, int(map.rivers.size())) << "a cycle";
    } else if (river.end == RiverEnd::Lake) {
      ASSERT_GE(river.joins, 0);
      ASSERT_LT(river.joins, int(map.lakes.size()));
    } else {
      EXPECT_EQ(river.joins, -1);
    }
  }
}

TEST(RiverNetwork, OrientsForestsWhicheverWayTheyAreDrawn) {
  int rivers = 0, tributaries = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Dice dice(seed);
    const VectorMap expected = check_map(random_forest(dice).map);
    VectorMap drawn = expected;
    for (River& river : drawn.rivers) {
      if (dice.below(2)) std::reverse(river.points.begin(), river.points.end());
      river.end = RiverEnd::Sea;
      river.joins = -1;
    }
    const VectorMap found = check_map(drawn, {.strict = true});
    expect_forest(found);
    ASSERT_EQ(found.rivers.size(), expected.rivers.size()) << seed;
    for (std::size_t i = 0; i < found.rivers.size(); ++i) {
      EXPECT_EQ(found.rivers[i].points, expected.rivers[i].points) << seed << " " << i;
      EXPECT_EQ(found.rivers[i].joins, expected.rivers[i].joins) << seed << " " << i;
      tributaries += found.rivers[i].end == RiverEnd::River;
    }
    rivers += int(found.rivers.size());
  }
  EXPECT_GT(rivers, 600);
  EXPECT_GT(tributaries, 300);
}

TEST(RiverNetwork, KeepsTheForestThatWasMeant) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Dice dice(seed);
    const Forest meant = random_forest(dice);
    const VectorMap found = check_map(meant.map);
    ASSERT_EQ(found.rivers.size(), meant.map.rivers.size());
    for (std::size_t i = 0; i < found.rivers.size(); ++i) {
      EXPECT_EQ(found.rivers[i].joins, meant.map.rivers[i].joins) << seed << " " << i;
      EXPECT_LT(glm::length(found.rivers[i].points[0] - meant.map.rivers[i].points[0]), 0.01);
    }
  }
}

TEST(RiverNetwork, SnapsRoughMouthsOfRandomForests) {
  int rivers = 0, other = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Dice dice(seed);
    VectorMap map = random_forest(dice).map;
    const auto joins = [](const VectorMap& m) {
      std::vector<int> list;
      for (const River& r : m.rivers) list.push_back(r.joins);
      return list;
    };
    const auto meant = joins(map);
    for (River& river : map.rivers) {  // up to 600 m short of, or past, what they flow into
      const glm::dvec2 before = river.points[river.points.size() - 2];
      const glm::dvec2 way = glm::normalize(river.points.back() - before);
      river.points.back() += way * dice.uniform(-600.0, 600.0);
      if (dice.below(2)) std::reverse(river.points.begin(), river.points.end());
      river.end = RiverEnd::Sea;
      river.joins = -1;
    }
    const VectorMap found = check_map(map);
    expect_forest(found);
    // Where a mouth comes to lie within the error of two rivers, either may be meant.
    const auto as_found = joins(found);
    ASSERT_EQ(as_found.size(), meant.size()) << seed;
    for (std::size_t i = 0; i < meant.size(); ++i) other += as_found[i] != meant[i], ++rivers;
    EXPECT_TRUE(check_map(found, {.strict = true}) == found) << seed;
  }
  EXPECT_LT(other, 0.005 * rivers);
}

TEST(RiverNetwork, MakesTreesOfAnyScribble) {
  const Context context;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Dice dice(seed);
    VectorMap map;
    map.coasts.push_back({square(0.0, 100e3), {}, false, "", -1});
    map.coasts[0].holes.push_back({{40e3, 40e3}, {40e3, 50e3}, {50e3, 50e3}, {50e3, 40e3}});
    const bool lake = seed % 2;
    if (lake) map.lakes.push_back({square(70e3, 80e3), {}, {}, "", -1});
    for (int r = 1 + dice.below(15); r-- > 0;) {
      River river;
      for (int k = 1 + dice.below(8); k-- > 0;)
        river.points.push_back({dice.uniform(-10e3, 110e3), dice.uniform(-10e3, 110e3)});
      map.rivers.push_back(river);
    }
    for (int k = dice.below(5); k-- > 0;)
      map.peaks.push_back({{dice.uniform(1e3, 39e3), dice.uniform(1e3, 99e3)}, {}, "", -1, {}});
    const VectorMap found = check_map(map);
    expect_forest(found);
    const LandRegion land(found);
    for (const River& river : found.rivers)
      for (std::size_t k = 0; k + 1 < river.points.size(); ++k) {
        const glm::dvec2 middle = 0.5 * (river.points[k] + river.points[k + 1]);
        const auto shore = land.coast().nearest(middle);
        EXPECT_TRUE(land.on_land(middle) || shore->distance < 3.0)
            << seed << " (" << middle.x << ", " << middle.y << ")";
      }
    for (const River& river : found.rivers) {
      if (river.end == RiverEnd::River) continue;
      const SegmentTree& goal = river.end == RiverEnd::Sea    ? land.coast()
                                : river.end == RiverEnd::Lake ? land.lakes()
                                                              : land.frame();
      EXPECT_LT(goal.nearest(river.points.back())->distance, 1.1) << seed;
    }
    // Rivers that cross inside a lake are trimmed to its shore only when read again.
    EXPECT_TRUE(lake || check_map(found) == found) << "not settled, seed " << seed;
  }
}

TEST(RiverNetwork, CutsTheSeaAndCarriesOnInland) {
  VectorMap map;
  map.coasts.push_back({square(0.0, 100e3), {}, false, "", -1});
  map.peaks.push_back({{50e3, 20e3}, 2000.0, "P", -1, {}});
  map.peaks.push_back({{52e3, 62e3}, 2000.0, "source", -1, {}});
  const auto add = [&](Polyline points) { map.rivers.push_back({points, {}, -1, {}, 0, "", -1}); };
  add({{20e3, 50e3}, {20e3, -5e3}});  // 0: out to sea
  add({{80e3, 50e3}, {80e3, 4e3}});   // 1: 4 km short of the coast
  add({{50e3, 60e3}, {50e3, 40e3}});  // 2: ends inland, a peak on the straight way
  const VectorMap found = check_map(map);
  ASSERT_EQ(found.rivers.size(), 3u);
  EXPECT_EQ(found.rivers[0].points.back(), glm::dvec2(20e3, 0.0));
  EXPECT_EQ(found.rivers[1].points.back(), glm::dvec2(80e3, 0.0));
  EXPECT_EQ(found.rivers[2].points.front(), glm::dvec2(50e3, 60e3));
  for (const glm::dvec2 p : found.rivers[2].points)
    EXPECT_GT(glm::length(p - glm::dvec2(50e3, 20e3)), 2000.0);
  EXPECT_EQ(found.warnings.size(), 3u);
}

TEST(RiverNetwork, JoinsCrossingsAndCutsLoopsAndOvershoots) {
  VectorMap map;
  map.coasts.push_back({square(0.0, 100e3), {}, false, "", -1});
  const auto add = [&](const char* name, Polyline points) {
    map.rivers.push_back({points, {}, -1, {}, 0, name, -1});
  };
  add("straight", {{30e3, 80e3}, {30e3, 0.0}});
  add("across", {{10e3, 60e3}, {60e3, 0.0}});
  add("overshoot", {{50e3, 70e3}, {29.5e3, 70e3}});
  add("looped",
      {{80e3, 90e3}, {80e3, 60e3}, {90e3, 60e3}, {90e3, 65e3}, {75e3, 65e3}, {75e3, 0.0}});
  const VectorMap found = check_map(map);
  expect_forest(found);
  std::map<std::string, std::vector<const River*>> by_name;
  for (const River& r : found.rivers) by_name[r.name].push_back(&r);
  ASSERT_EQ(by_name["straight"].size(), 1u);
  ASSERT_EQ(by_name["across"].size(), 2u);  // above the crossing and, afresh, below
  ASSERT_EQ(by_name["overshoot"].size(), 1u);
  ASSERT_EQ(by_name["looped"].size(), 1u);
  EXPECT_EQ(by_name["overshoot"][0]->points.back(), glm::dvec2(30e3, 70e3));
  EXPECT_EQ(by_name["overshoot"][0]->points.front(), glm::dvec2(50e3, 70e3));
  EXPECT_EQ(by_name["looped"][0]->points.size(), 4u);
  EXPECT_GE(found.warnings.size(), 3u);
}

TEST(RiverNetwork, LetsRiversLeaveByTheFrameAndByLakes) {
  const std::string text = collection(
      feature(R"("kind": "coast", "clipped": true)", "Polygon",
              "[[[0,0],[60,0],[70,30],[60,60],[0,60],[0,0]]]") +
          "," +
          feature(R"("kind": "lake")", "Polygon", "[[[20,20],[30,20],[30,30],[20,30],[20,20]]]") +
          "," +
          river("[[40, 50], [20, 50], [0.1, 45]]", R"(, "ends": "frame", "end_height_m": 420)") +
          "," + river("[[25, 25], [45, 40]]") +             // into the lake, drawn from it
          "," + river("[[29, 25], [50, 20], [63.2, 10]]"),  // out of it, to the sea
      R"("units": "km", "frame": {"size_km": [90, 60]},)");
  const VectorMap map = read_geojson(text);
  ASSERT_EQ(map.rivers.size(), 3u);
  EXPECT_EQ(map.rivers[0].end, RiverEnd::Frame);
  EXPECT_EQ(map.rivers[0].end_height_m, 420.0);
  EXPECT_EQ(map.rivers[0].points.back().x, 0.0);
  EXPECT_EQ(map.rivers[1].end, RiverEnd::Lake);
  EXPECT_EQ(map.rivers[1].joins, 0);
  EXPECT_EQ(map.rivers[1].points.front(), glm::dvec2(45e3, 40e3));
  EXPECT_EQ(map.rivers[2].end, RiverEnd::Sea);
  EXPECT_EQ(map.rivers[2].points.front().x, 30e3);
}

TEST(RiverNetwork, FollowsTheFileWhereTheMapIsSilent) {
  const auto from_sea_to_sea = [](const std::string& more) {
    return read_geojson(collection(island() + "," + river("[[50, 10], [50, 110]]", more)));
  };
  EXPECT_EQ(from_sea_to_sea("").rivers[0].points.back().y, 110e3);
  EXPECT_EQ(from_sea_to_sea(R"(, "direction": "source to mouth")").rivers[0].points.back().y,
            110e3);
  // 2 km off the coast at its source, 4 km at its mouth.
  const auto rough = [](const std::string& more) {
    return read_geojson(collection(island() + "," + river("[[50, 12], [50, 106]]", more)));
  };
  EXPECT_EQ(rough("").rivers[0].points.back().y, 10e3);
  EXPECT_EQ(rough(R"(, "direction": "source to mouth")").rivers[0].points.back().y, 110e3);
}

}  // namespace
}  // namespace orogen
