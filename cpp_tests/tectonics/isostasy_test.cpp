#include "tectonics/isostasy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

// Elastic thickness that gives the flexural parameter wanted.
IsostasyParameters with_alpha(double alpha) {
  IsostasyParameters p;
  p.elastic_thickness = 10e3;
  p.elastic_thickness *= std::pow(alpha / flexural_parameter(p), 4.0 / 3.0);
  return p;
}

Raster<float> bend(const Raster<float>& load, const IsostasyParameters& p, int threads = 0) {
  Context context({}, threads);
  Raster<float> result;
  context.run([&] { result = flexural_deflection(load, p, context); });
  return result;
}

TEST(Isostasy, AiryByHand) {
  const IsostasyParameters p{.crust_density = 2750.0, .mantle_density = 3300.0};
  EXPECT_NEAR(airy_uplift_share(p), 1.0 / 6.0, 1e-12);
  EXPECT_NEAR(airy_root_share(p), 5.0, 1e-12);
  // A thickening of 6 km: 1 km up, 5 km down.
  EXPECT_NEAR(6.0 * airy_uplift_share(p) * (1.0 + airy_root_share(p)), 6.0, 1e-12);
}

TEST(Isostasy, FlexuralParameterByHand) {
  const IsostasyParameters p{.crust_density = 2800.0,
                             .mantle_density = 3300.0,
                             .elastic_thickness = 20e3,
                             .young_modulus = 7e10,
                             .poisson_ratio = 0.25};
  const double rigidity = 7e10 * 8e12 / (12.0 * 0.9375);
  EXPECT_NEAR(flexural_parameter(p), std::pow(4.0 * rigidity / (500.0 * 9.81), 0.25), 1e-6);
}

// D w'''' + Δρ g w = V δ(x): w = V α³ / 8D e^(−x/α) (cos x/α + sin x/α), w0 = root h dx / 2α.
TEST(Isostasy, LineLoadBendsAsInTheTextbook) {
  for (double cells : {6.0, 20.0, 45.0}) {  // an α; the last is gathered
    const double cell = 1e3, alpha = cells * cell;
    const auto p = with_alpha(alpha);
    const int n = 160, length = int(16.0 * cells) | 1;
    const Grid grid{n | 1, length, cell, {3e3, -5e3}};
    Raster<float> load(grid);
    for (int r = 0; r < grid.ny; ++r) load(r, grid.nx / 2) = 1000.0f;
    const auto w = bend(load, p);
    const double w0 = airy_root_share(p) * 1000.0 * cell / (2.0 * alpha);
    for (int c = 0; c < grid.nx; ++c) {
      const double x = std::fabs(c - grid.nx / 2) / cells;
      EXPECT_NEAR(w(grid.ny / 2, c), w0 * std::exp(-x) * (std::cos(x) + std::sin(x)), 0.01 * w0)
          << cells << " " << x;
    }
  }
}

// −kei(r) by its integral: kei(r) = −∫ J0(k r) k / (1 + k⁴) dk, kei(0) = −π/4; at r > 0 its series.
double minus_kei(double r) {
  if (r == 0.0) return 0.785398163397448;
  double sum = 0.0,
         term = 1.0;  // kei = −ln(r/2) bei − π/4 ber + Σ (−1)^k ψ(2k+2) (r/2)^(4k+2) / ((2k+1)!)²
  double ber = 0.0, bei = 0.0;
  const double half = 0.5 * r;
  double factorial = 1.0, harmonic = 0.0;
  term = 1.0;
  for (int m = 0; m < 60; ++m) {  // (r/2)^(2m) / (m!)²
    if (m > 0) {
      factorial = m;
      term *= half * half / (factorial * factorial);
      harmonic += 1.0 / m;
    }
    const double sign = (m / 2) % 2 ? -1.0 : 1.0;
    if (m % 2 == 0) ber += sign * term;
    if (m % 2 == 1) {
      bei += sign * term;
      sum += sign * (harmonic - 0.57721566490153286) * term;
    }
  }
  return -(-std::log(half) * bei - 0.785398163397448 * ber + sum);
}

// D ∇⁴w + Δρ g w = P δ: w = −P l² / (2π D) kei(r / l), l⁴ = D / Δρ g = α⁴ / 4.
TEST(Isostasy, PointLoadIsKelvinsFunction) {
  const double cell = 1e3, alpha = 12e3, l = alpha / std::sqrt(2.0);
  const auto p = with_alpha(alpha);
  const Grid grid{151, 151, cell, {0.0, 0.0}};
  Raster<float> load(grid);
  load(75, 75) = 1000.0f;
  const auto w = bend(load, p);
  const double scale = airy_root_share(p) * 1000.0 * cell * cell / (2.0 * 3.14159265358979 * l * l);
  for (int c = 75; c < 150; c += 3)
    EXPECT_NEAR(w(75, c), scale * minus_kei((c - 75) * cell / l), 0.01 * scale * 0.785);
  EXPECT_NEAR(w(75 + 12, 75 - 5), scale * minus_kei(13e3 / l), 0.01 * scale * 0.785);
}

