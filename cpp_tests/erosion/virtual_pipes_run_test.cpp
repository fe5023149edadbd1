#include "foundation/resample.h"
#include "virtual_pipes_cases.h"

namespace orogen {
namespace {

struct RandomCase {
  Raster<float> elevation, moisture, sediment;
  Raster<std::uint8_t> pinned;
  PipeParameters parameters;
  PipeForcing forcing;
};

/// Sizes from 1 x 1, hills, flats, spikes and checkerboards, all options at random.
void random_case(std::uint64_t k, RandomCase& out) {
  auto pick = [&k, n = 0u]() mutable { return random_uniform(99, k, n++); };
  const int sizes[] = {1, 2, 3, 7, 13, 31, 37, 61, 97, 261};
  const int nx = sizes[int(pick() * 10)], ny = sizes[int(pick() * 9)];
  const double cell = 20.0 + 380.0 * pick();
  out.elevation = hills(nx, ny, cell, std::uint32_t(k), 400.0 * pick());
  const int kind = int(pick() * 6);
  for (std::size_t i = 0; i < out.elevation.size(); ++i) {
    float& z = out.elevation[i];
    if (kind == 0) z = 10.0f;
    if (kind == 1) z = (i % std::size_t(nx) + i / std::size_t(nx)) % 2 ? 3.0f : 800.0f;
    if (kind == 2 && random_uniform(k, 5, i) < 0.02) z += 3000.0f;
  }
  out.moisture = Raster<float>(out.elevation.grid());
  out.sediment = Raster<float>(out.elevation.grid());
  out.pinned = Raster<std::uint8_t>(out.elevation.grid());
  for (std::size_t i = 0; i < out.elevation.size(); ++i) {
    out.moisture[i] = float(random_uniform(k, 6, i));
    out.sediment[i] = float(5.0 * random_uniform(k, 7, i));
    out.pinned[i] = random_uniform(k, 8, i) < 0.03;
  }
  PipeParameters p;
  p.seed = int(k);
  p.random_rain = pick() < 0.5;
  p.open_sides = pick() < 0.5;
  p.sediment_capacity = std::pow(10.0, 1.0 + 4.0 * pick());
  p.capacity_law = CapacityLaw(int(pick() * 3));
  p.bed_slope = BedSlope(int(pick() * 2));
  p.limit_to_neighbours = pick() < 0.7;
  p.sea_keeps_sediment = pick() < 0.3;
  p.settle_at_end = pick() < 0.3;
  p.rock_talus_angle_deg = pick() < 0.3 ? 45.0 : 90.0;
  p.drag_coefficient = pick() < 0.2 ? 0.0 : 0.05;
  p.erosion_halving_depth = pick() < 0.2 ? 5.0 : 0.0;
  p.deposition_halving_depth = pick() < 0.2 ? 5.0 : 0.0;
  out.parameters = steps_of(p, cell, 60);
  if (pick() < 0.5) out.forcing.moisture = &out.moisture;
  if (pick() < 0.5) out.forcing.sediment_thickness = &out.sediment;
  if (pick() < 0.5) out.forcing.pinned = &out.pinned;
  if (pick() < 0.3) out.forcing.layers = {{out.sediment, 1e-3, 40.0}, {out.sediment, 0.0, 90.0}};
}

template <class Real>
void check_balances(double tolerance) {
  int moved = 0;
  for (std::uint64_t k = 0; k < 120; ++k) {
    SCOPED_TRACE(k);
    RandomCase c;
    random_case(k, c);
    Context context;
    const PipeErosionResult r =
        erode_virtual_pipes<Real>(c.elevation, c.forcing, c.parameters, context);
    moved += r.sediment_balance.eroded_m3 > 0.0;
    const double cells = double(c.elevation.size()) * c.elevation.grid().cell_area();
    // Relative to what was eroded, or to a millimetre of it: many cases hardly erode.
    ASSERT_LT(std::abs(r.sediment_balance.residual_m3),
              tolerance * std::max(r.sediment_balance.eroded_m3, 1e-3 * cells));
    ASSERT_LT(r.water_balance.relative_residual(), tolerance);
    for (std::size_t i = 0; i < c.elevation.size(); ++i) {
      ASSERT_TRUE(std::isfinite(r.elevation[i]));
      ASSERT_GE(r.water_depth[i], 0.0f);
      ASSERT_GE(r.sediment_thickness[i], 0.0f);
      ASSERT_GE(r.wear[i], 0.0f);
      ASSERT_GE(r.deposition[i], 0.0f);
      if (c.forcing.pinned && c.pinned[i] && c.elevation[i] > 0.0f) {
        ASSERT_EQ(r.elevation[i], c.elevation[i]);
      }
      if (!(c.elevation[i] > 0.0f) && !c.parameters.sea_keeps_sediment) {
        ASSERT_EQ(r.elevation[i], c.elevation[i]);
      }
    }
    ASSERT_LE(r.steepest_excess, 1e-3);
  }
  EXPECT_GT(moved, 60);
}

TEST(VirtualPipes, BalancesCloseInFloat) {
  check_balances<float>(1e-5);
}
TEST(VirtualPipes, BalancesCloseInDouble) {
  check_balances<double>(1e-10);
}

TEST(VirtualPipes, TenThousandStepsStayBounded) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const Raster<float> z = hills(67, 59, 40.0, seed);
    PipeParameters p;
    p.sediment_capacity = 1000.0;
    p = steps_of(p, 40.0, 10000);
    const PipeErosionResult r = run(z, p);
    EXPECT_EQ(r.steps, 10000);
    EXPECT_LT(r.sediment_balance.relative_residual(), 1e-5);
    EXPECT_LT(r.water_balance.relative_residual(), 1e-5);
    EXPECT_GT(r.sediment_balance.eroded_m3, 0.0);
    float top = 0.0f, after = 0.0f;
    for (std::size_t i = 0; i < z.size(); ++i) {
      top = std::max(top, z[i]);
      after = std::max(after, r.elevation[i]);
      ASSERT_TRUE(std::isfinite(r.elevation[i]) && r.elevation[i] > -1000.0f);
      ASSERT_TRUE(r.water_depth[i] >= 0.0f && r.water_depth[i] < 500.0f);
      ASSERT_LE(r.wear[i], p.max_change * 1.01);
      if (z[i] > 0.0f) {
        ASSERT_GT(r.elevation[i], 0.0f) << "the coast moved";
      }
    }
    EXPECT_LE(after, top + 1.0f);
  }
}

