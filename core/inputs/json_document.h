// JSON text read with limits: size, then depth, counts and numbers as they come, before anything
// is allocated for them. What breaks a limit, and what is not JSON, is an InputError that names the
// place in the document and the offset in the text.
//
// Members called "coordinates" are kept apart as plain numbers (24 bytes a position instead of some
// hundred); in the document stands a binary value whose subtype is the index into `coordinates`.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace orogen {

struct JsonLimits {
  std::size_t bytes = std::size_t(512) << 20;
  int depth = 64;                  // arrays and objects inside each other
  std::size_t values = 4'000'000;  // members and elements, positions apart
  std::size_t positions = 10'000'000;
};

/// Nested arrays of positions. A single position has depth 0, a list of positions depth 1.
struct Coordinates {
  bool single = false;                // the value itself is one position
  std::vector<glm::dvec2> positions;  // first two numbers of each
  std::vector<Coordinates> parts;     // never both positions and parts
};

struct JsonDocument {
  nlohmann::json root;
  std::vector<Coordinates> coordinates;
};

JsonDocument parse_json(std::string_view text, const JsonLimits& limits = {});

}  // namespace orogen