TEST(Isostasy, WithoutElasticThicknessItIsAirys) {
  const Grid grid{37, 23, 500.0, {0.0, 0.0}};
  Raster<float> load(grid);
  for (std::size_t i = 0; i < load.size(); ++i) load[i] = float(1e3 * random_normal(1, 2, i));
  for (double thickness : {0.0, 1e-3}) {
    IsostasyParameters p{.elastic_thickness = thickness};
    const auto w = bend(load, p);
    for (std::size_t i = 0; i < load.size(); ++i)
      EXPECT_NEAR(w[i], airy_root_share(p) * load[i], 1e-3);
  }
}

TEST(Isostasy, TheHollowBearsTheWholeLoad) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const double alpha = 2e3 + 20e3 * random_uniform(seed, 1, 0);
    const auto p = with_alpha(alpha);
    const int n = 120 + int(7 * seed) % 31, m = 130 + int(5 * seed) % 29;
    const Grid grid{n, m, alpha / 8.0, {0.0, 0.0}};
    Raster<float> load(grid);
    double weight = 0.0, borne = 0.0;
    for (int r = m / 2 - 5; r < m / 2 + 5; ++r)
      for (int c = n / 2 - 5; c < n / 2 + 5; ++c) {
        load(r, c) = float(1e3 * random_uniform(seed, 2, grid.index(r, c)));
        weight += load(r, c);
      }
    const auto w = bend(load, p);
    for (float v : w.values()) borne += v;
    EXPECT_NEAR(borne, airy_root_share(p) * weight, 0.01 * airy_root_share(p) * weight);
    EXPECT_GT(w(m / 2, n / 2), 0.0f);  // down under the load
    EXPECT_LT(*std::min_element(w.values().begin(), w.values().end()), 0.0f);  // a bulge around
  }
}

TEST(Isostasy, LoadsDoNotWrapRound) {
  const auto p = with_alpha(10e3);
  const Grid grid{60, 50, 1e3, {0.0, 0.0}};
  Raster<float> load(grid);
  for (int r = 0; r < 50; ++r) load(r, 0) = 1e3f;
  const auto w = bend(load, p);
  const double x = 5.9;
  const double least = std::exp(-x) * (std::cos(x) + std::sin(x));
  EXPECT_NEAR(w(25, 59) / w(25, 0), least, 2e-3);
  EXPECT_GT(w(25, 0), 100.0f);
}

TEST(Isostasy, GatheringCostsLittle) {
  const auto p = with_alpha(40e3);  // 40 cells: gathered by two; 20 coarse cells: not
  const Grid fine{100, 90, 1e3, {0.0, 0.0}}, coarse{50, 45, 2e3, {0.0, 0.0}};
  Raster<float> load(fine), sums(coarse);
  for (int r = 0; r < 90; ++r)
    for (int c = 0; c < 100; ++c) {
      load(r, c) = float(2e3 * std::exp(-std::pow(std::hypot(r - 40.0, c - 60.0) / 9.0, 2.0)));
      sums(r / 2, c / 2) += 0.25f * load(r, c);
    }
  const auto w = bend(load, p), v = bend(sums, p);
  const float deepest = *std::max_element(w.values().begin(), w.values().end());
  for (int r = 0; r < 44; ++r)
    for (int c = 0; c < 49; ++c) {
      const float mean = 0.25f * (w(2 * r, 2 * c) + w(2 * r + 1, 2 * c) + w(2 * r, 2 * c + 1) +
                                  w(2 * r + 1, 2 * c + 1));
      EXPECT_NEAR(mean, v(r, c), 1e-3f * deepest);
    }
}

TEST(Isostasy, DegenerateGridsAndThreadsGiveTheSameBytes) {
  for (const Grid& grid : {Grid{1, 1, 1e3, {0.0, 0.0}}, Grid{1, 67, 1e3, {0.0, 0.0}},
                           Grid{131, 1, 1e3, {0.0, 0.0}}, Grid{131, 97, 1e3, {0.0, 0.0}}}) {
    Raster<float> load(grid);
    for (std::size_t i = 0; i < load.size(); ++i) load[i] = float(random_uniform(3, 1, i));
    const auto one = bend(load, with_alpha(8e3), 1);
    for (float w : one.values()) EXPECT_TRUE(std::isfinite(w));
    for (int threads : {2, 4}) EXPECT_EQ(one, bend(load, with_alpha(8e3), threads));
  }
}