TEST(VirtualPipes, NeverChangesMoreThanMaxChange) {
  const Raster<float> z = hills(120, 90, 100.0, 9);
  PipeParameters p = steps_of({}, 100.0, 150);
  p.sediment_capacity = 1e5;
  p.max_change = 2.5;
  p.slippage_interval = 0;
  p.sediment_talus_angle_deg = 89.0;
  const PipeErosionResult r = run(z, p);
  for (std::size_t i = 0; i < z.size(); ++i) {
    ASSERT_LE(r.wear[i], 2.5f * 1.00001f);
    ASSERT_LE(r.deposition[i], 2.5f * 1.00001f);
  }
  EXPECT_GT(r.cells_at_max_change, 100);
  EXPECT_EQ(run(z,
                [&] {
                  p.max_change = 0.0;
                  return p;
                }())
                .elevation,
            z);
}

// ---- Materials and forcing ----

double eroded(const Raster<float>& z, const PipeParameters& p, const PipeForcing& f = {}) {
  return run(z, p, f).sediment_balance.eroded_m3;
}

TEST(VirtualPipes, MoreRainMoreWear) {
  const Raster<float> z = hills(128, 128, 50.0, 4);
  PipeParameters p = steps_of({}, 50.0, 120);
  p.random_rain = false;
  double last = 0.0;
  for (const double rain : {5.0, 20.0, 80.0, 320.0}) {
    p.rain_rate_mm_per_h = rain;
    const double now = eroded(z, p);
    EXPECT_GT(now, last * 1.2) << rain;
    last = now;
  }
}

