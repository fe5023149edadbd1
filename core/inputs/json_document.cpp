#include "inputs/json_document.h"

#include <cmath>

#include "foundation/errors.h"

namespace orogen {
namespace {

using nlohmann::json;

/// Builds the document from nlohmann's events. `open_` are the arrays and objects around the
/// current value, `numbers_` the arrays inside a member "coordinates".
class Builder {
 public:
  using number_integer_t = json::number_integer_t;
  using number_unsigned_t = json::number_unsigned_t;
  using number_float_t = json::number_float_t;
  using string_t = json::string_t;
  using binary_t = json::binary_t;

  explicit Builder(const JsonLimits& limits) : limits_(limits) {}

  bool null() { return value(nullptr, "null"); }
  bool boolean(bool b) { return value(b, "true or false"); }
  bool number_integer(number_integer_t i) { return number(double(i), i); }
  bool number_unsigned(number_unsigned_t i) { return number(double(i), i); }
  bool number_float(number_float_t x, const string_t&) { return number(x, x); }
  bool string(string_t& text) { return value(std::move(text), "text"); }
  bool binary(binary_t&) { return false; }
  bool key(string_t& name) {
    if (!numbers_.empty()) refuse("must be a number or a list, not an object");
    open_.back().key = std::move(name);
    if (open_.back().value->contains(open_.back().key)) refuse("stands twice");
    return true;
  }
  bool start_object(std::size_t) {
    if (!numbers_.empty()) refuse("must be a number or a list, not an object");
    return start(json::object());
  }
  bool end_object() { return end(); }
  bool start_array(std::size_t) {
    const bool first = numbers_.empty() && !open_.empty() && open_.back().value->is_object() &&
                       open_.back().key == "coordinates";
    if (!first && numbers_.empty()) return start(json::array());
    check_depth();
    if (++positions_ > limits_.positions) refuse_count("positions", limits_.positions);
    numbers_.emplace_back();
    return true;
  }
  bool end_array() { return numbers_.empty() ? end() : end_numbers(); }
  bool parse_error(std::size_t position, const std::string&, const json::exception& error) {
    std::string why = error.what();  // "[json.exception.parse_error.101] parse error at ...: why"
    if (const auto bracket = why.find("] "); bracket != why.npos) why.erase(0, bracket + 2);
    if (const auto colon = why.find(": "); colon != why.npos && error.id < 400)
      why.erase(0, colon + 2);
    if (const auto token = why.find("; last read"); token != why.npos) why.resize(token);
    refuse("is not JSON: " + why.substr(0, 200), " (offset " + std::to_string(position) + ")");
  }

  JsonDocument take() { return std::move(document_); }

 private:
  struct Level {
    json* value;
    std::string key;       // of the member being read (objects)
    std::size_t size = 0;  // index of the element being read (arrays)
  };
  struct Numbers {
    std::vector<double> plain;  // numbers that stand directly in this array (at most 2 kept)
    std::size_t count = 0;      // of them
    Coordinates content;
    std::size_t elements() const { return count + content.positions.size() + content.parts.size(); }
  };

  std::string place() const {
    std::string path;
    for (const Level& level : open_) {
      if (level.value->is_array())
        path += "[" + std::to_string(level.size) + "]";
      else
        path += (path.empty() || level.key.empty() ? "" : ".") + level.key.substr(0, 60);
    }
    for (const Numbers& level : numbers_) path += "[" + std::to_string(level.elements()) + "]";
    return path.empty() ? "document" : path;
  }
  [[noreturn]] void refuse(const std::string& why, const std::string& where = "") const {
    throw InputError(place() + where + ": " + why);
  }
  [[noreturn]] void refuse_count(const char* what, std::size_t most) const {
    refuse("more than " + std::to_string(most) + " " + what);
  }
  void check_depth() const {
    if (open_.size() + numbers_.size() >= std::size_t(limits_.depth))
      refuse("nested deeper than " + std::to_string(limits_.depth) + " levels");
  }

  json* add(json&& element) {
    if (++values_ > limits_.values) refuse_count("values", limits_.values);
    if (open_.empty()) {
      document_.root = std::move(element);
      return &document_.root;
    }
    Level& level = open_.back();
    if (level.value->is_array()) {
      level.value->push_back(std::move(element));
      return &level.value->back();
    }
    return &((*level.value)[level.key] = std::move(element));
  }
  bool value(json&& element, const char* what) {
    if (!numbers_.empty()) refuse(std::string("must be a number, not ") + what);
    add(std::move(element));
    if (!open_.empty()) ++open_.back().size;
    return true;
  }
  bool number(double x, json&& element) {
    if (!std::isfinite(x)) refuse("must be a finite number");
    if (numbers_.empty()) return value(std::move(element), "");
    Numbers& level = numbers_.back();
    if (!level.content.positions.empty() || !level.content.parts.empty())
      refuse("is a number beside lists");
    if (level.count++ < 2) level.plain.push_back(x);
    return true;
  }
  bool start(json&& container) {
    check_depth();
    json* added = add(std::move(container));
    open_.push_back({added, {}, 0});
    return true;
  }
  bool end() {
    open_.pop_back();
    if (!open_.empty()) ++open_.back().size;
    return true;
  }
  bool end_numbers() {
    Numbers done = std::move(numbers_.back());
    numbers_.pop_back();
    if (done.count == 1) refuse("a position needs two numbers (east and north)");
    if (done.count > 0) {
      const glm::dvec2 position{done.plain[0], done.plain[1]};
      if (!numbers_.empty()) {
        if (numbers_.back().count > 0 || !numbers_.back().content.parts.empty())
          refuse("is a position beside something else");
        numbers_.back().content.positions.push_back(position);
        return true;
      }
      done.content.single = true;
      done.content.positions.push_back(position);
    } else if (!numbers_.empty()) {
      if (numbers_.back().count > 0 || !numbers_.back().content.positions.empty())
        refuse("is a list beside positions or numbers");
      numbers_.back().content.parts.push_back(std::move(done.content));
      return true;
    }
    add(json::binary({}, document_.coordinates.size()));
    document_.coordinates.push_back(std::move(done.content));
    return true;
  }

  JsonLimits limits_;
  JsonDocument document_;
  std::vector<Level> open_;
  std::vector<Numbers> numbers_;
  std::size_t values_ = 0, positions_ = 0;
};

}  // namespace

JsonDocument parse_json(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    throw InputError("document: larger than " + std::to_string(limits.bytes >> 20) + " MiB (" +
                     std::to_string(text.size()) + " bytes)");
  Builder builder(limits);
  json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace orogen
