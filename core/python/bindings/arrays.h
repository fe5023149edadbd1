// Rasters and NumPy arrays. Results are handed over without a copy: the array's base keeps the
// memory alive. Arguments are copied into rasters, since the work goes on without the GIL.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "foundation/raster.h"
#include "foundation/varying.h"
#include "foundation/vertex_values.h"
#include "pipeline/terrain.h"

namespace orogen::python {

namespace py = pybind11;

/// A view, shape (ny, nx), of memory that `owner` keeps alive.
template <class T>
py::array array_view(const Grid& grid, const T* data, const py::handle& owner, bool writeable) {
  py::array view(py::dtype::of<T>(), {py::ssize_t(grid.ny), py::ssize_t(grid.nx)}, data, owner);
  if (!writeable) view.attr("flags").attr("writeable") = false;
  return view;
}

/// A result that Python owns from now on.
template <class T>
py::array to_array(Raster<T> raster) {
  auto* owned = new Raster<T>(std::move(raster));
  const py::capsule owner(owned, [](void* p) { delete static_cast<Raster<T>*>(p); });
  return array_view(owned->grid(), owned->data(), owner, true);
}

/// A field, shared with the terrain and the cache: read-only.
py::array to_array(const Field& field);

/// A raster member of a bound struct as a property: a read-only view that keeps the struct alive.
template <class S, class T, class... Options>
void raster_property(py::class_<S, Options...>& type, const char* name, Raster<T> S::*member,
                     const char* text) {
  type.def_property_readonly(
      name,
      [member](const py::object& self) {
        const Raster<T>& raster = self.cast<const S&>().*member;
        return array_view(raster.grid(), raster.data(), self, false);
      },
      text);
}

/// A vector as an array of shape (n), or (n, width) where items are structs of `width` numbers.
/// With an owner, who keeps the memory alive, a read-only view; else a copy.
template <class Number, class Item>
py::array to_array(const std::vector<Item>& items, const py::handle& owner = {}) {
  static_assert(sizeof(Item) % sizeof(Number) == 0);
  std::vector<py::ssize_t> shape{py::ssize_t(items.size())};
  if constexpr (std::is_class_v<Item>) shape.push_back(sizeof(Item) / sizeof(Number));
  py::array array(py::dtype::of<Number>(), std::move(shape),
                  reinterpret_cast<const Number*>(items.data()), owner);
  if (owner) array.attr("flags").attr("writeable") = false;
  return array;
}

/// A vector member of a bound struct as a property: a read-only view that keeps the struct alive.
template <class Number, class S, class Item, class... Options>
void vector_property(py::class_<S, Options...>& type, const char* name,
                     std::vector<Item> S::*member, const char* text) {
  type.def_property_readonly(
      name,
      [member](const py::object& self) {
        return to_array<Number>(self.cast<const S&>().*member, self);
      },
      text);
}

/// An argument of shape (ny, nx), floats finite, of any type that NumPy casts safely. InputError
/// naming it otherwise. `grid`: where it lies; nullptr: its shape and `cell_size` say.
template <class T>
Raster<T> to_raster(const py::handle& array, const char* name, double cell_size);
template <class T>
Raster<T> to_raster(const py::handle& array, const char* name, const Grid& grid);

/// A mask: not 0 where true.
Raster<std::uint8_t> to_mask(const py::handle& array, const char* name, const Grid& grid);

/// An argument of shape (n, 2): places in metres, finite.
std::vector<glm::dvec2> to_points(const py::handle& array, const char* name);

/// An argument with one number, finite, for each of `count` vertices.
template <class T>
std::vector<T> to_vector(const py::handle& array, const char* name, std::size_t count);

/// A number for everywhere or an array.
class VaryingArgument {
 public:
  VaryingArgument(const py::handle& value, const char* name, const Grid& grid);
  Varying varying() const { return raster_.empty() ? Varying(value_) : Varying(raster_); }

 private:
  double value_ = 0.0;
  Raster<float> raster_;
};

/// A number for everywhere or one for each vertex.
class VertexArgument {
 public:
  VertexArgument(const py::handle& value, const char* name, std::size_t count);
  VertexValues values() const { return each_.empty() ? VertexValues(value_) : VertexValues(each_); }

 private:
  double value_ = 0.0;
  std::vector<float> each_;
};

}  // namespace orogen::python
