// A field on a grid: one value a cell, contiguous, row-major.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "foundation/grid.h"

namespace orogen {

template <class T>
class Raster {
 public:
  using value_type = T;

  Raster() = default;
  explicit Raster(const Grid& grid, T fill = T{}) : grid_(grid), values_(grid.size(), fill) {}

  const Grid& grid() const { return grid_; }
  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  T& operator()(int row, int column) { return values_[grid_.index(row, column)]; }
  const T& operator()(int row, int column) const { return values_[grid_.index(row, column)]; }
  T* row(int r) { return values_.data() + grid_.index(r, 0); }
  const T* row(int r) const { return values_.data() + grid_.index(r, 0); }
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }

  bool operator==(const Raster&) const = default;

 private:
  Grid grid_;
  std::vector<T> values_;
};

}  // namespace orogen
