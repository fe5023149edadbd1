// Folds of 100 km (paper C, Table 1) on 1024 x 1024 cells, at wavelengths of 7, 3 and 1 km.
#include <benchmark/benchmark.h>

#include <cmath>

#include "folding/fold_lines.h"
#include "folding/fold_relief.h"
#include "folding/fold_skeleton.h"

namespace orogen {
namespace {

struct Scene {
  Context context;
  Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 1024);
  CompressionField field;

  // Compressed everywhere, in a direction that bends.
  Scene() {
    field.compression_x = Raster<float>(grid);
    field.compression_y = Raster<float>(grid);
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        const double angle = 0.5 * std::sin(grid.center(r, c).y / 20e3);
        field.compression_x(r, c) = float(0.3 * std::cos(angle));
        field.compression_y(r, c) = float(0.3 * std::sin(angle));
      }
  }
  FoldSkeleton skeleton(double wavelength) const {
    return fold_skeleton(field, FoldWavelength(wavelength), {}, 1, context);
  }
};

const Scene& scene() {
  static const Scene s;
  return s;
}

void fold_points_and_faces(benchmark::State& state) {
  const FoldWavelength wavelength(double(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        fold_mesh({0.0, 0.0}, glm::dvec2(100e3), wavelength, 1, scene().context));
}
void fold_skeletons(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(scene().skeleton(double(state.range(0))));
  state.counters["edges"] = double(scene().skeleton(double(state.range(0))).mesh.edges.size());
}
void fold_heights(benchmark::State& state) {
  const FoldSkeleton skeleton = scene().skeleton(double(state.range(0)));
  for (auto _ : state) {
    Raster<float> speed = crest_speed(scene().field, 1e-4, scene().context);
    shape_folds(skeleton, speed, kCreaseRounding * double(state.range(0)), scene().context);
    benchmark::DoNotOptimize(speed.data());
  }
}
void lines_of_folds(benchmark::State& state) {
  const FoldSkeleton skeleton = scene().skeleton(double(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(fold_lines(skeleton.top));
}

void wavelengths(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(7000)->Arg(3000)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK(fold_points_and_faces)->Name("fold_mesh")->Apply(wavelengths);
BENCHMARK(fold_skeletons)->Name("fold_skeleton")->Apply(wavelengths);
BENCHMARK(fold_heights)->Name("fold_heights/1024")->Apply(wavelengths);
BENCHMARK(lines_of_folds)->Name("fold_lines")->Apply(wavelengths);

}  // namespace
}  // namespace orogen
