#include "tectonics/sub_plates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/errors.h"
#include "foundation/random.h"
#include "tectonics/boundaries.h"
#include "tectonics/plate_pair.h"

namespace orogen {
namespace {

using test::map_of;

std::vector<glm::dvec2> random_peaks(std::uint64_t seed, int n) {
  std::vector<glm::dvec2> peaks;
  for (int i = 0; i < n; ++i)
    peaks.push_back({100e3 * random_uniform(seed, 1, i), 100e3 * random_uniform(seed, 2, i)});
  return peaks;
}

int nearest(const std::vector<glm::dvec2>& peaks, glm::dvec2 p) {
  int best = 0;
  for (int i = 1; i < int(peaks.size()); ++i)
    if (std::hypot(peaks[i].x - p.x, peaks[i].y - p.y) <
        std::hypot(peaks[best].x - p.x, peaks[best].y - p.y))
      best = i;
  return best;
}

TEST(SubPlates, RasterIsThePlateOfTheNearestPeak) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 70);
  for (int seed = 0; seed < 100; ++seed) {
    const auto peaks = random_peaks(seed, 1 + seed % 40);
    PlateParameters parameters;
    parameters.boundary_roughness = 0.0;
    parameters.line_boundaries = parameters.volcanoes = false;
    const auto result = infer_plates(map_of(peaks), grid, parameters, 1, context);
    std::vector<int> plate_of(peaks.size(), -1);
    double area = 0.0;
    for (int k = 0; k < int(result.plates.size()); ++k) {
      for (int p : result.plates[k].peaks) plate_of[p] = k;
      area += result.plates[k].area;
    }
    EXPECT_NEAR(area, 1e10, 1.0);
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        const int peak = nearest(peaks, grid.center(r, c));
        ASSERT_EQ(result.plate(r, c), plate_of[peak]);
        ASSERT_NEAR(
            result.peak_distance(r, c),
            std::hypot(peaks[peak].x - grid.center(r, c).x, peaks[peak].y - grid.center(r, c).y),
            0.1);
      }
  }
}

TEST(SubPlates, EverySeparatePlateObeysTheThresholds) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 32);
  for (int seed = 0; seed < 100; ++seed) {
    const PlateParameters parameters;
    const auto result = infer_plates(map_of(random_peaks(seed, 30)), grid, parameters, 1, context);
    for (const PlateSide& side : result.sides) {
      const Plate &a = result.plates[side.left], &b = result.plates[side.right];
      if (std::hypot(side.b.x - side.a.x, side.b.y - side.a.y) < 1.0) continue;
      std::vector<int> both;  // the two sides of a line of peaks share its peaks, and stay apart
      std::set_intersection(a.peaks.begin(), a.peaks.end(), b.peaks.begin(), b.peaks.end(),
                            std::back_inserter(both));
      if (!both.empty()) continue;
      EXPECT_GE(a.area / b.area, parameters.merge_area * (1 - 1e-9));
      EXPECT_GE(b.area / a.area, parameters.merge_area * (1 - 1e-9));
      const double dot = a.velocity.x * b.velocity.x + a.velocity.y * b.velocity.y;
      EXPECT_LE(dot, parameters.merge_direction * std::hypot(a.velocity.x, a.velocity.y) *
                             std::hypot(b.velocity.x, b.velocity.y) +
                         1e-12);
    }
    for (const Plate& plate : result.plates)
      EXPECT_LE(std::hypot(plate.velocity.x, plate.velocity.y), parameters.plate_speed * 1.0001);
  }
}

// Share of the line from the first peak to the last that has a boundary between two converging
// plates within `distance`.
double share_along(const PlateMap& plates, glm::dvec2 from, glm::dvec2 to, double distance) {
  const Context context;
  const auto boundaries = plate_boundaries(plates, {}, context).boundaries;
  int near = 0;
  for (int k = 0; k <= 1000; ++k) {
    const glm::dvec2 p = from + (k / 1000.0) * (to - from);
    double best = std::numeric_limits<double>::infinity();
    for (const PlateBoundary& b : boundaries)
      for (std::size_t i = 0; i < b.points.size(); ++i)
        if (b.kind[i] == PlateBoundaryKind::Convergent)
          best = std::min(best, std::hypot(b.points[i].x - p.x, b.points[i].y - p.y));
    near += best <= distance;
  }
  return near / 1001.0;
}

TEST(SubPlates, ALineOfTenPeaksGivesOneBoundaryAlongIt) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 200);
  for (double angle : {0.0, 0.4, 1.2, 2.0})
    for (int seed = 0; seed < 5; ++seed) {
      const glm::dvec2 along{std::cos(angle), std::sin(angle)};
      std::vector<glm::dvec2> peaks;
      for (int i = 0; i < 10; ++i)
        peaks.push_back(glm::dvec2(50e3) + (i - 4.5) * 7e3 * along +
                        1500.0 *
                            glm::dvec2(random_uniform(seed, 1, i), random_uniform(seed, 2, i)));
      const auto result = infer_plates(map_of(peaks), grid, {}, seed, context);
      EXPECT_EQ(result.plates.size(), 2u);
      EXPECT_GT(share_along(result, peaks.front(), peaks.back(), 7e3), 0.9);
      const auto boundaries = plate_boundaries(result, {}, context);
      for (const PlateBoundary& b : boundaries.boundaries) {  // no cut across the line
        const double across = std::hypot(b.points.back().x - b.points.front().x,
                                         b.points.back().y - b.points.front().y);
        EXPECT_GT(across, 60e3);
      }
    }
  // Without the option the cells cut between the peaks, as the paper says.
  std::vector<glm::dvec2> peaks;
  for (int i = 0; i < 10; ++i) peaks.push_back({18e3 + 7e3 * i, 50e3});
  PlateParameters plain;
  plain.line_boundaries = false;
  EXPECT_LT(share_along(infer_plates(map_of(peaks), grid, plain, 1, context), peaks.front(),
                        peaks.back(), 3.4e3),
            0.5);
}