TEST(VirtualPipes, HarderLayersWearLess) {
  const Raster<float> z = hills(96, 96, 50.0, 6);
  PipeParameters p = steps_of({}, 50.0, 120);
  PipeForcing forcing;
  double last = 1e300;
  for (const double rate : {1e-3, 1e-4, 1e-5}) {
    forcing.layers = {{Raster<float>(z.grid(), 1000.0f), rate, 90.0}};
    const double now = eroded(z, p, forcing);
    EXPECT_LT(now, last * 0.6);
    last = now;
  }
  // Half of the map harder: that half wears less.
  Raster<float> ease(z.grid(), 1.0f);
  for (int r = 0; r < 96; ++r)
    for (int c = 0; c < 48; ++c) ease(r, c) = 0.05f;
  forcing = {};
  forcing.erodibility = &ease;
  const PipeErosionResult even = run(z, p), half = run(z, p, forcing);
  double wear_even = 0.0, wear_half = 0.0;
  for (int r = 0; r < 96; ++r)
    for (int c = 0; c < 40; ++c) {
      wear_even += even.wear(r, c);
      wear_half += half.wear(r, c);
    }
  EXPECT_LT(wear_half, 0.3 * wear_even);
}

TEST(VirtualPipes, WearStopsAtALayerThatDoesNotDissolve) {
  const Raster<float> z = hills(80, 80, 50.0, 8);
  PipeParameters p = steps_of({}, 50.0, 200);
  p.sediment_capacity = 1e4;
  PipeForcing forcing;
  Raster<float> first(z.grid(), 1.5f), none(z.grid(), 0.0f), second(z.grid(), 0.75f);
  forcing.layers = {{first, 1e-2, 90.0},
                    {none, 1e-2, 90.0},
                    {second, 5e-3, 90.0},
                    {Raster<float>(z.grid(), 1e5f), 0.0, 90.0}};
  const PipeErosionResult r = run(z, p, forcing);
  int stopped = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    ASSERT_LE(r.wear[i], 2.25f + 1e-5f);
    stopped += r.wear[i] > 2.249f;
  }
  EXPECT_GT(stopped, 50);
}

TEST(VirtualPipes, LayersOfOneRockAreOneRock) {
  const Raster<float> z = hills(70, 90, 50.0, 18);
  PipeParameters p = steps_of({}, 50.0, 100);
  p.sediment_capacity = 3000.0;
  PipeForcing forcing;
  forcing.layers = {{Raster<float>(z.grid(), 1e4f), p.rock_dissolution_rate, 90.0},
                    {Raster<float>(z.grid(), 3.0f), p.rock_dissolution_rate, 90.0}};
  EXPECT_EQ(run(z, p, forcing).elevation, run(z, p).elevation);
}

TEST(VirtualPipes, SeaTakesOrKeepsWhatReachesIt) {
  const Raster<float> z = hills(150, 120, 60.0, 13, 20.0);
  PipeParameters p = steps_of({}, 60.0, 150);
  const PipeErosionResult leaves = run(z, p);
  EXPECT_GT(leaves.sediment_balance.exported_m3, 0.0);
  p.sea_keeps_sediment = true;
  const PipeErosionResult keeps = run(z, p);
  double laid = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i)
    if (!(keeps.elevation[i] > 0.0f)) laid += double(keeps.deposition[i]) * z.grid().cell_area();
  EXPECT_GT(laid, 0.0);
  EXPECT_LE(laid, keeps.sediment_balance.exported_m3 * 1.001);
}

TEST(VirtualPipes, TracedSedimentIsNotConserved) {
  const Raster<float> z = hills(100, 100, 60.0, 15);
  PipeParameters p = steps_of({}, 60.0, 100);
  p.transport = TransportScheme::SemiLagrangian;
  const PipeErosionResult r = run(z, p);
  EXPECT_LT(r.water_balance.relative_residual(), 1e-5);
  EXPECT_GT(r.sediment_balance.eroded_m3, 0.0);
  EXPECT_GT(r.sediment_balance.relative_residual(), 1e-4);  // told, not hidden
  for (const float v : r.elevation.values()) ASSERT_TRUE(std::isfinite(v));
}

TEST(VirtualPipes, PaperBsSettingRuns) {
  Raster<float> z(Grid{128, 128, 1.0});
  const Raster<float> noise = hills(128, 128, 1.0, 31);
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = 0.4f + 0.2f * (noise[i] - 150.0f);
  PipeParameters p;
  p.duration = 5.0;
  p.time_step = 0.01;
  p.gravity = 10.0;
  p.drag_coefficient = 0.0;
  p.rain_rate_mm_per_h = 3.6e6 * 0.1;  // 0.1 a unit of time
  p.evaporation_rate = 0.1;
  p.capacity_law = CapacityLaw::Velocity;
  p.sediment_capacity = 0.1;
  p.bed_slope = BedSlope::Steepest;
  p.max_slope = 0.5;
  p.sediment_dissolution_rate = p.rock_dissolution_rate = p.deposition_rate = 0.2;
  p.limit_to_neighbours = false;
  p.sea_keeps_sediment = true;
  p.max_change = 0.2;
  const PipeErosionResult plain = run(z, p);
  EXPECT_EQ(plain.steps, 500);
  EXPECT_GT(plain.sediment_balance.eroded_m3, 0.0);
  EXPECT_LT(plain.sediment_balance.relative_residual(), 1e-5);
  p.erosion_halving_depth = 1e-3;
  const PipeErosionResult slowed = run(z, p);
  EXPECT_LT(slowed.sediment_balance.eroded_m3, 0.9 * plain.sediment_balance.eroded_m3);
}

