#include "climate/whittaker.h"

#include <gtest/gtest.h>

#include <set>

namespace orogen {
namespace {

struct Station {
  const char* name;
  double temperature, precipitation;  // °C, m/yr
  Biome biome;
};

// Climate normals of weather stations, and what grows there.
constexpr Station kStations[] = {
    {"Utqiagvik", -11.2, 0.12, Biome::Tundra},
    {"Fairbanks", -2.4, 0.27, Biome::Taiga},
    {"Tromso", 2.9, 1.03, Biome::Taiga},
    {"Moscow", 5.8, 0.71, Biome::DeciduousForest},
    {"New York", 12.9, 1.27, Biome::DeciduousForest},
    {"Quillayute", 9.7, 2.53, Biome::TemperateRainForest},
    {"Milford Sound", 10.3, 6.7, Biome::TemperateRainForest},
    {"Denver", 10.1, 0.40, Biome::Grassland},
    {"Rome", 15.5, 0.80, Biome::Shrubland},
    {"Reno", 12.3, 0.19, Biome::TemperateDesert},
    {"Cairo", 22.0, 0.02, Biome::SubtropicalDesert},
    {"Yuma", 23.9, 0.08, Biome::SubtropicalDesert},
    {"Delhi", 25.2, 0.79, Biome::Grassland},
    {"Brasilia", 21.4, 1.48, Biome::TropicalSeasonalForest},
    {"Iquitos", 26.4, 2.86, Biome::TropicalRainForest},
};

TEST(Whittaker, KnowsRealPlaces) {
  for (const Station& station : kStations)
    EXPECT_EQ(whittaker_biome(station.temperature, station.precipitation), station.biome)
        << station.name << ": "
        << info(whittaker_biome(station.temperature, station.precipitation)).name;
}

TEST(Whittaker, BeltsMeetAtTheirLimits) {
  EXPECT_EQ(whittaker_biome(-5.001, 0.5), Biome::Tundra);
  EXPECT_EQ(whittaker_biome(-4.999, 0.5), Biome::Taiga);
  EXPECT_EQ(whittaker_biome(2.999, 1.0), Biome::Taiga);
  EXPECT_EQ(whittaker_biome(3.0, 1.0), Biome::DeciduousForest);
  EXPECT_EQ(whittaker_biome(19.999, 2.4), Biome::TemperateRainForest);
  EXPECT_EQ(whittaker_biome(20.0, 2.4), Biome::TropicalRainForest);
}

TEST(Whittaker, GivesDryLandEverywhere) {
  std::set<Biome> found;
  for (int t = -60; t <= 60; ++t)
    for (int p = 0; p <= 130; ++p) found.insert(whittaker_biome(t, 0.1 * p));
  const std::set<Biome> all{Biome::Tundra,
                            Biome::Bare,
                            Biome::Taiga,
                            Biome::Shrubland,
                            Biome::TemperateDesert,
                            Biome::TemperateRainForest,
                            Biome::DeciduousForest,
                            Biome::Grassland,
                            Biome::TropicalRainForest,
                            Biome::TropicalSeasonalForest,
                            Biome::SubtropicalDesert};
  EXPECT_EQ(found, all);
}

TEST(Whittaker, MoreRainNeverMakesADesert) {
  const auto is_desert = [](Biome biome) {
    return biome == Biome::TemperateDesert || biome == Biome::SubtropicalDesert ||
           biome == Biome::Bare;
  };
  for (double t = -30.0; t < 40.0; t += 0.25)
    for (double p = 0.0, left = false; p < 4.0; p += 0.02) {
      const bool desert = is_desert(whittaker_biome(t, p));
      EXPECT_FALSE(left && desert) << t << " " << p;
      left = left || !desert;
    }
}

}  // namespace
}  // namespace orogen
