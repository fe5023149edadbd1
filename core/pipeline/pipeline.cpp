#include "pipeline/pipeline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "erosion/virtual_pipes.h"
#include "foundation/fields.h"
#include "pipeline/collision_products.h"
#include "pipeline/sha256.h"

namespace orogen {

namespace {

constexpr std::size_t kFixedBytes = std::size_t(32) << 20;  // code, threads' stacks, small things

void append(std::string& text, std::string_view part) {
  text += std::to_string(part.size());  // so that no two lists of parts give one text
  text += ':';
  text += part;
}

void append_value(std::string& text, const ParameterValue& value) {
  text += char('0' + value.index());
  if (const auto* s = std::get_if<std::string>(&value)) return append(text, *s);
  if (const auto* b = std::get_if<bool>(&value)) return append(text, *b ? "1" : "0");
  if (const auto* i = std::get_if<std::int64_t>(&value)) return append(text, std::to_string(*i));
  append(text, detail::format_number(std::get<double>(value)));
}

std::string key_of_inputs(const Grid& grid, std::uint32_t seed) {
  std::string text;
  append(text, OROGEN_VERSION);
  append(text, std::to_string(seed));
  append(text, std::to_string(grid.nx) + "x" + std::to_string(grid.ny));
  for (const double value : {grid.cell_size, grid.origin.x, grid.origin.y})
    append(text, detail::format_number(value));
  return sha256(text);
}

std::string key_of_stage(const Stage& stage, const ParameterSet& parameters,
                         const std::string& inputs, const Recipe& recipe,
                         const std::map<std::string, std::string, std::less<>>& keys) {
  std::string text;
  append(text, inputs);
  append(text, stage.info->name);
  for (const auto& [name, value] : parameters) {
    append(text, name);
    append_value(text, value);
  }
  for (const std::string_view field : stage.info->reads) append(text, keys.find(field)->second);
  for (const std::string_view field : stage.info->may_read) {
    const auto found = keys.find(field);
    append(text, found == keys.end() ? "" : found->second);
  }
  for (const std::string_view input : stage.info->inputs) {
    const auto found = recipe.documents.find(input);
    append(text, found == recipe.documents.end() ? "" : found->second);
  }
  return sha256(text);
}

std::string in_bytes(std::size_t bytes) {
  return std::to_string(bytes) + " bytes (" +
         detail::format_number(std::round(double(bytes) / double(1 << 30) * 100.0) / 100.0) +
         " GiB)";
}

void refuse_beyond_limit(std::size_t needed, const GenerateOptions& options, const Grid& grid) {
  const std::size_t limit =
      options.memory_limit_bytes ? options.memory_limit_bytes : available_memory();
  if (needed <= limit) return;
  throw MemoryLimitError(std::to_string(grid.nx) + " x " + std::to_string(grid.ny) +
                         " cells need about " + in_bytes(needed) + " of memory; the limit is " +
                         in_bytes(limit) + ". Take a lower resolution or raise the limit.");
}

/// Runs one stage, or takes its result from the cache.
void take_stage(const Stage& stage, const ParameterSet& parameters, const std::string& key,
                PipelineState& state, Context& context, Cache* cache, StageTime& time) {
  const auto start = std::chrono::steady_clock::now();
  const auto kept = cache ? cache->find(key) : nullptr;
  if (kept) {
    for (const auto& [name, field] : kept->fields) state.terrain.set(name, field);
    state.products.add(kept->products);
    time.cached = true;
  } else {
    const Products before = state.products;
    stage.run(state, parameters, context);
    context.report(1.0);
    if (cache) {
      StageResult result{{}, state.products.since(before)};
      for (const std::string_view name : stage.info->writes)
        result.fields.emplace(name, state.terrain.field(name));
      const double beside = stage.product_bytes_per_cell * double(state.terrain.grid().size());
      cache->insert(key, std::move(result), std::size_t(beside));
    }
  }
  time.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A line for each of the recipe's springs that brought no water, and why.
void warn_of_idle_springs(const Recipe& recipe, const Terrain& terrain,
                          std::vector<std::string>& warnings) {
  const bool flows = std::ranges::any_of(recipe.stages, [](const RecipeStage& item) {
    return item.stage == hydraulic_erosion_stage().name;
  });
  const Grid& grid = terrain.grid();
  for (std::size_t i = 0; i < recipe.inputs.river_sources.size(); ++i) {
    const glm::dvec2 p = recipe.inputs.river_sources[i].position;
    if (flows && terrain.integer("land")(grid.row_of(p.y), grid.column_of(p.x))) continue;
    warnings.push_back("river_sources[" + std::to_string(i) + "]: changes nothing; " +
                       (flows ? "it lies in the sea" : "no stage hydraulic_erosion is run"));
  }
}

}  // namespace

std::size_t estimate_memory(const std::vector<RecipeStage>& stages, const Grid& grid) {
  std::set<std::string_view> written;
  double peak = 0.0, products = 0.0;  // bytes a cell
  for (const RecipeStage& item : stages) {
    const Stage& stage = *find_stage(item.stage);
    double rewritten = 0.0;  // old versions live until the stage is done
    for (const std::string_view field : stage.info->writes)
      if (!written.insert(field).second) rewritten += 4.0;
    products += stage.product_bytes_per_cell;
    peak = std::max(
        peak, 4.0 * double(written.size()) + products + rewritten + stage.working_bytes_per_cell);
  }
  return kFixedBytes + std::size_t(peak * double(grid.size()));
}

Generated generate(const Recipe& recipe, const GenerateOptions& options, Context& context,
                   Cache* cache) {
  check_stages(recipe.stages, recipe.inputs);
  const Grid grid = recipe_grid(recipe, options.resolution);
  const std::size_t estimate = estimate_memory(recipe.stages, grid);
  refuse_beyond_limit(estimate, options, grid);

  const std::uint32_t seed = options.seed.value_or(recipe.seed);
  PipelineState state{recipe.inputs, seed, Terrain(grid), {}, options.watch};
  std::vector<StageTime> times;
  double all_cost = 0.0;
  for (const RecipeStage& item : recipe.stages) all_cost += find_stage(item.stage)->cost;

  const std::string inputs = key_of_inputs(grid, seed);
  std::map<std::string, std::string, std::less<>> keys;  // of the results that wrote each field
  context.keep_in(cache ? &cache->kept() : nullptr);
  context.run([&] {
    double done = 0.0;
    for (const RecipeStage& item : recipe.stages) {
      const Stage& stage = *find_stage(item.stage);
      const ParameterSet parameters = stage.complete(item.parameters, "");
      const std::string key = key_of_stage(stage, parameters, inputs, recipe, keys);
      context.begin_stage(stage.info->name, done / all_cost, (done + stage.cost) / all_cost);
      done += stage.cost;
      take_stage(stage, parameters, key, state, context, cache,
                 times.emplace_back(StageTime{item.stage}));
      for (const std::string_view field : stage.info->writes)
        keys.insert_or_assign(std::string(field), key);
    }
  });
  std::vector<std::string> warnings;
  if (const auto folds = state.products.find<FoldedPhases>())
    warnings = fold_edit_warnings(recipe.inputs, *folds);
  warn_of_idle_springs(recipe, state.terrain, warnings);
  return {std::move(state.terrain), std::move(state.products), seed, std::move(times), estimate,
          std::move(warnings)};
}

}  // namespace orogen
