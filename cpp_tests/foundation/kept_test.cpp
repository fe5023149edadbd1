#include "foundation/kept.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "foundation/noise.h"

namespace orogen {
namespace {

std::size_t no_bytes(int) {
  return 8;
}

TEST(Kept, MakesOnceWhatIsAskedForAgain) {
  Kept store;
  Context context;
  int made = 0;
  const auto ask = [&](double number) {
    return *kept(
        context, Kept::Key("test", number, 2), [&] { return ++made; }, no_bytes);
  };
  EXPECT_EQ(ask(1.0), 1);
  EXPECT_EQ(ask(1.0), 2) << "nowhere to keep it";
  context.keep_in(&store);
  EXPECT_EQ(ask(1.0), 3);
  EXPECT_EQ(ask(1.0), 3);
  EXPECT_EQ(ask(0.0), 4);
  EXPECT_EQ(ask(-0.0), 5) << "to the bit";
  store.clear();
  EXPECT_EQ(ask(1.0), 6);
}

TEST(Kept, DropsTheLeastRecentlyUsedAndNeverKeepsMuch) {
  Kept store;
  const auto value = std::make_shared<const int>(1);
  store.insert(Kept::Key("large"), value, Kept::kLargest + 1);
  EXPECT_EQ(store.find(Kept::Key("large")), nullptr);
  const int most = int(Kept::kCapacity / Kept::kLargest);
  for (int i = 0; i <= most; ++i) {
    store.insert(Kept::Key("one", i), value, Kept::kLargest);
    EXPECT_NE(store.find(Kept::Key("one", 0)), nullptr);
  }
  EXPECT_EQ(store.find(Kept::Key("one", 1)), nullptr);
  EXPECT_NE(store.find(Kept::Key("one", 2)), nullptr);
}

TEST(Kept, NoiseIsTheSameByte) {
  Kept store;
  Context plain, keeping;
  keeping.keep_in(&store);
  const Grid grid{70, 41, 55.0, {1e3, -2e3}};
  for (const std::uint32_t seed : {1u, 2u, 1u}) {
    const Raster<float> a = fbm({.seed = seed}, grid, plain),
                        b = fbm({.seed = seed}, grid, keeping);
    EXPECT_TRUE(std::ranges::equal(a.values(), b.values()));
  }
}

}  // namespace
}  // namespace orogen
