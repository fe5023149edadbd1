#include "inputs/plate_gesture.h"

#include <gtest/gtest.h>

#include <limits>

#include "foundation/errors.h"

namespace orogen {
namespace {

PlateGesture gesture_of(std::size_t points, std::size_t arrows) {
  PlateGesture gesture;
  gesture.points.assign(points, {1e3, 2e3});
  gesture.arrows.assign(arrows, {5e3, 0.0});
  return gesture;
}

std::string refusal(const std::vector<PlateGesture>& gestures) {
  try {
    check_gestures(gestures, "plates");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PlateGesture, SoundOnesPass) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({gesture_of(1, 1), gesture_of(10'000, 10'000)}), "");
}

TEST(PlateGesture, NamesWhatIsWrongAndWhere) {
  EXPECT_EQ(refusal({gesture_of(1, 1), gesture_of(0, 0)}),
            "plates[1].points: 0 points; 1 to 10000 are allowed");
  EXPECT_EQ(refusal({gesture_of(10'001, 10'001)}),
            "plates[0].points: 10001 points; 1 to 10000 are allowed");
  EXPECT_EQ(refusal({gesture_of(3, 2)}),
            "plates[0].arrows: 2 arrows for 3 points; one a point is wanted");
  EXPECT_EQ(refusal(std::vector<PlateGesture>(1001, gesture_of(1, 1))),
            "plates: 1001 plates; at most 1000 are allowed");
  EXPECT_EQ(refusal(std::vector<PlateGesture>(10, gesture_of(10'000, 10'000))), "");
  EXPECT_EQ(refusal(std::vector<PlateGesture>(11, gesture_of(10'000, 10'000))),
            "plates: more than 100000 points in all are not allowed");
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -2e8}) {
    auto gesture = gesture_of(3, 3);
    gesture.points[2].y = bad;
    EXPECT_EQ(refusal({gesture}),
              "plates[0].points[2]: finite numbers from -1e8 to 1e8 m are wanted");
    gesture = gesture_of(3, 3);
    gesture.arrows[1].x = bad;
    EXPECT_EQ(refusal({gesture}),
              "plates[0].arrows[1]: finite numbers from -1e8 to 1e8 m are wanted");
  }
  auto gesture = gesture_of(1, 1);
  gesture.crust = PlateCrust(7);
  EXPECT_EQ(refusal({gesture}), "plates[0].crust: continental or oceanic is wanted");
}

}  // namespace
}  // namespace orogen
