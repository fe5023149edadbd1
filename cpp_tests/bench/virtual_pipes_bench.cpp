// Virtual pipes: steps of a storm over land without sea, and over an island.
#include <benchmark/benchmark.h>

#include "erosion/virtual_pipes.h"
#include "foundation/noise.h"

namespace {

using namespace orogen;

Raster<float> island(int n, double lift) {
  const Context context;
  FbmParameters noise;
  noise.wavelength = 30e3;
  const Grid grid{n, n, 100.0};
  Raster<float> z = fbm(noise, grid, context);
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) {
      const double x = 2.0 * c / n - 1.0, y = 2.0 * r / n - 1.0;
      z(r, c) = float(lift + 400.0 * double(z(r, c)) - 1500.0 * (x * x + y * y) * (lift < 2e3));
    }
  return z;
}

template <class Real>
void storm(benchmark::State& state, double lift) {
  const int n = int(state.range(0)), steps = int(state.range(1));
  const Raster<float> z = island(n, lift);
  PipeParameters parameters;
  parameters.duration = stable_time_step(100.0, parameters) * steps;
  for (auto _ : state) {
    Context context;
    benchmark::DoNotOptimize(erode_virtual_pipes<Real>(z, {}, parameters, context));
  }
  state.counters["cell_steps"] = benchmark::Counter(
      double(z.size()) * steps * double(state.iterations()), benchmark::Counter::kIsRate);
}

void storm_on_land(benchmark::State& state) {
  storm<float>(state, 3000.0);
}
void storm_on_island(benchmark::State& state) {
  storm<float>(state, 800.0);
}
void storm_in_double(benchmark::State& state) {
  storm<double>(state, 3000.0);
}

BENCHMARK(storm_on_land)
    ->Args({1024, 150})
    ->Args({2048, 40})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(storm_on_island)->Args({1024, 150})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(storm_in_double)->Args({1024, 30})->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
