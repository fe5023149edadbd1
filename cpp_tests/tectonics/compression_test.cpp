#include "tectonics/compression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gestures.h"
#include "tectonics/voronoi.h"

namespace orogen {
namespace {

CompressionField field_of(const TransportField& transport, const Grid& grid, int threads = 0) {
  Context context({}, threads);
  CompressionField result;
  context.run([&] { result = compression_field(transport, grid, context); });
  return result;
}

const std::vector<Grid> kGrids{{1, 1, 3e3, {40e3, 40e3}},
                               {1, 97, 1e3, {50e3, 0.0}},
                               {131, 1, 900.0, {0.0, 45e3}},
                               {97, 89, 1100.0, {-5e3, -2e3}},
                               {64, 128, 800.0, {20e3, 0.0}}};

TEST(Compression, CrustIsThatOfThePreimageOfTheGridsBorder) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const TransportField transport(rigid_plates(test::random_plates(seed)));
    const Grid& grid = kGrids[seed % kGrids.size()];
    const auto field = field_of(transport, grid);
    const auto corner = [&](int r, int c) {
      return transport.inverse(grid.origin + grid.cell_size * glm::dvec2(c, r));
    };
    Ring border;
    for (int c = 0; c < grid.nx; ++c) border.push_back(corner(0, c));
    for (int r = 0; r < grid.ny; ++r) border.push_back(corner(r, grid.nx));
    for (int c = grid.nx; c > 0; --c) border.push_back(corner(grid.ny, c));
    for (int r = grid.ny; r > 0; --r) border.push_back(corner(r, 0));
    const double area = ring_area(border), whole = grid.width() * grid.height();
    EXPECT_NEAR(field.source_area_m2, area, 1e-9 * whole);
    double sum = 0.0;
    for (float q : field.crust.values()) sum += q;
    EXPECT_NEAR(sum * grid.cell_area(), area, 1e-6 * whole);
  }
}

TEST(Compression, AmountIsTheAreaOfEachQuadrangle) {
  const TransportField transport(rigid_plates(test::random_plates(4)));
  const Grid grid = kGrids[3];
  const auto field = field_of(transport, grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      Ring quadrangle;
      for (const auto& [i, j] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 0}})
        quadrangle.push_back(
            transport.inverse(grid.origin + grid.cell_size * glm::dvec2(c + j, r + i)));
      EXPECT_NEAR(field.crust(r, c), ring_area(quadrangle) / grid.cell_area(), 1e-6);
    }
}

// F = R D, with D = diag(a, b) in axes turned by `axis`: U = D, whatever the rotation R.
TEST(Compression, StretchOfKnownShearAndRotation) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const double a = 0.2 + 0.8 * random_uniform(seed, 1, 0),
                 b = a + 2.0 * random_uniform(seed, 2, 0);
    const double axis = 3.14159265358979 * random_uniform(seed, 3, 0);
    const double turn = seed % 4 ? 6.0 * random_uniform(seed, 4, 0) : 0.0;
    const double c = std::cos(axis), s = std::sin(axis), p = std::cos(turn), q = std::sin(turn);
    // Inverse: D⁻¹ Rᵀ.
    const double xx = c * c / a + s * s / b, xy = c * s / a - c * s / b, yy = s * s / a + c * c / b;
    const Stretch stretch =
        stretch_of(xx * p - xy * q, xx * q + xy * p, xy * p - yy * q, xy * q + yy * p);
    EXPECT_NEAR(stretch.smaller, a, 1e-9);
    EXPECT_NEAR(stretch.larger, b, 1e-9);
    EXPECT_NEAR(
        stretch.direction_x * stretch.direction_x + stretch.direction_y * stretch.direction_y, 1.0,
        1e-12);
    if (b - a > 1e-3) {
      EXPECT_NEAR(std::fabs(c * stretch.direction_x + s * stretch.direction_y), 1.0, 1e-9);
    }
  }
  const Stretch rotation = stretch_of(0.6, -0.8, 0.8, 0.6);
  EXPECT_NEAR(rotation.smaller, 1.0, 1e-15);
  EXPECT_NEAR(rotation.larger, 1.0, 1e-15);
}

