#include "pipeline/terrain.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace orogen {
namespace {

const Grid kGrid{4, 3, 10.0, {0.0, 0.0}};

TEST(Terrain, KeepsFieldsByName) {
  Terrain terrain(kGrid);
  terrain.set("elevation", Raster<float>(kGrid, 5.0f));
  terrain.set("land", Raster<std::int32_t>(kGrid, 1));
  EXPECT_EQ(terrain.real("elevation")[7], 5.0f);
  EXPECT_EQ(terrain.integer("land")[7], 1);
  EXPECT_TRUE(terrain.has("land"));
  terrain.erase("land");
  EXPECT_FALSE(terrain.has("land"));
}

TEST(Terrain, RefusesWhatIsNotDeclared) {
  Terrain terrain(kGrid);
  EXPECT_THROW(terrain.set("altitude", Raster<float>(kGrid)), std::out_of_range);
  EXPECT_THROW(terrain.set("elevation", Raster<std::int32_t>(kGrid)), std::invalid_argument);
  EXPECT_THROW(terrain.set("elevation", Raster<float>(Grid{3, 4, 10.0})), std::invalid_argument);
  EXPECT_THROW(terrain.real("elevation"), std::out_of_range);
  terrain.set("elevation", Raster<float>(kGrid));
  EXPECT_THROW(terrain.integer("elevation"), std::invalid_argument);
}

TEST(Terrain, SharesFieldsBetweenCopies) {
  Terrain terrain(kGrid);
  terrain.set("elevation", Raster<float>(kGrid, 1.0f));
  Terrain copy = terrain;
  EXPECT_EQ(copy.real("elevation").data(), terrain.real("elevation").data());
  copy.set("elevation", Raster<float>(kGrid, 2.0f));
  EXPECT_EQ(terrain.real("elevation")[0], 1.0f);
  EXPECT_EQ(copy.real("elevation")[0], 2.0f);
}

}  // namespace
}  // namespace orogen
