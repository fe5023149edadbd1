// Words for what was found in a map: which feature, where, and what was mended.
//
// Places are written as the map's maker wrote them: degrees for maps in longitude and latitude,
// kilometres or metres from the frame's corner for planar ones.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "inputs/projection.h"

namespace orogen {

enum class MapUnits { Degrees, Kilometres, Metres };

class MapReport {
 public:
  explicit MapReport(bool strict, MapUnits units = MapUnits::Metres, glm::dvec2 corner = {})
      : strict_(strict), units_(units), corner_(corner) {}

  void set_projection(const Projection& projection) { projection_ = projection; }

  /// "(9.1003°, 42.3012°)", "(37.16 km, 114.68 km)" or "(371600 m, 12 m)".
  std::string place(glm::dvec2 position) const;

  /// Notes what was mended; an InputError if the map is to be taken strictly.
  void warn(const std::string& message);

  std::vector<std::string> take_warnings();

 private:
  bool strict_;
  MapUnits units_;
  glm::dvec2 corner_;
  std::optional<Projection> projection_;
  std::vector<std::string> warnings_;
  std::size_t left_out_ = 0;
};

/// "features[12] (peak 'Monte X')"; "peaks[3] ('Monte X')" for what comes from no file.
std::string feature_words(std::string_view kind, int feature, std::size_t index,
                          std::string_view name);

/// "4.2 km" or "320 m".
std::string distance_words(double metres);

/// A text from a file, short and without control characters.
std::string shown(std::string_view text);

}  // namespace orogen
