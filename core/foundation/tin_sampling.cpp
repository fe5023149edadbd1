#include "foundation/tin_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "foundation/bilinear.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr std::size_t kChunk = 4096;
constexpr int kBandRows = 16;
constexpr double kSlack = 1e-9;  // of a cell or a triangle: no point falls between two triangles

/// The numbers of things sorted by bucket: those of bucket b are items[begin[b]] on.
struct Buckets {
  std::vector<std::int32_t> begin, items;

  /// each(item, put) calls put(bucket) for every bucket of an item, the same ones each time.
  template <class Each>
  Buckets(std::size_t buckets, std::size_t count, Each&& each) : begin(buckets + 1, 0) {
    for (std::size_t i = 0; i < count; ++i) each(i, [&](std::size_t b) { ++begin[b + 1]; });
    for (std::size_t b = 0; b < buckets; ++b) begin[b + 1] += begin[b];
    items.resize(begin.back());
    std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < count; ++i)
      each(i, [&](std::size_t b) { items[next[b]++] = std::int32_t(i); });
  }
};

void check_field(const Tin& tin, VertexField field) {
  if (field.size() != tin.size())
    throw InputError("field: " + std::to_string(field.size()) + " values, the TIN has " +
                     std::to_string(tin.size()) + " vertices");
}

struct Triangle {
  std::array<std::int32_t, 3> vertices;
  glm::dvec2 corner[3], a, b;  // corners, and the ways from the first to the others
  double per_area;

  Triangle(const Tin& tin, std::int32_t number) : vertices(tin.triangles[number]) {
    for (int k = 0; k < 3; ++k) corner[k] = tin.points[vertices[k]];
    a = corner[1] - corner[0];
    b = corner[2] - corner[0];
    per_area = 1.0 / (a.x * b.y - a.y * b.x);
  }
  bool has_area() const { return a.x * b.y - a.y * b.x > 0.0; }
};

/// The plane through a field's three values.
struct Plane {
  double value, low, high;
  glm::dvec2 corner, gradient;

  Plane(const Triangle& t, VertexField field) : corner(t.corner[0]) {
    const double z[] = {field[t.vertices[0]], field[t.vertices[1]], field[t.vertices[2]]};
    const double da = z[1] - z[0], db = z[2] - z[0];
    value = z[0];
    gradient = {(da * t.b.y - db * t.a.y) * t.per_area, (db * t.a.x - da * t.b.x) * t.per_area};
    low = std::min({z[0], z[1], z[2]});
    high = std::max({z[0], z[1], z[2]});
  }
  double at(glm::dvec2 p) const {
    const glm::dvec2 way = p - corner;
    return std::clamp(value + gradient.x * way.x + gradient.y * way.y, low, high);
  }
};

/// Where the horizontal line at y runs through a triangle: [first, second], or nothing.
std::pair<double, double> chord(const glm::dvec2 (&corner)[3], double y) {
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec2 a = corner[k], b = corner[(k + 1) % 3];
    if ((y < a.y && y < b.y) || (y > a.y && y > b.y)) continue;
    if (a.y == b.y) {
      from = std::min({from, a.x, b.x});
      to = std::max({to, a.x, b.x});
      continue;
    }
    const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    from = std::min(from, x);
    to = std::max(to, x);
  }
  return {from, to};
}

/// Rows or columns of a grid by the place of their centres, those beyond the domain moved to its
/// side.
struct Centers {
  double low, high, first, step;  // m
  int count;

  double at(int k) const { return std::clamp(first + k * step, low, high); }
  int from(double place) const {
    if (place <= low) return 0;
    return std::clamp(int(std::ceil((place - first) / step - kSlack)), 0, count);
  }
  int to(double place) const {  // past the last
    if (place >= high) return count;
    return std::clamp(int(std::floor((place - first) / step + kSlack)) + 1, 0, count);
  }
};

/// Where a triangle covers cells' centres: columns [first, second) of each row of a band.
struct Covered {
  int row, row_end;
  bool any = false;
  std::array<std::pair<int, int>, kBandRows> columns;
  std::array<double, kBandRows> y;  // m, of the rows' centres, within the triangle
};

