// The named fields of a terrain: name, unit and one sentence, declared once. The same names are
// mesh attributes, volume grids and file channels.
#pragma once

#include <span>
#include <string_view>

namespace orogen {

enum class FieldType { Real, Integer };  // float32, int32

struct FieldInfo {
  std::string_view name;
  FieldType type;
  std::string_view unit;  // empty: a pure number
  std::string_view text;
};

std::span<const FieldInfo> known_fields();

/// The declaration of a field; throws std::out_of_range for a name that is not declared.
const FieldInfo& field_info(std::string_view name);

}  // namespace orogen
