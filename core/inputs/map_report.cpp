#include "inputs/map_report.h"

#include <cmath>
#include <cstdio>

#include "foundation/errors.h"

namespace orogen {
namespace {

constexpr std::size_t kMostWarnings = 1000;

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

}  // namespace

std::string MapReport::place(glm::dvec2 p) const {
  if (units_ == MapUnits::Degrees && projection_) {
    const glm::dvec2 g = projection_->unproject(p);
    return format("(%.4f°, %.4f°)", g.x, g.y);
  }
  const glm::dvec2 q = p - corner_;
  if (units_ == MapUnits::Kilometres) return format("(%.3f km, %.3f km)", q.x / 1e3, q.y / 1e3);
  return format("(%.1f m, %.1f m)", q.x, q.y);
}

void MapReport::warn(const std::string& message) {
  if (strict_) throw InputError(message + " (refused: strict)");
  if (warnings_.size() < kMostWarnings)
    warnings_.push_back(message);
  else
    ++left_out_;
}

std::vector<std::string> MapReport::take_warnings() {
  if (left_out_ > 0) warnings_.push_back("and " + std::to_string(left_out_) + " more");
  left_out_ = 0;
  return std::move(warnings_);
}

std::string feature_words(std::string_view kind, int feature, std::size_t index,
                          std::string_view name) {
  const std::string called = name.empty() ? "" : "'" + shown(name) + "'";
  if (feature >= 0)
    return "features[" + std::to_string(feature) + "] (" + std::string(kind) +
           (called.empty() ? "" : " " + called) + ")";
  return std::string(kind) + "s[" + std::to_string(index) + "]" +
         (called.empty() ? "" : " (" + called + ")");
}

std::string distance_words(double metres) {
  return metres >= 1000.0 ? format("%.1f km", metres / 1e3) : format("%.0f m", metres);
}

std::string shown(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, 60)) result += (unsigned char)c < 0x20 || c == 0x7f ? ' ' : c;
  if (text.size() > 60) {
    while (!result.empty() && (result.back() & 0xc0) == 0x80) result.pop_back();
    if (!result.empty() && (result.back() & 0x80)) result.pop_back();
    result += "…";
  }
  return result;
}

}  // namespace orogen
