#include "arrays.h"

#include <cmath>
#include <cstring>

#include "foundation/errors.h"
#include "foundation/parameters.h"

namespace orogen::python {

namespace {

constexpr double kLargestCell = 1e7;  // m

std::string shape_of(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

[[noreturn]] void refuse_shape(const py::array& array, const char* name,
                               const std::string& wanted) {
  throw InputError(std::string(name) + ": shape " + shape_of(array) + " is not allowed; " + wanted +
                   " is wanted");
}

py::array any_array(const py::handle& value, const char* name) {
  const py::array given = py::array::ensure(py::reinterpret_borrow<py::object>(value));
  if (given) return given;
  PyErr_Clear();
  throw InputError(std::string(name) + ": no array");
}

/// The array with numbers of this type.
template <class T>
py::array numbers_of(const py::array& given, const char* name) {
  const std::string kinds = std::is_floating_point_v<T> ? "biuf" : "biu";
  if (kinds.find(given.dtype().kind()) == std::string::npos)
    throw InputError(std::string(name) + ": type " + py::str(given.dtype()).cast<std::string>() +
                     " is not allowed; " + (std::is_floating_point_v<T> ? "numbers" : "integers") +
                     " are wanted");
  return py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(given);
}

template <class T>
py::array as_array(const py::handle& value, const char* name) {
  const py::array given = any_array(value, name);
  if (given.ndim() != 2 || given.shape(0) < 1 || given.shape(1) < 1)
    refuse_shape(given, name, "(ny, nx), each at least 1,");
  return numbers_of<T>(given, name);
}

bool is_number(const py::handle& value) {
  return PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr());
}

double to_number(const py::handle& value, const char* name) {
  const double number = value.cast<double>();
  if (!std::isfinite(number)) throw InputError(std::string(name) + ": a finite number is wanted");
  return number;
}

template <class T>
void check_finite(const Raster<T>& raster, const char* name) {
  if constexpr (std::is_floating_point_v<T>)
    for (int row = 0; row < raster.grid().ny; ++row)
      for (int column = 0; column < raster.grid().nx; ++column)
        if (!std::isfinite(raster(row, column)))
          throw InputError(std::string(name) + "[" + std::to_string(row) + ", " +
                           std::to_string(column) +
                           "]: " + detail::format_number(raster(row, column)) +
                           " is not allowed; a finite number is wanted");
}

}  // namespace

py::array to_array(const Field& field) {
  return std::visit(
      [](const auto& shared) -> py::array {
        using Shared = std::decay_t<decltype(shared)>;
        const py::capsule owner(new Shared(shared),
                                [](void* p) { delete static_cast<Shared*>(p); });
        return array_view(shared->grid(), shared->data(), owner, false);
      },
      field);
}

template <class T>
Raster<T> to_raster(const py::handle& value, const char* name, double cell_size) {
  if (!(cell_size > 0.0 && cell_size <= kLargestCell))
    throw InputError("cell_size: " + detail::format_number(cell_size) +
                     " is not allowed; a number above 0, up to 10000000 m is wanted");
  const py::array array = as_array<T>(value, name);
  Raster<T> raster(Grid{int(array.shape(1)), int(array.shape(0)), cell_size, {0.0, 0.0}});
  std::memcpy(raster.data(), array.data(), raster.size() * sizeof(T));
  check_finite(raster, name);
  return raster;
}

template <class T>
Raster<T> to_raster(const py::handle& value, const char* name, const Grid& grid) {
  const py::array array = as_array<T>(value, name);
  if (array.shape(0) != grid.ny || array.shape(1) != grid.nx)
    refuse_shape(array, name,
                 "(" + std::to_string(grid.ny) + ", " + std::to_string(grid.nx) +
                     "), as of the other arrays,");
  Raster<T> raster(grid);
  std::memcpy(raster.data(), array.data(), raster.size() * sizeof(T));
  check_finite(raster, name);
  return raster;
}

template Raster<float> to_raster(const py::handle&, const char*, double);
template Raster<float> to_raster(const py::handle&, const char*, const Grid&);
template Raster<std::int32_t> to_raster(const py::handle&, const char*, double);
template Raster<std::int32_t> to_raster(const py::handle&, const char*, const Grid&);

Raster<std::uint8_t> to_mask(const py::handle& value, const char* name, const Grid& grid) {
  const auto numbers = to_raster<std::int32_t>(value, name, grid);
  Raster<std::uint8_t> mask(grid);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = numbers[i] != 0;
  return mask;
}

std::vector<glm::dvec2> to_points(const py::handle& value, const char* name) {
  const py::array given = any_array(value, name);
  if (given.ndim() != 2 || given.shape(1) != 2) refuse_shape(given, name, "(n, 2)");
  const py::array array = numbers_of<double>(given, name);
  std::vector<glm::dvec2> points(std::size_t(given.shape(0)));
  std::memcpy(points.data(), array.data(), points.size() * sizeof(glm::dvec2));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y))
      throw InputError(std::string(name) + "[" + std::to_string(i) + "]: a finite place is wanted");
  return points;
}

template <class T>
std::vector<T> to_vector(const py::handle& value, const char* name, std::size_t count) {
  const py::array given = any_array(value, name);
  if (given.ndim() != 1 || std::size_t(given.shape(0)) != count)
    refuse_shape(given, name, "(" + std::to_string(count) + ",), one for each vertex,");
  const py::array array = numbers_of<T>(given, name);
  const T* data = static_cast<const T*>(array.data());
  std::vector<T> numbers(data, data + count);
  if constexpr (std::is_floating_point_v<T>)
    for (std::size_t i = 0; i < count; ++i)
      if (!std::isfinite(numbers[i]))
        throw InputError(std::string(name) + "[" + std::to_string(i) +
                         "]: a finite number is wanted");
  return numbers;
}

template std::vector<float> to_vector(const py::handle&, const char*, std::size_t);
template std::vector<double> to_vector(const py::handle&, const char*, std::size_t);
template std::vector<std::int32_t> to_vector(const py::handle&, const char*, std::size_t);

VaryingArgument::VaryingArgument(const py::handle& value, const char* name, const Grid& grid) {
  if (is_number(value))
    value_ = to_number(value, name);
  else
    raster_ = to_raster<float>(value, name, grid);
}

VertexArgument::VertexArgument(const py::handle& value, const char* name, std::size_t count) {
  if (is_number(value))
    value_ = to_number(value, name);
  else
    each_ = to_vector<float>(value, name, count);
}

}  // namespace orogen::python
