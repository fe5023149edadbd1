#include "folding/fold_mesh.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "folding/bilinear.h"
#include "foundation/random.h"

namespace orogen {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

constexpr double kDisc = 0.727;  // radius of a point's disc over λ: mean edge = λ
constexpr double kShortest = 1.0, kLongest = 1e6;  // λ, m
constexpr int kRounds = 30;                        // darts thrown at each cell
constexpr double kMostCells = 60e6;                // some three a point
constexpr std::uint64_t kStream = 0x666f6c64;

/// Cells of the plane that hold at most one point each, with an empty rim.
class Sample {
 public:
  Sample(glm::dvec2 low, glm::dvec2 high, const FoldWavelength& wavelength, std::uint32_t seed)
      : low_(low), high_(high), wavelength_(wavelength), seed_(seed) {
    lowest_ = kDisc * wavelength.lowest();
    highest_ = kDisc * wavelength.highest();
    cell_ = lowest_ / std::numbers::sqrt2;
    reach_ = int(std::ceil(highest_ / cell_));
    column0_ = std::floor(low.x / cell_) - reach_;
    row0_ = std::floor(low.y / cell_) - reach_;
    const double columns = std::floor(high.x / cell_) + reach_ + 1 - column0_;
    const double rows = std::floor(high.y / cell_) + reach_ + 1 - row0_;
    if (!(columns * rows <= kMostCells))
      throw InputError("fold_wavelength: " + std::to_string(wavelength.lowest()) +
                       " m is too short for this map (more than 20 million mesh points)");
    columns_ = int(columns);
    rows_ = int(rows);
    slots_.resize(std::size_t(columns_) * rows_);
  }

  std::vector<glm::dvec2> points(const Context& context) {
    std::vector<Dart> open = cells_in_random_order();
    for (int round = 0; round < kRounds; ++round) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < open.size(); ++i) {
        if (i % 8192 == 0) context.check();
        if (throw_dart(open[i], round)) open[kept++] = open[i];
      }
      open.resize(kept);
    }
    std::vector<glm::dvec2> result;
    for (const Slot& slot : slots_)
      if (slot.x < kFar) result.push_back({slot.x, slot.y});
    return result;
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  struct Slot {
    double x = kFar, y = kFar, radius = 0.0;
  };
  struct Dart {
    std::uint64_t key;
    int row, column;
  };

  std::vector<Dart> cells_in_random_order() const {
    std::vector<Dart> cells;
    cells.reserve(slots_.size());
    for (int r = reach_; r < rows_ - reach_; ++r)
      for (int c = reach_; c < columns_ - reach_; ++c) {
        const auto row = std::uint64_t(std::int64_t(row0_ + r));
        const auto column = std::uint64_t(std::int64_t(column0_ + c));
        cells.push_back({random_bits(seed_, kStream + row, column), r, c});
      }
    std::sort(cells.begin(), cells.end(), [](const Dart& a, const Dart& b) {
      return a.key != b.key ? a.key < b.key
                            : std::pair(a.row, a.column) < std::pair(b.row, b.column);
    });
    return cells;
  }

  // Whether the cell is still worth a dart.
  bool throw_dart(const Dart& cell, int round) {
    const std::uint64_t bits = mix64(cell.key + std::uint64_t(round));
    const double x = (column0_ + cell.column + double(bits >> 32) * 0x1p-32) * cell_;
    const double y = (row0_ + cell.row + double(bits & 0xffffffffu) * 0x1p-32) * cell_;
    if (x < low_.x || x > high_.x || y < low_.y || y > high_.y) return true;
    double radius = lowest_;
    if (lowest_ < highest_) {
      radius = kDisc * wavelength_.at({x, y});
      // As many darts per disc everywhere.
      const double share = (lowest_ / radius) * (lowest_ / radius);
      if (double(mix64(bits) >> 11) * 0x1p-53 > share) return true;
    }
    const int reach = std::min(reach_, int(std::ceil(0.5 * (radius + highest_) / cell_)));
    for (int r = cell.row - reach; r <= cell.row + reach; ++r) {
      const Slot* row = &slots_[std::size_t(r) * columns_];
      for (int c = cell.column - reach; c <= cell.column + reach; ++c) {
        const double dx = row[c].x - x, dy = row[c].y - y;
        const double apart = 0.5 * (radius + row[c].radius);
        if (dx * dx + dy * dy < apart * apart) return !covers(row[c], cell);
      }
    }
    slots_[std::size_t(cell.row) * columns_ + cell.column] = {x, y, radius};
    return false;
  }