TEST(SubPlates, FewPeaks) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 30);
  const auto none = infer_plates(map_of({}), grid, {}, 1, context);
  ASSERT_EQ(none.plates.size(), 1u);
  EXPECT_EQ(none.plates[0].velocity, glm::dvec2(0.0));
  EXPECT_NEAR(none.plates[0].area, 1e10, 1.0);
  const auto one = infer_plates(map_of({{30e3, 40e3}}), grid, {}, 1, context);
  EXPECT_EQ(one.plates.size(), 1u);
  EXPECT_EQ(one.volcanoes, std::vector<int>{0});
  const auto two = infer_plates(map_of({{30e3, 50e3}, {70e3, 50e3}}), grid, {}, 1, context);
  EXPECT_EQ(two.plates.size(), 2u);
  EXPECT_GT(two.plates[0].velocity.x, 0.0);
  EXPECT_LT(two.plates[1].velocity.x, 0.0);
  const auto same = infer_plates(map_of({{30e3, 50e3}, {30e3, 50e3}}), grid, {}, 1, context);
  EXPECT_EQ(same.plates.size(), 1u);
  const auto outside =
      infer_plates(map_of({{-30e3, 50e3}, {-40e3, 20e3}, {150e3, 9e3}}), grid, {}, 1, context);
  EXPECT_GE(outside.plates.size(), 1u);
  for (int p : outside.plate.values()) EXPECT_LT(p, int(outside.plates.size()));
  EXPECT_EQ(
      infer_plates(map_of({{5e3, 5e3}}), {1, 1, 10.0, {0.0, 0.0}}, {}, 1, context).plate.size(),
      1u);
}

TEST(SubPlates, TheMapMaySayWhichPeaksAreVolcanoes) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 30);
  auto map = map_of({{30e3, 50e3}, {70e3, 50e3}, {50e3, 90e3}});
  map.peaks[2].volcano = true;
  const auto said = infer_plates(map, grid, {}, 1, context);
  EXPECT_EQ(said.volcanoes, std::vector<int>{2});
  for (const Plate& plate : said.plates)
    EXPECT_EQ(std::count(plate.peaks.begin(), plate.peaks.end(), 2), 0);
  auto one = map_of({{30e3, 40e3}});
  one.peaks[0].volcano = false;
  EXPECT_TRUE(infer_plates(one, grid, {}, 1, context).volcanoes.empty());
}

TEST(SubPlates, UserMotionsReplaceInferredOnes) {
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 50);
  const auto pair = test::make_pair(test::pair_map(), grid, {-0.01, 0.002}, 1e-7, context);
  ASSERT_EQ(pair.plates.plates.size(), 2u);
  const Plate& west = pair.plates.plates[pair.plates.plate(25, 5)];
  EXPECT_EQ(west.velocity, glm::dvec2(-0.01, 0.002));
  EXPECT_NEAR(west.velocity_at(west.centroid + glm::dvec2(0.0, 1e4)).x, -0.01 - 1e-3, 1e-12);
  const PlateMotion bad[] = {{{0.0, 0.0}, {std::nan(""), 0.0}, 0.0}};
  EXPECT_THROW(infer_plates(test::pair_map(), grid, {}, 1, context, bad), InputError);
}

TEST(SubPlates, SameForAnyNumberOfThreadsAndAtAnyResolution) {
  const auto map = map_of(random_peaks(4, 25), 1500.0, {100e3, 73e3});
  const Grid fine = grid_over({0.0, 0.0}, map.frame.size, 300);
  PlateMap first;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      auto result = infer_plates(map, fine, {}, 9, context);
      if (first.plates.empty())
        first = std::move(result);
      else
        EXPECT_EQ(result.plate, first.plate);
    });
  }
  const Context context;
  const Grid coarse = grid_over({0.0, 0.0}, map.frame.size, 100);
  const auto result = infer_plates(map, coarse, {}, 9, context);
  ASSERT_EQ(result.plates.size(), first.plates.size());
  for (std::size_t k = 0; k < result.plates.size(); ++k)
    EXPECT_EQ(result.plates[k].velocity, first.plates[k].velocity);
  for (int r = 0; r < coarse.ny; ++r)
    for (int c = 0; c < coarse.nx; ++c)
      if (fine.contains(3 * r + 1, 3 * c + 1)) {
        ASSERT_EQ(result.plate(r, c), first.plate(3 * r + 1, 3 * c + 1));
      }
}

}  // namespace
}  // namespace orogen
