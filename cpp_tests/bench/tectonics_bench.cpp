// Paper A's stages up to the combination on 1024 x 1024 cells: 26 peaks, a ragged island, rivers.
#include <benchmark/benchmark.h>

#include <cmath>

#include "folding/warped_folds.h"
#include "foundation/distance_transform.h"
#include "foundation/gaussian_blur.h"
#include "foundation/noise.h"
#include "foundation/random.h"
#include "hydrology/river_beds.h"
#include "sculpting/combination.h"
#include "tectonics/boundaries.h"
#include "tectonics/velocity_map.h"

namespace orogen {
namespace {

struct Scene {
  Context context;
  Grid grid = grid_over({0.0, 0.0}, glm::dvec2(200e3), 1024);
  VectorMap map;
  Raster<std::uint8_t> land{grid};
  PlateMap plates;
  BoundaryMap boundaries;
  VelocityMap velocity;
  Raster<float> folds;
  RiverBeds beds;
  WatershedMap watershed;

  Scene() {
    map.frame.size = glm::dvec2(200e3);
    for (int i = 0; i < 26; ++i) {
      map.peaks.push_back({});
      map.peaks.back().position = {40e3 + 120e3 * random_uniform(1, 1, i),
                                   40e3 + 120e3 * random_uniform(1, 2, i)};
      map.peaks.back().height_m = 1000.0 + 1700.0 * random_uniform(1, 3, i);
    }
    const auto noise = fbm({.seed = 1, .wavelength = 80e3}, grid, context);
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        const glm::dvec2 d = (grid.center(r, c) - glm::dvec2(100e3)) / 90e3;
        land(r, c) = std::hypot(d.x, d.y) + 0.1 * noise(r, c) < 1.0;
      }
    for (int i = 0; i < 10; ++i) {
      const glm::dvec2 way{std::cos(0.63 * i), std::sin(0.63 * i)};
      map.rivers.push_back({});
      for (int k = 0; k < 30; ++k)
        map.rivers.back().points.push_back(glm::dvec2(100e3) + (15e3 + 3e3 * k) * way +
                                           2e3 * std::sin(0.7 * k) * glm::dvec2(-way.y, way.x));
    }
    plates = infer_plates(map, grid, {}, 1, context);
    boundaries = plate_boundaries(plates, {}, context);
    velocity = velocity_map(plates, {}, context);
    folds = warped_folds(map, plates, boundaries, velocity, {}, 1, context);
    beds = lay_river_beds(map, land, 0.0, 1e3, 1);
    watershed = watershed_map(map, beds, land, plates.peak_distance, {}, context);
  }
};

Scene& scene() {
  static Scene s;
  return s;
}

template <class Work>
void measure(benchmark::State& state, Work work) {
  Scene& s = scene();
  for (auto _ : state) benchmark::DoNotOptimize(work(s));
}

void plates(benchmark::State& state) {
  measure(state, [](Scene& s) { return infer_plates(s.map, s.grid, {}, 1, s.context); });
}
void boundaries(benchmark::State& state) {
  measure(state, [](Scene& s) { return plate_boundaries(s.plates, {}, s.context); });
}
void velocity(benchmark::State& state) {
  measure(state, [](Scene& s) { return velocity_map(s.plates, {}, s.context); });
}
void folds(benchmark::State& state) {
  measure(state, [](Scene& s) {
    return warped_folds(s.map, s.plates, s.boundaries, s.velocity, {}, 1, s.context);
  });
}
void watershed(benchmark::State& state) {
  measure(state, [](Scene& s) {
    return watershed_map(s.map, s.beds, s.land, s.plates.peak_distance, {}, s.context);
  });
}
void combination(benchmark::State& state) {
  measure(state,
          [](Scene& s) { return combine_relief(s.folds, s.watershed, s.land, {}, s.context); });
}
void blur(benchmark::State& state) {
  const double sigma = double(state.range(0));
  measure(state,
          [&](Scene& s) { return gaussian_blur(s.folds, sigma * s.grid.cell_size, s.context); });
}
void distance(benchmark::State& state) {
  measure(state, [](Scene& s) { return nearest_feature(s.land, s.context); });
}

BENCHMARK(plates)->Name("plates/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(boundaries)->Name("boundaries/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(velocity)->Name("velocity/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(folds)->Name("folds/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(watershed)->Name("watershed/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(combination)->Name("combination/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(blur)
    ->Name("gaussian_blur/1024")
    ->Arg(2)
    ->Arg(50)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(distance)->Name("nearest_feature/1024")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace orogen
