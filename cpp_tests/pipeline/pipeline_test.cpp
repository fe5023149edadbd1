#include "pipeline/pipeline.h"

#include <gtest/gtest.h>

#include <thread>

#include "erosion/mountain_growth.h"
#include "foundation/random.h"
#include "island.h"
#include "strata/rock_body.h"

namespace orogen {
namespace {

Generated run(const Recipe& recipe, Cache* cache = nullptr, const GenerateOptions& options = {},
              int threads = 0) {
  Context context({}, threads);
  return generate(recipe, options, context, cache);
}

bool same_fields(const Terrain& a, const Terrain& b) {
  if (a.fields().size() != b.fields().size()) return false;
  for (const auto& [name, field] : a.fields()) {
    const bool same = std::visit(
        [&](const auto& x) {
          return *x == *std::get<std::decay_t<decltype(x)>>(b.fields().find(name)->second);
        },
        field);
    if (!same) return false;
  }
  return true;
}

std::vector<std::string> computed(const Generated& generated) {
  std::vector<std::string> names;
  for (const StageTime& time : generated.stages)
    if (!time.cached) names.push_back(time.stage);
  return names;
}

TEST(Pipeline, RunsTheDefaultRecipe) {
  const Generated made = run(island_recipe());
  EXPECT_EQ(made.terrain.grid(), recipe_grid(island_recipe()));
  EXPECT_EQ(made.stages.size(), default_stages().size());
  ASSERT_TRUE(made.terrain.has("elevation"));
  const auto heights = made.terrain.real("elevation").values();
  EXPECT_GT(*std::max_element(heights.begin(), heights.end()), 500.0f);
  EXPECT_LT(*std::min_element(heights.begin(), heights.end()), 0.0f);
}

TEST(Pipeline, GivesTheSameWithAndWithoutCacheAndOnAnyThreads) {
  const Generated first = run(island_recipe(), nullptr, {}, 1);
  Cache cache;
  for (const int threads : {2, 4}) {
    EXPECT_TRUE(same_fields(first.terrain, run(island_recipe(), nullptr, {}, threads).terrain));
    EXPECT_TRUE(same_fields(first.terrain, run(island_recipe(), &cache, {}, threads).terrain));
  }
}

TEST(Pipeline, TakesUnchangedStagesFromTheCache) {
  Cache cache;
  const Recipe recipe = island_recipe();
  EXPECT_EQ(computed(run(recipe, &cache)).size(), recipe.stages.size());
  EXPECT_TRUE(computed(run(recipe, &cache)).empty());

  Recipe later = recipe;  // a default said aloud changes nothing
  later.stages.back().parameters["shelf_depth"] = std::int64_t{130};
  ASSERT_EQ(later.stages.back().stage, "sea_floor");
  EXPECT_TRUE(computed(run(later, &cache)).empty());
  later.stages.back().parameters["shelf_depth"] = 140.0;
  EXPECT_EQ(computed(run(later, &cache)), std::vector<std::string>{"sea_floor"});
  EXPECT_TRUE(same_fields(run(later, &cache).terrain, run(later).terrain));
}

TEST(Pipeline, AChangeRecomputesOnlyWhatReadsFromIt) {
  Cache cache;
  Recipe recipe = island_recipe();
  run(recipe, &cache);
  for (RecipeStage& item : recipe.stages)
    if (item.stage == "folds") item.parameters["fold_strength"] = 0.9;
  const auto again = computed(run(recipe, &cache));
  EXPECT_EQ(again.front(), "folds");
  EXPECT_EQ(std::count(again.begin(), again.end(), "watershed"), 0);
  EXPECT_EQ(std::count(again.begin(), again.end(), "combination"), 1);
}

TEST(Pipeline, MapSeedAndResolutionAreInputsToo) {
  Cache cache;
  const Recipe recipe = island_recipe();
  const std::size_t all = recipe.stages.size();
  run(recipe, &cache);
  EXPECT_EQ(computed(run(recipe, &cache, {.resolution = 65, .seed = {}})).size(), all);
  EXPECT_EQ(computed(run(recipe, &cache, {.seed = 8u})).size(), all);
  std::string moved = island_geojson();
  moved.replace(moved.find("[21, 18]"), 8, "[22, 18]");
  EXPECT_EQ(computed(run(read_recipe(R"({"orogen": 1, "seed": 7, "resolution": 64, "map": )" +
                                     moved + "}"),
                         &cache))
                .size(),
            all);
  EXPECT_TRUE(computed(run(recipe, &cache)).empty());
}

TEST(Pipeline, TheSeedChangesTheTerrain) {
  const Generated made = run(island_recipe(), nullptr, {.seed = 8u});
  EXPECT_EQ(made.seed, 8u);
  EXPECT_FALSE(same_fields(made.terrain, run(island_recipe()).terrain));
}

TEST(Pipeline, RefusesWhatNeedsTooMuchMemoryBeforeItStarts) {
  try {
    run(island_recipe(), nullptr,
        {.resolution = 60000, .seed = {}, .memory_limit_bytes = 1000000000});
    FAIL() << "nothing was refused";
  } catch (const MemoryLimitError& error) {
    const std::string why = error.what();
    EXPECT_NE(why.find("60000 x 45000"), std::string::npos) << why;
    EXPECT_NE(why.find("1000000000 bytes"), std::string::npos) << why;
  }
  EXPECT_GT(available_memory(), std::size_t(1) << 20);
}

TEST(Pipeline, ProgressNeverFallsAndNamesEveryStage) {
  std::vector<std::string> seen;
  double last = 0.0;
  Context context([&](std::string_view stage, double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    if (seen.empty() || seen.back() != stage) seen.emplace_back(stage);
    return true;
  });
  generate(island_recipe(), {}, context);
  std::vector<std::string> wanted;
  for (const RecipeStage& item : default_stages()) wanted.push_back(item.stage);
  EXPECT_EQ(seen, wanted);
  EXPECT_NEAR(last, 1.0, 1e-12);
}

TEST(Pipeline, CancelledAtAnyMomentItLeavesACacheThatIsRight) {
  Cache cache;
  const Generated truth = run(island_recipe());
  int cancelled = 0;
  for (int i = 0; i < 20; ++i) {
    int calls = int(random_uniform(3, 0, i) * 12.0);
    Context context([&](std::string_view, double) { return calls-- > 0; });
    try {
      generate(island_recipe(), {}, context, &cache);
    } catch (const Cancelled&) {
      ++cancelled;
    }
    EXPECT_TRUE(same_fields(truth.terrain, run(island_recipe(), &cache).terrain));
    if (i % 3 == 0) cache.clear();
  }
  EXPECT_GT(cancelled, 5);
}

TEST(Pipeline, TwoRunsMayShareACache) {
  Cache cache;
  const Generated truth = run(island_recipe());
  std::vector<char> same(2);
  std::vector<std::thread> threads;
  for (int i = 0; i < 2; ++i)
    threads.emplace_back(
        [&, i] { same[i] = same_fields(truth.terrain, run(island_recipe(), &cache).terrain); });
  for (auto& thread : threads) thread.join();
  EXPECT_TRUE(same[0] && same[1]);
}

TEST(Pipeline, GrowsMountainsBetweenPlates) {
  Context context;
  const Recipe recipe = read_recipe(collision_document());
  const Generated made = generate(recipe, {}, context);
  EXPECT_EQ(made.stages.size(), default_stages(DefaultFor::Collisions).size());
  const Grid& grid = made.terrain.grid();
  EXPECT_EQ(grid.nx, 64);
  const auto& z = made.terrain.real("elevation");
  EXPECT_GT(z(grid.ny / 2, grid.nx / 2), 200.0f);
  EXPECT_LT(z(2, 2), 200.0f);
  EXPECT_EQ(made.terrain.integer("influence")(0, 32), 0);
  EXPECT_EQ(made.terrain.integer("influence")(grid.ny - 1, 32), 1);
  ASSERT_TRUE(made.products.find<Strata>());
  EXPECT_EQ(made.products.find<Strata>()->horizons.layers(), 4);
}

TEST(Pipeline, AnotherColumnKeepsTheCollision) {
  Context context;
  Cache cache;
  generate(read_recipe(collision_document()), {}, context, &cache);
  std::string other = collision_document();
  other.replace(other.find("alps"), 4, "jura");
  const Generated made = generate(read_recipe(other), {}, context, &cache);
  for (const StageTime& time : made.stages)
    EXPECT_EQ(time.cached, time.stage == "collision") << time.stage;
}

TEST(Pipeline, FoldsAreEditedByARecipe) {
  Context context;
  Cache cache;
  const Recipe plain = read_recipe(collision_document());
  const Recipe edited = read_recipe(collision_document(
      R"(, "fold_edits": [{"edit": "set", "layer": 1, "from": [-18000, 0], "to": [18000, 0],
          "value": 3000}, {"edit": "add", "layer": 1, "from": [-18000, 0], "to": [18000, 0]}])"));
  const auto a = generate(plain, {}, context, &cache), b = generate(edited, {}, context, &cache);
  EXPECT_TRUE(b.stages[0].cached);
  EXPECT_FALSE(b.stages[1].cached);
  EXPECT_NE(a.terrain.real("fold_uplift_rate"), b.terrain.real("fold_uplift_rate"));
  EXPECT_EQ(write_recipe(read_recipe(write_recipe(edited))), write_recipe(edited));
  EXPECT_TRUE(b.warnings.empty());
}

TEST(Pipeline, EditsOfWhatIsNotThereAreRefused) {
  const auto says = [](const std::string& member) -> std::string {
    try {
      read_recipe(collision_document(R"(, "fold_edits": [{"edit": "add", "from": [-18000, 0],
                                     "to": [18000, 0], )" +
                                     member + "}]"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(says(R"("layer": 4)"), "");
  EXPECT_EQ(says(R"("layer": 5)"),
            "fold_edits[0].layer: 5 is not allowed; the recipe's layers count from 1 to 4");
  EXPECT_EQ(says(R"("layer": 1, "phase": 2)"),
            "fold_edits[0].phase: 2 is not allowed; the recipe's phases count from 1 to 1");
}

TEST(Pipeline, GrowthIsKeptFrameByFrame) {
  Context context;
  std::string document = collision_document(R"(, "stages": [{"stage": "collision"},
      {"stage": "fold_layers"},
      {"stage": "mountain_growth", "parameters": {"frames": 3, "steps": 6}}])");
  const Generated made = generate(read_recipe(document), {}, context);
  const auto frames = made.products.find<GrowthFrames>();
  ASSERT_TRUE(frames);
  ASSERT_EQ(frames->frames.size(), 3u);
  EXPECT_EQ(frames->frames.back().elevation, made.terrain.real("elevation"));
}

TEST(Pipeline, StagesNameTheInputsThatAreMissing) {
  const auto says = [](const std::string& document) -> std::string {
    try {
      read_recipe(document);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(says(collision_document(R"(, "stages": [{"stage": "land"}])")),
            "stages[0]: stage 'land' needs 'map', which the recipe does not have");
  EXPECT_EQ(says(island_document(R"(, "stages": [{"stage": "collision"}])")),
            "stages[0]: stage 'collision' needs 'phases', which the recipe does not have");
}

std::string mountain_stages(const std::string& parameters = "", bool land = false) {
  return std::string(R"(, "stages": [)") + (land ? R"({"stage": "land"}, )" : "") +
         R"({"stage": "collision"}, {"stage": "fold_layers"}, {"stage": "mountain_growth",
          "parameters": {"steps": 10, "coarse_levels": 1)" +
         parameters + R"(}}, {"stage": "rock_detail"}, {"stage": "outcrop"}])";
}

TEST(Pipeline, MountainsGrowWithinTheCoastThatAMapDrew) {
  // All sides are closed: rivers have no way but to the coast.
  const std::string closed = R"(, "west_side": "closed", "east_side": "closed",
                                "north_side": "closed", "south_side": "closed")";
  const auto recipe = [&](bool land) {
    return read_recipe(island_document(collision_members() + mountain_stages(closed, land)));
  };
  EXPECT_THROW(run(recipe(false)), InputError);
  Cache cache;
  const Generated made = run(recipe(true), &cache);
  const auto& land = made.terrain.integer("land");
  const auto& grown = made.products.get<GrownTin>();
  const Grid& grid = made.terrain.grid();
  int at_sea = 0;
  for (std::size_t i = 0; i < grown.size(); ++i) {
    const int r = std::clamp(grid.row_of(grown.points[i].y), 0, grid.ny - 1);
    const int c = std::clamp(grid.column_of(grown.points[i].x), 0, grid.nx - 1);
    if (land(r, c)) continue;
    ++at_sea;
    ASSERT_EQ(grown.elevation[i], 0.0);
  }
  EXPECT_GT(at_sea, 500);
  EXPECT_GT(std::ranges::max(made.terrain.real("elevation").values()), 100.0f);
  // The cache knows that the coast counts, though the stage can do without.
  const std::string open = collision_members() + mountain_stages();
  const Generated without = run(read_recipe(island_document(open)), &cache);
  const Generated with =
      run(read_recipe(island_document(collision_members() + mountain_stages("", true))), &cache);
  EXPECT_NE(without.terrain.real("elevation"), with.terrain.real("elevation"));
}

TEST(Pipeline, RainOfARecipeCountsByItsRatios) {
  Cache cache;
  const auto grow = [&](const std::string& rain) {
    return run(read_recipe(collision_document(rain + mountain_stages())), &cache)
        .terrain.real("elevation");
  };
  const auto even = grow("");
  EXPECT_EQ(grow(R"(, "rain": [[1]])"), even);
  EXPECT_EQ(grow(R"(, "rain": [[800, 800], [800, 800]])"), even);
  const auto west = grow(R"(, "rain": [[4, 0.5]])");
  EXPECT_EQ(grow(R"(, "rain": [[8, 1], [8, 1]])"), west);
  double wet = 0.0, dry = 0.0;
  for (int r = 8; r < 40; ++r)
    for (int c = 4; c < 28; ++c) {
      wet += west(r, c) - even(r, c);
      dry += west(r, 63 - c) - even(r, 63 - c);
    }
  EXPECT_LT(wet, 0.0);
  EXPECT_GT(dry, 0.0);
  const Recipe recipe = read_recipe(collision_document(R"(, "rain": [[4, 0.5]])"));
  EXPECT_EQ(recipe_hash(read_recipe(write_recipe(recipe))), recipe_hash(recipe));
}

TEST(Pipeline, SedimentHidesTheRockInTheOutcrop) {
  const auto grow = [&](const std::string& parameters, bool detail = true) {
    Recipe recipe = read_recipe(collision_document(mountain_stages(parameters)));
    if (!detail)
      std::erase_if(recipe.stages, [](const RecipeStage& s) { return s.stage == "rock_detail"; });
    return run(recipe);
  };
  const std::string filling = R"(, "deposition_coefficient": 1.0)";
  const Generated made = grow(filling), smooth = grow(filling, false);
  const auto& depth = made.terrain.real("sediment_thickness");
  const auto& layer = made.terrain.integer("rock_layer");
  const int loose = int(read_recipe(collision_document()).inputs.column->layers.size()) + 1;
  const RockTable& rocks = made.products.get<Strata>().rocks;
  const int color = int(rocks.color(loose_sediment(rocks)));
  int hidden = 0, detailed = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const float detail = made.terrain.real("elevation")[i] - smooth.terrain.real("elevation")[i];
    detailed += detail != 0.0f;
    if (depth[i] < kHidingSediment) continue;
    ++hidden;
    ASSERT_EQ(layer[i], loose);
    ASSERT_EQ(made.terrain.real("age")[i], 0.0f);
    ASSERT_EQ(made.terrain.integer("strata_color")[i], color);
    ASSERT_NEAR(detail, 0.0f, 1e-4f);  // of a float that came and went
  }
  EXPECT_GT(detailed, 100);
  EXPECT_GT(hidden, 20);
  EXPECT_FALSE(made.products.get<GrownTin>().sediment_thickness.empty());
  EXPECT_TRUE(grow("").products.get<GrownTin>().sediment_thickness.empty());
}

}  // namespace
}  // namespace orogen
