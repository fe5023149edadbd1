#include "erosion/slope_limit.h"

#include <gtest/gtest.h>

#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

struct Ground {
  Raster<float> z, least;
  Raster<std::uint8_t> base;
};

/// Spikes and walls on a random grid, with some base level and some ground held up.
Ground random_ground(int seed) {
  const auto u = [&](int k) { return random_uniform(seed, 3, k); };
  const Grid grid{1 + int(40 * u(0)), 1 + int(40 * u(1)), 10.0 + 200.0 * u(2), {0, 0}};
  Ground g{Raster<float>(grid), Raster<float>(grid, -1e9f), Raster<std::uint8_t>(grid)};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    g.z[i] = float(3000.0 * random_uniform(seed, 4, i));
    g.base[i] = random_uniform(seed, 5, i) < 0.05;
    if (random_uniform(seed, 6, i) < 0.05) g.least[i] = 0.8f * g.z[i];
  }
  return g;
}

/// The same by plain relaxation until nothing changes.
Raster<float> slowly(const Ground& g, const Varying& slope) {
  Raster<float> z = g.z;
  const Grid& grid = z.grid();
  for (bool changed = true; changed;) {
    changed = false;
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c)
        for (int dr = -1; dr <= 1; ++dr)
          for (int dc = -1; dc <= 1; ++dc) {
            if (!grid.contains(r + dr, c + dc) || (!dr && !dc) || g.base(r, c)) continue;
            const float step = float(slope.at(grid.index(r, c)) * grid.cell_size *
                                     (dr && dc ? std::sqrt(2.0) : 1.0));
            const float limit = std::max(z(r + dr, c + dc) + step, g.least(r, c));
            if (z(r, c) > limit) z(r, c) = limit, changed = true;
          }
  }
  return z;
}

TEST(SlopeLimit, AgreesWithPlainRelaxationOnRandomGround) {
  for (int seed = 0; seed < 100; ++seed) {
    Context context;
    Ground g = random_ground(seed);
    const double slope = 0.2 + 2.0 * random_uniform(seed, 7, 0);
    const Raster<float> wanted = slowly(g, slope);
    limit_slope(g.z, g.base, g.least, slope, context);
    for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_NEAR(g.z[i], wanted[i], 1e-2);
  }
}

TEST(SlopeLimit, FollowsASlopeThatVaries) {
  for (int seed = 0; seed < 100; ++seed) {
    Context context;
    Ground g = random_ground(seed);
    Raster<float> slope(g.z.grid());
    for (std::size_t i = 0; i < slope.size(); ++i)
      slope[i] = float(0.2 + 2.0 * random_uniform(seed, 8, std::uint32_t(i)));
    const Raster<float> wanted = slowly(g, slope);
    limit_slope(g.z, g.base, g.least, slope, context);
    for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_NEAR(g.z[i], wanted[i], 1e-2);
  }
}

TEST(SlopeLimit, MakesNoHollowAndLeavesGentleGroundAlone) {
  Context context;
  const Grid grid{50, 40, 100.0, {0, 0}};
  Raster<float> z(grid), least(grid, -1e9f);
  Raster<std::uint8_t> base(grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      z(r, c) = float(20.0 * r + 30.0 * c);
      base(r, c) = r == 0 || c == 0;
    }
  const Raster<float> gentle = z;
  limit_slope(z, base, least, 0.6, context);
  EXPECT_EQ(z, gentle);
  z(20, 25) += 900.0f;  // a spike becomes a cone that drains
  limit_slope(z, base, least, 0.6, context);
  for (int r = 1; r < grid.ny; ++r)
    for (int c = 1; c < grid.nx; ++c) EXPECT_GT(z(r, c), std::min(z(r - 1, c), z(r, c - 1)));
}

TEST(SlopeLimit, RefusesWhatItCannotUse) {
  Context context;
  Raster<float> z(Grid{3, 3, 1.0, {0, 0}}), least(z.grid());
  EXPECT_THROW(limit_slope(z, Raster<std::uint8_t>(z.grid()), least, 0.0, context), InputError);
  const Raster<std::uint8_t> other(Grid{3, 4, 1.0, {0, 0}});
  EXPECT_THROW(limit_slope(z, other, least, 1.0, context), InputError);
}

}  // namespace
}  // namespace orogen
