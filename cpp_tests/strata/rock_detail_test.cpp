#include "strata/rock_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

/// A ramp up through flat layers of two beds each, the lower one weaker.
struct Ramp {
  Context context;
  StratigraphicColumn column = test::three_layers();
  RockTable rocks{column, {}, StrataPalette::Map};
  Grid grid{400, 3, 5.0, {}};
  HorizonStack horizons = initial_horizons(column, grid, context);
  Raster<float> elevation{grid};

  explicit Ramp(double slope) {
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c)
        elevation(r, c) = float(-1390.0 + slope * (c + 0.5) * grid.cell_size);
  }
  Raster<float> detail(const RockDetailParameters& p) {
    return add_rock_detail({horizons, rocks, elevation}, column, p, 1, context);
  }
};

TEST(RockDetail, HardBedsStandSteeperAndLayersKeepTheirBounds) {
  Ramp ramp(0.7);
  const Raster<float> z =
      ramp.detail({.ledge_contrast = 1.0, .ledge_height = 1000.0, .roughness = 0.0});
  double slope[2] = {0.0, 0.0};
  int count[2] = {0, 0};
  for (int c = 1; c + 1 < ramp.grid.nx; ++c) {
    const float h[] = {-1400.0f, -800.0f, -500.0f, 0.0f};
    const Rock rock = ramp.rocks.rock_at(h, ramp.elevation(1, c));
    if (rock.layer != 1) continue;  // shale under sandstone
    slope[rock.sub_layer] += z(1, c + 1) - z(1, c);
    ++count[rock.sub_layer];
    EXPECT_GT(z(1, c + 1), z(1, c));
  }
  // g = e^r over its mean: the ratio of slopes is e^(0.5 - 0.15)
  EXPECT_NEAR((slope[1] / count[1]) / (slope[0] / count[0]), std::exp(0.35), 0.06);
  const auto at = [&](float height) {  // the ramp's cell nearest to a height
    return int(std::lround((height + 1390.0) / 0.7 / ramp.grid.cell_size - 0.5));
  };
  for (const float bound : {-800.0f, -500.0f}) EXPECT_NEAR(z(1, at(bound)), bound, 4.0);
}

TEST(RockDetail, FlatGroundStays) {
  Ramp ramp(0.1);
  EXPECT_EQ(ramp.detail({}), ramp.elevation);
}

TEST(RockDetail, LedgesAreHeldToTheirHeight) {
  Ramp ramp(0.7);
  const Raster<float> z =
      ramp.detail({.ledge_contrast = 5.0, .ledge_height = 15.0, .roughness = 0.0});
  float most = 0.0f;
  for (std::size_t i = 0; i < z.size(); ++i)
    most = std::max(most, std::fabs(z[i] - ramp.elevation[i]));
  EXPECT_LE(most, 15.0f);
  EXPECT_GT(most, 10.0f);
}

TEST(RockDetail, RoughnessHasItsSize) {
  Ramp ramp(0.7);
  const Raster<float> z =
      ramp.detail({.ledge_contrast = 0.0, .roughness = 10.0, .roughness_wavelength = 60.0});
  double square = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i) square += std::pow(z[i] - ramp.elevation[i], 2);
  const double deviation = std::sqrt(square / z.size());
  EXPECT_GT(deviation, 2.5);
  EXPECT_LT(deviation, 10.0);
}

TEST(RockDetail, RefusesSlopesTheWrongWayRound) {
  Ramp ramp(0.7);
  EXPECT_THROW(ramp.detail({.least_slope = 0.6, .full_slope = 0.5}), InputError);
}

}  // namespace
}  // namespace orogen
