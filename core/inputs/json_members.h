// Members of JSON objects by type; what has the wrong one is an InputError that names it. Missing
// and null members are alike.
#pragma once

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "foundation/errors.h"
#include "inputs/map_report.h"

namespace orogen {

using json = nlohmann::json;

[[noreturn]] inline void refuse(const std::string& place, const std::string& why) {
  throw InputError(place + ": " + why);
}

inline std::string brief(const json& value) {
  switch (value.type()) {
    case json::value_t::null:
      return "null";
    case json::value_t::object:
      return "an object";
    case json::value_t::array:
    case json::value_t::binary:
      return "a list";
    case json::value_t::string:
      return "the text '" + shown(value.get_ref<const std::string&>()) + "'";
    default:
      return value.dump();
  }
}

/// A member that may be missing or null.
inline const json* member(const json& object, const char* name) {
  const auto it = object.find(name);
  return it == object.end() || it->is_null() ? nullptr : &*it;
}
inline std::string text_member(const json& object, const char* name, const std::string& place) {
  const json* value = member(object, name);
  if (!value) return {};
  if (!value->is_string()) refuse(place + "." + name, "must be text, not " + brief(*value));
  return value->get<std::string>();
}
inline std::optional<double> number_member(const json& object, const char* name,
                                           const std::string& place) {
  const json* value = member(object, name);
  if (!value) return {};
  if (!value->is_number()) refuse(place + "." + name, "must be a number, not " + brief(*value));
  return value->get<double>();
}
inline std::optional<bool> boolean_member(const json& object, const char* name,
                                          const std::string& place) {
  const json* value = member(object, name);
  if (!value) return {};
  if (!value->is_boolean())
    refuse(place + "." + name, "must be true or false, not " + brief(*value));
  return value->get<bool>();
}
inline std::optional<glm::dvec2> pair_member(const json& object, const char* name,
                                             const std::string& place) {
  const json* value = member(object, name);
  if (!value) return {};
  if (!value->is_array() || value->size() != 2 || !(*value)[0].is_number() ||
      !(*value)[1].is_number())
    refuse(place + "." + name, "must be a list of two numbers");
  return glm::dvec2{(*value)[0].get<double>(), (*value)[1].get<double>()};
}

}  // namespace orogen
