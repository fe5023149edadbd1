// Paper C's collision of three plates on 1024 x 1024 cells (section 7.1: 10 ms on a GPU).
#include <benchmark/benchmark.h>

#include "tectonics/collision_uplift.h"
#include "tectonics/compression.h"
#include "tectonics/fault_dip.h"
#include "tectonics/isostasy.h"
#include "tectonics/plate_margins.h"

namespace orogen {
namespace {

std::vector<PlateGesture> three_plates() {
  PlateGesture west{
      {{10e3, 20e3}, {30e3, 15e3}, {35e3, 45e3}, {25e3, 60e3}, {8e3, 50e3}}, {}, {}, "west"};
  PlateGesture east{
      {{75e3, 25e3}, {90e3, 20e3}, {95e3, 55e3}, {80e3, 60e3}, {70e3, 45e3}}, {}, {}, "east"};
  PlateGesture north{
      {{30e3, 80e3}, {50e3, 75e3}, {70e3, 82e3}, {60e3, 95e3}, {38e3, 94e3}}, {}, {}, "north"};
  west.arrows.assign(5, {9e3, 2e3});
  east.arrows.assign(5, {-6e3, 0.0});
  north.arrows.assign(5, {0.0, -7e3});
  return {west, east, north};
}

struct Scene {
  Context context;
  Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 1024);
  TransportField transport{rigid_plates(three_plates())};
  CompressionField field = compression_field(transport, grid, context);
  Raster<float> convergence =
      plate_convergence(transport, grid, CollisionParameters().crust_smoothing, context);
  CollisionUplift collision = collision_uplift(transport, field, convergence, {}, context);
};

template <class Work>
void measure(benchmark::State& state, Work&& work) {
  static Scene scene;
  for (auto _ : state) benchmark::DoNotOptimize(work(scene));
}

void compression(benchmark::State& state) {
  measure(state, [](Scene& s) { return compression_field(s.transport, s.grid, s.context); });
}
void uplift(benchmark::State& state) {
  measure(state, [](Scene& s) {
    return collision_uplift(s.transport, s.field, s.convergence, {}, s.context);
  });
}
void collision(benchmark::State& state) {
  measure(state, [](Scene& s) {
    const auto field = compression_field(s.transport, s.grid, s.context);
    const auto convergence =
        plate_convergence(s.transport, s.grid, CollisionParameters().crust_smoothing, s.context);
    return collision_uplift(s.transport, field, convergence, {}, s.context);
  });
}
void margins(benchmark::State& state) {
  static TransportField oceanic = [] {
    auto gestures = three_plates();
    gestures[0].crust = PlateCrust::Oceanic;
    return TransportField(rigid_plates(gestures));
  }();
  measure(state, [](Scene& s) { return plate_margins(oceanic, s.field, {}, 1, s.context); });
}
void dip(benchmark::State& state) {
  measure(state, [](Scene& s) {
    return fault_motion(s.collision.uplift_rate, s.collision.fault, {}, s.context);
  });
}
// Elastic thickness in m: 100 m bends over some 1.5 km (on the grid itself), 15 km over 65 km.
void flexure(benchmark::State& state) {
  const IsostasyParameters parameters{.elastic_thickness = double(state.range(0))};
  measure(state,
          [&](Scene& s) { return flexural_deflection(s.field.crust, parameters, s.context); });
}

BENCHMARK(compression)->Name("compression/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(uplift)->Name("collision_uplift/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(collision)->Name("collision/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(margins)->Name("plate_margins/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(dip)->Name("fault_motion/1024")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(flexure)
    ->Name("flexure/1024")
    ->Arg(100)
    ->Arg(15000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace orogen