TEST(Compression, RigidPartsAreNotSqueezedEvenIfTheyTurn) {
  const auto plates =
      rigid_plates(std::vector{test::random_gesture(1, {30e3, 50e3}, 15e3, 40, 0.5, {2e3, 1e3}),
                               test::random_gesture(2, {80e3, 50e3}, 10e3, 40, -0.3, {-4e3, 0.0})});
  const TransportField transport(plates);
  const Grid grid = kGrids[3];
  const auto field = field_of(transport, grid);
  int inside = 0;
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      const glm::dvec2 p = grid.center(r, c);
      const int nearest = transport.nearest_plate(p);
      EXPECT_EQ(field.plate(r, c), nearest);
      bool within = true;
      for (const glm::dvec2 d : {glm::dvec2(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
        within = within && transport.distance(nearest, p + grid.cell_size * d) == 0.0;
      if (!within) continue;
      ++inside;
      EXPECT_NEAR(field.crust(r, c), 1.0, 1e-6);
      EXPECT_EQ(field.compression_x(r, c), 0.0f);
      EXPECT_EQ(field.compression_y(r, c), 0.0f);
    }
  EXPECT_GT(inside, 500);
}

TEST(Compression, ConvergingPlatesSqueezeTheGroundBetween) {
  const TransportField transport(rigid_plates(test::facing_pair(8e3)));
  const Grid grid{101, 20, 1e3, {-500.0, 40e3}};
  const auto field = field_of(transport, grid);
  for (int c = 42; c <= 58; ++c) {  // hulls end at 38 and 62 km
    EXPECT_GT(field.crust(10, c), 1.2f);
    EXPECT_GT(std::fabs(field.compression_x(10, c)), 0.15f);
    EXPECT_NEAR(field.compression_y(10, c), 0.0f, 1e-3f);
    // 1 / ν₁ is the shortening, and nothing stretches along the plates.
    EXPECT_NEAR(field.crust(10, c), 1.0f / (1.0f - std::fabs(field.compression_x(10, c))), 1e-3f);
  }
  float whole = 0.0f;
  for (int c = 39; c <= 61; ++c) whole += field.crust(10, c);
  EXPECT_NEAR(whole, 23.0f + 16.0f * 23.0f / 24.0f, 1.5f);  // 40 km of ground in 24 km
}

TEST(Compression, PartingPlatesDoNot) {
  const TransportField transport(rigid_plates(test::facing_pair(-8e3)));
  const Grid grid{101, 20, 1e3, {-500.0, 40e3}};
  const auto field = field_of(transport, grid);
  for (int c = 24; c <= 76; ++c) {
    EXPECT_LT(field.crust(10, c), 0.9f);
    EXPECT_NEAR(field.compression_x(10, c), 0.0f, 1e-5f);
    EXPECT_NEAR(field.compression_y(10, c), 0.0f, 1e-5f);
  }
}

TEST(Compression, OnePlateAloneThickensNothing) {
  for (double angle : {0.0, 0.4}) {
    const TransportField transport(rigid_plates(
        std::vector{test::random_gesture(5, {50e3, 45e3}, 15e3, 9, angle, {8e3, 3e3})}));
    const auto field = field_of(transport, kGrids[3]);
    // Where a turning plate's motion has a kink, a cell that straddles it may be anything near 1.
    int more = 0;
    for (float q : field.crust.values()) more += q > 1.0f + 1e-6f;
    EXPECT_LE(more, angle == 0.0 ? 0 : 97 * 89 / 30);
    EXPECT_LE(field.source_area_m2, kGrids[3].width() * kGrids[3].height() * (1.0 + 1e-9));
  }
}

TEST(Compression, WithoutPlatesThereIsNone) {
  const auto field = field_of(TransportField({}), kGrids[3]);
  for (float q : field.crust.values()) EXPECT_NEAR(q, 1.0f, 1e-6f);
  for (float c : field.compression_x.values()) EXPECT_EQ(c, 0.0f);
  for (int plate : field.plate.values()) EXPECT_EQ(plate, -1);
}

TEST(Compression, ThreadsGiveTheSameBytes) {
  const TransportField transport(rigid_plates(test::random_plates(9)));
  const Grid grid{257, 193, 450.0, {0.0, 0.0}};
  const auto one = field_of(transport, grid, 1);
  for (int threads : {2, 4}) {
    const auto many = field_of(transport, grid, threads);
    EXPECT_EQ(one.crust, many.crust);
    EXPECT_EQ(one.compression_x, many.compression_x);
    EXPECT_EQ(one.compression_y, many.compression_y);
    EXPECT_EQ(one.plate, many.plate);
    EXPECT_EQ(one.source_area_m2, many.source_area_m2);
  }
}

TEST(Compression, StopsWhenAsked) {
  Context context;
  context.cancel();
  EXPECT_THROW(compression_field(TransportField({}), kGrids[3], context), Cancelled);
}

}  // namespace
}  // namespace orogen