Covered covered_by(const Triangle& triangle, const Centers& rows, const Centers& columns, int row,
                   int row_end) {
  const auto [south, north] =
      std::minmax({triangle.corner[0].y, triangle.corner[1].y, triangle.corner[2].y});
  Covered found;
  found.row = std::max(row, rows.from(south));
  found.row_end = std::min(row_end, rows.to(north));
  for (int r = found.row; r < found.row_end; ++r) {
    const int i = r - found.row;
    found.y[i] = std::clamp(rows.at(r), south, north);
    const auto [west, east] = chord(triangle.corner, found.y[i]);
    found.columns[i] = {columns.from(west), columns.to(east)};
    found.any |= found.columns[i].first < found.columns[i].second;
  }
  return found;
}

/// paint(number, triangle, covered, columns) for each triangle that has an area, band by band of
/// rows.
template <class Paint>
void paint_all(const Tin& tin, const Grid& grid, const Context& context, Paint&& paint) {
  const glm::dvec2 low = tin.domain.origin, high = tin.domain.far_corner();
  const glm::dvec2 first = grid.center(0, 0);
  const Centers rows{low.y, high.y, first.y, grid.cell_size, grid.ny};
  const Centers columns{low.x, high.x, first.x, grid.cell_size, grid.nx};
  const Buckets bands(
      std::size_t(grid.ny + kBandRows - 1) / kBandRows, tin.triangles.size(),
      [&](std::size_t number, auto&& put) {
        const Triangle triangle(tin, std::int32_t(number));
        if (!triangle.has_area()) return;
        const auto [south, north] =
            std::minmax({triangle.corner[0].y, triangle.corner[1].y, triangle.corner[2].y});
        const int begin = rows.from(south), end = rows.to(north);
        for (int b = begin / kBandRows; begin < end && b <= (end - 1) / kBandRows; ++b) put(b);
      });
  parallel_chunks(context, bands.begin.size() - 1, 1, [&](std::size_t band, std::size_t) {
    const int row = int(band) * kBandRows, row_end = std::min(grid.ny, row + kBandRows);
    for (std::int32_t i = bands.begin[band]; i < bands.begin[band + 1]; ++i) {
      const Triangle triangle(tin, bands.items[i]);
      const Covered covered = covered_by(triangle, rows, columns, row, row_end);
      if (covered.any) paint(bands.items[i], triangle, covered, columns);
    }
  });
}

/// Barycentric coordinates of p.
TinPlace place_in(const Tin& tin, std::int32_t triangle, glm::dvec2 p) {
  const auto& t = tin.triangles[triangle];
  const auto twice_area = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
  const glm::dvec2 a = tin.points[t[0]] - p, b = tin.points[t[1]] - p, c = tin.points[t[2]] - p;
  const double ab = twice_area(a, b), bc = twice_area(b, c), ca = twice_area(c, a);
  const double all = ab + bc + ca;
  return {t, {bc / all, ca / all, ab / all}};
}

/// Least barycentric coordinate of p: not below 0 inside.
double depth_inside(const Tin& tin, std::int32_t triangle, glm::dvec2 p) {
  return std::ranges::min(place_in(tin, triangle, p).weights);
}

/// Whether the vertices are the centres of the grid's cells, in its order.
bool is_grid(const Tin& tin, const Grid& grid) {
  const auto same = [&](glm::dvec2 a, glm::dvec2 b) {
    return std::fmax(std::fabs(a.x - b.x), std::fabs(a.y - b.y)) <= kSlack * grid.cell_size;
  };
  return tin.columns == grid.nx && tin.size() == grid.size() &&
         same(tin.points.front(), grid.center(0, 0)) &&
         same(tin.points.back(), grid.center(grid.ny - 1, grid.nx - 1));
}

}  // namespace

