#include "strata/horizon_trace.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "foundation/errors.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

using Block = test::RoughBlock;

TEST(HorizonTraces, LieOnTheGroundAndOnTheHorizon) {
  Block b;
  std::size_t points = 0;
  for (int k = 0; k <= 3; ++k)
    for (const Trace& trace : horizon_traces(b.body, k, b.context))
      for (const glm::vec3 p : trace) {
        const glm::dvec2 place = glm::dvec2(p.x, p.y) + b.grid.origin;
        std::vector<float> h(4);
        b.horizons.at(place, h.data());
        ASSERT_NEAR(p.z, b.body.ground_at(place), 0.05);
        ASSERT_NEAR(p.z, h[k], k == 3 ? 0.2 : 0.1);
        ++points;
      }
  EXPECT_GT(points, 500u);
}

/// Independent count: every pair of neighbouring centres with different rock has a trace between.
TEST(HorizonTraces, PartTheRockOfOneLayerFromThatOfAnother) {
  Block b;
  std::size_t crossed = 0, sides = 0;
  for (int k = 0; k <= 3; ++k)
    for (const Trace& trace : horizon_traces(b.body, k, b.context)) {
      const bool closed = trace.front() == trace.back();
      crossed += trace.size() - closed;
    }
  std::vector<float> h(4);
  const auto layer = [&](int r, int c) {
    b.horizons.at(b.grid.center(r, c), h.data());
    return b.rocks.rock_at(h.data(), b.elevation(r, c)).layer;
  };
  for (int r = 0; r < b.grid.ny; ++r)
    for (int c = 0; c < b.grid.nx; ++c) {
      if (c + 1 < b.grid.nx) sides += std::abs(layer(r, c) - layer(r, c + 1));
      if (r + 1 < b.grid.ny) sides += std::abs(layer(r, c) - layer(r + 1, c));
    }
  EXPECT_EQ(crossed, sides);
}

TEST(HorizonTraces, HaveTheHorizonAboveGroundOnTheirLeft) {
  Block b;
  for (const Trace& trace : horizon_traces(b.body, 1, b.context))
    for (std::size_t i = 0; i + 1 < trace.size(); ++i) {
      const glm::dvec2 from(trace[i].x, trace[i].y), to(trace[i + 1].x, trace[i + 1].y);
      const glm::dvec2 way = to - from;
      if (glm::length(way) < 20.0) continue;
      const glm::dvec2 left(-way.y, way.x);
      const glm::dvec2 place = 0.5 * (from + to) + 0.2 * left + b.grid.origin;
      std::vector<float> h(4);
      b.horizons.at(place, h.data());
      EXPECT_GT(h[1] - b.body.ground_at(place), -5.0);
    }
}

TEST(HorizonTraces, GroundThatIsTheHighestHorizonHasNone) {
  Block b;
  const Raster<float>& top = b.horizons.heights.back();
  const RockBody whole{b.horizons, b.rocks, top};
  for (int k = 0; k <= 3; ++k) EXPECT_TRUE(horizon_traces(whole, k, b.context).empty());
}

TEST(HorizonTraces, RefuseAHorizonThatIsNone) {
  Block b;
  EXPECT_THROW(horizon_traces(b.body, 4, b.context), InputError);
  EXPECT_THROW(horizon_traces(b.body, -1, b.context), InputError);
}

}  // namespace
}  // namespace orogen
