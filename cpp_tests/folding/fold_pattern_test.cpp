#include "folding/fold_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/random.h"

namespace orogen {
namespace {

TEST(FoldPattern, HasMeanZeroAndVarianceOneWhereGroundFolds) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Grid grid{1 + int(seed) * 7 % 53, 1 + int(seed) * 11 % 47, 100.0, {}};
    Raster<float> speed(grid);
    for (std::size_t i = 0; i < speed.size(); ++i)
      if (random_uniform(seed, 1, i) < 0.7)
        speed[i] = float(1e-4 * (0.1 + random_uniform(seed, 2, i)));
    const auto pattern = fold_pattern(speed);
    double sum = 0.0, square = 0.0, count = 0.0;
    for (std::size_t i = 0; i < speed.size(); ++i) {
      ASSERT_LE(std::fabs(pattern[i]), 3.0f);
      if (speed[i] == 0.0f) continue;
      sum += pattern[i];
      square += double(pattern[i]) * pattern[i];
      count += 1.0;
    }
    if (count < 2.0) continue;
    ASSERT_NEAR(sum / count, 0.0, 1e-5);
    ASSERT_NEAR(square / count, 1.0, 1e-5);
  }
}

TEST(FoldPattern, KeepsTheOrderOfSpeedsAndCutsOffOutliers) {
  Raster<float> speed(Grid{100, 1, 1.0, {}}, 1e-4f);
  speed[3] = 1e-4f * 1.01f;
  speed[50] = 3e-3f;  // 30 times the others
  const auto pattern = fold_pattern(speed);
  EXPECT_EQ(pattern[50], 3.0f);
  EXPECT_GT(pattern[3], pattern[4]);
  EXPECT_LT(pattern[4], 0.0f);
}

TEST(FoldPattern, IsFlatWhereNothingFolds) {
  const Raster<float> none(Grid{5, 3, 1.0, {}});
  EXPECT_EQ(fold_pattern(none), none);
  EXPECT_TRUE(fold_pattern(Raster<float>()).empty());
  const auto even = fold_pattern(Raster<float>(Grid{5, 3, 1.0, {}}, 2e-4f));
  for (const float v : even.values()) EXPECT_TRUE(std::isfinite(v));
}

}  // namespace
}  // namespace orogen
