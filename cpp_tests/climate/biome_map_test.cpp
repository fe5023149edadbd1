#include "climate/biome_map.h"

#include <gtest/gtest.h>

#include "climate/holdridge.h"
#include "climate/whittaker.h"
#include "foundation/errors.h"
#include "foundation/noise.h"

namespace orogen {
namespace {

const Grid kGrid{12, 10, 100.0};

/// Sea in the columns below 4, a beach, then a plain of 50 m; temperate and moist.
struct Case {
  Raster<float> elevation{kGrid, 50.0f}, temperature{kGrid, 0.5f}, moisture{kGrid, 0.6f};
  Raster<std::int32_t> land{kGrid, 1};
  Raster<float> water{kGrid};
  Raster<std::int32_t> painted{kGrid, -1};

  Case() {
    for (int r = 0; r < kGrid.ny; ++r)
      for (int c = 0; c < 5; ++c) {
        elevation(r, c) = c < 4 ? -20.0f : 3.0f;
        land(r, c) = c == 4;
      }
  }
  BiomeInputs inputs() const {
    return {.elevation = elevation,
            .land = &land,
            .water_depth = &water,
            .temperature = &temperature,
            .moisture = &moisture,
            .painted = &painted};
  }
  Biome at(int r, int c, const BiomeParameters& parameters = {.beach_slope_deg = 60.0}) const {
    return Biome(map_biomes(inputs(), parameters, Context())(r, c));
  }
};

TEST(BiomeMap, GoesFromTheSeaOverTheBeachInland) {
  Case plain;
  plain.land = Raster<std::int32_t>(kGrid, 1);
  EXPECT_EQ(plain.at(5, 2), Biome::DeciduousForest) << "no sea without a seed";
  const Case coast = [] {
    Case made;
    for (int r = 0; r < kGrid.ny; ++r) made.elevation(r, 5) = 3.0f;
    return made;
  }();
  EXPECT_EQ(coast.at(5, 3), Biome::Ocean);
  EXPECT_EQ(coast.at(5, 4), Biome::Beach);
  EXPECT_EQ(coast.at(5, 6), Biome::DeciduousForest);
  EXPECT_EQ(coast.at(5, 5), Biome::Beach) << "200 m from the sea's middle: 150 m from its shore";
  EXPECT_EQ(coast.at(5, 5, {.beach_width = 100.0, .beach_slope_deg = 60.0}),
            Biome::DeciduousForest);
  EXPECT_EQ(coast.at(5, 4, {.beach_height = 2.0, .beach_slope_deg = 60.0}), Biome::DeciduousForest);
  EXPECT_EQ(coast.at(5, 4, {.beach_slope_deg = 5.0}), Biome::DeciduousForest);
}

TEST(BiomeMap, GroundThatRoseIsLandAndWhatSankIsSea) {
  Case changed;
  changed.elevation(2, 1) = 30.0f;  // land still says sea
  for (int c = 4; c < 8; ++c) changed.elevation(7, c) = -1.0f;
  changed.elevation(3, 9) = -10.0f;  // a dry hollow inland
  EXPECT_EQ(changed.at(2, 1), Biome::DeciduousForest);
  EXPECT_EQ(changed.at(7, 7), Biome::Ocean);
  EXPECT_EQ(changed.at(3, 9), Biome::DeciduousForest);
}

TEST(BiomeMap, LakesStandBeforePaintAndPaintBeforeClimate) {
  Case drawn;
  drawn.water(5, 8) = 2.0f;
  for (const int c : {2, 4, 8, 9}) drawn.painted(5, c) = int(Biome::Scorched);
  EXPECT_EQ(drawn.at(5, 2), Biome::Ocean);
  EXPECT_EQ(drawn.at(5, 4), Biome::Scorched);
  EXPECT_EQ(drawn.at(5, 8), Biome::Lake);
  EXPECT_EQ(drawn.at(5, 9), Biome::Scorched);
}

TEST(BiomeMap, GoesByTheClassification) {
  Case drawn;
  const Raster<float> degrees(kGrid, 24.0f), rain(kGrid, 2.0f);
  Raster<float> snow(kGrid);
  snow(5, 10) = 1.0f;
  BiomeInputs inputs = drawn.inputs();
  inputs.air_temperature = &degrees;
  inputs.biotemperature = &degrees;
  inputs.rainfall = &rain;
  inputs.snow_cover = &snow;
  const auto by = [&](Classification classification) {
    return map_biomes(inputs, {.classification = classification}, Context());
  };
  EXPECT_EQ(by(Classification::Paper)(5, 8), int(Biome::DeciduousForest));
  EXPECT_EQ(by(Classification::Paper)(5, 10), int(Biome::Snow));
  EXPECT_EQ(by(Classification::Whittaker)(5, 8), int(whittaker_biome(24.0, 2.0)));
  EXPECT_EQ(by(Classification::Holdridge)(5, 8), int(holdridge_biome(24.0, 2.0)));
  EXPECT_EQ(by(Classification::Whittaker)(5, 10), int(Biome::Snow));
  EXPECT_EQ(by(Classification::Holdridge)(5, 10), int(Biome::Snow));
}

TEST(BiomeMap, SaysWhatAClassificationLacks) {
  const Case drawn;
  try {
    map_biomes(drawn.inputs(), {.classification = Classification::Holdridge}, Context());
    ADD_FAILURE();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("holdridge"), std::string::npos) << text;
    EXPECT_NE(text.find("biotemperature"), std::string::npos) << text;
  }
}

TEST(BiomeMap, IsDryLandExactlyWhereTheLandIsDry) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Grid grid{1 + int(seed % 23), 1 + int(seed % 19), 250.0};
    Raster<float> ground = fbm({.seed = seed, .wavelength = 2000.0}, grid, Context());
    const Raster<float> warm(grid, 0.01f * seed), moist(grid, 0.5f);
    Raster<std::int32_t> land(grid);
    Raster<float> water(grid);
    for (std::size_t i = 0; i < ground.size(); ++i) {
      ground[i] *= 200.0f;
      land[i] = ground[i] > 0.0f;
      water[i] = land[i] && i % 7 == 0 ? 1.0f : 0.0f;
    }
    const auto made = map_biomes({.elevation = ground,
                                  .land = &land,
                                  .water_depth = &water,
                                  .temperature = &warm,
                                  .moisture = &moist},
                                 {}, Context());
    for (std::size_t i = 0; i < ground.size(); ++i) {
      ASSERT_EQ(made[i] == int(Biome::Ocean), land[i] == 0);
      ASSERT_EQ(made[i] == int(Biome::Lake), water[i] > 0.0f);
    }
  }
}

}  // namespace
}  // namespace orogen
