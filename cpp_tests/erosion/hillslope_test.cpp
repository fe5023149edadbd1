#include "erosion/hillslope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "foundation/errors.h"
#include "hydrology/random_terrains.h"

namespace orogen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double volume(const Raster<float>& z, const Raster<std::uint8_t>& base) {
  double v = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i)
    if (!base[i]) v += double(z[i]) * z.grid().cell_area();
  return v;
}

TEST(Creep, AWaveDecaysAsTheHeatEquationSays) {
  const Context context;
  const Grid g{128, 96, 10.0, {}};
  const Raster<std::uint8_t> base(g);
  const double kx = std::numbers::pi / g.width() * 3.0, ky = std::numbers::pi / g.height() * 2.0;
  for (double years : {1e3, 2e4, 1e5}) {
    Raster<float> z(g);
    for (int r = 0; r < g.ny; ++r)
      for (int c = 0; c < g.nx; ++c)
        z(r, c) = float(100.0 * std::cos(kx * g.center(r, c).x) * std::cos(ky * g.center(r, c).y));
    const Raster<float> start = z;
    creep(z, base, {.diffusivity = 0.5}, years, context);
    const double decay = std::exp(-0.5 * (kx * kx + ky * ky) * years);
    for (std::size_t i = 0; i < z.size(); ++i) ASSERT_NEAR(z[i], decay * start[i], 0.6);
  }
}

TEST(Creep, BetweenHeldSidesItReachesAParabolaOfUplift) {
  // Steady state of D z'' = -U between two held sides; uplift is put in by hand.
  const Context context;
  const Grid g{101, 3, 10.0, {}};
  Raster<std::uint8_t> base(g);
  for (int r = 0; r < 3; ++r) base(r, 0) = base(r, 100) = 1;
  Raster<float> z(g);
  const double uplift = 1e-4, diffusivity = 0.2;
  for (int i = 0; i < 4000; ++i) {
    for (std::size_t k = 0; k < z.size(); ++k)
      if (!base[k]) z[k] += float(uplift * 1e3);
    creep(z, base, {.diffusivity = diffusivity}, 1e3, context);
  }
  for (int c = 0; c <= 100; ++c) {
    const double x = 10.0 * c;
    EXPECT_NEAR(z(1, c), 0.5 * uplift / diffusivity * x * (1000.0 - x), 0.5);
  }
}

TEST(Creep, KeepsMassOnAnyTerrain) {
  const Context context;
  for (int t = 0; t < 100; ++t)
    for (double critical : {0.0, 0.8}) {
      SCOPED_TRACE(t);
      const RandomTerrain terrain = random_terrain(t);
      Raster<float> z = terrain.elevation;
      const MassBalance m = creep(z, terrain.base, {0.3, critical}, 2e3, context);
      double ground = 0.0;
      for (float h : terrain.elevation.values()) ground += std::fabs(h) * z.grid().cell_area();
      EXPECT_LE(std::fabs(m.residual_m3), 1e-12 * (m.eroded_m3 + m.deposited_m3 + ground));
      EXPECT_NEAR(volume(terrain.elevation, terrain.base) - volume(z, terrain.base), m.exported_m3,
                  1e-6 * (1e3 * double(z.size()) * z.grid().cell_area()));
      const auto [low, high] =
          std::minmax_element(terrain.elevation.values().begin(), terrain.elevation.values().end());
      for (std::size_t i = 0; i < z.size(); ++i) {
        ASSERT_TRUE(!terrain.base[i] || z[i] == terrain.elevation[i]);
        ASSERT_GE(z[i], *low - 1e-3f);
        ASSERT_LE(z[i], *high + 1e-3f);
      }
    }
}

TEST(Creep, NonlinearCreepFlattensSteepSlopesFaster) {
  const Context context;
  const Grid g{200, 5, 5.0, {}};
  const Raster<std::uint8_t> base(g);
  Raster<float> linear(g), nonlinear(g);
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = nonlinear[i] = float(400.0 - 4.2 * std::abs(int(i % 200) - 100));
  creep(linear, base, {.diffusivity = 0.05}, 2e4, context);
  creep(nonlinear, base, {.diffusivity = 0.05, .critical_slope = 1.0}, 2e4, context);
  EXPECT_LT(nonlinear(2, 100), linear(2, 100) - 1.0f);
}

