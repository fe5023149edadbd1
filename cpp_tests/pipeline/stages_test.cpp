// Every stage is held to its contract, by the same tests, without exemptions.
#include "pipeline/stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "foundation/fields.h"
#include "island.h"

namespace orogen {
namespace {

class StageContract : public testing::TestWithParam<std::string> {
 protected:
  const Stage& stage() const { return *find_stage(GetParam()); }
};

bool is_snake_case(std::string_view name) {
  bool good = !name.empty() && std::islower(static_cast<unsigned char>(name[0]));
  for (const char c : name)
    good &= std::islower(static_cast<unsigned char>(c)) ||
            std::isdigit(static_cast<unsigned char>(c)) || c == '_';
  return good;
}

bool is_sentence(std::string_view text) {
  return text.size() > 8 && std::isupper(static_cast<unsigned char>(text[0])) &&
         text.back() == '.' && text.find('\n') == text.npos;
}

/// What each stage of the registry leaves behind, run one after the other.
struct Run {
  FieldMap fields;
  Products products;
};

const std::map<std::string, Run, std::less<>>& whole_run() {
  static const auto runs = [] {
    std::map<std::string, Run, std::less<>> result;
    const Recipe recipe = whole_recipe();
    Context context;
    PipelineState state{recipe.inputs, recipe.seed, Terrain(recipe_grid(recipe)), {}};
    for (const Stage& stage : stages()) {
      const Products before = state.products;
      stage.run(state, stage.complete({}, ""), context);
      Run& run = result[std::string(stage.info->name)];
      run.products = state.products.since(before);
      for (const auto name : stage.info->writes)
        run.fields.emplace(name, state.terrain.field(name));
    }
    return result;
  }();
  return runs;
}

/// The stage before `stage` that wrote `field` last.
const Run& writer_of(std::string_view field, std::string_view stage) {
  const Run* writer = nullptr;
  for (const Stage& s : stages()) {
    if (s.info->name == stage) break;
    for (const auto written : s.info->writes)
      if (written == field) writer = &whole_run().find(s.info->name)->second;
  }
  if (!writer) throw std::logic_error("nothing before writes " + std::string(field));
  return *writer;
}

/// A state with what `stage` says it reads and nothing else; `but`: a field left out, with the
/// products that came with it.
PipelineState state_for(const Stage& stage, std::string_view but = "") {
  const Recipe recipe = whole_recipe();
  PipelineState state{recipe.inputs, recipe.seed, Terrain(recipe_grid(recipe)), {}};
  std::set<const Run*> left_out;
  if (!but.empty()) left_out.insert(&writer_of(but, stage.info->name));
  for (const auto field : stage.info->may_read)
    state.terrain.set(field, writer_of(field, stage.info->name).fields.find(field)->second);
  for (const auto field : stage.info->reads) {
    const Run& writer = writer_of(field, stage.info->name);
    if (field != but) state.terrain.set(field, writer.fields.find(field)->second);
    if (!left_out.contains(&writer)) state.products.add(writer.products);
  }
  return state;
}

TEST_P(StageContract, IsDescribed) {
  const StageInfo& info = *stage().info;
  EXPECT_TRUE(is_snake_case(info.name));
  EXPECT_TRUE(is_sentence(info.text)) << info.text;
  EXPECT_GT(info.citation.size(), 8u);
  EXPECT_FALSE(info.writes.empty());
}

TEST_P(StageContract, NamesDeclaredFieldsOnce) {
  for (const auto& names : {stage().info->reads, stage().info->may_read, stage().info->writes}) {
    std::set<std::string_view> seen;
    for (const auto name : names) {
      EXPECT_NO_THROW(field_info(name)) << name;
      EXPECT_TRUE(seen.insert(name).second) << name;
    }
  }
}

TEST_P(StageContract, ParametersAreWellFormed) {
  std::set<std::string> seen;
  for (const ParameterInfo& p : stage().parameters) {
    EXPECT_TRUE(is_snake_case(p.name)) << p.name;
    EXPECT_TRUE(seen.insert(p.name).second) << p.name;
    EXPECT_TRUE(is_sentence(p.text)) << p.name << ": " << p.text;
    EXPECT_NO_THROW(stage().complete({{p.name, p.default_value}}, "")) << p.name;
    if (p.kind == ParameterKind::Integer || p.kind == ParameterKind::Real) {
      EXPECT_LT(p.low, p.high) << p.name;
      EXPECT_NO_THROW(stage().complete({{p.name, p.low}}, "")) << p.name;
      EXPECT_NO_THROW(stage().complete({{p.name, p.high}}, "")) << p.name;
      EXPECT_THROW(stage().complete({{p.name, p.high * 2.0 + 1.0}}, ""), InputError) << p.name;
    }
    EXPECT_EQ(p.kind == ParameterKind::Choice, !p.choices.empty()) << p.name;
  }
  EXPECT_EQ(stage().complete({}, "").size(), stage().parameters.size());
  EXPECT_THROW(stage().complete({{"no_such_thing", 1.0}}, ""), InputError);
}

TEST_P(StageContract, ReadsNothingButWhatItSays) {
  PipelineState state = state_for(stage());
  Context context;
  EXPECT_NO_THROW(stage().run(state, stage().complete({}, ""), context));
}

TEST_P(StageContract, NeedsAllThatItReads) {
  for (const auto field : stage().info->reads) {
    PipelineState state = state_for(stage(), field);
    Context context;
    EXPECT_THROW(stage().run(state, stage().complete({}, ""), context), std::out_of_range) << field;
  }
}

TEST_P(StageContract, WritesExactlyWhatItSays) {
  PipelineState state = state_for(stage());
  const FieldMap before = state.terrain.fields();
  Context context;
  stage().run(state, stage().complete({}, ""), context);
  const auto& writes = stage().info->writes;
  for (const auto& [name, field] : state.terrain.fields()) {
    const bool declared = std::find(writes.begin(), writes.end(), name) != writes.end();
    const auto old = before.find(name);
    EXPECT_EQ(declared, old == before.end() || old->second != field) << name;
  }
  for (const auto name : writes) EXPECT_TRUE(state.terrain.has(name)) << name;
}

TEST_P(StageContract, WritesFiniteNumbers) {
  for (const auto& [name, field] : whole_run().find(GetParam())->second.fields)
    if (const auto* real = std::get_if<RealField>(&field))
      for (const float value : (*real)->values()) ASSERT_TRUE(std::isfinite(value)) << name;
}

TEST_P(StageContract, GivesTheSameOnAnyNumberOfThreads) {
  for (const int threads : {1, 3}) {
    PipelineState state = state_for(stage());
    Context context({}, threads);
    context.run([&] { stage().run(state, stage().complete({}, ""), context); });
    for (const auto& [name, field] : whole_run().find(GetParam())->second.fields)
      EXPECT_TRUE(std::visit(
          [&](const auto& a) {
            const auto& b = std::get<std::decay_t<decltype(a)>>(state.terrain.field(name));
            return *a == *b;
          },
          field))
          << name << " on " << threads << " threads";
  }
}

TEST_P(StageContract, StopsWhenCancelled) {
  PipelineState state = state_for(stage());
  Context context;
  context.cancel();
  EXPECT_THROW(stage().run(state, stage().complete({}, ""), context), Cancelled);
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const Stage& stage : stages()) names.emplace_back(stage.info->name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Every, StageContract, testing::ValuesIn(all_names()),
                         [](const auto& info) { return info.param; });

TEST(Stages, HaveDifferentNames) {
  const auto names = all_names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(find_stage("no_such_stage"), nullptr);
}

TEST(Stages, TheDefaultRecipeMakesEveryFieldThatAnyOfItsStagesReads) {
  EXPECT_NO_THROW(check_stages(default_stages(), whole_recipe().inputs));
}

}  // namespace
}  // namespace orogen
