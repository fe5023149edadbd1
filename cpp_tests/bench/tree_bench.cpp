#include <benchmark/benchmark.h>

#include "vegetation/tree_mesh.h"
#include "vegetation/tree_species.h"

namespace orogen {
namespace {

void tree_of(benchmark::State& state, const char* species, double quality) {
  const Context context;
  const TreeParameters& parameters = find_tree_species(species).parameters;
  std::uint64_t seed = 0;
  std::size_t vertices = 0;
  for (auto _ : state) {
    const PlantMesh mesh =
        mesh_tree(grow_tree(parameters, ++seed, context), {.quality = quality}, context);
    benchmark::DoNotOptimize(mesh.positions.data());
    vertices += mesh.positions.size();
  }
  state.counters["vertices"] = double(vertices) / double(state.iterations());
}
BENCHMARK_CAPTURE(tree_of, black_oak, "black_oak", 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tree_of, black_oak_tenth, "black_oak", 0.1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tree_of, weeping_willow, "weeping_willow", 1.0)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace orogen
