#include <benchmark/benchmark.h>

#include "foundation/noise.h"
#include "vegetation/placement.h"

namespace orogen {
namespace {

/// Hills under forests and meadows.
void plants(benchmark::State& state) {
  const Context context;
  const Grid grid{1024, 1024, 8.0};
  Raster<float> elevation = fbm({.seed = 1, .wavelength = 3000.0}, grid, context);
  Raster<std::int32_t> biome(grid);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    elevation[i] = 400.0f + 150.0f * elevation[i];
    biome[i] = std::int32_t(elevation[i] > 500.0f   ? Biome::Taiga
                            : elevation[i] > 300.0f ? Biome::DeciduousForest
                                                    : Biome::Grassland);
  }
  std::size_t placed = 0;
  for (auto _ : state)
    placed = place_plants({elevation, biome}, tree_table(), {.most_plants = int(state.range(0))},
                          {}, 1, context)
                 .kinds.size();
  state.counters["plants"] = double(placed);
}
BENCHMARK(plants)->Arg(1'000'000)->Arg(4'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace orogen
