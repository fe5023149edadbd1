#include "tectonics/map_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "plate_pair.h"
#include "tectonics/compression.h"

namespace orogen {
namespace {

TEST(MapMotion, PlatesOfAMapMoveAsTheirVelocitiesSay) {
  Context context;
  const Grid grid{100, 100, 1000.0, {}};
  const auto pair = test::make_pair(test::pair_map(), grid, {0.02, 0.0}, 0.0, context);
  const MotionPhase phase = motion_of(pair.plates, {.years = 3e6, .travel = 5000.0});
  EXPECT_EQ(phase.years, 3e6);
  ASSERT_EQ(phase.plates.size(), pair.plates.plates.size());
  double farthest = 0.0;
  for (std::size_t i = 0; i < phase.plates.size(); ++i)
    for (std::size_t k = 0; k < phase.plates[i].points.size(); ++k) {
      const glm::dvec2 arrow = phase.plates[i].arrows[k];
      const glm::dvec2 v = pair.plates.plates[i].velocity_at(phase.plates[i].points[k]);
      farthest = std::max(farthest, std::hypot(arrow.x, arrow.y));
      EXPECT_NEAR(arrow.x * v.y - arrow.y * v.x, 0.0, 1e-6);
      EXPECT_GE(arrow.x * v.x + arrow.y * v.y, 0.0);
    }
  EXPECT_NEAR(farthest, 5000.0, 1e-6);
  const auto plates = rigid_plates(phase.plates);
  EXPECT_LT(plates[0].residual_m, 1e-6);
  // They meet in the middle, where the crust thickens.
  const auto field = compression_field(TransportField(plates), grid, context);
  EXPECT_GT(field.crust(50, 50), 1.05f);
}

TEST(MapMotion, PlatesAtRestStay) {
  Context context;
  const Grid grid{50, 50, 2000.0, {}};
  const auto pair = test::make_pair(test::pair_map(), grid, {0.0, 0.0}, 0.0, context);
  for (const PlateGesture& gesture : motion_of(pair.plates, {}).plates)
    for (const glm::dvec2 arrow : gesture.arrows) EXPECT_EQ(arrow, glm::dvec2(0.0));
}

TEST(MapMotion, RefusesToPushPlatesThroughEachOther) {
  Context context;
  const Grid grid{50, 50, 2000.0, {}};
  const auto pair = test::make_pair(test::pair_map(), grid, {0.02, 0.0}, 0.0, context);
  EXPECT_THROW(motion_of(pair.plates, {.travel = 25e3}), InputError);
  EXPECT_THROW(motion_of(pair.plates, {.travel = 0.0}), InputError);
}

}  // namespace
}  // namespace orogen
