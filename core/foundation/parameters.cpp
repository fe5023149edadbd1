#include "foundation/parameters.h"

#include <charconv>

namespace orogen::detail {

namespace {

std::string full_name(std::string_view place, std::string_view name) {
  return place.empty() ? std::string(name) : std::string(place) + "." + std::string(name);
}

std::string to_text(const ParameterValue& value) {
  if (const bool* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (const auto* i = std::get_if<std::int64_t>(&value)) return std::to_string(*i);
  if (const double* d = std::get_if<double>(&value)) return format_number(*d);
  std::string text = std::get<std::string>(value);
  if (text.size() > 40) text = text.substr(0, 40) + "…";
  return "'" + text + "'";
}

std::string join(const std::string_view* names, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) {
    if (i) result += ", ";
    result += names[i];
  }
  return result;
}

}  // namespace

std::string format_number(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

void refuse_value(std::string_view place, std::string_view name, std::string_view value,
                  std::string_view allowed) {
  throw InputError(full_name(place, name) + ": " + std::string(value) + " is not allowed; " +
                   std::string(allowed));
}

void refuse_name(std::string_view place, std::string_view name,
                 const std::vector<ParameterInfo>& known) {
  std::string names;
  for (const auto& info : known) names += (names.empty() ? "" : ", ") + info.name;
  throw InputError(full_name(place, name.substr(0, 60)) + ": no such parameter; there are " +
                   (names.empty() ? "none here" : names));
}

bool to_bool(const ParameterValue& value, std::string_view place, std::string_view name) {
  if (const bool* b = std::get_if<bool>(&value)) return *b;
  refuse_value(place, name, to_text(value), "true or false is wanted");
}

double to_number(const ParameterValue& value, bool whole, double low, double high,
                 std::string_view unit, std::string_view place, std::string_view name) {
  double number = std::nan("");
  if (const auto* i = std::get_if<std::int64_t>(&value)) number = double(*i);
  if (const double* d = std::get_if<double>(&value)) number = *d;
  const bool fits = number >= low && number <= high && (!whole || number == std::floor(number));
  if (fits) return number;
  refuse_value(place, name, to_text(value),
               std::string(whole ? "a whole number" : "a number") + " from " + format_number(low) +
                   " to " + format_number(high) + (unit.empty() ? "" : " " + std::string(unit)) +
                   " is wanted");
}

std::size_t to_choice(const ParameterValue& value, const std::string_view* choices,
                      std::size_t count, std::string_view place, std::string_view name) {
  if (const auto* text = std::get_if<std::string>(&value))
    for (std::size_t i = 0; i < count; ++i)
      if (choices[i] == *text) return i;
  refuse_value(place, name, to_text(value), "one of " + join(choices, count) + " is wanted");
}

}  // namespace orogen::detail
