// The contract of a stage, as data: what it reads and writes, and where it comes from.
#pragma once

#include <string_view>
#include <vector>

namespace orogen {

struct StageInfo {
  std::string_view name;                        // as in recipes
  std::string_view text;                        // one sentence
  std::string_view citation;                    // paper, section, equations
  std::vector<std::string_view> reads;          // fields it needs
  std::vector<std::string_view> writes;         // fields it makes or changes
  std::vector<std::string_view> inputs = {};    // what it needs of the recipe: map, phases, column
  std::vector<std::string_view> may_read = {};  // fields it takes if a stage before it wrote them
};

}  // namespace orogen
