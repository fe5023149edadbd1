#include "folding/warped_folds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "foundation/distance_transform.h"
#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"
#include "foundation/random.h"
#include "foundation/simd.h"
#include "foundation/units.h"

namespace orogen {

namespace {

constexpr float kPatternShare = 0.94f, kNoiseShare = 0.34f;

constexpr float kConvergenceLow = 0.15f, kConvergenceHigh = 0.75f;  // C runs from 0 to 1
constexpr double kSummitShare = 0.25;    // width of a peak in E over peak_reach
constexpr double kCoarsePerWidth = 3.0;  // cells of the coarse grid of E in that width
constexpr float kStretch = 0.25f;        // of distances to peaks, a standard deviation
constexpr float kCrestSoftness = 0.1f;
constexpr float kShoulder = 2.41421356f;  // where (u − 1) / (1 + u²) is greatest
constexpr double kRimTilt = 0.3;          // of the crater's depth, so that the peak tops the rim

double height_of(const Peak& peak, const FoldParameters& parameters) {
  return peak.height_m.value_or(parameters.default_peak_height);
}

// E, on a grid coarse enough to be cheap and fine enough to be interpolated.
Raster<float> summit_level(const VectorMap& map, const Grid& grid, const FoldParameters& parameters,
                           const Context& context) {
  const double width = kSummitShare * parameters.peak_reach;
  const double cell = std::max(width / kCoarsePerWidth, grid.cell_size);
  const Grid coarse{int(grid.width() / cell) + 3, int(grid.height() / cell) + 3, cell,
                    grid.origin - glm::dvec2(cell)};
  Raster<float> level(coarse, float(parameters.default_peak_height));
  if (map.peaks.empty()) return level;
  parallel_rows(context, coarse.ny, [&](int r) {
    for (int c = 0; c < coarse.nx; ++c) {
      const glm::dvec2 p = coarse.center(r, c);
      double sum = 0.0, weights = 0.0;
      for (const Peak& peak : map.peaks) {
        const glm::dvec2 d = (peak.position - p) / width;
        const double s = d.x * d.x + d.y * d.y + 1.0, w = 1.0 / (s * s);
        sum += w * height_of(peak, parameters);
        weights += w;
      }
      level(r, c) = float(sum / weights);
    }
  });
  return level;
}

void interpolate_row(const Raster<float>& coarse, const Grid& grid, int r, float* out) {
  const Grid& g = coarse.grid();
  const double ratio = grid.cell_size / g.cell_size;
  const glm::dvec2 first = g.to_cells(grid.center(r, 0)) - glm::dvec2(0.5);
  const int row = std::clamp(int(first.y), 0, g.ny - 2);
  const float v = float(first.y - row);
  const float *low = coarse.row(row), *high = coarse.row(row + 1);
  for (int c = 0; c < grid.nx; ++c) {
    const double x = first.x + c * ratio;
    const int i = std::clamp(int(x), 0, g.nx - 2);
    const float u = float(x - i);
    const float a = low[i] + u * (low[i + 1] - low[i]), b = high[i] + u * (high[i + 1] - high[i]);
    out[c] = a + v * (b - a);
  }
}

inline float smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// Distance to the nearest peak that is no volcano: under a cone no other ground is raised.
Raster<float> distance_without(const VectorMap& map, const PlateMap& plates,
                               const Context& context) {
  const Grid& grid = plates.plate.grid();
  std::vector<glm::dvec2> positions;
  for (int i = 0; i < int(map.peaks.size()); ++i)
    if (!std::binary_search(plates.volcanoes.begin(), plates.volcanoes.end(), i))
      positions.push_back(map.peaks[i].position);
  if (positions.empty()) return Raster<float>(grid, float(grid.width() + grid.height()));
  return nearest_point(positions, grid, context).distance;
}

struct RowShape {
  float peak_reach, massif, plain, strength, rift_depth, rift_width;
};

OROGEN_CLONES void shape_row(const RowShape& s, const float* noise, const float* stretch,
                             const float* level, const float* peak_distance,
                             const float* massif_distance, const float* convergence,
                             const float* boundary_distance, float* out, int n) {
  for (int i = 0; i < n; ++i) {
    const float stretched = 1.0f + kStretch * std::clamp(stretch[i], -1.5f, 1.5f);
    const float x = stretched * peak_distance[i] / s.peak_reach, k = 1.0f / (1.0f + x * x);
    const float t = 1.0f + s.strength * noise[i];
    const float crest = (t + std::sqrt(t * t + kCrestSoftness)) / (2.0f * (1.0f + s.strength));
    const float folded = smoothstep(kConvergenceLow, kConvergenceHigh, convergence[i]);
    const float parted = smoothstep(kConvergenceLow, kConvergenceHigh, -convergence[i]);
    const float y = boundary_distance[i] / s.rift_width;
    const float u = std::min(kShoulder * y * y * y * y, 1e6f);
    const float rift = parted * s.rift_depth * (u - 1.0f) / (1.0f + u * u);
    const float z = stretched * massif_distance[i] / s.massif, w = 1.0f + z * z,
                massif = 1.0f / (w * w);
    const float high = folded + (1.0f - folded) * massif;
    const float height = s.plain + (1.0f - s.plain) * high * crest;
    out[i] = k * (level[i] * height + rift);
  }
}

// The larger of the two, rounded off where they differ by less than `width`.
double smooth_max(double a, double b, double width) {
  const double overlap = std::max(width - std::fabs(a - b), 0.0);
  return std::max(a, b) + (width > 0.0 ? 0.25 * overlap * overlap / width : 0.0);
}

// Height of a cone whose crater's rim passes through the peak, which tops it.
class Cone {
 public:
  Cone(const Peak& peak, const FoldParameters& parameters, std::uint32_t seed, int number)
      : height_(height_of(peak, parameters)),
        slope_(std::tan(radians(parameters.volcano_slope_deg))),
        radius_(parameters.crater_radius),
        depth_(std::min(parameters.crater_depth, 0.8 * height_)) {
    const double angle =
        2.0 * std::numbers::pi * random_uniform(seed, 0x766f6c63, std::uint64_t(number));
    to_peak_ = {std::cos(angle), std::sin(angle)};
    centre_ = peak.position - radius_ * to_peak_;
  }

