#include "pipeline/cache.h"

#include <gtest/gtest.h>

namespace orogen {
namespace {

const Grid kGrid{10, 10, 1.0, {0.0, 0.0}};  // 400 bytes a field

StageResult result_with(float value) {
  StageResult result;
  result.fields.emplace("elevation",
                        std::make_shared<const Raster<float>>(Raster<float>(kGrid, value)));
  return result;
}

float value_of(const StageResult& result) {
  return (*std::get<RealField>(result.fields.at("elevation")))[0];
}

TEST(Cache, FindsWhatWasKept) {
  Cache cache(1000);
  EXPECT_EQ(cache.find("a"), nullptr);
  cache.insert("a", result_with(1.0f));
  ASSERT_NE(cache.find("a"), nullptr);
  EXPECT_EQ(value_of(*cache.find("a")), 1.0f);
  EXPECT_EQ(cache.bytes(), 400u);
  cache.clear();
  EXPECT_EQ(cache.find("a"), nullptr);
  EXPECT_EQ(cache.bytes(), 0u);
}

TEST(Cache, DropsTheLeastRecentlyUsedAtItsBound) {
  Cache cache(1000);
  cache.insert("a", result_with(1.0f));
  cache.insert("b", result_with(2.0f));
  cache.find("a");
  cache.insert("c", result_with(3.0f));
  EXPECT_NE(cache.find("a"), nullptr);
  EXPECT_EQ(cache.find("b"), nullptr);
  EXPECT_NE(cache.find("c"), nullptr);
  EXPECT_LE(cache.bytes(), cache.capacity());
}

TEST(Cache, CountsProductsAndRefusesWhatNeverFits) {
  Cache cache(1000);
  cache.insert("a", result_with(1.0f), 500);
  EXPECT_EQ(cache.bytes(), 900u);
  cache.insert("b", result_with(2.0f), 601);
  EXPECT_EQ(cache.find("b"), nullptr);
  EXPECT_NE(cache.find("a"), nullptr);
}

TEST(Cache, AResultInUseOutlivesItsEntry) {
  Cache cache(400);
  cache.insert("a", result_with(1.0f));
  const auto held = cache.find("a");
  cache.insert("b", result_with(2.0f));
  EXPECT_EQ(cache.find("a"), nullptr);
  EXPECT_EQ(value_of(*held), 1.0f);
}

}  // namespace
}  // namespace orogen
