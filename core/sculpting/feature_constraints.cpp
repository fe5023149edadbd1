#include "sculpting/feature_constraints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "foundation/distance_transform.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr double kThroughCell = 0.71;  // cells: half a cell's diagonal

/// The nearest place of a curve to a point.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  glm::dvec2 outward{0.0, 0.0};
  double height = 0.0, elevation = 0.0, plateau = 0.0;
  FeatureSide side;
};

Nearest on_piece(const FeatureSample& a, const FeatureSample& b, glm::dvec2 p) {
  const glm::dvec2 from(a.position.x, a.position.y);
  const glm::dvec2 way = glm::dvec2(b.position.x, b.position.y) - from, off = p - from;
  const double length2 = way.x * way.x + way.y * way.y;
  const double along = length2 > 0.0 ? (off.x * way.x + off.y * way.y) / length2 : 0.0;
  const double t = std::clamp(along, 0.0, 1.0);
  const glm::dvec2 rest = off - t * way;
  Nearest found;
  found.distance = std::sqrt(rest.x * rest.x + rest.y * rest.y);
  double left = 0.5;  // share of the left side
  if (found.distance > 0.0) {
    found.outward = rest / found.distance;
    if (length2 > 0.0)
      left += 0.5 * (way.x * found.outward.y - way.y * found.outward.x) / std::sqrt(length2);
  }
  const FeatureSample at = mix(a, b, t);
  found.height = at.position.z;
  found.elevation = at.elevation;
  found.plateau = at.plateau;
  found.side = mix(at.right, at.left, left);
  return found;
}

FeatureZone zone_of(const Nearest& nearest, double cell) {
  const bool asked = nearest.elevation >= 0.5;
  const double plateau = asked ? std::max(nearest.plateau, kThroughCell * cell) : nearest.plateau;
  if (nearest.distance <= plateau) return asked ? FeatureZone::Plateau : FeatureZone::Envelope;
  const double slope = nearest.plateau + nearest.side.slope_size;
  if (nearest.distance <= slope) return FeatureZone::Slope;
  return nearest.distance <= slope + nearest.side.envelope ? FeatureZone::Envelope
                                                           : FeatureZone::None;
}

/// The cells that a curve may reach: first row and column, and their numbers.
struct Window {
  int row = 0, column = 0, rows = 0, columns = 0;
};

Window window_of(const std::vector<FeatureSample>& samples, const Grid& grid) {
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const FeatureSample& s : samples) {
    const auto side = [](const FeatureSide& f) { return f.slope_size + f.envelope; };
    const double reach = s.plateau + std::max(side(s.left), side(s.right)) + grid.cell_size;
    const glm::dvec2 p(s.position.x, s.position.y);
    low = {std::min(low.x, p.x - reach), std::min(low.y, p.y - reach)};
    high = {std::max(high.x, p.x + reach), std::max(high.y, p.y + reach)};
  }
  const auto clamp = [](double cells, int most) {
    return int(std::clamp(cells, 0.0, double(most)));
  };
  const glm::dvec2 first = grid.to_cells(low), last = grid.to_cells(high);
  const int r0 = clamp(std::floor(first.y), grid.ny), r1 = clamp(std::ceil(last.y), grid.ny);
  const int c0 = clamp(std::floor(first.x), grid.nx), c1 = clamp(std::ceil(last.x), grid.nx);
  return {r0, c0, r1 - r0, c1 - c0};
}

void ask(FeatureConstraints& all, std::size_t i, const Nearest& nearest, FeatureZone zone) {
  const auto asked = std::uint8_t(zone);
  if (asked < all.zone[i] || asked == 0) return;
  if (asked == all.zone[i] && float(nearest.distance) >= all.distance[i]) return;
  all.zone[i] = asked;
  all.distance[i] = float(nearest.distance);
  all.elevation[i] = float(nearest.height);
  const double from_curve = nearest.elevation >= 0.5 ? 1.0 : -1.0;
  all.slope[i] = float(-from_curve * std::tan(nearest.side.slope_angle));
  all.onward_x[i] = float(from_curve * nearest.outward.x);
  all.onward_y[i] = float(from_curve * nearest.outward.y);
}

void add_curve(FeatureConstraints& all, const FeatureCurve& curve, const Context& context) {
  const Grid& grid = all.zone.grid();
  const std::vector<FeatureSample> samples = sample_curve(curve, 0.5 * grid.cell_size);
  const Window window = window_of(samples, grid);
  if (window.rows <= 0 || window.columns <= 0) return;
  std::vector<glm::dvec2> points;
  for (const FeatureSample& s : samples) points.push_back({s.position.x, s.position.y});
  const glm::dvec2 corner = grid.origin + grid.cell_size * glm::dvec2(window.column, window.row);
  const Grid part{window.columns, window.rows, grid.cell_size, corner};
  const Raster<std::int32_t> nearest_sample = nearest_point(points, part, context).nearest;
  parallel_rows(context, part.ny, [&](int r) {
    for (int c = 0; c < part.nx; ++c) {
      const std::int32_t sample = nearest_sample(r, c), pieces = std::int32_t(samples.size()) - 1;
      Nearest nearest;
      for (std::int32_t k = std::max(sample - 1, 0); k <= std::min(sample, pieces - 1); ++k) {
        const Nearest found = on_piece(samples[k], samples[k + 1], part.center(r, c));
        if (found.distance < nearest.distance) nearest = found;
      }
      ask(all, grid.index(r + window.row, c + window.column), nearest,
          zone_of(nearest, grid.cell_size));
    }
  });
}

}  // namespace

FeatureConstraints feature_constraints(std::span<const FeatureCurve> curves, const Grid& grid,
                                       const Context& context) {
  FeatureConstraints all{
      Raster<std::uint8_t>(grid), Raster<float>(grid, std::numeric_limits<float>::infinity()),
      Raster<float>(grid),        Raster<float>(grid),
      Raster<float>(grid),        Raster<float>(grid)};
  for (const FeatureCurve& curve : curves) add_curve(all, curve, context);
  return all;
}

}  // namespace orogen
