#include "virtual_pipes_cases.h"

namespace orogen {
namespace {

TEST(VirtualPipes, LakeAtRestStaysToTheBit) {
  // Heights in eighths of a metre: every sum is exact.
  Raster<float> z(Grid{300, 70, 50.0});
  Raster<float> water(z.grid());
  for (std::size_t i = 0; i < z.size(); ++i) {
    z[i] = 1000.0f + float(random_bits(1, 2, i) % 800) / 8.0f;
    water[i] = std::max(0.0f, 1060.0f - z[i]);
  }
  PipeForcing forcing;
  forcing.water_depth = &water;
  const PipeErosionResult after = run(z, steps_of(no_water(), 50.0, 200), forcing);
  EXPECT_EQ(after.water_depth, water);
  EXPECT_EQ(after.elevation, z);
  EXPECT_EQ(after.sediment_balance.eroded_m3, 0.0);
}

TEST(VirtualPipes, LakeOverAnyBedStaysWithinRounding) {
  const Raster<float> z = hills(97, 101, 100.0, 3, 2000.0);
  Raster<float> water(z.grid());
  for (std::size_t i = 0; i < z.size(); ++i) water[i] = std::max(0.0f, 2050.0f - z[i]);
  PipeForcing forcing;
  forcing.water_depth = &water;
  const PipeErosionResult after = run(z, steps_of(no_water(), 100.0, 500), forcing);
  for (std::size_t i = 0; i < z.size(); ++i) {
    ASSERT_NEAR(after.water_depth[i], water[i], 2e-3) << i;
    ASSERT_NEAR(after.elevation[i], z[i], 2e-2) << i;
  }
}

TEST(VirtualPipes, SmallWavesRunAtTheCelerityOfThePipes) {
  // A step of 1 cm on water as deep as the pipes: fronts at x0 +- sqrt(g D) t, plateau half way.
  const int nx = 400, middle = 200;
  PipeParameters p = no_water();
  p.drag_coefficient = 0.0;
  p.pipe_depth = 2.0;
  const Raster<float> z(Grid{nx, 3, 10.0}, 500.0f);
  Raster<float> water(z.grid(), 2.0f);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < middle; ++c) water(r, c) = 2.01f;
  PipeForcing forcing;
  forcing.water_depth = &water;
  p.duration = 250.0;
  const PipeErosionResult after = run_double(z, p, forcing);
  const double reach = std::sqrt(p.gravity * p.pipe_depth) * p.duration / 10.0;  // cells
  const auto depth = [&](double c) { return after.water_depth(1, int(c)); };
  EXPECT_NEAR(depth(middle), 2.005, 5e-4);
  EXPECT_NEAR(depth(middle + 0.8 * reach), 2.005, 1e-3);
  EXPECT_NEAR(depth(middle - 0.8 * reach), 2.005, 1e-3);
  EXPECT_NEAR(depth(middle + 1.2 * reach), 2.0, 1e-4);
  EXPECT_NEAR(depth(middle - 1.2 * reach), 2.01, 1e-4);
}

TEST(VirtualPipes, DamBreakRunsOnAndKeepsItsWater) {
  PipeParameters p = no_water();
  p.sediment_capacity = 0.0;
  const Raster<float> z(Grid{200, 5, 20.0}, 100.0f);
  Raster<float> water(z.grid());
  for (int r = 0; r < 5; ++r)
    for (int c = 0; c < 60; ++c) water(r, c) = 10.0f;
  PipeForcing forcing;
  forcing.water_depth = &water;
  int last = 59;
  for (const double duration : {60.0, 180.0, 360.0}) {
    p.duration = duration;
    const PipeErosionResult after = run(z, p, forcing);
    double volume = 0.0;
    int front = 0;
    for (int c = 0; c < 200; ++c) {
      ASSERT_GE(after.water_depth(2, c), 0.0f);
      volume += after.water_depth(2, c);
      if (after.water_depth(2, c) > 0.01f) front = c;
      ASSERT_LE(after.water_depth(2, c), 11.0f);
    }
    EXPECT_NEAR(volume, 600.0, 600.0 * 1e-6);
    EXPECT_GT(front, last + 2);
    EXPECT_LE(front, 59 + duration / after.time_step);  // never more than a cell a step
    last = front;
  }
}

TEST(VirtualPipes, SteadyRainOnASlopeFlowsAsChezySays) {
  // Far down a plane the discharge is rain times length, the depth (q² cf / (g S))^(1/3).
  const double slope = 0.1, rain = 100.0 / 3.6e6;
  PipeParameters p;
  p.random_rain = false;
  p.rain_rate_mm_per_h = 100.0;
  p.evaporation_rate = 0.0;
  p.sediment_capacity = 0.0;
  p.duration = 4000.0;
  Raster<float> z(Grid{100, 8, 20.0});
  for (int r = 0; r < 8; ++r)
    for (int c = 0; c < 100; ++c) z(r, c) = float(1000.0 - slope * 20.0 * c);
  // Side walls, and the sea at the lower end.
  p.open_sides = false;
  Raster<std::uint8_t> land(z.grid(), 1);
  for (int r = 0; r < 8; ++r) land(r, 99) = 0;
  PipeForcing forcing;
  forcing.land = &land;
  for (const double depth : {0.25, 1.0}) {  // whatever the pipes' depth
    p.pipe_depth = depth;
    const PipeErosionResult after = run(z, p, forcing);
    for (const int c : {30, 60, 90}) {
      const double q = rain * 20.0 * (c + 0.5);
      const double expected = std::cbrt(q * q * p.drag_coefficient / (p.gravity * slope));
      EXPECT_NEAR(after.water_depth(4, c), expected, 0.03 * expected) << c << " D " << depth;
    }
  }
}

TEST(VirtualPipes, SourceFillsAndRainIsCounted) {
  const Raster<float> z(Grid{50, 40, 10.0}, 20.0f);
  PipeParameters p = no_water();
  p.sediment_capacity = 0.0;
  p.duration = 600.0;
  PipeForcing forcing;
  forcing.sources = {{{255.0, 205.0}, 3.0}};
  const PipeErosionResult after = run(z, p, forcing);
  EXPECT_NEAR(after.water_balance.supplied_m3, 1800.0, 1e-3);
  EXPECT_NEAR(after.water_balance.stored_m3, 1800.0, 1e-2);

  p.rain_rate_mm_per_h = 36.0;
  p.drop_probability = 0.05;
  Raster<float> moisture(z.grid(), 0.5f);
  forcing = {};
  forcing.moisture = &moisture;
  const double expected = 0.5 * 36e-3 / 6.0 * 2000.0 * 100.0;  // m³
  EXPECT_NEAR(run(z, p, forcing).water_balance.supplied_m3, expected, 0.05 * expected);
  p.random_rain = false;
  EXPECT_NEAR(run(z, p, forcing).water_balance.supplied_m3, expected, 1e-5 * expected);
}

TEST(VirtualPipes, DeepLakeTakesUpDrizzle) {
  // 0.4 micrometres a step on 500 m of water: lost in float unless rounding is carried over.
  const Raster<float> z(Grid{40, 40, 100.0}, 100.0f);
  const Raster<float> water(z.grid(), 500.0f);
  PipeForcing forcing;
  forcing.water_depth = &water;
  PipeParameters p = no_water();
  p.random_rain = false;
  p.rain_rate_mm_per_h = 1e-4;
  p.duration = 3600.0 * 24;
  const PipeErosionResult after = run(z, p, forcing);
  EXPECT_NEAR(after.water_balance.stored_m3, after.water_balance.supplied_m3,
              1e-4 * after.water_balance.supplied_m3);
}

// ---- Symmetry, oracle, sameness ----

template <class Map>
Raster<float> mapped(const Raster<float>& z, Map&& map) {
  Raster<float> out(z.grid());
  for (int r = 0; r < z.grid().ny; ++r)
    for (int c = 0; c < z.grid().nx; ++c) {
      const auto [mr, mc] = map(r, c);
      out(mr, mc) = z(r, c);
    }
  return out;
}

TEST(VirtualPipes, MirroredAndTurnedTerrainErodesMirroredAndTurned) {
  const int n = 293;  // tiles' borders do not fall on mirrored places
  const Raster<float> z = hills(n, n, 80.0, 11);
  PipeParameters p = steps_of({}, 80.0, 60);
  p.random_rain = false;
  p.sediment_capacity = 2000.0;
  const Raster<float> plain = run(z, p).elevation;
  EXPECT_NE(plain, z);
  const auto mirror = [n](int r, int c) { return std::pair{r, n - 1 - c}; };
  const auto flip = [n](int r, int c) { return std::pair{n - 1 - r, c}; };
  const auto transpose = [](int r, int c) { return std::pair{c, r}; };
  EXPECT_EQ(run(mapped(z, mirror), p).elevation, mapped(plain, mirror));
  EXPECT_EQ(run(mapped(z, flip), p).elevation, mapped(plain, flip));
  EXPECT_EQ(run(mapped(z, transpose), p).elevation, mapped(plain, transpose));
}

TEST(VirtualPipes, AgreesWithASlowPlainSolver) {
  for (const auto& [nx, ny] : {std::pair{61, 47}, {1, 40}, {40, 1}, {1, 1}, {300, 35}}) {
    const Raster<float> z = hills(nx, ny, 60.0, 5 + std::uint32_t(nx));
    PipeParameters p;
    p.random_rain = false;
    p.open_sides = false;
    p.slippage_interval = 0;
    p.sediment_talus_angle_deg = 89.0;  // nothing slides
    p.max_change = 1e6;
    p.sediment_capacity = 1500.0;
    p = steps_of(p, 60.0, 30);
    const PipeErosionResult fast = run_double(z, p), quick = run(z, p);
    PipeOracle slow(z, p, fast.time_step);
    for (int i = 0; i < fast.steps; ++i) slow.step();
    double most = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      const double change = slow.sediment[i] - slow.wear[i];
      most = std::max(most, std::abs(change));
      // The results are floats: half a unit in the last place, and 1e-6.
      ASSERT_NEAR(double(fast.deposition[i]) - double(fast.wear[i]), change, 1e-6) << i;
      ASSERT_NEAR(fast.sediment_thickness[i], slow.sediment[i], 1e-6) << i;
      ASSERT_NEAR(fast.water_depth[i], slow.depth[i], 1e-6) << i;
      ASSERT_NEAR(double(quick.deposition[i]) - double(quick.wear[i]), change, 0.02) << i;
    }
    if (nx * ny > 100) {
      EXPECT_GT(most, 0.5);
    }
  }
}

TEST(VirtualPipes, SameBytesForAnyNumberOfThreads) {
  const Raster<float> z = hills(523, 131, 90.0, 21);
  PipeParameters p = steps_of({}, 90.0, 40);
  p.sediment_capacity = 2000.0;
  p.rock_talus_angle_deg = 40.0;
  const PipeErosionResult one = run(z, p, {}, 1);
  for (const int threads : {2, 3, 4, 8}) {
    const PipeErosionResult many = run(z, p, {}, threads);
    EXPECT_EQ(many.elevation, one.elevation) << threads;
    EXPECT_EQ(many.water_depth, one.water_depth) << threads;
    EXPECT_EQ(many.sediment_thickness, one.sediment_thickness) << threads;
    EXPECT_EQ(many.sediment_balance.exported_m3, one.sediment_balance.exported_m3) << threads;
    EXPECT_EQ(many.water_balance.exported_m3, one.water_balance.exported_m3) << threads;
  }
}

// ---- Balances and bounds over random terrains ----

}  // namespace
}  // namespace orogen
