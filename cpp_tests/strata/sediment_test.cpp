// Loose sediment on folded rock, in sections and blocks.
#include <gtest/gtest.h>

#include "strata/block.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

/// Rough ground with sediment in its hollows.
struct Filled : test::RoughBlock {
  Raster<float> sediment{grid};
  RockBody filled{horizons, rocks, elevation, &sediment};

  Filled() {
    for (std::size_t i = 0; i < sediment.size(); ++i)
      sediment[i] = std::max(0.0f, 450.0f - elevation[i]);
  }
  float rock_top(glm::dvec2 place) const {
    return body.ground_at(place) - float(bilinear_at(grid, place)(sediment));
  }
};

TEST(Sediment, LiesInSectionsBetweenRockAndGround) {
  Filled f;
  const Polyline line{{2100, 1100}, {7900, 4900}};
  const Section with = cut_section(f.filled, line, 50.0, -1500.0, f.context);
  const Section without = cut_section(f.body, line, 50.0, -1500.0, f.context);
  ASSERT_EQ(with.surface, without.surface);
  int covered = 0;
  for (std::size_t i = 0; i < with.points.size(); ++i) {
    std::vector<float> h(4);
    f.horizons.at(with.points[i], h.data());
    const float top = std::min(f.rock_top(with.points[i]), h[3]);  // above the column it is loose
    float level = -1500.0f;
    for (const SectionBand& band : with.bands) {
      ASSERT_EQ(band.bottom[i], level);
      level = band.top[i];
      if (band.top[i] - band.bottom[i] < 0.2f) continue;
      ASSERT_EQ(band.layer == 4, band.top[i] > top + 0.1f);
      if (band.layer == 4) {
        ASSERT_NEAR(band.bottom[i], top, 0.2);
        ++covered;
      }
    }
    ASSERT_EQ(level, with.surface[i]);
  }
  EXPECT_GT(covered, 20);
  EXPECT_LT(covered, int(with.points.size()) - 20);
}

TEST(Sediment, CoversTheTopOfABlock) {
  Filled f;
  const RockMesh mesh = block_diagram(f.filled, -1500.0, f.context);
  int covered = 0;
  for (int r = 0, face = 0; r + 1 < f.grid.ny; ++r)
    for (int c = 0; c + 1 < f.grid.nx; ++c, ++face) {
      const float depth = f.sediment(r, c);
      if (depth > 0.0f && depth < 0.2f) continue;
      std::vector<float> h(4);
      f.horizons.at(f.grid.center(r, c), h.data());
      const int expected = depth > 0.0f ? 4 : f.rocks.rock_at(h.data(), f.elevation(r, c)).layer;
      ASSERT_EQ(mesh.layer[face], expected);
      covered += depth > 0.0f;
    }
  EXPECT_GT(covered, 200);
}

}  // namespace
}  // namespace orogen
