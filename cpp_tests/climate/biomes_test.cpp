#include "climate/biomes.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace orogen {
namespace {

TEST(Biomes, HoldThePapersTable) {
  EXPECT_EQ(info(Biome::Snow).amplitude, 0.5);
  EXPECT_EQ(info(Biome::Snow).roughness, 0.7);
  EXPECT_EQ(info(Biome::Scorched).amplitude, 0.7);
  EXPECT_EQ(info(Biome::TemperateDesert).roughness, 0.1);
  EXPECT_EQ(info(Biome::SubtropicalDesert).roughness, 0.6);
  EXPECT_EQ(info(Biome::Ocean).name, "ocean");
  double amplitudes = 0.0, roughnesses = 0.0;
  std::set<std::string_view> names;
  for (const BiomeInfo& biome : biomes()) {
    amplitudes += biome.amplitude;
    roughnesses += biome.roughness;
    names.insert(biome.name);
  }
  EXPECT_NEAR(amplitudes, 5.7, 1e-12);
  EXPECT_NEAR(roughnesses, 5.4, 1e-12);
  EXPECT_EQ(names.size(), std::size_t(kBiomes));
}

TEST(Biomes, AreParted) {
  EXPECT_EQ(biome_of(0.1, 0.9), Biome::Snow);
  EXPECT_EQ(biome_of(0.0, 0.0), Biome::Scorched);
  EXPECT_EQ(biome_of(0.3, 0.7), Biome::Taiga);
  EXPECT_EQ(biome_of(0.3, 0.1), Biome::TemperateDesert);
  EXPECT_EQ(biome_of(0.5, 0.9), Biome::TemperateRainForest);
  EXPECT_EQ(biome_of(0.5, 0.6), Biome::DeciduousForest);
  EXPECT_EQ(biome_of(1.0, 1.0), Biome::TropicalRainForest);
  EXPECT_EQ(biome_of(1.0, 0.2), Biome::Grassland);
  EXPECT_EQ(biome_of(1.0, 0.0), Biome::SubtropicalDesert);
  std::set<Biome> found;
  for (int t = 0; t <= 100; ++t)
    for (int m = 0; m <= 100; ++m) found.insert(biome_of(t / 100.0, m / 100.0));
  EXPECT_EQ(found.size(), 13u);  // all but beach, lake, ocean
}

}  // namespace
}  // namespace orogen