// ---- Manners ----

std::string refusal(const Raster<float>& z, const PipeParameters& p, const PipeForcing& f = {}) {
  try {
    run(z, p, f);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(VirtualPipes, RefusesWhatItCannotUse) {
  const Raster<float> z = hills(20, 20, 50.0, 1);
  PipeParameters p = steps_of({}, 50.0, 5);
  EXPECT_EQ(refusal(z, p), "accepted");
  EXPECT_NE(refusal(Raster<float>(), p).find("elevation"), std::string::npos);
  Raster<float> bad = z;
  bad(3, 4) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(refusal(bad, p).find("row 3, column 4"), std::string::npos);
  PipeForcing f;
  const Raster<float> wet(z.grid(), 1.5f);
  f.moisture = &wet;
  EXPECT_NE(refusal(z, p, f).find("moisture"), std::string::npos);
  const Raster<float> other(Grid{3, 3, 50.0}, 0.5f);
  f.moisture = &other;
  EXPECT_NE(refusal(z, p, f).find("grid"), std::string::npos);
  f = {};
  f.sources = {{{175.0, 1275.0}, 1.0}};
  EXPECT_NE(refusal(z, p, f).find("sources[0]"), std::string::npos);
  f = {};
  f.layers = {{Raster<float>(z.grid(), -1.0f), 1e-4, 90.0}};
  EXPECT_NE(refusal(z, p, f).find("layers[0].thickness"), std::string::npos);
  p.time_step = 1e4;
  EXPECT_NE(refusal(z, p).find("time_step"), std::string::npos);
  p = steps_of({}, 50.0, 5);
  p.drag_coefficient = -1.0;
  EXPECT_NE(refusal(z, p).find("drag_coefficient"), std::string::npos);
}

TEST(VirtualPipes, ReportsProgressAndStopsWhenAsked) {
  const Raster<float> z = hills(100, 100, 50.0, 1);
  const PipeParameters p = steps_of({}, 50.0, 5000);
  double last = 0.0;
  Context context([&](std::string_view, double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return fraction < 0.02;
  });
  EXPECT_THROW(erode_virtual_pipes<float>(z, {}, p, context), Cancelled);
  EXPECT_GT(last, 0.0);
  EXPECT_LT(last, 0.5);
}

TEST(VirtualPipes, AWatchSeesTheGroundAndChangesNothing) {
  const Raster<float> z = hills(300, 200, 50.0, 4);
  const PipeParameters p = steps_of({}, 50.0, 80);
  const Context context;
  const Raster<float> before = resample_mean(z, GrowthWatch::grid(z.grid()), context);
  int seen = 0;
  GrowthWatch watch([&](double years, const WatchedGround& ground) {
    ++seen;
    EXPECT_GT(years, 0.0);
    ASSERT_EQ(ground.elevation.grid(), before.grid());
    double water = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      ASSERT_NEAR(ground.elevation[i] - before[i], ground.change[i], 1e-3);
      ASSERT_GE(ground.water_depth[i], 0.0f);
      water += ground.water_depth[i];
    }
    EXPECT_GT(water, 0.0);
  });
  PipeForcing watched;
  watched.watch = &watch;
  EXPECT_EQ(run(z, p, watched).elevation, run(z, p).elevation);
  EXPECT_GT(seen, 0);
}

TEST(VirtualPipes, DeclaresItsStage) {
  EXPECT_EQ(hydraulic_erosion_stage().name, "hydraulic_erosion");
  EXPECT_FALSE(hydraulic_erosion_stage().writes.empty());
  EXPECT_FALSE(describe_parameters<PipeParameters>().empty());
}

}  // namespace
}  // namespace orogen
