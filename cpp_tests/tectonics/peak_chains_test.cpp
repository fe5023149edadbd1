#include "tectonics/peak_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/random.h"

namespace orogen {
namespace {

std::vector<glm::dvec2> line_of(int n, double bend, double jitter, std::uint64_t seed) {
  std::vector<glm::dvec2> peaks;
  for (int i = 0; i < n; ++i) {
    const double turn = bend * i / n;
    peaks.push_back({8e3 * i * std::cos(turn) + jitter * (random_uniform(seed, 1, i) - 0.5),
                     8e3 * i * std::sin(turn) + jitter * (random_uniform(seed, 2, i) - 0.5)});
  }
  return peaks;
}

TEST(PeakChains, FindsStraightBentAndRaggedLines) {
  for (int seed = 0; seed < 20; ++seed)
    for (double bend : {0.0, 0.5})
      for (double jitter : {0.0, 2e3}) {
        const auto peaks = line_of(10, bend, jitter, seed);
        const auto pattern = find_peak_pattern(peaks, {});
        ASSERT_EQ(pattern.chains.size(), 1u) << seed << " " << bend << " " << jitter;
        auto chain = pattern.chains[0];
        ASSERT_EQ(chain.size(), 10u);
        if (chain.front() > chain.back()) std::reverse(chain.begin(), chain.end());
        for (int i = 0; i < 10; ++i) EXPECT_EQ(chain[i], i);
      }
}

TEST(PeakChains, ClustersAreNone) {
  for (int seed = 0; seed < 50; ++seed) {
    std::vector<glm::dvec2> peaks;
    for (int i = 0; i < 30; ++i)
      peaks.push_back({60e3 * random_uniform(seed, 1, i), 60e3 * random_uniform(seed, 2, i)});
    for (const auto& chain : find_peak_pattern(peaks, {}).chains) EXPECT_LT(chain.size(), 8u);
  }
  std::vector<glm::dvec2> grid;
  for (int i = 0; i < 36; ++i) grid.push_back({5e3 * (i % 6), 5e3 * (i / 6)});
  EXPECT_TRUE(find_peak_pattern(grid, {}).chains.empty());
}

TEST(PeakChains, LonePeaksAreIsolated) {
  auto peaks = line_of(10, 0.0, 0.0, 1);
  peaks.push_back({36e3, 60e3});
  const auto pattern = find_peak_pattern(peaks, {});
  EXPECT_EQ(pattern.chains.size(), 1u);
  for (int i = 0; i < 11; ++i) EXPECT_EQ(bool(pattern.isolated[i]), i == 10);
  EXPECT_TRUE(find_peak_pattern(std::vector<glm::dvec2>{{1.0, 2.0}}, {}).isolated[0]);
}

TEST(PeakChains, FewAndRepeatedPeaks) {
  EXPECT_TRUE(find_peak_pattern({}, {}).isolated.empty());
  const std::vector<glm::dvec2> two{{0.0, 0.0}, {9e3, 0.0}};
  EXPECT_TRUE(find_peak_pattern(two, {}).chains.empty());
  EXPECT_FALSE(find_peak_pattern(two, {}).isolated[0]);
  EXPECT_EQ(find_peak_pattern(two, {.minimum_peaks = 2}).chains.size(), 1u);
  const std::vector<glm::dvec2> same(5, {3.0, 4.0});
  const auto pattern = find_peak_pattern(same, {});
  EXPECT_TRUE(pattern.chains.empty());
  for (char flag : pattern.isolated) EXPECT_TRUE(flag);
}

}  // namespace
}  // namespace orogen
