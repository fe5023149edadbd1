#include "pipeline/strict_json.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "foundation/errors.h"
#include "foundation/parameters.h"

namespace orogen {

namespace {

constexpr int kDeepest = 64;

std::string shown(const nlohmann::json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array";
  std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

}  // namespace

nlohmann::json parse_strict_json(std::string_view text) {
  using Event = nlohmann::json::parse_event_t;
  std::vector<std::set<std::string>> open;  // members of the objects around
  const auto watch = [&](int depth, Event event, nlohmann::json& parsed) {
    if (depth > kDeepest)
      throw InputError("JSON nested deeper than " + std::to_string(kDeepest) + " levels");
    if (event == Event::object_start) open.emplace_back();
    if (event == Event::object_end) open.pop_back();
    if (event == Event::key && !open.back().insert(parsed.get<std::string>()).second)
      throw InputError("member " + shown(parsed) + " stands twice in one JSON object");
    return true;
  };
  try {
    return nlohmann::json::parse(text, watch);
  } catch (const nlohmann::json::exception& error) {
    std::string what = error.what();
    if (const auto end = what.find("] "); end != std::string::npos) what = what.substr(end + 2);
    if (what.size() > 300) what = what.substr(0, 300) + "...";
    throw InputError("no valid JSON: " + what);
  }
}

void JsonValue::only_members(std::initializer_list<std::string_view> names) const {
  if (!value_.is_object()) refuse(shown(value_) + " is not allowed; an object is wanted");
  std::string list;
  for (const auto name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  for (const auto& [key, value] : value_.items())
    if (std::find(names.begin(), names.end(), key) == names.end())
      refuse("there is no member '" + key.substr(0, 60) + "'; there may be " + list);
}

JsonValue JsonValue::member(const char* name) const {
  if (!value_.contains(name)) refuse("member '" + std::string(name) + "' is missing");
  return {value_.at(name), place_.empty() ? name : place_ + "." + name};
}

JsonValue JsonValue::element(std::size_t i) const {
  return {value_.at(i), place_ + "[" + std::to_string(i) + "]"};
}

std::size_t JsonValue::array_size() const {
  if (!value_.is_array()) refuse(shown(value_) + " is not allowed; an array is wanted");
  return value_.size();
}

std::string JsonValue::text(std::size_t longest) const {
  if (!value_.is_string()) refuse(shown(value_) + " is not allowed; text is wanted");
  auto result = value_.get<std::string>();
  if (result.size() > longest)
    refuse("text of " + std::to_string(result.size()) + " bytes is not allowed; at most " +
           std::to_string(longest));
  return result;
}

std::int64_t JsonValue::integer(std::int64_t low, std::int64_t high) const {
  const bool fits =
      value_.is_number_integer() &&
      (!value_.is_number_unsigned() || value_.get<std::uint64_t>() <= std::uint64_t(INT64_MAX));
  const std::int64_t number = fits ? value_.get<std::int64_t>() : 0;
  if (!fits || number < low || number > high)
    refuse(shown(value_) + " is not allowed; a whole number from " + std::to_string(low) + " to " +
           std::to_string(high) + " is wanted");
  return number;
}

double JsonValue::number(double low, double high) const {
  const double number = value_.is_number() ? value_.get<double>() : std::nan("");
  if (!(number >= low && number <= high))
    refuse(shown(value_) + " is not allowed; a number from " + detail::format_number(low) + " to " +
           detail::format_number(high) + " is wanted");
  return number;
}

void JsonValue::refuse(const std::string& what) const {
  throw InputError((place_.empty() ? std::string("recipe") : place_) + ": " + what);
}

}  // namespace orogen