TEST(Landslide, NoSlopeStaysAboveTheTalusAngleAndMassIsKept) {
  const Context context;
  for (int t = 0; t < 100; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    const Grid& g = terrain.elevation.grid();
    const double talus = 0.6;
    Raster<float> z = terrain.elevation;
    const auto [low, high] = std::minmax_element(z.values().begin(), z.values().end());
    const float relief = *high - *low;  // at most ten cells too steep in a row
    if (const double most = 10.0 * talus * g.cell_size; relief > most)
      for (float& h : z.values()) h *= float(most / relief);
    const MassBalance m = landslide(z, terrain.base, talus, {.rounds = 10000}, kInfinity, context);
    EXPECT_LE(std::fabs(m.residual_m3), 1e-11 * std::max(1.0, m.eroded_m3 + m.deposited_m3));
    for (int r = 0; r < g.ny; ++r)
      for (int c = 0; c < g.nx; ++c)
        for (int dr = -1; dr <= 1; ++dr)
          for (int dc = -1; dc <= 1; ++dc) {
            if (terrain.base(r, c) || !g.contains(r + dr, c + dc) || (!dr && !dc)) continue;
            const double length = g.cell_size * std::hypot(dr, dc);
            ASSERT_LE(z(r, c) - z(r + dr, c + dc), talus * length + 0.01);
          }
  }
}

TEST(Landslide, GentleGroundIsLeftAlone) {
  const Context context;
  const Grid g{40, 30, 10.0, {}};
  Raster<float> z(g);
  for (int r = 0; r < 30; ++r)
    for (int c = 0; c < 40; ++c) z(r, c) = float(3.0 * r + 2.0 * c);
  const Raster<float> start = z;
  const MassBalance m =
      landslide(z, Raster<std::uint8_t>(g), 0.6, {.rounds = 100}, kInfinity, context);
  EXPECT_EQ(z, start);
  EXPECT_EQ(m.eroded_m3, 0.0);
}

TEST(Landslide, FallsAtItsRate) {
  const Context context;
  const Grid g{9, 1, 10.0, {}};
  Raster<std::uint8_t> base(g);
  base(0, 0) = 1;
  Raster<float> z(g, 100.0f);
  z(0, 0) = 0.0f;
  landslide(z, base, 0.5, {.landslide_rate = 0.01, .rounds = 1000}, 10.0, context);
  // dz/dt = -l (s - tan θ) with s = z / 10 m: excess of 9.5 decays by exp(-l t / 10 m).
  EXPECT_NEAR(z(0, 1), 5.0 + 95.0 * std::exp(-0.01 * 10.0 / 10.0), 0.05);
}

TEST(Landslide, TalusMayVaryAndThreadsDoNotMatter) {
  const RandomTerrain terrain = random_terrain(8, {211, 190, 1.0, {}});
  Raster<float> talus(terrain.elevation.grid());
  for (std::size_t i = 0; i < talus.size(); ++i) talus[i] = i % 3 ? 0.1f : 0.4f;
  Raster<float> first;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    Raster<float> z = terrain.elevation;
    context.run([&] {
      landslide(z, terrain.base, talus, {.rounds = 40}, kInfinity, context);
      creep(z, terrain.base, {.diffusivity = 0.1, .critical_slope = 1.0}, 10.0, context);
    });
    if (threads == 1) first = z;
    EXPECT_EQ(z, first);
  }
}

TEST(Hillslope, RefusesBadInput) {
  const Context context;
  Raster<float> z(Grid{3, 3, 1.0, {}});
  const Raster<std::uint8_t> base(z.grid()), elsewhere(Grid{2, 2, 1.0, {}});
  EXPECT_THROW(creep(z, base, {.diffusivity = -1.0}, 1.0, context), InputError);
  EXPECT_THROW(creep(z, base, {}, kInfinity, context), InputError);
  EXPECT_THROW(creep(z, elsewhere, {}, 1.0, context), InputError);
  EXPECT_THROW(landslide(z, base, 0.5, {}, NAN, context), InputError);
  EXPECT_THROW(landslide(z, elsewhere, 0.5, {}, 1.0, context), InputError);
}

}  // namespace
}  // namespace orogen
