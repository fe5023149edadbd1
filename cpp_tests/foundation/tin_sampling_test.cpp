#include "foundation/tin_sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

double plane(glm::dvec2 p) {
  return 100.0 + 0.03 * p.x - 0.07 * p.y;
}

std::vector<double> heights_of(const Tin& tin, double (*height)(glm::dvec2)) {
  std::vector<double> z(tin.size());
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = height(tin.points[i]);
  return z;
}

TEST(TinSampling, APlaneComesOutExactOnGridsOfEveryKind) {
  Context context;
  for (int number = 0; number < 100; ++number) {
    const auto uniform = [&](int what) { return random_uniform(number, 71, what); };
    const TinDomain domain{{1e5 * uniform(0), -1e5 * uniform(1)},
                           {200.0 + 3000.0 * uniform(2), 200.0 + 3000.0 * uniform(3)}};
    const Tin tin = (number % 2 ? jittered_tin : poisson_tin)(domain, 30.0 + 200.0 * uniform(4),
                                                              std::uint32_t(number), context);
    // Finer and coarser than the mesh; reaching past the domain.
    const Grid grid{1 + int(150 * uniform(5)), 1 + int(150 * uniform(6)), 3.0 + 50.0 * uniform(7),
                    domain.origin - glm::dvec2(100.0 * uniform(8), 40.0)};
    const Raster<float> sampled = sample_to_grid(tin, heights_of(tin, plane), grid, context);
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        const glm::dvec2 p = grid.center(r, c), high = domain.far_corner();
        const double expected = plane(
            {std::clamp(p.x, domain.origin.x, high.x), std::clamp(p.y, domain.origin.y, high.y)});
        ASSERT_NEAR(sampled(r, c), expected, 1e-6 * std::fabs(expected) + 1e-6)
            << number << ": " << r << ", " << c;
      }
  }
}

TEST(TinSampling, SeveralFieldsAtOnceAreEachAsAlone) {
  Context context;
  for (int number = 0; number < 20; ++number) {
    const Tin tin = (number % 2 ? jittered_tin : poisson_tin)({{0, 0}, {2000, 1500}}, 70.0,
                                                              std::uint32_t(number), context);
    std::vector<std::vector<double>> values(5, std::vector<double>(tin.size()));
    for (std::size_t k = 0; k < values.size(); ++k)
      for (std::size_t i = 0; i < tin.size(); ++i)
        values[k][i] = random_uniform(std::uint32_t(number), k, i);
    const std::vector<VertexField> fields(values.begin(), values.end());
    const Grid grid{91 + number, 47, 21.0, {10.0, -5.0}};
    const auto together = sample_to_grid(tin, fields, grid, context);
    ASSERT_EQ(together.size(), fields.size());
    for (std::size_t k = 0; k < fields.size(); ++k)
      EXPECT_TRUE(std::ranges::equal(together[k].values(),
                                     sample_to_grid(tin, fields[k], grid, context).values()));
  }
}

TEST(TinSampling, GridAndPointsAgree) {
  Context context;
  for (int number = 0; number < 20; ++number) {
    const Tin tin = poisson_tin({{0, 0}, {2000, 1500}}, 60.0, std::uint32_t(number), context);
    std::vector<double> z(tin.size());
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = random_uniform(number, 72, i);
    const Grid grid{173, 131, 11.7, {-5.0, 4.0}};
    const Raster<float> sampled = sample_to_grid(tin, z, grid, context);
    std::vector<glm::dvec2> centers;
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) centers.push_back(grid.center(r, c));
    const auto at_points = sample_at_points(tin, z, centers, context);
    for (std::size_t i = 0; i < centers.size(); ++i)
      ASSERT_NEAR(sampled[i], at_points[i], 1e-6) << number << ": " << i;
  }
}

TEST(TinSampling, VerticesKeepTheirValues) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {2000, 1500}}, 40.0, 5, context);
  std::vector<double> z(tin.size());
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = random_uniform(5, 73, i);
  const auto same = sample_at_points(tin, z, tin.points, context);
  for (std::size_t i = 0; i < z.size(); ++i) ASSERT_NEAR(same[i], z[i], 1e-9);
}

TEST(TinSampling, CoarseToFineKeepsPlanesAndRange) {
  Context context;
  const TinDomain domain{{10, 20}, {5000, 4000}};
  const Tin coarse = jittered_tin(domain, 300.0, 1, context);
  const Tin fine = poisson_tin(domain, 70.0, 2, context);
  const auto z = sample_at_points(coarse, heights_of(coarse, plane), fine.points, context);
  for (std::size_t i = 0; i < z.size(); ++i) ASSERT_NEAR(z[i], plane(fine.points[i]), 1e-9);
}

TEST(TinSampling, RastersAreReadBilinearly) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {1000, 1000}}, 37.0, 1, context);
  const Grid grid{25, 25, 40.0, {0, 0}};
  Raster<float> raster(grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) raster(r, c) = float(plane(grid.center(r, c)));
  const auto z = sample_at_points(raster, tin.points, context);
  for (std::size_t i = 0; i < z.size(); ++i) {
    const glm::dvec2 p = tin.points[i];
    ASSERT_NEAR(z[i], plane({std::clamp(p.x, 20.0, 980.0), std::clamp(p.y, 20.0, 980.0)}), 2e-5);
  }
  const Raster<float> one(Grid{1, 1, 40.0, {0, 0}}, 3.0f);
  for (double v : sample_at_points(one, tin.points, context)) ASSERT_EQ(v, 3.0);
}

TEST(TinSampling, VolumeIsTheSumOverCells) {
  // A fine grid's mean converges to the exact volume under the triangles.
  Context context;
  const Tin tin = poisson_tin({{0, 0}, {1000, 1000}}, 100.0, 4, context);
  std::vector<double> z(tin.size());
  double volume = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    z[i] = 50.0 * random_uniform(4, 74, i);
    volume += z[i] * tin.cell_areas[i];
  }
  const Grid grid{2000, 2000, 0.5, {0, 0}};
  const Raster<float> fine = sample_to_grid(tin, z, grid, context);
  const double mean = std::accumulate(fine.values().begin(), fine.values().end(), 0.0) / 4e6;
  EXPECT_NEAR(mean, volume / 1e6, 1e-4);
}

TEST(TinSampling, ThreadsDoNotMatter) {
  const Grid grid{200, 190, 10.0, {0, 0}};
  Raster<float> first;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      const Tin tin = poisson_tin({{0, 0}, {2000, 1900}}, 23.0, 8, context);
      std::vector<double> z(tin.size());
      for (std::size_t i = 0; i < z.size(); ++i) z[i] = random_uniform(5, 73, i);
      const Raster<float> sampled = sample_to_grid(tin, z, grid, context);
      if (threads == 1) first = sampled;
      EXPECT_EQ(sampled, first);
    });
  }
}

TEST(TinSampling, RefusesFieldsOfAnotherSize) {
  Context context;
  const Tin tin = jittered_tin({{0, 0}, {100, 100}}, 30.0, 5, context);
  const std::vector<double> z(tin.size() + 1);
  EXPECT_THROW(sample_to_grid(tin, z, Grid{3, 3, 1.0, {}}, context), InputError);
  EXPECT_THROW(sample_at_points(tin, z, tin.points, context), InputError);
  EXPECT_THROW(sample_at_points(Raster<float>(), tin.points, context), InputError);
}

}  // namespace
}  // namespace orogen
