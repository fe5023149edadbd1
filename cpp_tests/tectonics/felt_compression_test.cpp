#include "tectonics/felt_compression.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "gestures.h"
#include "tectonics/collision_uplift.h"
#include "tectonics/smoothed_compression.h"

namespace orogen {
namespace {

const Grid kGrid{60, 50, 2e3, {-10e3, 0.0}};

struct Scene {
  TransportField transport;
  CompressionField field;
  Raster<float> convergence;
};

Scene scene(glm::dvec2 arrow, PlateCrust west_crust, const Context& context) {
  std::vector<PlateGesture> gestures{test::box({15e3, 20e3}, {35e3, 80e3}, arrow),
                                     test::box({65e3, 20e3}, {85e3, 80e3}, {0.0, 0.0})};
  gestures[0].crust = west_crust;
  Scene made{TransportField(rigid_plates(gestures)), {}, {}};
  made.field = compression_field(made.transport, kGrid, context);
  made.convergence = plate_convergence(made.transport, kGrid, 5e3, context);
  return made;
}

double strength(const CompressionField& field, std::size_t i) {
  return std::hypot(field.compression_x[i], field.compression_y[i]);
}

TEST(FeltCompression, IsTheFieldWeighedAndWithoutSmoothingNoMore) {
  const Context context;
  const Scene s = scene({10e3, 0.0}, PlateCrust::Continental, context);
  const auto felt = felt_compression(s.transport, s.field, s.convergence, 0.0, context);
  double most = 0.0;
  for (std::size_t i = 0; i < kGrid.size(); ++i) {
    EXPECT_EQ(felt.compression_x[i], s.field.compression_x[i] * s.convergence[i]);
    EXPECT_EQ(felt.compression_y[i], s.field.compression_y[i] * s.convergence[i]);
    most = std::max(most, strength(felt, i));
  }
  EXPECT_GT(most, 0.1);
}

TEST(FeltCompression, PlatesThatPartFoldNothing) {
  const Context context;
  const Scene s = scene({-10e3, 0.0}, PlateCrust::Continental, context);
  const auto felt = felt_compression(s.transport, s.field, s.convergence, 4e3, context);
  double behind = 0.0, left = 0.0;
  for (std::size_t i = 0; i < kGrid.size(); ++i) {
    behind = std::max(behind, strength(s.field, i));
    left = std::max(left, strength(felt, i));
  }
  EXPECT_GT(behind, 0.05);  // eq. 2 squeezes the ground behind them
  EXPECT_LT(left, 0.05 * behind);
}

TEST(FeltCompression, OceanicCrustDoesNotFold) {
  const Context context;
  const Scene s = scene({10e3, 0.0}, PlateCrust::Oceanic, context);
  const auto felt = felt_compression(s.transport, s.field, s.convergence, 0.0, context);
  int continental = 0;
  for (std::size_t i = 0; i < kGrid.size(); ++i)
    if (s.field.plate[i] == 0)
      EXPECT_EQ(strength(felt, i), 0.0);
    else
      continental += strength(felt, i) > 0.05;
  EXPECT_GT(continental, 50);
}

TEST(FeltCompression, RefusesAnotherGrid) {
  const Context context;
  const Scene s = scene({10e3, 0.0}, PlateCrust::Continental, context);
  EXPECT_THROW(
      felt_compression(s.transport, s.field, Raster<float>(Grid{3, 3, 1.0, {}}), 0.0, context),
      InputError);
}

TEST(MeanCompression, IsThatOfTheGroundThatRises) {
  const Context context;
  const Grid grid{4, 2, 1e3, {}};
  CompressionField field;
  field.compression_x = Raster<float>(grid);
  field.compression_y = Raster<float>(grid, 0.4f);
  Raster<float> rate(grid);
  EXPECT_EQ(mean_compression(field, rate, context), 1.0);
  field.compression_x[1] = 0.3f;
  field.compression_y[2] = 0.1f;
  rate[1] = 1e-3f;
  rate[2] = 5e-4f;
  rate[3] = 0.5e-5f;  // under 1% of the greatest
  EXPECT_NEAR(mean_compression(field, rate, context), 0.5 * (0.5 + 0.1), 1e-7);
  EXPECT_EQ(mean_compression({}, {}, context), 1.0);
  field.compression_x = field.compression_y = Raster<float>(grid);
  EXPECT_EQ(mean_compression(field, rate, context), 1e-3);
}

}  // namespace
}  // namespace orogen
