// Makes a Stage from a function and its parameter structs. For the stage lists of this room.
#pragma once

#include <tuple>
#include <utility>

#include "foundation/random.h"
#include "pipeline/stages.h"

namespace orogen {

/// See Stage.
struct StageCosts {
  unsigned by_default = DefaultFor::Maps;
  double cost = 1.0;
  double working_bytes_per_cell = 0.0;
  double product_bytes_per_cell = 0.0;
};

/// A seed for one stage, so that no two stages draw the same numbers.
inline std::uint32_t stage_seed(std::uint32_t seed, std::string_view stage) {
  std::uint64_t bits = seed;
  for (const char c : stage) bits = mix64(bits ^ std::uint64_t(static_cast<unsigned char>(c)));
  return std::uint32_t(bits);
}

/// A raster inside a product, as a field: no copy, the product lives as long as the field.
template <class Product, class T>
Field part_of(const std::shared_ptr<const Product>& product, const Raster<T>& raster) {
  return std::shared_ptr<const Raster<T>>(product, &raster);
}

template <class... P>
void assign_parameters(std::tuple<P...>& structs, const ParameterSet& values,
                       std::string_view place) {
  std::vector<ParameterInfo> known;
  std::apply(
      [&](const auto&... p) {
        (
            [&] {
              for (auto& info : describe_parameters(p)) known.push_back(std::move(info));
            }(),
            ...);
      },
      structs);
  for (const auto& [name, value] : values) {
    bool found = false;
    [[maybe_unused]] const auto try_one = [&](auto& target) {
      for (const auto& info : describe_parameters(target))
        if (info.name == name) {
          set_parameter(target, name, value, place);
          found = true;
        }
    };
    std::apply([&](auto&... target) { (try_one(target), ...); }, structs);
    if (!found) detail::refuse_name(place, name, known);
  }
}

template <class... P>
Stage make_stage(const StageInfo& info, StageCosts costs,
                 void (*run)(PipelineState&, Context&, const P&...)) {
  Stage stage;
  stage.info = &info;
  stage.by_default = costs.by_default;
  stage.cost = costs.cost;
  stage.working_bytes_per_cell = costs.working_bytes_per_cell;
  stage.product_bytes_per_cell = costs.product_bytes_per_cell;
  [[maybe_unused]] const auto append = [&](auto infos) {
    for (auto& p : infos) stage.parameters.push_back(std::move(p));
  };
  (append(describe_parameters<P>()), ...);
  stage.complete = [](const ParameterSet& values, std::string_view place) {
    std::tuple<P...> structs;
    assign_parameters(structs, values, place);
    ParameterSet all;
    [[maybe_unused]] const auto collect = [&](const auto& source) {
      for (auto& [name, value] : parameter_values(source)) all.emplace(name, std::move(value));
    };
    std::apply([&](const auto&... source) { (collect(source), ...); }, structs);
    return all;
  };
  stage.run = [run](PipelineState& state, const ParameterSet& values, Context& context) {
    std::tuple<P...> structs;
    assign_parameters(structs, values, "");
    std::apply([&](const P&... source) { run(state, context, source...); }, structs);
  };
  return stage;
}

}  // namespace orogen
