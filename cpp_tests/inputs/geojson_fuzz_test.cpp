// Ten thousand random and broken maps: read or refused, with a place, and never slowly.
#include <chrono>
#include <cmath>
#include <cstdio>

#include "inputs/geojson_mutants.h"

namespace orogen {
namespace {

using namespace test;

struct Outcome {
  int read = 0, refused = 0;
  double slowest = 0.0;  // s
};

void try_text(const std::string& text, Outcome& outcome) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const VectorMap map = read_geojson(text);
    ++outcome.read;
    EXPECT_TRUE(map.frame.size.x > 0.0 && map.frame.size.y > 0.0);
  } catch (const InputError& error) {
    ++outcome.refused;
    const std::string message = error.what();
    EXPECT_TRUE(names_a_place(message)) << message;
    EXPECT_LT(message.size(), 1000u) << message;
  }
  outcome.slowest =
      std::fmax(outcome.slowest,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

TEST(GeojsonFuzz, SurvivesTenThousandMaps) {
  std::vector<std::string> seeds;
  for (const std::string name :
       {"corsica.geojson", "cyprus.geojson", "imaginary.geojson", "corsica_sketch.geojson",
        "corsica_sketch_km.geojson", "cyprus_km.geojson"})
    if (const auto path = map_file(name)) seeds.push_back(read_text(*path));
  Outcome whole, broken;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    Dice dice(k);
    try_text(random_map(dice), whole);
  }
  for (std::uint64_t k = 0; k < 8000; ++k) {
    Dice dice(100000 + k);
    const bool small = seeds.empty() || k % 4 != 0;
    const std::string text =
        small ? random_map(dice) : seeds[std::size_t(dice.below(int(seeds.size())))];
    try_text(mutated(text, dice), broken);
  }
  EXPECT_GT(whole.read, 1000);
  EXPECT_GT(broken.read, 500);
  EXPECT_GT(broken.refused, 3000);
  // Sanitizers slow the worst case some tenfold.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  const double limit = 10.0;
#else
  const double limit = 1.0;
#endif
  EXPECT_LT(std::fmax(whole.slowest, broken.slowest), limit);
  RecordProperty("slowest_ms", int(1e3 * std::fmax(whole.slowest, broken.slowest)));
  std::printf("whole: %d read, %d refused; broken: %d read, %d refused; slowest %.0f ms\n",
              whole.read, whole.refused, broken.read, broken.refused,
              1e3 * std::fmax(whole.slowest, broken.slowest));
}

}  // namespace
}  // namespace orogen
