#include "pipeline/terrain.h"

#include <stdexcept>

#include "foundation/fields.h"

namespace orogen {

namespace {

[[noreturn]] void refuse_type(std::string_view name) {
  throw std::invalid_argument("field '" + std::string(name) + "' is declared with the other type");
}

}  // namespace

std::size_t field_bytes(const Field& field) {
  return std::visit([](const auto& raster) { return raster->size() * sizeof((*raster)[0]); },
                    field);
}

const Field& Terrain::field(std::string_view name) const {
  const auto found = fields_.find(name);
  if (found == fields_.end())
    throw std::out_of_range("the terrain has no field '" + std::string(name) + "'");
  return found->second;
}

const Raster<float>& Terrain::real(std::string_view name) const {
  if (const auto* found = std::get_if<RealField>(&field(name))) return **found;
  refuse_type(name);
}

const Raster<std::int32_t>& Terrain::integer(std::string_view name) const {
  if (const auto* found = std::get_if<IntegerField>(&field(name))) return **found;
  refuse_type(name);
}

void Terrain::set(std::string_view name, Raster<float> values) {
  set(name, Field(std::make_shared<const Raster<float>>(std::move(values))));
}

void Terrain::set(std::string_view name, Raster<std::int32_t> values) {
  set(name, Field(std::make_shared<const Raster<std::int32_t>>(std::move(values))));
}

void Terrain::set(std::string_view name, Field field) {
  const bool real = std::holds_alternative<RealField>(field);
  if (real != (field_info(name).type == FieldType::Real)) refuse_type(name);
  const Grid& grid = std::visit([](const auto& f) -> const Grid& { return f->grid(); }, field);
  if (!(grid == grid_))
    throw std::invalid_argument("field '" + std::string(name) + "' lies on another grid");
  fields_.insert_or_assign(std::string(name), std::move(field));
}

void Terrain::erase(std::string_view name) {
  if (const auto found = fields_.find(name); found != fields_.end()) fields_.erase(found);
}

}  // namespace orogen
