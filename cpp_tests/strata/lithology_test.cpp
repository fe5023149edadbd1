#include "strata/lithology.h"

#include <gtest/gtest.h>

#include <set>

namespace orogen {
namespace {

TEST(Lithology, EveryRockHasItsOwnNameAndColours) {
  std::set<std::string_view> names;
  std::set<std::uint32_t> map, natural;
  for (const LithologyInfo& info : known_lithologies()) {
    names.insert(info.name);
    map.insert(info.map);
    natural.insert(info.natural);
    EXPECT_GE(info.resistance, 0.0);
    EXPECT_LE(info.resistance, 1.0);
  }
  EXPECT_EQ(names.size(), known_lithologies().size());
  EXPECT_EQ(map.size(), names.size());
  EXPECT_EQ(natural.size(), names.size());
  EXPECT_EQ(lithology_info(Lithology::Granite).name, "granite");  // the table follows the enum
  EXPECT_EQ(lithology_info(Lithology::Sediment).name, "sediment");
  EXPECT_EQ(lithology_info(Lithology::Limestone).name, "limestone");
}

TEST(Lithology, ShadesGoToWhiteAndBlack) {
  EXPECT_EQ(shaded_color(0x408020, 0.0), 0x408020u);
  EXPECT_EQ(shaded_color(0x408020, 1.0), 0xffffffu);
  EXPECT_EQ(shaded_color(0x408020, -1.0), 0x000000u);
  EXPECT_EQ(shaded_color(0x408020, -0.5), 0x204010u);
}

}  // namespace
}  // namespace orogen
