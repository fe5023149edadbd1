// Parameter declarations: each parameter is declared once, beside its struct.
//
//   struct FoldParameters {
//     double fold_wavelength = 9000.0;
//   };
//   constexpr auto parameter_table(const FoldParameters*) {
//     return std::tuple{
//         real("fold_wavelength", &FoldParameters::fold_wavelength, 500.0, 50e3, "m",
//              "Distance from crest to crest of the widest folds."),
//     };
//   }
//
// The default is the struct's own. From this come Python keywords and docstrings, the recipe
// schema, Blender properties, command-line help and the reference docs. A choice is an enum whose
// values count from 0, with one name each.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "foundation/errors.h"

namespace orogen {

enum class ParameterKind { Boolean, Integer, Real, Choice };

using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;

/// A declaration, without its struct.
struct ParameterInfo {
  std::string name;
  ParameterKind kind{};
  ParameterValue default_value;
  double low = 0.0, high = 0.0;  // allowed range, inclusive (Integer, Real)
  std::string unit;              // empty: a pure number
  std::string text;              // one sentence
  std::vector<std::string> choices;
};

template <class Struct, class Member>
struct Parameter {
  std::string_view name;
  Member Struct::*member;
  double low, high;
  std::string_view unit, text;
  const std::string_view* choices = nullptr;
  std::size_t choice_count = 0;
};

template <class S>
constexpr Parameter<S, double> real(std::string_view name, double S::*member, double low,
                                    double high, std::string_view unit, std::string_view text) {
  return {name, member, low, high, unit, text};
}
template <class S>
constexpr Parameter<S, int> integer(std::string_view name, int S::*member, int low, int high,
                                    std::string_view unit, std::string_view text) {
  return {name, member, double(low), double(high), unit, text};
}
template <class S>
constexpr Parameter<S, bool> boolean(std::string_view name, bool S::*member,
                                     std::string_view text) {
  return {name, member, 0.0, 1.0, "", text};
}
template <class S, class E, std::size_t N>
constexpr Parameter<S, E> choice(std::string_view name, E S::*member,
                                 const std::string_view (&choices)[N], std::string_view text) {
  return {name, member, 0.0, double(N - 1), "", text, choices, N};
}

namespace detail {

std::string format_number(double value);
[[noreturn]] void refuse_value(std::string_view place, std::string_view name,
                               std::string_view value, std::string_view allowed);
bool to_bool(const ParameterValue&, std::string_view place, std::string_view name);
double to_number(const ParameterValue&, bool whole, double low, double high, std::string_view unit,
                 std::string_view place, std::string_view name);
std::size_t to_choice(const ParameterValue&, const std::string_view* choices, std::size_t count,
                      std::string_view place, std::string_view name);
[[noreturn]] void refuse_name(std::string_view place, std::string_view name,
                              const std::vector<ParameterInfo>& known);

template <class S, class M>
ParameterInfo describe(const Parameter<S, M>& p, const S& defaults) {
  ParameterInfo info{std::string(p.name), {}, {}, p.low, p.high, std::string(p.unit),
                     std::string(p.text), {}};
  const M& value = defaults.*p.member;
  if constexpr (std::is_same_v<M, bool>) {
    info.kind = ParameterKind::Boolean;
    info.default_value = value;
  } else if constexpr (std::is_enum_v<M>) {
    info.kind = ParameterKind::Choice;
    info.choices.assign(p.choices, p.choices + p.choice_count);
    info.default_value = info.choices[std::size_t(value)];
  } else if constexpr (std::is_integral_v<M>) {
    info.kind = ParameterKind::Integer;
    info.default_value = std::int64_t(value);
  } else {
    info.kind = ParameterKind::Real;
    info.default_value = double(value);
  }
  return info;
}

template <class S, class M>
void assign(S& target, const Parameter<S, M>& p, const ParameterValue& value,
            std::string_view place) {
  if constexpr (std::is_same_v<M, bool>)
    target.*p.member = to_bool(value, place, p.name);
  else if constexpr (std::is_enum_v<M>)
    target.*p.member = M(to_choice(value, p.choices, p.choice_count, place, p.name));
  else
    target.*p.member =
        M(to_number(value, std::is_integral_v<M>, p.low, p.high, p.unit, place, p.name));
}

template <class S, class M>
ParameterValue value_of(const S& source, const Parameter<S, M>& p) {
  return describe(p, source).default_value;
}

}  // namespace detail

/// All declarations of a parameter struct, in order.
template <class S>
std::vector<ParameterInfo> describe_parameters(const S& defaults = S{}) {
  std::vector<ParameterInfo> result;
  std::apply([&](const auto&... p) { (result.push_back(detail::describe(p, defaults)), ...); },
             parameter_table(static_cast<const S*>(nullptr)));
  return result;
}

/// Sets one parameter by name. InputError for an unknown name, a wrong type or a value out of
/// range; `place` (such as "stages[2].parameters") begins the message.
template <class S>
void set_parameter(S& target, std::string_view name, const ParameterValue& value,
                   std::string_view place = "") {
  bool found = false;
  std::apply(
      [&](const auto&... p) {
        ((p.name == name ? (detail::assign(target, p, value, place), found = true) : false), ...);
      },
      parameter_table(static_cast<const S*>(nullptr)));
  if (!found) detail::refuse_name(place, name, describe_parameters<S>());
}

/// Every parameter's current value, in order.
template <class S>
std::vector<std::pair<std::string, ParameterValue>> parameter_values(const S& source) {
  std::vector<std::pair<std::string, ParameterValue>> result;
  for (auto& info : describe_parameters(source))
    result.emplace_back(std::move(info.name), std::move(info.default_value));
  return result;
}

/// InputError if any parameter is out of range (a struct filled in from C++).
template <class S>
void check_parameters(const S& source, std::string_view place = "") {
  S copy = source;
  for (const auto& [name, value] : parameter_values(source))
    set_parameter(copy, name, value, place);
}

}  // namespace orogen
