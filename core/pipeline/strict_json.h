// Strict reading of JSON documents: what is there must be known, of the right type and finite, and
// every refusal begins with the place.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace orogen {

/// Parses a whole document. InputError for text that is no JSON, depth over 64, a member named
/// twice; it says where.
nlohmann::json parse_strict_json(std::string_view text);

/// One value of a document, and its place in it.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, std::string place)
      : value_(value), place_(std::move(place)) {}

  const nlohmann::json& json() const { return value_; }
  const std::string& place() const { return place_; }

  /// InputError unless this is an object whose members all have one of these names.
  void only_members(std::initializer_list<std::string_view> names) const;
  bool has(const char* name) const { return value_.contains(name); }
  JsonValue member(const char* name) const;  // InputError if missing
  JsonValue element(std::size_t i) const;
  std::size_t array_size() const;  // InputError unless an array

  std::string text(std::size_t longest = 1000) const;
  std::int64_t integer(std::int64_t low, std::int64_t high) const;
  double number(double low, double high) const;

  [[noreturn]] void refuse(const std::string& what) const;

 private:
  const nlohmann::json& value_;
  std::string place_;
};

/// Numbers from `low` to `high` as a list of rows, all as long: GivenRaster or CornerMap.
/// InputError if there is none.
template <class Rows>
Rows read_rows(const JsonValue& list, double low, double high) {
  Rows result;
  result.rows = int(list.array_size());
  if (result.rows < 1) list.refuse("at least one row of numbers is wanted");
  result.columns = int(list.element(0).array_size());
  if (result.columns < 1) list.element(0).refuse("at least one number is wanted");
  for (int r = 0; r < result.rows; ++r) {
    const JsonValue row = list.element(r);
    if (int(row.array_size()) != result.columns)
      row.refuse("every row must have the same number of values");
    for (int c = 0; c < result.columns; ++c) {
      const double value = row.element(c).number(low, high);
      result.values.push_back(typename decltype(result.values)::value_type(value));
    }
  }
  return result;
}

}  // namespace orogen
