// A terrain: a grid, and the named fields that stages have written on it.
//
// Every field is declared in foundation/fields.h (name, type, unit, sentence). A field is shared
// and constant once set, so that copies of a terrain and cached results cost no memory; a stage
// that changes a field sets a new one.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "foundation/raster.h"

namespace orogen {

using RealField = std::shared_ptr<const Raster<float>>;
using IntegerField = std::shared_ptr<const Raster<std::int32_t>>;
using Field = std::variant<RealField, IntegerField>;
using FieldMap = std::map<std::string, Field, std::less<>>;

std::size_t field_bytes(const Field& field);

class Terrain {
 public:
  explicit Terrain(const Grid& grid) : grid_(grid) {}

  const Grid& grid() const { return grid_; }
  const FieldMap& fields() const { return fields_; }
  bool has(std::string_view name) const { return fields_.find(name) != fields_.end(); }

  /// A field by name. std::out_of_range if the terrain lacks it, std::invalid_argument if it is of
  /// the other type.
  const Field& field(std::string_view name) const;
  const Raster<float>& real(std::string_view name) const;
  const Raster<std::int32_t>& integer(std::string_view name) const;

  /// Adds or replaces a field. std::out_of_range for a name that is not declared,
  /// std::invalid_argument for another type or grid than declared.
  void set(std::string_view name, Raster<float> values);
  void set(std::string_view name, Raster<std::int32_t> values);
  void set(std::string_view name, Field field);

  void erase(std::string_view name);

 private:
  Grid grid_;
  FieldMap fields_;
};

}  // namespace orogen
