// Small maps and helpers for the tests of inputs.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "foundation/errors.h"
#include "foundation/random.h"
#include "inputs/geojson.h"

namespace orogen::test {

/// Seeded numbers, one after the other.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * random_uniform(seed_, 0, counter_++);
  }
  int below(int n) { return int(uniform(0.0, n)); }

 private:
  std::uint64_t seed_, counter_ = 0;
};

/// A planar map (km) of these features.
inline std::string collection(const std::string& features,
                              const std::string& members = R"("units": "km",)") {
  return R"({"type": "FeatureCollection", )" + members + R"( "features": [)" + features + "]}";
}
inline std::string feature(const std::string& properties, const std::string& type,
                           const std::string& coordinates) {
  return R"({"type": "Feature", "properties": {)" + properties + R"(}, "geometry": {"type": ")" +
         type + R"(", "coordinates": )" + coordinates + "}}";
}
/// A square island of 100 km at (10, 10) km.
inline std::string island() {
  return feature(R"("kind": "coast", "name": "I")", "Polygon",
                 "[[[10,10],[110,10],[110,110],[10,110],[10,10]]]");
}
inline std::string river(const std::string& points, const std::string& more = "") {
  return feature(R"("kind": "river")" + more, "LineString", points);
}
inline std::string peak(const std::string& place, const std::string& more = "") {
  return feature(R"("kind": "peak")" + more, "Point", place);
}

/// The message with which a text is refused; fails if it is not.
inline std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  try {
    read_geojson(text, options);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "was accepted: " << text.substr(0, 300);
  return {};
}

/// A map of the shared data, or one that ships.
inline std::optional<std::filesystem::path> map_file(const std::string& name) {
  const std::filesystem::path source = OROGEN_SOURCE_DIR;
  std::vector<std::filesystem::path> folders{source / "core/python/orogen/maps",
                                             source / "../shared/data"};
  if (const char* shared = std::getenv("OROGEN_SHARED"))
    folders.push_back(std::filesystem::path(shared) / "data");
  for (const auto& folder : folders)
    if (std::filesystem::exists(folder / name)) return folder / name;
  return {};
}

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace orogen::test
