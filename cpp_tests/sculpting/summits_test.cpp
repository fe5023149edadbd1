#include "sculpting/summits.h"

#include <gtest/gtest.h>

#include "hydrology/drainage.h"
#include "support_island.h"

namespace orogen {
namespace {

struct Asked {
  VectorMap map;
  RiverBeds beds;
  std::vector<Summit> summits;
  Raster<float> least, cap;
};

Asked ask(VectorMap map, int n) {
  Context context;
  Asked a;
  a.map = std::move(map);
  const Grid grid = test::island_grid(a.map, n);
  const Raster<std::uint8_t> land(grid, 1);
  a.beds = lay_river_beds(a.map, land, 0.0, 1e3, 1);
  a.summits = collect_summits(a.map, land);
  a.least = summit_pyramids(a.summits, a.beds, context);
  a.cap = summit_cap(a.summits, grid, 5000.0, context);
  return a;
}

TEST(Summits, LeastAndGreatestHeightsMeetAtThePeaksAndCrossOnlyBetweenPeaks) {
  for (int seed = 0; seed < 100; ++seed) {
    VectorMap map = test::island(seed);
    map.rivers.clear();
    const Asked a = ask(std::move(map), 100);
    ASSERT_FALSE(a.summits.empty());
    for (std::size_t k = 1; k < a.summits.size(); ++k)
      EXPECT_GE(a.summits[k - 1].height, a.summits[k].height);
    for (const Summit& s : a.summits) {
      EXPECT_GE(a.least[s.cell], s.height - 1e-3);
      EXPECT_NEAR(a.cap[s.cell], s.height, 1e-3);
    }
    VectorMap alone = a.map;
    alone.peaks.resize(1);
    const Asked b = ask(std::move(alone), 100);
    for (std::size_t i = 0; i < b.cap.size(); ++i) EXPECT_LE(b.least[i], b.cap[i] + 1e-3f);
  }
}

TEST(Summits, PyramidsAreNoSteeperThanTheirFlanks) {
  VectorMap map = test::island(3);
  map.rivers.clear();
  map.peaks.resize(1);
  const Asked a = ask(std::move(map), 320);
  const Grid& grid = a.least.grid();
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 1; c < grid.nx; ++c) {
      const double rise = std::abs(a.least(r, c) - a.least(r, c - 1)) / grid.cell_size;
      EXPECT_LT(rise, 2.0);  // where it ends, far from the peak, H r⁴/R⁴ falls by 4 H / R
    }
}

TEST(Summits, ARiverPastAPeakHasAGorgeAndComesFromGroundThatIsNoLower) {
  VectorMap map = test::island(1);
  map.peaks.resize(1);
  const glm::dvec2 peak = map.peaks[0].position;
  map.peaks[0].height_m = 1500.0;
  River river;
  for (int k = 0; k < 9; ++k) river.points.push_back(peak + glm::dvec2(1500.0 * (k - 2), 250.0));
  map.rivers = {river};
  const Asked a = ask(std::move(map), 320);
  float highest = 0.0f;
  for (std::size_t i = 0; i < a.beds.cells.size(); ++i) {  // from the mouth up
    const float here = a.least[a.beds.cells[i]];
    EXPECT_GE(here, highest - 1e-3f);
    highest = std::max(highest, here);
  }
  EXPECT_LT(highest, 1500.0 - 0.8 * 250.0);
  EXPECT_GT(highest, 900.0);
}

TEST(Summits, OfTwoPeaksInOneCellTheHigherCounts) {
  VectorMap map = test::island(1);
  map.peaks.resize(2);
  map.peaks[1].position = map.peaks[0].position;
  map.peaks[0].height_m = 800.0;
  map.peaks[1].height_m = 900.0;
  const Asked a = ask(std::move(map), 64);
  ASSERT_EQ(a.summits.size(), 1u);
  EXPECT_EQ(a.summits[0].height, 900.0);
}

}  // namespace
}  // namespace orogen
