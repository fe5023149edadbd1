// A quantity over a TIN that is either the same everywhere or given vertex by vertex (as Varying is
// on a grid).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "foundation/errors.h"

namespace orogen {

struct VertexValues {
  double value = 0.0;
  std::span<const float> values{};  // if given, they count and `value` does not; not owned

  VertexValues() = default;
  VertexValues(double constant) : value(constant) {}
  VertexValues(std::span<const float> each) : values(each) {}

  double at(std::int32_t vertex) const { return values.empty() ? value : double(values[vertex]); }

  /// InputError if there are values, but not one for each vertex.
  void check(std::size_t vertices, const std::string& name) const {
    if (!values.empty() && values.size() != vertices)
      throw InputError(name + ": " + std::to_string(values.size()) + " values, the TIN has " +
                       std::to_string(vertices) + " vertices");
  }
};

}  // namespace orogen
