// A step of water and stream power on TINs of ten thousand to a million vertices, near the steady
// state as the peers are timed: 1e-3 m/yr, 2e-5 /yr, 10,000 years a step, four open sides. The
// mesh, and what is made of a result, beside it.
#include <benchmark/benchmark.h>

#include "erosion/tin_hillslope.h"
#include "erosion/tin_stream_power.h"
#include "foundation/random.h"
#include "foundation/tin.h"
#include "foundation/tin_sampling.h"
#include "hydrology/tin_flow.h"

namespace orogen {
namespace {

TinDomain square(double vertices) {
  const double side = 100.0 * std::sqrt(vertices);
  return {{0.0, 0.0}, {side, side}};
}

Tin mesh(double vertices, const Context& context) {
  return jittered_tin(square(vertices), spacing_for(square(vertices), vertices), 1, context);
}

std::vector<double> noise_over(const Tin& tin) {
  std::vector<double> z(tin.size());
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = tin.sides[i] ? 0.0 : random_uniform(1, 2, i);
  return z;
}

void tin_stream_power(benchmark::State& state) {
  Context context({}, int(state.range(1)));
  const Tin tin = mesh(double(state.range(0)), context);
  std::vector<double> z = noise_over(tin);
  TinFlow flow(tin, side_mask(tin, 15u));
  TinStreamPower solver({.slope_exponent = 0.1 * double(state.range(2)),
                         .deposition_coefficient = 0.1 * double(state.range(3))});
  const TinForcing forcing{.uplift_rate = 1e-3, .erodibility = 2e-5};
  context.run([&] {
    for (int i = 0; i < 5; ++i) solver.step(flow, z, forcing, 1e4, context);
    for (auto _ : state) solver.step(flow, z, forcing, 1e4, context);
  });
  state.counters["pits"] = double(flow.pit_count());
}

void tin_route_noise(benchmark::State& state) {
  Context context({}, int(state.range(1)));
  const Tin tin = mesh(double(state.range(0)), context);
  const std::vector<double> z = noise_over(tin);
  TinFlow flow(tin, side_mask(tin, 15u));
  context.run([&] {
    for (auto _ : state) flow.route(z, context);
  });
  state.counters["pits"] = double(flow.pit_count());
}

void tin_landslide(benchmark::State& state) {
  Context context;
  const Tin tin = mesh(double(state.range(0)), context);
  const auto base = side_mask(tin, 15u);
  std::vector<double> steep = noise_over(tin);
  for (double& z : steep) z *= 200.0;
  for (auto _ : state) {
    std::vector<double> z = steep;
    landslide(tin, z, base, 0.6, {}, 1e5, context);
  }
}

void tin_creep(benchmark::State& state) {
  Context context;
  const Tin tin = mesh(double(state.range(0)), context);
  std::vector<double> z = noise_over(tin);
  TinCreep creep(tin, side_mask(tin, 15u), {.diffusivity = 0.05});
  for (auto _ : state) creep.step(z, 1e5, context);
}

void tin_make(benchmark::State& state) {
  Context context;
  for (auto _ : state) benchmark::DoNotOptimize(mesh(double(state.range(0)), context));
}

void tin_to_grid(benchmark::State& state) {
  Context context;
  const Tin tin = mesh(double(state.range(0)), context);
  const std::vector<double> z = noise_over(tin);
  const double side = tin.domain.size.x;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        sample_to_grid(tin, z, Grid{1024, 1024, side / 1024, {0.0, 0.0}}, context));
}

constexpr auto kMilliseconds = benchmark::kMillisecond;
BENCHMARK(tin_stream_power)
    ->ArgNames({"vertices", "threads", "exponent_x10", "deposition_x10"})
    ->ArgsProduct({{10'000, 100'000, 1'000'000}, {1, 2}, {10}, {0, 10}})
    ->Args({100'000, 2, 15, 0})
    ->Unit(kMilliseconds)
    ->UseRealTime();
BENCHMARK(tin_route_noise)
    ->ArgNames({"vertices", "threads"})
    ->ArgsProduct({{100'000, 1'000'000}, {1, 2}})
    ->Unit(kMilliseconds)
    ->UseRealTime();
BENCHMARK(tin_landslide)->Arg(1'000'000)->Unit(kMilliseconds)->UseRealTime();
BENCHMARK(tin_creep)->Arg(1'000'000)->Unit(kMilliseconds)->UseRealTime();
BENCHMARK(tin_make)->Arg(100'000)->Arg(1'000'000)->Unit(kMilliseconds)->UseRealTime();
BENCHMARK(tin_to_grid)->Arg(100'000)->Arg(1'000'000)->Unit(kMilliseconds)->UseRealTime();

}  // namespace
}  // namespace orogen
