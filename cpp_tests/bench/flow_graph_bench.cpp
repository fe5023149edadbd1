// A step of water and stream power on 1024² and 2048² cells: rough noise, fBm with pits, and a
// landscape near its steady state. All cells but the four sides are land.
#include <benchmark/benchmark.h>

#include "erosion/stream_power.h"
#include "foundation/noise.h"
#include "foundation/random.h"
#include "hydrology/drainage.h"
#include "hydrology/flow_graph.h"

namespace orogen {
namespace {

enum Ground { White, Rough };

Raster<std::uint8_t> four_sides(const Grid& grid) {
  Raster<std::uint8_t> base(grid);
  for (int c = 0; c < grid.nx; ++c) base(0, c) = base(grid.ny - 1, c) = 1;
  for (int r = 0; r < grid.ny; ++r) base(r, 0) = base(r, grid.nx - 1) = 1;
  return base;
}

Raster<float> ground_of(int kind, const Grid& grid, const Context& context) {
  if (kind == White) {
    Raster<float> z(grid);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = float(random_uniform(1, 2, i));
    return z;
  }
  Raster<float> z = fbm({.seed = 3, .wavelength = 20e3, .octaves = 9, .gain = 0.5}, grid, context);
  for (float& v : z.values()) v = 1000.0f + 300.0f * v;
  return z;
}

void drain(benchmark::State& state) {
  const int n = int(state.range(1));
  const Grid grid{n, n, 100.0, {0.0, 0.0}};
  Context context({}, int(state.range(2)));
  const Raster<float> z = ground_of(int(state.range(0)), grid, context);
  FlowGraph flow(four_sides(grid));
  std::vector<double> area;
  context.run([&] {
    for (auto _ : state) {
      flow.route(z, context);
      accumulate_drainage_area(flow, area, context);
    }
  });
  state.counters["pits"] = double(flow.pit_count());
}

// Near the steady state, as the peers are timed: 1e-3 m/yr, 2e-5 /yr, 10,000 years a step.
void erode(benchmark::State& state) {
  const int n = int(state.range(1));
  const Grid grid{n, n, 100.0, {0.0, 0.0}};
  Context context({}, int(state.range(2)));
  Raster<float> z = ground_of(Rough, grid, context);
  const Raster<std::uint8_t> base = four_sides(grid);
  for (std::size_t i = 0; i < z.size(); ++i)
    if (base[i]) z[i] = 0.0f;
  FlowGraph flow(base);
  StreamPower solver({.slope_exponent = 0.1 * double(state.range(0)),
                      .deposition_coefficient = 0.1 * double(state.range(3))});
  const StreamPowerForcing forcing{.uplift_rate = 1e-3, .erodibility = 2e-5};
  context.run([&] {
    for (int i = 0; i < 10; ++i) solver.step(flow, z, forcing, 1e9, context);
    for (auto _ : state) solver.step(flow, z, forcing, 1e4, context);
  });
  state.counters["pits"] = double(flow.pit_count());
}

BENCHMARK(drain)
    ->ArgNames({"ground", "n", "threads"})
    ->ArgsProduct({{White, Rough}, {1024, 2048}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(erode)
    ->ArgNames({"exponent_x10", "n", "threads", "deposition_x10"})
    ->ArgsProduct({{10}, {1024, 2048}, {1, 2}, {0}})
    ->Args({10, 1024, 2, 10})
    ->Args({15, 1024, 2, 0})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace orogen