  glm::dvec2 centre() const { return centre_; }
  double reach() const { return radius_ + height_ / slope_; }
  double height() const { return height_; }

  double operator()(glm::dvec2 p) const {
    const glm::dvec2 d = p - centre_;
    const double r = std::hypot(d.x, d.y);
    // From 0 under the rim's top to 1 opposite, fading outwards; even in the crater's middle.
    const double towards = (d.x * to_peak_.x + d.y * to_peak_.y) / std::max(r, radius_ + 1e-9);
    const double fade = radius_ / std::max(r, radius_ + 1e-9);
    const double rim = height_ - 0.5 * kRimTilt * depth_ * (1.0 - towards) * fade;
    if (r >= radius_) return rim - slope_ * (r - radius_);
    const double floor = height_ - depth_;
    return floor + (rim - floor) * (r / radius_) * (r / radius_);
  }

 private:
  double height_, slope_, radius_, depth_;
  glm::dvec2 to_peak_{}, centre_{};
};

void add_volcano(Raster<float>& relief, const Cone& cone, const Context& context) {
  const Grid& grid = relief.grid();
  const glm::dvec2 low = grid.to_cells(cone.centre() - glm::dvec2(cone.reach()));
  const glm::dvec2 high = grid.to_cells(cone.centre() + glm::dvec2(cone.reach()));
  const auto clamped = [](double v, int n) { return int(std::clamp(v, 0.0, double(n))); };
  const int r0 = clamped(low.y, grid.ny), r1 = clamped(high.y + 1.0, grid.ny);
  const int c0 = clamped(low.x, grid.nx), c1 = clamped(high.x + 1.0, grid.nx);
  if (r0 >= r1) return;
  parallel_rows(context, r1 - r0, [&](int row) {
    for (int r = r0 + row, c = c0; c < c1; ++c) {
      const double z = cone(grid.center(r, c));
      if (z > 0.0) relief(r, c) = float(smooth_max(relief(r, c), z, 0.1 * cone.height()));
    }
  });
}

}  // namespace

Raster<float> warped_folds(const VectorMap& map, const PlateMap& plates,
                           const BoundaryMap& boundaries, const VelocityMap& velocity,
                           const FoldParameters& parameters, std::uint32_t seed,
                           const Context& context, const Raster<float>* pattern) {
  check_parameters(parameters, "folds");
  const Grid& grid = plates.plate.grid();
  if (pattern && pattern->grid() != grid)
    throw InputError("pattern: must lie on the grid of the plates");
  const Raster<float> level = summit_level(map, grid, parameters, context);
  const FbmParameters fbm_parameters{.seed = seed,
                                     .wavelength = parameters.fold_wavelength,
                                     .octaves = parameters.octaves,
                                     .gain = parameters.gain};
  const FbmParameters stretch_parameters{
      .seed = seed ^ 0x2545f491u, .wavelength = parameters.peak_reach, .octaves = 3};
  const double shift =
      parameters.warp == FoldWarp::Compress ? -parameters.folding_time : parameters.folding_time;
  const RowShape shape{float(parameters.peak_reach),  float(parameters.massif_radius),
                       float(parameters.plain_share), float(parameters.fold_strength),
                       float(parameters.rift_depth),  float(parameters.rift_width)};
  const Raster<float> without_volcanoes =
      plates.volcanoes.empty() ? Raster<float>() : distance_without(map, plates, context);
  const Raster<float>& massif_distance =
      plates.volcanoes.empty() ? plates.peak_distance : without_volcanoes;
  Raster<float> relief(grid);
  parallel_chunks(context, grid.ny, 8, [&](std::size_t begin, std::size_t end) {
    std::vector<double> x(grid.nx), y(grid.nx);
    std::vector<float> noise(grid.nx), stretch(grid.nx), summits(grid.nx);
    for (int r = int(begin); r < int(end); ++r) {
      const float *vx = velocity.velocity_x.row(r), *vy = velocity.velocity_y.row(r);
      for (int c = 0; c < grid.nx; ++c) {
        const glm::dvec2 p = grid.center(r, c);
        x[c] = p.x;
        y[c] = p.y;
      }
      fbm(stretch_parameters, x.data(), y.data(), stretch.data(), grid.nx);
      for (int c = 0; c < grid.nx; ++c) {
        x[c] += shift * vx[c];
        y[c] += shift * vy[c];
      }
      fbm(fbm_parameters, x.data(), y.data(), noise.data(), grid.nx);
      if (pattern)  // the variance stays 1
        for (int c = 0; c < grid.nx; ++c)
          noise[c] = kPatternShare * (*pattern)(r, c) + kNoiseShare * noise[c];
      interpolate_row(level, grid, r, summits.data());
      shape_row(shape, noise.data(), stretch.data(), summits.data(), plates.peak_distance.row(r),
                massif_distance.row(r), boundaries.convergence.row(r),
                boundaries.boundary_distance.row(r), relief.row(r), grid.nx);
    }
  });
  for (int v : plates.volcanoes)
    add_volcano(relief, Cone(map.peaks[v], parameters, seed, v), context);
  return relief;
}

const StageInfo& folds_stage() {
  static const StageInfo info{
      "folds",
      "Makes the relief of folds by noise warped along plate velocities, with rifts and volcanoes.",
      "Michel, Emilien and Cani 2015, section 5 and section 7's limits",
      {"plate", "peak_distance", "boundary_distance", "convergence", "velocity_x", "velocity_y"},
      {"fold_relief"},
      {"map"}};
  return info;
}

}  // namespace orogen