TEST(Isostasy, RefusesWhatCannotFloat) {
  const Raster<float> load(Grid{4, 4, 1e3, {0.0, 0.0}}, 1.0f);
  EXPECT_THROW(bend(load, {.crust_density = 3300.0}), InputError);
  EXPECT_THROW(bend(load, {.crust_density = 3400.0}), InputError);
  EXPECT_THROW(bend(load, {.elastic_thickness = -1.0}), InputError);
  EXPECT_THROW(bend(load, {.poisson_ratio = 0.6}), InputError);
  Raster<float> bad = load;
  bad[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(bend(bad, {}), InputError);
}

TEST(Isostasy, CrustThatFloatsRisesByItsShareAndBendsDownBesideARange) {
  Context context;
  const Grid grid{200, 60, 2000.0, {}};
  Raster<float> thickening(grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 80; c < 120; ++c) thickening(r, c) = 1e-3f;
  IsostasyParameters p;
  EXPECT_EQ(isostatic_uplift(thickening, p, context), thickening);
  p.isostasy = Isostasy::Airy;
  const Raster<float> airy = isostatic_uplift(thickening, p, context);
  EXPECT_NEAR(airy(30, 100), 1e-3 * (1.0 - 2800.0 / 3300.0), 1e-9);
  EXPECT_EQ(airy(30, 70), 0.0f);
  p.isostasy = Isostasy::Flexure;
  const Raster<float> bent = isostatic_uplift(thickening, p, context);
  EXPECT_GT(bent(30, 100), airy(30, 100));  // the plate bears a part of the range
  EXPECT_LT(bent(30, 76), 0.0f);            // and sinks beside it
  p.elastic_thickness = 0.0;
  const Raster<float> free = isostatic_uplift(thickening, p, context);
  for (std::size_t i = 0; i < free.size(); ++i) ASSERT_NEAR(free[i], airy[i], 1e-9);
}

TEST(Isostasy, AirInTheHollowBendsTheStifferMantle) {
  const IsostasyParameters p;
  const double crust = flexural_parameter(p), air = flexural_parameter(p, HollowFill::Air);
  EXPECT_NEAR(std::pow(crust / air, 4.0), 3300.0 / 500.0, 1e-9);
}

TEST(Isostasy, FloatingUpliftKeepsItsMeanWhereCrustThickens) {
  const Context context;
  const Grid grid{96, 64, 2e3, {}};
  Raster<float> thickening(grid);
  for (int r = 20; r < 40; ++r)
    for (int c = 30; c < 60; ++c) thickening(r, c) = float(1e-3 * (0.2 + random_uniform(1, r, c)));
  EXPECT_EQ(floating_uplift(thickening, {}, context), thickening);
  for (const Isostasy kind : {Isostasy::Airy, Isostasy::Flexure}) {
    const IsostasyParameters p{.isostasy = kind, .elastic_thickness = 8e3};
    const auto rise = floating_uplift(thickening, p, context);
    const auto plain = isostatic_uplift(thickening, p, context);
    double before = 0.0, after = 0.0;
    for (std::size_t i = 0; i < rise.size(); ++i) {
      if (thickening[i] > 0.0f) {
        before += thickening[i];
        after += rise[i];
      }
      EXPECT_NEAR(rise[i] * plain(30, 45), plain[i] * rise(30, 45), 1e-12);  // scaled alike
    }
    EXPECT_NEAR(after, before, 1e-6 * before);
  }
  // Airy's model only scales, which is undone; a flexed foreland sinks.
  const auto airy = floating_uplift(thickening, {.isostasy = Isostasy::Airy}, context);
  for (std::size_t i = 0; i < airy.size(); ++i) EXPECT_NEAR(airy[i], thickening[i], 1e-9);
  const auto flexed = floating_uplift(
      thickening, {.isostasy = Isostasy::Flexure, .elastic_thickness = 8e3}, context);
  EXPECT_LT(*std::min_element(flexed.values().begin(), flexed.values().end()), 0.0f);
}

TEST(Isostasy, NothingFloatsWithoutThickening) {
  const Context context;
  const Raster<float> none(Grid{8, 8, 1e3, {}});
  EXPECT_EQ(floating_uplift(none, {.isostasy = Isostasy::Airy}, context), none);
}

}  // namespace
}  // namespace orogen
