#include "tectonics/fault_dip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

const Grid kGrid{60, 50, 500.0, {1e3, -2e3}};

struct Scene {
  Raster<float> uplift{kGrid}, fault{kGrid};
};

// A straight fault through the grid's middle; the moving side lies the way `angle` points. The
// uplift is 1 mm/yr beside the fault and grows away from it.
Scene straight(double angle) {
  Scene scene;
  const glm::dvec2 inward{std::cos(angle), std::sin(angle)};
  const glm::dvec2 middle = kGrid.origin + 0.5 * glm::dvec2(kGrid.width(), kGrid.height());
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c) {
      const glm::dvec2 d = kGrid.center(r, c) - middle;
      const double s = d.x * inward.x + d.y * inward.y;
      scene.fault(r, c) = float(s);
      scene.uplift(r, c) = s < 0.0 ? 0.0f : float(1e-3 * (1.0 + 1e-5 * s));
    }
  return scene;
}

TEST(FaultDip, TheHangingWallMovesOntoTheStableSide) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const double angle = 6.28 * random_uniform(seed, 1, 0);
    const FaultDipParameters p{true, 10.0 + 70.0 * random_uniform(seed, 2, 0), 20e3};
    const Scene scene = straight(angle);
    const auto motion = fault_motion(scene.uplift, scene.fault, p, Context{});
    for (int r = 0; r < kGrid.ny; ++r)
      for (int c = 0; c < kGrid.nx; ++c) {
        const double s = scene.fault(r, c);
        // The plane of the fault rises by tan(dip) over each metre towards the stable side.
        const double x = s / p.dip_reach, fade = (1.0 - x) * (1.0 - x) * (1.0 + 2.0 * x);
        const double speed =
            s > 0.0 && s < p.dip_reach ? 1e-3 / std::tan(p.dip_deg * 0.01745329251994) * fade : 0.0;
        EXPECT_NEAR(motion.velocity_x(r, c), -speed * std::cos(angle), 0.03 * speed + 1e-12);
        EXPECT_NEAR(motion.velocity_y(r, c), -speed * std::sin(angle), 0.03 * speed + 1e-12);
      }
  }
}

TEST(FaultDip, AnUprightFaultOrNoUpliftMovesNothingSideways) {
  Scene scene = straight(0.4);
  const auto upright = fault_motion(scene.uplift, scene.fault, {true, 90.0, 20e3}, Context{});
  for (float v : upright.velocity_x.values()) EXPECT_EQ(v, 0.0f);
  scene.uplift = Raster<float>(kGrid);
  const auto still = fault_motion(scene.uplift, scene.fault, {}, Context{});
  for (float v : still.velocity_y.values()) EXPECT_EQ(v, 0.0f);
}

TEST(FaultDip, WithoutAFaultNothingMoves) {
  const Raster<float> uplift(kGrid, 1e-3f);
  const Raster<float> none(kGrid, float(kGrid.width() + kGrid.height()));
  const auto motion = fault_motion(uplift, none, {true, 30.0, 500e3}, Context{});
  for (float v : motion.velocity_x.values()) EXPECT_EQ(v, 0.0f);
  for (float v : motion.velocity_y.values()) EXPECT_EQ(v, 0.0f);
}

TEST(FaultDip, DegenerateGridsAndThreadsGiveTheSameBytes) {
  for (const Grid& grid :
       {Grid{1, 1, 1e3, {0.0, 0.0}}, Grid{1, 31, 1e3, {0.0, 0.0}}, Grid{97, 61, 1e3, {0.0, 0.0}}}) {
    Raster<float> uplift(grid), fault(grid);
    for (std::size_t i = 0; i < grid.size(); ++i) {
      uplift[i] = float(random_uniform(1, 1, i));
      fault[i] = float(20e3 * random_normal(1, 2, i));
    }
    FaultMotion one;
    for (int threads : {1, 2, 4}) {
      Context context({}, threads);
      FaultMotion motion;
      context.run([&] { motion = fault_motion(uplift, fault, {}, context); });
      for (float v : motion.velocity_x.values()) EXPECT_TRUE(std::isfinite(v));
      if (threads == 1) one = motion;
      EXPECT_EQ(one.velocity_x, motion.velocity_x);
      EXPECT_EQ(one.velocity_y, motion.velocity_y);
    }
  }
}

TEST(FaultDip, RefusesOtherGridsAndDipsOutOfRange) {
  const Scene scene = straight(0.0);
  const Raster<float> other(Grid{3, 3, 500.0, {0.0, 0.0}});
  EXPECT_THROW(fault_motion(other, scene.fault, {}, Context{}), InputError);
  EXPECT_THROW(fault_motion(scene.uplift, scene.fault, {true, 4.0, 1e3}, Context{}), InputError);
  EXPECT_THROW(fault_motion(scene.uplift, scene.fault, {true, 91.0, 1e3}, Context{}), InputError);
}

}  // namespace
}  // namespace orogen
