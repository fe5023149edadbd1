#include "strata/section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "foundation/errors.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

using Block = test::RoughBlock;

TEST(Section, BandsFillItFromTheBaseToTheGround) {
  Block b;
  const Section s =
      cut_section(b.body, {{2500, 1200}, {6000, 2500}, {7500, 4500}}, 70.0, -900.0, b.context);
  ASSERT_EQ(s.points.size(), s.distance.size());
  EXPECT_NEAR(s.distance.back(), std::hypot(3500, 1300) + std::hypot(1500, 2000), 1e-6);
  EXPECT_NE(std::find(s.points.begin(), s.points.end(), glm::dvec2(6000, 2500)), s.points.end());
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    float level = -900.0f;
    for (const SectionBand& band : s.bands) {
      ASSERT_EQ(band.bottom[i], level);
      ASSERT_GE(band.top[i], band.bottom[i]);
      level = band.top[i];
    }
    ASSERT_EQ(level, s.surface[i]);
    ASSERT_EQ(s.surface[i], b.body.ground_at(s.points[i]));
  }
}

TEST(Section, EveryPlaceInABandHasItsRock) {
  Block b;
  const Section s = cut_section(b.body, {{2100, 1100}, {7900, 4900}}, 50.0, -1500.0, b.context);
  std::vector<float> h(4);
  int checked = 0;
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    b.horizons.at(s.points[i], h.data());
    for (const SectionBand& band : s.bands)
      for (const float share : {0.02f, 0.5f, 0.98f}) {
        if (band.top[i] - band.bottom[i] < 1.0f) continue;
        const Rock rock =
            b.rocks.rock_at(h.data(), band.bottom[i] + share * (band.top[i] - band.bottom[i]));
        ASSERT_EQ(rock.layer, band.layer);
        ASSERT_EQ(rock.sub_layer, band.sub_layer);
        ASSERT_EQ(b.rocks.color(rock), band.color);
        ++checked;
      }
  }
  EXPECT_GT(checked, 1000);
}

TEST(Section, PictureAgreesWithBands) {
  Block b;
  const Section s = cut_section(b.body, {{2100, 3000}, {7900, 3000}}, 10.0, -1000.0, b.context);
  const SectionPicture picture = draw_section(b.body, s, 290, 100, 1500.0);
  ASSERT_EQ(picture.pixels.size(), 29000u);
  int rock = 0;
  for (int c = 0; c < 290; ++c)
    for (int r = 0; r < 100; ++r) {
      const double z = 1500.0 - (r + 0.5) * 25.0;
      const std::size_t i = 2 * c + 1;  // the pixel's middle is a point of the section
      const std::uint32_t pixel = picture.pixels[r * 290 + c];
      std::uint32_t expected = 0;
      float nearest = 1e9f;
      for (const SectionBand& band : s.bands) {
        if (z > band.bottom[i] && z <= band.top[i]) expected = 0xff000000u | band.color;
        nearest = std::min(
            {nearest, std::fabs(float(z) - band.bottom[i]), std::fabs(float(z) - band.top[i])});
      }
      if (nearest > 0.05f) {
        ASSERT_EQ(pixel, expected) << r << ' ' << c;
      }
      rock += pixel != 0;
    }
  EXPECT_GT(rock, 10000);
}

TEST(Section, RefusesWhatIsNoLine) {
  Block b;
  EXPECT_THROW(cut_section(b.body, {{2100, 3000}}, 10.0, -1000.0, b.context), InputError);
  EXPECT_THROW(cut_section(b.body, {{2100, 3000}, {2200, 3000}}, 0.0, -1000.0, b.context),
               InputError);
  EXPECT_THROW(cut_section(b.body, {{2100, 3000}, {7900, 3000}}, 1e-3, -1000.0, b.context),
               InputError);
  const auto says = [&](const Polyline& line, double base = -1000.0) -> std::string {
    try {
      cut_section(b.body, line, 10.0, base, b.context);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(says({{2100, 3000}, {9000, 3000}}).find("line[1]: (9000, 3000) lies outside"), 0u);
  EXPECT_EQ(says({{2100, std::nan("")}, {2200, 3000}}).find("line[0]: "), 0u);
  EXPECT_EQ(says({{2100, 3000}, {2100, 3000}}).find("line: its points"), 0u);
  EXPECT_EQ(says({{2100, 3000}, {2200, 3000}}, std::nan("")).find("base: "), 0u);
  const Grid& grid = b.body.elevation.grid();  // from border to border is allowed
  EXPECT_EQ(says({grid.origin, grid.origin + glm::dvec2(grid.width(), grid.height())}), "");
  const Section s = cut_section(b.body, {{2100, 3000}, {2200, 3000}}, 10.0, -1000.0, b.context);
  EXPECT_THROW(draw_section(b.body, s, 0, 5, 100.0), InputError);
  EXPECT_THROW(draw_section(b.body, s, 5, 5, -1000.0), InputError);
}

}  // namespace
}  // namespace orogen