std::vector<Raster<float>> sample_to_grid(const Tin& tin, std::span<const VertexField> fields,
                                          const Grid& grid, const Context& context) {
  for (const VertexField field : fields) check_field(tin, field);
  std::vector<Raster<float>> out(fields.size(), Raster<float>(grid));
  if (is_grid(tin, grid)) {
    for (std::size_t k = 0; k < fields.size(); ++k)
      for (std::size_t i = 0; i < grid.size(); ++i) out[k][i] = float(fields[k][i]);
    return out;
  }
  paint_all(
      tin, grid, context,
      [&](std::int32_t, const Triangle& triangle, const Covered& covered, const Centers& columns) {
        for (std::size_t k = 0; k < fields.size(); ++k) {
          const Plane plane(triangle, fields[k]);
          for (int r = covered.row; r < covered.row_end; ++r) {
            const auto [from, to] = covered.columns[r - covered.row];
            const double y = covered.y[r - covered.row];
            float* line = out[k].row(r);
            for (int c = from; c < to; ++c) line[c] = float(plane.at({columns.at(c), y}));
          }
        }
      });
  return out;
}

Raster<float> sample_to_grid(const Tin& tin, VertexField field, const Grid& grid,
                             const Context& context) {
  return std::move(sample_to_grid(tin, {&field, 1}, grid, context).front());
}

Raster<std::int32_t> triangles_on(const Tin& tin, const Grid& grid, const Context& context) {
  Raster<std::int32_t> out(grid, -1);
  paint_all(tin, grid, context,
            [&](std::int32_t number, const Triangle&, const Covered& covered, const Centers&) {
              for (int r = covered.row; r < covered.row_end; ++r) {
                const auto [from, to] = covered.columns[r - covered.row];
                for (int c = from; c < to; ++c) out(r, c) = number;
              }
            });
  return out;
}

std::vector<double> sample_at_points(const Raster<float>& raster,
                                     std::span<const glm::dvec2> points, const Context& context) {
  const Grid& grid = raster.grid();
  if (raster.empty()) throw InputError("raster: has no cells");
  std::vector<double> values(points.size());
  parallel_chunks(context, points.size(), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) values[i] = bilinear_at(grid, points[i])(raster);
  });
  return values;
}

std::vector<TinPlace> locate(const Tin& tin, std::span<const glm::dvec2> points,
                             const Context& context) {
  const glm::dvec2 low = tin.domain.origin, high = tin.domain.far_corner();
  const double side = std::sqrt(tin.domain.area() / double(tin.size()));  // a vertex a bucket
  const int nx = int(tin.domain.size.x / side) + 1, ny = int(tin.domain.size.y / side) + 1;
  const auto column = [&](double x) { return std::clamp(int((x - low.x) / side), 0, nx - 1); };
  const auto row = [&](double y) { return std::clamp(int((y - low.y) / side), 0, ny - 1); };
  const Buckets buckets(
      std::size_t(nx) * ny, tin.triangles.size(), [&](std::size_t triangle, auto&& put) {
        const auto& t = tin.triangles[triangle];
        const glm::dvec2 a = tin.points[t[0]], b = tin.points[t[1]], c = tin.points[t[2]];
        const auto [west, east] = std::minmax({a.x, b.x, c.x});
        const auto [south, north] = std::minmax({a.y, b.y, c.y});
        for (int r = row(south); r <= row(north); ++r)
          for (int k = column(west); k <= column(east); ++k) put(std::size_t(r) * nx + k);
      });
  std::vector<TinPlace> places(points.size());
  parallel_chunks(context, points.size(), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const glm::dvec2 p{std::clamp(points[i].x, low.x, high.x),
                         std::clamp(points[i].y, low.y, high.y)};
      const std::size_t bucket = std::size_t(row(p.y)) * nx + column(p.x);
      std::int32_t found = -1;
      double deepest = -std::numeric_limits<double>::infinity();
      for (std::int32_t k = buckets.begin[bucket]; k < buckets.begin[bucket + 1]; ++k) {
        const double depth = depth_inside(tin, buckets.items[k], p);
        if (depth <= deepest) continue;
        deepest = depth;
        found = buckets.items[k];
        if (depth >= 0.0) break;
      }
      places[i] = place_in(tin, found, p).within();
    }
  });
  return places;
}

std::vector<double> sample_at_points(const Tin& tin, std::span<const double> field,
                                     std::span<const glm::dvec2> points, const Context& context) {
  check_field(tin, field);
  const std::vector<TinPlace> places = locate(tin, points, context);
  std::vector<double> values(points.size());
  parallel_chunks(context, points.size(), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      values[i] = places[i].mix([&](std::int32_t vertex) { return field[vertex]; });
  });
  return values;
}

}  // namespace orogen
