#include "erosion/fitted_growth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "foundation/gaussian_blur.h"
#include "foundation/noise.h"

namespace orogen {
namespace {

const Grid kGrid{200, 150, 200.0, {0.0, 0.0}};

/// Two ranges by a sea in the west, on rough ground.
struct Ground {
  Raster<float> elevation{kGrid}, erodibility{kGrid, 3e-6f};
  Raster<std::int32_t> land{kGrid, 1};

  Ground() {
    Context context;
    const Raster<float> rough =
        fbm({.seed = 3, .wavelength = 5000.0, .octaves = 6}, kGrid, context);
    const auto hill = [](double x, double y, double height, double width) {
      return height * std::exp(-(x * x + y * y) / (width * width));
    };
    for (int r = 0; r < kGrid.ny; ++r)
      for (int c = 0; c < kGrid.nx; ++c) {
        land(r, c) = c >= 20;
        const double z = 120.0 + hill(c - 90.0, r - 50.0, 1500.0, 30.0) +
                         hill(c - 150.0, r - 110.0, 900.0, 40.0) + 40.0 * rough(r, c);
        elevation(r, c) = c < 20 ? -80.0f : float(std::max(z, 1.0));
      }
  }
  FittedGrowth grow(const FittedGrowthParameters& parameters = {}) const {
    Context context;
    return grow_towards(elevation, land, erodibility, parameters, context);
  }
  bool is_base(int r, int c) const {
    return !land(r, c) || r == 0 || r == kGrid.ny - 1 || c == kGrid.nx - 1;
  }
};

/// Root mean square of the difference on land, both blurred over `radius` (m).
double difference(const Ground& ground, const Raster<float>& grown, double radius) {
  Context context;
  Raster<float> change(kGrid);
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = grown[i] - ground.elevation[i];
  change = gaussian_blur(change, radius, context);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < change.size(); ++i)
    if (ground.land[i]) sum += change[i] * change[i], ++count;
  return std::sqrt(sum / count);
}

TEST(FittedGrowth, StandsAtLargeWhereTheGivenGroundDoes) {
  const Ground ground;
  const FittedGrowth made = ground.grow();
  EXPECT_LT(difference(ground, made.elevation, 4000.0), 15.0);  // m, of 1500
  EXPECT_GT(difference(ground, made.elevation, 200.0), 30.0);   // it is other ground
  EXPECT_GT(
      difference(ground,
                 ground.grow({.coarse_steps = 1, .middle_steps = 1, .finest_steps = 1}).elevation,
                 4000.0),
      30.0);  // and the fit is what does it
}

TEST(FittedGrowth, SeaAndSidesStay) {
  const Ground ground;
  const FittedGrowth made = ground.grow();
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c)
      if (ground.is_base(r, c)) {
        EXPECT_EQ(made.elevation(r, c), ground.elevation(r, c));
      }
}

TEST(FittedGrowth, RisesNowhereFasterThanHillslopesAtTalusWearDown) {
  Ground ground;
  for (float& z : ground.elevation.values()) z *= 5.0f;
  const FittedGrowthParameters p;
  const FittedGrowth made = ground.grow(p);
  const double most = 1.3 * 3e-6 * std::tan(p.talus_angle_deg * M_PI / 180.0) *
                      std::pow(p.hillslope_area, p.area_exponent);
  double highest = 0.0;
  for (const float u : made.uplift_rate.values()) highest = std::max(highest, double(u));
  EXPECT_LE(highest, most * 1.0001);
  EXPECT_GT(highest, most * 0.99);
}

TEST(FittedGrowth, TheSameBytesForAnyNumberOfThreads) {
  const Ground ground;
  Raster<float> made[2];
  for (const int threads : {1, 2}) {
    Context context({}, threads);
    context.run([&] {
      made[threads - 1] =
          grow_towards(ground.elevation, ground.land, ground.erodibility, {}, context).elevation;
    });
  }
  EXPECT_EQ(made[0], made[1]);
}

TEST(FittedGrowth, WithoutLandNothingGrows) {
  Ground ground;
  for (std::int32_t& land : ground.land.values()) land = 0;
  EXPECT_EQ(ground.grow().elevation, ground.elevation);
}

TEST(FittedGrowth, FieldsOfOtherGridsAreRefused) {
  Ground ground;
  ground.erodibility = Raster<float>(Grid{3, 3, 1.0, {0.0, 0.0}}, 1e-6f);
  EXPECT_THROW(ground.grow(), InputError);
}

}  // namespace
}  // namespace orogen
