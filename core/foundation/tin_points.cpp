// The point patterns of jittered_tin and poisson_tin.
#include <algorithm>
#include <cmath>
#include <string>

#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/random.h"
#include "foundation/tin.h"

namespace orogen {

namespace {

constexpr double kMostPoints = 100e6;
constexpr double kJitter = 0.4;       // over the spacing; at 0.25 slopes show the lattice
constexpr double kLeastMargin = 0.6;  // of any point: no triangle is obtuse at a side
constexpr double kMargin = kLeastMargin + kJitter;  // between lattice and sides, over the spacing
constexpr double kLeastDistance = 0.77;             // of Poisson points, over the spacing
constexpr int kTrials = 24;  // points tried in each cell of the background grid

void check_spacing(const TinDomain& domain, double spacing) {
  domain.check();
  if (!(spacing > 0.0 && domain.area() / (spacing * spacing) <= kMostPoints))
    throw InputError("spacing: " + std::to_string(spacing) + " m is not above 0 and at least " +
                     std::to_string(std::sqrt(domain.area() / kMostPoints)) + " m");
}

/// Along the four sides, corners included.
std::vector<glm::dvec2> side_points(const TinDomain& domain, double spacing, std::uint32_t seed) {
  const glm::dvec2 low = domain.origin, high = domain.far_corner();
  std::vector<glm::dvec2> points{low, {high.x, low.y}, high, {low.x, high.y}};
  for (int side = 0; side < 4; ++side) {
    const bool upright = side >= 2;
    const double length = upright ? domain.size.y : domain.size.x;
    const int pieces = std::max(1, int(std::lround(length / spacing)));
    for (int k = 1; k < pieces; ++k) {
      const double jitter = 0.2 * (random_uniform(seed, std::uint64_t(side), k) - 0.5);
      const double along = length * ((k + jitter) / pieces);
      if (upright)
        points.push_back({side == 2 ? low.x : high.x, low.y + along});
      else
        points.push_back({low.x + along, side == 0 ? low.y : high.y});
    }
  }
  return points;
}

/// Random points in a rectangle, none closer to another, or to those given, than `distance`. The
/// cells of a background grid hold at most one each. Cells three apart cannot be in each other's
/// way, so that each ninth of them is filled in parallel.
class PoissonDisc {
 public:
  PoissonDisc(const TinDomain& domain, double distance, std::uint32_t seed)
      : domain_(domain),
        square_(distance * distance),
        cell_(distance / std::sqrt(2.0)),
        seed_(seed),
        nx_(int(domain.size.x / cell_) + 1),
        ny_(int(domain.size.y / cell_) + 1),
        points_(std::size_t(nx_) * ny_, glm::dvec2(kNone)) {}

  void add(glm::dvec2 p) { at(column_of(p.x), row_of(p.y)) = p; }

  /// Fills the domain but for a margin along its sides.
  void fill(double margin, const Context& context) {
    for (int trial = 0; trial < kTrials; ++trial)
      for (int phase = 0; phase < 9; ++phase)
        parallel_chunks(
            context, std::size_t(ny_ + 2) / 3, 16, [&](std::size_t from, std::size_t to) {
              for (std::size_t k = from; k < to; ++k)
                for (int r = int(k) * 3 + phase / 3, c = phase % 3; r < ny_ && c < nx_; c += 3)
                  try_cell(r, c, trial, margin);
            });
  }

  std::vector<glm::dvec2> points() const {
    std::vector<glm::dvec2> found;
    for (const glm::dvec2 p : points_)
      if (p.x != kNone) found.push_back(p);
    return found;
  }

 private:
  static constexpr double kNone = -1e300;

  glm::dvec2& at(int c, int r) { return points_[std::size_t(r) * nx_ + c]; }
  int column_of(double x) const { return std::min(nx_ - 1, int((x - domain_.origin.x) / cell_)); }
  int row_of(double y) const { return std::min(ny_ - 1, int((y - domain_.origin.y) / cell_)); }

  void try_cell(int r, int c, int trial, double margin) {
    if (at(c, r).x != kNone) return;
    const std::uint64_t counter = (std::uint64_t(r) * nx_ + c) * kTrials + trial;
    const glm::dvec2 offset{(c + random_uniform(seed_, 10, counter)) * cell_,
                            (r + random_uniform(seed_, 11, counter)) * cell_};
    const glm::dvec2 rest = domain_.size - offset;
    if (std::min({offset.x, offset.y, rest.x, rest.y}) < margin) return;
    const glm::dvec2 p = domain_.origin + offset;
    for (int y = std::max(0, r - 2); y <= std::min(ny_ - 1, r + 2); ++y)
      for (int x = std::max(0, c - 2); x <= std::min(nx_ - 1, c + 2); ++x) {
        const glm::dvec2 way = at(x, y) - p;
        if (way.x * way.x + way.y * way.y < square_) return;
      }
    at(c, r) = p;
  }

  TinDomain domain_;
  double square_, cell_;
  std::uint32_t seed_;
  int nx_, ny_;
  std::vector<glm::dvec2> points_;
};

}  // namespace

Tin jittered_tin(const TinDomain& domain, double spacing, std::uint32_t seed,
                 const Context& context) {
  check_spacing(domain, spacing);
  std::vector<glm::dvec2> points = side_points(domain, spacing, seed);
  const glm::dvec2 inner = domain.size - 2.0 * kMargin * spacing;
  const double row_height = 0.5 * std::sqrt(3.0) * spacing;
  const int rows = inner.x > 0.0 && inner.y > 0.0 ? int(std::lround(inner.y / row_height)) : -1;
  const int columns = std::max(1, int(std::lround(inner.x / spacing)));
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c < columns + (r % 2 == 0); ++c) {
      const std::uint64_t counter = std::uint64_t(r) * 0x100000000ull + std::uint64_t(c);
      const double jitter_x = 2.0 * kJitter * (random_uniform(seed, 8, counter) - 0.5);
      const double jitter_y = 2.0 * kJitter * (random_uniform(seed, 9, counter) - 0.5);
      const double x = inner.x * ((c + (r % 2 ? 0.5 : 0.0)) / columns);
      const double y = rows > 0 ? inner.y * (double(r) / rows) : 0.5 * inner.y;
      points.push_back(domain.origin +
                       spacing * glm::dvec2(kMargin + jitter_x, kMargin + jitter_y) +
                       glm::dvec2(x, y));
    }
  return triangulate(domain, std::move(points), context);
}

Tin poisson_tin(const TinDomain& domain, double spacing, std::uint32_t seed,
                const Context& context) {
  check_spacing(domain, spacing);
  std::vector<glm::dvec2> points = side_points(domain, spacing, seed);
  PoissonDisc disc(domain, kLeastDistance * spacing, seed);
  for (const glm::dvec2 p : points) disc.add(p);
  disc.fill(kLeastMargin * spacing, context);
  const std::vector<glm::dvec2> inside = disc.points();
  const auto is_inside = [&](glm::dvec2 p) {
    return p.x > domain.origin.x && p.y > domain.origin.y && p.x < domain.far_corner().x &&
           p.y < domain.far_corner().y;
  };
  std::copy_if(inside.begin(), inside.end(), std::back_inserter(points), is_inside);
  return triangulate(domain, std::move(points), context);
}

}  // namespace orogen
