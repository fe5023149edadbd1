#include "folding/fold_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "foundation/bilinear.h"
#include "foundation/delaunay.h"
#include "foundation/kept.h"
#include "foundation/random.h"

namespace orogen {

namespace {

constexpr double kDisc = 0.727;  // radius of a point's disc over λ: mean edge = λ
constexpr double kShortest = 1.0, kLongest = 1e6;  // λ, m
constexpr int kRounds = 30;                        // darts thrown at each cell
constexpr double kMostCells = 60e6;                // some three a point
constexpr std::uint64_t kStream = 0x666f6c64;

/// Cells of the plane that hold at most one point each, with an empty rim. Lengths are in cells.
class Sample {
 public:
  Sample(glm::dvec2 low, glm::dvec2 high, const FoldWavelength& wavelength, std::uint32_t seed)
      : low_(low), high_(high), wavelength_(wavelength), seed_(seed) {
    cell_ = kDisc * wavelength.lowest() / std::numbers::sqrt2;
    lowest_ = std::numbers::sqrt2_v<float>;
    highest_ = float(kDisc * wavelength.highest() / cell_);
    reach_ = int(std::ceil(highest_));
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
    find_neighbours();
  }

  std::vector<glm::dvec2> points(const Context& context) {
    std::vector<Cell> open = cells_in_random_order();
    for (int round = 0; round < kRounds; ++round) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < open.size(); ++i) {
        if (i % 8192 == 0) context.check();
        if (throw_dart(open[i], round)) open[kept++] = open[i];
      }
      open.resize(kept);
    }
    std::vector<glm::dvec2> result;
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c) {
        const Slot& slot = slots_[std::size_t(r) * columns_ + c];
        if (slot.x < kFar) result.push_back(place(r, c, slot.x, slot.y));
      }
    return result;
  }

 private:
  static constexpr float kFar = std::numeric_limits<float>::infinity();
  struct Slot {
    float x = kFar, y = kFar;  // from the cell's corner
    float radius = 0.0f;
  };
  struct Cell {
    std::uint64_t key;
    int row, column;
  };
  struct Neighbour {
    float row, column, gap;
    std::ptrdiff_t slot;  // all four from the cell in the middle
  };

  glm::dvec2 place(int row, int column, float x, float y) const {
    return cell_ * glm::dvec2(column0_ + column + x, row0_ + row + y);
  }

  // Cells that can hold a point too near, nearest first.
  void find_neighbours() {
    for (int r = -reach_; r <= reach_; ++r)
      for (int c = -reach_; c <= reach_; ++c) {
        const double gap = std::hypot(std::max(std::abs(r) - 1, 0), std::max(std::abs(c) - 1, 0));
        if (gap < highest_)
          neighbours_.push_back({float(r), float(c), float(gap), r * std::ptrdiff_t(columns_) + c});
      }
    std::stable_sort(neighbours_.begin(), neighbours_.end(), [](const auto& a, const auto& b) {
      return std::pair(a.gap, a.row * a.row + a.column * a.column) <
             std::pair(b.gap, b.row * b.row + b.column * b.column);
    });
  }

  std::vector<Cell> cells_in_random_order() const {
    std::vector<Cell> cells;
    cells.reserve(slots_.size());
    for (int r = reach_; r < rows_ - reach_; ++r)
      for (int c = reach_; c < columns_ - reach_; ++c) {
        const auto row = std::uint64_t(std::int64_t(row0_ + r));
        const auto column = std::uint64_t(std::int64_t(column0_ + c));
        cells.push_back({random_bits(seed_, kStream + row, column), r, c});
      }
    std::stable_sort(cells.begin(), cells.end(),
                     [](const Cell& a, const Cell& b) { return a.key < b.key; });
    return cells;
  }

  // Whether the cell is still worth a dart.
  bool throw_dart(const Cell& cell, int round) {
    const std::uint64_t bits = mix64(cell.key + std::uint64_t(round));
    const float x = float(bits >> 40) * 0x1p-24f, y = float(bits >> 8 & 0xffffff) * 0x1p-24f;
    const glm::dvec2 p = place(cell.row, cell.column, x, y);
    if (p.x < low_.x || p.x > high_.x || p.y < low_.y || p.y > high_.y) return true;
    float radius = lowest_;
    if (lowest_ < highest_) {
      radius = float(kDisc * wavelength_.at(p) / cell_);
      // As many darts per disc everywhere.
      const float share = (lowest_ / radius) * (lowest_ / radius);
      if (float(mix64(bits) >> 40) * 0x1p-24f > share) return true;
    }
    Slot* slot = &slots_[std::size_t(cell.row) * columns_ + cell.column];
    for (const Neighbour& n : neighbours_) {
      if (2.0f * n.gap >= radius + highest_) break;
      const Slot& other = slot[n.slot];
      const float dx = n.column + other.x - x, dy = n.row + other.y - y;
      const float apart = 0.5f * (radius + other.radius);
      if (dx * dx + dy * dy < apart * apart) return !covers(n, other);
    }
    *slot = {x, y, radius};
    return false;
  }

  // Whether no place in the middle cell is far enough from the neighbour's point.
  bool covers(const Neighbour& n, const Slot& point) const {
    const float dx = std::fabs(n.column + point.x - 0.5f) + 0.5f;
    const float dy = std::fabs(n.row + point.y - 0.5f) + 0.5f;
    const float apart = 0.5f * (lowest_ + point.radius);
    return dx * dx + dy * dy < apart * apart;
  }

  glm::dvec2 low_, high_;
  const FoldWavelength& wavelength_;
  std::uint32_t seed_;
  double cell_ = 0.0;                     // m
  float lowest_ = 0.0f, highest_ = 0.0f;  // radii
  double column0_ = 0.0, row0_ = 0.0;     // of the first cell, counted from the coordinates' origin
  int reach_ = 0, columns_ = 0, rows_ = 0;
  std::vector<Slot> slots_;
  std::vector<Neighbour> neighbours_;
};

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
  return bilinear_at(wavelength_.raster->grid(), p)(*wavelength_.raster);
}

namespace {

FoldMesh make_mesh(glm::dvec2 low, glm::dvec2 high, const FoldWavelength& wavelength,
                   std::uint32_t seed, const Context& context) {
  const glm::dvec2 margin(wavelength.highest());
  FoldMesh mesh;
  mesh.points = Sample(low - margin, high + margin, wavelength, seed).points(context);
  context.check();
  const auto triangles = delaunay(mesh.points, context).triangles;
  mesh.faces.reserve(triangles.size());
  for (const auto& corners : triangles) mesh.faces.push_back({corners, {}});
  context.check();
  join_edges(mesh);
  return mesh;
}

std::size_t bytes_of(const FoldMesh& mesh) {
  return mesh.points.size() * sizeof(glm::dvec2) + mesh.edges.size() * sizeof(FoldMesh::Edge) +
         mesh.faces.size() * sizeof(FoldMesh::Face);
}

}  // namespace

FoldMesh fold_mesh(glm::dvec2 low, glm::dvec2 high, const FoldWavelength& wavelength,
                   std::uint32_t seed, const Context& context) {
  const auto make = [&] { return make_mesh(low, high, wavelength, seed, context); };
  if (!wavelength.is_even()) return make();
  const Kept::Key key("fold_mesh", low.x, low.y, high.x, high.y, wavelength.lowest(), seed);
  return *kept(context, key, make, bytes_of);
}

}  // namespace orogen
