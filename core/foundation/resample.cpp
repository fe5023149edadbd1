#include "foundation/resample.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

/// Along one axis: for each target cell the source cells it is made of, with weights that sum to 1.
struct Taps {
  std::vector<int> begin{0}, cell;
  std::vector<float> weight;

  void add(int source_cell, double w, int count) {
    cell.push_back(std::clamp(source_cell, 0, count - 1));
    weight.push_back(float(w));
  }
  void close() { begin.push_back(int(cell.size())); }
};

struct Axis {
  int source_count, target_count;
  double ratio, shift;  // a target coordinate t (cells) is ratio * t + shift in source cells

  double center(int t) const { return ratio * (t + 0.5) + shift - 0.5; }
};

Axis x_axis(const Grid& source, const Grid& target) {
  return {source.nx, target.nx, target.cell_size / source.cell_size,
          (target.origin.x - source.origin.x) / source.cell_size};
}

Axis y_axis(const Grid& source, const Grid& target) {
  return {source.ny, target.ny, target.cell_size / source.cell_size,
          (target.origin.y - source.origin.y) / source.cell_size};
}

/// Cell at or before a position, kept where an int can hold it.
int floor_cell(double position, int count) {
  return int(std::floor(std::clamp(position, -4.0, count + 4.0)));
}

Taps linear_taps(const Axis& a) {
  Taps taps;
  for (int t = 0; t < a.target_count; ++t, taps.close()) {
    const double x = std::clamp(a.center(t), 0.0, a.source_count - 1.0);
    const int i = floor_cell(x, a.source_count);
    taps.add(i, 1.0 - (x - i), a.source_count);
    taps.add(i + 1, x - i, a.source_count);
  }
  return taps;
}

Taps cubic_taps(const Axis& a) {
  Taps taps;
  for (int t = 0; t < a.target_count; ++t, taps.close()) {
    const double x = std::clamp(a.center(t), 0.0, a.source_count - 1.0);
    const int i = floor_cell(x, a.source_count);
    const double f = x - i, f2 = f * f, f3 = f2 * f;
    taps.add(i - 1, 0.5 * (-f3 + 2.0 * f2 - f), a.source_count);
    taps.add(i, 0.5 * (3.0 * f3 - 5.0 * f2 + 2.0), a.source_count);
    taps.add(i + 1, 0.5 * (-3.0 * f3 + 4.0 * f2 + f), a.source_count);
    taps.add(i + 2, 0.5 * (f3 - f2), a.source_count);
  }
  return taps;
}

Taps mean_taps(const Axis& a) {
  Taps taps;
  const double count = a.source_count;
  for (int t = 0; t < a.target_count; ++t, taps.close()) {
    const double from = std::clamp(a.ratio * t + a.shift, 0.0, count);
    const double to = std::clamp(a.ratio * (t + 1) + a.shift, 0.0, count);
    if (to - from < 1e-9) {
      taps.add(floor_cell(a.center(t) + 0.5, a.source_count), 1.0, a.source_count);
      continue;
    }
    for (int i = int(from); i < std::ceil(to); ++i)
      taps.add(i, (std::min(to, i + 1.0) - std::max(from, double(i))) / (to - from),
               a.source_count);
  }
  return taps;
}

OROGEN_CLONES void add_row(const float* source, float weight, int count, float* sum) {
  for (int c = 0; c < count; ++c) sum[c] += weight * source[c];
}

OROGEN_CLONES void add_row_in_double(const float* source, double weight, int count, double* sum) {
  for (int c = 0; c < count; ++c) sum[c] += weight * source[c];
}

void check(const Grid& source, const Grid& target) {
  if (source.size() == 0) throw InputError("resample: the source grid has no cells");
  if (!(target.cell_size > 0.0 && source.cell_size > 0.0))
    throw InputError("resample: cell_size must be above 0");
}

/// Sum is float for a few taps, double for means over many.
template <class Sum, class AddRow>
Raster<float> apply(const Raster<float>& source, const Grid& target, const Taps& x, const Taps& y,
                    AddRow add, const Context& context) {
  Raster<float> result(target);
  parallel_chunks(context, std::size_t(target.ny), 8, [&](std::size_t first, std::size_t last) {
    std::vector<Sum> row(source.grid().nx);
    for (std::size_t r = first; r < last; ++r) {
      std::fill(row.begin(), row.end(), Sum(0));
      for (int k = y.begin[r]; k < y.begin[r + 1]; ++k)
        add(source.row(y.cell[k]), y.weight[k], source.grid().nx, row.data());
      float* out = result.row(int(r));
      for (int c = 0; c < target.nx; ++c) {
        Sum sum = 0;
        for (int k = x.begin[c]; k < x.begin[c + 1]; ++k) sum += x.weight[k] * row[x.cell[k]];
        out[c] = float(sum);
      }
    }
  });
  return result;
}

}  // namespace

Raster<float> resample_bilinear(const Raster<float>& source, const Grid& target,
                                const Context& context) {
  check(source.grid(), target);
  if (source.grid() == target) return source;
  return apply<float>(source, target, linear_taps(x_axis(source.grid(), target)),
                      linear_taps(y_axis(source.grid(), target)), add_row, context);
}

Raster<float> resample_bicubic(const Raster<float>& source, const Grid& target,
                               const Context& context) {
  check(source.grid(), target);
  if (source.grid() == target) return source;
  return apply<float>(source, target, cubic_taps(x_axis(source.grid(), target)),
                      cubic_taps(y_axis(source.grid(), target)), add_row, context);
}

Raster<float> resample_mean(const Raster<float>& source, const Grid& target,
                            const Context& context) {
  check(source.grid(), target);
  if (source.grid() == target) return source;
  return apply<double>(source, target, mean_taps(x_axis(source.grid(), target)),
                       mean_taps(y_axis(source.grid(), target)), add_row_in_double, context);
}

Raster<std::uint8_t> resample_nearest(const Raster<std::uint8_t>& source, const Grid& target,
                                      const Context& context) {
  check(source.grid(), target);
  if (source.grid() == target) return source;
  const auto nearest = [](const Axis& a) {
    std::vector<int> cell(a.target_count);
    for (int t = 0; t < a.target_count; ++t)
      cell[t] = std::clamp(floor_cell(a.center(t) + 0.5, a.source_count), 0, a.source_count - 1);
    return cell;
  };
  const std::vector<int> x = nearest(x_axis(source.grid(), target));
  const std::vector<int> y = nearest(y_axis(source.grid(), target));
  Raster<std::uint8_t> result(target);
  parallel_rows(context, target.ny, [&](int r) {
    for (int c = 0; c < target.nx; ++c) result(r, c) = source(y[r], x[c]);
  });
  return result;
}

void multiply(Raster<float>& field, const Raster<float>* factor, const Context& context) {
  if (!factor) return;
  const Raster<float> there = resample_mean(*factor, field.grid(), context);
  for (std::size_t i = 0; i < field.size(); ++i) field[i] *= there[i];
}

}  // namespace orogen
