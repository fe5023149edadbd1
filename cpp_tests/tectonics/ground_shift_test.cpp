#include "tectonics/ground_shift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gestures.h"

namespace orogen {
namespace {

const Grid kGrid{50, 40, 2e3, {-5e3, 3e3}};

TransportField one_plate(glm::dvec2 arrow) {
  return TransportField(rigid_plates(std::vector{test::box({20e3, 20e3}, {40e3, 40e3}, arrow)}));
}

Raster<float> plane(double slope_x, double slope_y) {
  Raster<float> field(kGrid);
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c)
      field(r, c) = float(slope_x * kGrid.center(r, c).x + slope_y * kGrid.center(r, c).y);
  return field;
}

TEST(GroundShift, WithoutLaterPhasesNothingMoves) {
  const Context context;
  const GroundShift none = ground_shift({}, kGrid, context);
  EXPECT_TRUE(none.empty());
  const Raster<float> field = plane(0.1, 0.2);
  EXPECT_EQ(carried(field, none, context), field);
  EXPECT_EQ(place_before({7.0, 8.0}, none), glm::dvec2(7.0, 8.0));
}

TEST(GroundShift, OnePlateCarriesEverythingByItsArrow) {
  // Equation 2 gives a plate that is alone all of the ground.
  const Context context;
  const std::vector later{one_plate({6e3, -4e3})};
  const GroundShift shift = ground_shift(later, kGrid, context);
  const Raster<float> after = carried(plane(0.1, 0.2), shift, context);
  for (int r = 4; r < kGrid.ny - 4; ++r)
    for (int c = 4; c < kGrid.nx - 4; ++c) {
      const glm::dvec2 place = kGrid.center(r, c);
      ASSERT_NEAR(after(r, c), 0.1 * (place.x - 6e3) + 0.2 * (place.y + 4e3), 1e-2);
      const glm::dvec2 before = place_before(place, shift);
      ASSERT_NEAR(before.x, place.x - 6e3, 1e-2);
      ASSERT_NEAR(before.y, place.y + 4e3, 1e-2);
    }
}

TEST(GroundShift, WhatComesFromOutsideMirrorsTheInside) {
  const Context context;
  const std::vector later{one_plate({8e3, 0.0})};  // four cells
  Raster<float> field(kGrid);
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = float(random_uniform(3, 7, i));
  const Raster<float> after = carried(field, ground_shift(later, kGrid, context), context);
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c) ASSERT_NEAR(after(r, c), field(r, std::abs(c - 4)), 1e-3);
  const Grid one{1, 1, 2e3, {20e3, 20e3}};
  const Raster<float> only(one, 7.0f);
  EXPECT_EQ(carried(only, ground_shift(later, one, context), context), only);
}

TEST(GroundShift, TheLastPhaseIsUndoneFirst) {
  const Context context;
  // A quarter turn about the origin of the map, then a step east.
  PlateGesture turned = test::box({20e3, 20e3}, {40e3, 40e3}, {0.0, 0.0});
  for (std::size_t k = 0; k < turned.points.size(); ++k) {
    const glm::dvec2 p = turned.points[k];
    turned.arrows[k] = glm::dvec2(-p.y, p.x) - p;
  }
  const std::vector later{TransportField(rigid_plates(std::vector{turned})), one_plate({6e3, 0.0})};
  const GroundShift shift = ground_shift(later, Grid{40, 40, 1e3, {-45e3, 10e3}}, context);
  // Inside the plate as both moves left it: (-y, x) + (6 km, 0).
  const glm::dvec2 place{-24e3, 30e3};
  const glm::dvec2 stepped = place - glm::dvec2(6e3, 0.0);
  const glm::dvec2 expected(stepped.y, -stepped.x);
  const glm::dvec2 direct = later[0].inverse(later[1].inverse(place));
  const glm::dvec2 before = place_before(place, shift);
  EXPECT_NEAR(before.x, direct.x, 1.0);
  EXPECT_NEAR(before.y, direct.y, 1.0);
  EXPECT_NEAR(direct.x, expected.x, 1e-6);
  EXPECT_NEAR(direct.y, expected.y, 1e-6);
}

TEST(GroundShift, FieldsKeepTheirRangeAndThreadsDoNotCount) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Raster<float> field(kGrid);
    for (std::size_t i = 0; i < field.size(); ++i) field[i] = float(random_uniform(seed, 7, i));
    std::vector<TransportField> later;
    for (int p = 0; p < 1 + int(seed % 3); ++p)
      later.emplace_back(rigid_plates(test::random_plates(seed + 100 * p)));
    Raster<float> one;
    for (const int threads : {1, 2, 4}) {
      Context context({}, threads);
      context.run([&] {
        const auto after = carried(field, ground_shift(later, kGrid, context), context);
        if (threads == 1) one = after;
        ASSERT_EQ(after, one);
      });
    }
    const auto [low, high] = std::minmax_element(one.values().begin(), one.values().end());
    ASSERT_GE(*low, 0.0f);
    ASSERT_LE(*high, 1.0f);
  }
}

}  // namespace
}  // namespace orogen
