#include "strata/section_svg.h"

#include <gtest/gtest.h>

#include "foundation/errors.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(SectionSvg, DrawsEachBandOnceAndNamesTheLayers) {
  Context context;
  auto column = test::three_layers();
  column.layers[0].name = "old <&> grey";
  const RockTable rocks(column, {}, StrataPalette::Map);
  const Grid grid{50, 5, 100.0, {}};
  const HorizonStack stack = test::folded(column, grid, 2500.0, 450.0, context);
  const Raster<float> ground(grid, 700.0f);
  const Section s =
      cut_section({stack, rocks, ground}, {{50, 250}, {4950, 250}}, 50.0, -500.0, context);
  const std::string svg = section_svg(s, column, 2.0);
  EXPECT_EQ(svg.find("<svg "), 0u);
  EXPECT_EQ(count(svg, "<polygon "), s.bands.size());
  EXPECT_EQ(count(svg, "old &lt;&amp;&gt; grey"), 1u);
  EXPECT_EQ(count(svg, "<svg "), count(svg, "</svg>"));
  EXPECT_EQ(count(svg, "<text "), count(svg, "</text>"));
  EXPECT_EQ(svg.find("nan"), svg.npos);
  EXPECT_EQ(count(svg, ">vertical exaggeration 2<"), 1u);
  EXPECT_EQ(count(section_svg(s, column, 2.5), ">vertical exaggeration 2.5<"), 1u);
  EXPECT_EQ(count(section_svg(s, column, 1.0), ">no vertical exaggeration<"), 1u);
  EXPECT_THROW(section_svg(s, column, 0.0), InputError);
}

}  // namespace
}  // namespace orogen