  // Whether nothing in the cell is far enough from the point.
  bool covers(const Slot& point, const Dart& cell) const {
    const double x = (column0_ + cell.column + 0.5) * cell_ - point.x;
    const double y = (row0_ + cell.row + 0.5) * cell_ - point.y;
    const double dx = std::fabs(x) + 0.5 * cell_, dy = std::fabs(y) + 0.5 * cell_;
    const double apart = 0.5 * (lowest_ + point.radius);
    return dx * dx + dy * dy < apart * apart;
  }

  glm::dvec2 low_, high_;
  const FoldWavelength& wavelength_;
  std::uint32_t seed_;
  double lowest_, highest_, cell_;  // m
  double column0_, row0_;           // of the first cell, counted from the coordinates' origin
  int reach_, columns_ = 0, rows_ = 0;
  std::vector<Slot> slots_;
};

std::vector<FoldMesh::Face> delaunay_faces(const std::vector<glm::dvec2>& points) {
  std::vector<std::pair<Kernel::Point_2, int>> sites;
  sites.reserve(points.size());
  for (const glm::dvec2 p : points) sites.push_back({{p.x, p.y}, int(sites.size())});
  const Delaunay delaunay(sites.begin(), sites.end());
  std::vector<FoldMesh::Face> faces;
  faces.reserve(2 * points.size());
  if (delaunay.dimension() < 2) return faces;
  for (auto f = delaunay.finite_faces_begin(); f != delaunay.finite_faces_end(); ++f) {
    FoldMesh::Face face{{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}, {}};
    std::rotate(face.points.begin(), std::min_element(face.points.begin(), face.points.end()),
                face.points.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end(),
            [](const auto& a, const auto& b) { return a.points < b.points; });
  return faces;
}

// Edges from the faces' sides: those that start at each point stand together.
void join_edges(FoldMesh& mesh) {
  struct Side {
    int b, face, corner;
    bool forward;  // runs from the lower to the higher point, so that the face lies to its left
  };
  std::vector<int> first(mesh.points.size() + 1, 0);
  const auto for_sides = [&](auto&& body) {
    for (int f = 0; f < int(mesh.faces.size()); ++f)
      for (int k = 0; k < 3; ++k) {
        const int p = mesh.faces[f].points[k], q = mesh.faces[f].points[(k + 1) % 3];
        body(std::min(p, q), Side{std::max(p, q), f, k, p < q});
      }
  };
  for_sides([&](int a, const Side&) { ++first[a + 1]; });
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<Side> sides(3 * mesh.faces.size());
  std::vector<int> next(first.begin(), first.end() - 1);
  for_sides([&](int a, const Side& side) { sides[next[a]++] = side; });
  mesh.edges.reserve(sides.size() / 2 + mesh.points.size());
  for (int a = 0; a < int(mesh.points.size()); ++a) {
    std::sort(sides.begin() + first[a], sides.begin() + first[a + 1],
              [](const auto& s, const auto& t) {
                return std::pair(s.b, t.forward) < std::pair(t.b, s.forward);
              });
    for (int i = first[a]; i < first[a + 1]; ++i) {
      const Side& side = sides[i];
      if (i == first[a] || side.b != sides[i - 1].b) mesh.edges.push_back({a, side.b, -1, -1});
      FoldMesh::Edge& edge = mesh.edges.back();
      (side.forward ? edge.left : edge.right) = side.face;
      mesh.faces[side.face].edges[side.corner] = int(mesh.edges.size()) - 1;
    }
  }
}

}  // namespace

FoldWavelength::FoldWavelength(const Varying& wavelength)
    : wavelength_(wavelength), lowest_(wavelength.value), highest_(wavelength.value) {
  const auto allowed = [](double v) { return v >= kShortest && v <= kLongest; };
  bool good = allowed(wavelength.value);
  if (wavelength.raster) {
    const auto values = wavelength.raster->values();
    good = !values.empty() && std::all_of(values.begin(), values.end(), allowed);
    if (good) {
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      lowest_ = *low;
      highest_ = *high;
    }
  }
  if (!good) throw InputError("fold_wavelength: must lie within 1 m and 1000 km everywhere");
}

double FoldWavelength::at(glm::dvec2 p) const {
  if (!wavelength_.raster) return wavelength_.value;
  const Bilinear place(wavelength_.raster->grid(), p);
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) sum += place.weights[k] * (*wavelength_.raster)[place.cells[k]];
  return sum;
}

FoldMesh fold_mesh(glm::dvec2 low, glm::dvec2 high, const FoldWavelength& wavelength,
                   std::uint32_t seed, const Context& context) {
  const glm::dvec2 margin(wavelength.highest());
  FoldMesh mesh;
  mesh.points = Sample(low - margin, high + margin, wavelength, seed).points(context);
  context.check();
  mesh.faces = delaunay_faces(mesh.points);
  context.check();
  join_edges(mesh);
  return mesh;
}

}  // namespace orogen
