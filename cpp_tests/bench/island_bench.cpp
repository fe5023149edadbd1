#include <benchmark/benchmark.h>

#include <cmath>

#include "foundation/noise.h"
#include "foundation/random.h"
#include "island/island_relief.h"
#include "sculpting/feature_solver.h"

namespace orogen {
namespace {

const glm::dvec2 kLow{0.0, 0.0}, kHigh{100e3, 100e3};

void polygon_map_of(benchmark::State& state) {
  const Context context;
  for (auto _ : state)
    benchmark::DoNotOptimize(random_polygon_map(int(state.range(0)), 2, kLow, kHigh, 1, context));
}
BENCHMARK(polygon_map_of)->Arg(4000)->Arg(100'000)->Unit(benchmark::kMillisecond);

void island_of(benchmark::State& state) {
  const Context context;
  const Grid grid = grid_over(kLow, kHigh, int(state.range(0)));
  for (auto _ : state) {
    const Island made = make_island({}, kLow, kHigh, 1, {}, context);
    benchmark::DoNotOptimize(island_relief(made, {}, grid, 1, context));
  }
}
BENCHMARK(island_of)->Arg(1024)->Unit(benchmark::kMillisecond);

std::vector<FeatureCurve> twenty_curves() {
  std::vector<FeatureCurve> curves(20);
  for (std::uint64_t k = 0; k < curves.size(); ++k)
    for (std::uint64_t i = 0; i < 4; ++i) {
      const FeatureSide side{1500.0, 0.4, 3000.0};
      const double along = 8e3 * double(i), turn = 6.3 * random_uniform(k, 2, 0);
      const double x = 15e3 + 70e3 * random_uniform(k, 0, 0) + along * std::cos(turn);
      const double y =
          15e3 + 70e3 * random_uniform(k, 1, 0) + along * std::sin(turn + 0.2 * double(i));
      curves[k].points.push_back(
          {{x, y, 1500.0 * random_uniform(k, 3, i)}, true, 300.0, side, side});
    }
  return curves;
}

void feature_curves(benchmark::State& state) {
  Context context;
  const Grid grid = grid_over(kLow, kHigh, int(state.range(0)));
  const Raster<float> ground = fbm({.seed = 1, .wavelength = 20e3}, grid, context);
  const auto curves = twenty_curves();
  FeatureReport report;
  for (auto _ : state) {
    Raster<float> elevation = ground;
    report = apply_features(elevation, feature_constraints(curves, grid, context), {}, context);
  }
  state.counters["cells"] = double(report.cells);
  state.counters["iterations"] = report.iterations;
  state.counters["residual_m"] = report.residual;
}
BENCHMARK(feature_curves)->Arg(1024)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace orogen
