#include "sculpting/feature_solver.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "foundation/parallel.h"
#include "sculpting/five_point.h"

namespace orogen {

namespace {

constexpr double kTolerance = 1e-7;  // of the tallest change that is asked for
constexpr std::size_t kGrain = 8192;

/// Eq. 9 as a system: neighbours outside the envelope go to the right side.
class Diffusion {
 public:
  Diffusion(const Raster<float>& elevation, const FeatureConstraints& constraints,
            const FeatureParameters& parameters, const Context& context)
      : elevation_(elevation), constraints_(constraints), parameters_(parameters) {
    system_ = five_point_system(constraints.zone, number_);
    b_.resize(system_.size());
    start_.resize(system_.size());
    parallel_chunks(context, b_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) set_row(std::int32_t(i));
    });
  }

  const FivePointSystem& system() const { return system_; }
  const std::vector<double>& right_side() const { return b_; }
  const std::vector<double>& start() const { return start_; }

 private:
  void set_row(std::int32_t i) {
    const Grid& grid = elevation_.grid();
    const int r = system_.row[i], c = system_.column[i];
    const std::size_t cell = grid.index(r, c);
    const auto zone = FeatureZone(constraints_.zone[cell]);
    const double alpha = zone == FeatureZone::Plateau ? parameters_.plateau_weight : 0.0;
    const double beta = zone == FeatureZone::Slope ? parameters_.slope_weight : 0.0;
    const double nx = constraints_.onward_x[cell], ny = constraints_.onward_y[cell];
    double weights[4];  // west, east, south, north
    std::fill(weights, weights + 4, 0.25 * (1.0 - alpha - beta));
    weights[nx > 0.0 ? 0 : 1] += beta * nx * nx;
    weights[ny > 0.0 ? 2 : 3] += beta * ny * ny;
    b_[i] = alpha * constraints_.elevation[cell];
    if (beta > 0.0)
      b_[i] += beta * constraints_.slope[cell] * grid.cell_size *
               (std::fabs(nx * nx * nx) + std::fabs(ny * ny * ny));
    start_[i] = zone == FeatureZone::Plateau ? constraints_.elevation[cell] : elevation_[cell];
    constexpr int dr[4] = {0, 0, -1, 1}, dc[4] = {-1, 1, 0, 0};
    for (int k = 0; k < 4; ++k) {
      if (system_.neighbors[i][k] >= 0)
        system_.weights[i][k] = float(weights[k]);
      else if (grid.contains(r + dr[k], c + dc[k]))
        b_[i] += weights[k] * double(elevation_(r + dr[k], c + dc[k]));
      else
        system_.diagonal[i] -= float(weights[k]);
    }
  }

  const Raster<float>& elevation_;
  const FeatureConstraints& constraints_;
  const FeatureParameters& parameters_;
  FivePointSystem system_;
  Raster<std::int32_t> number_;
  std::vector<double> b_, start_;
};

/// The tallest change that plateaus and slopes ask for, at least 1 m.
double tallest(const Raster<float>& elevation, const FeatureConstraints& constraints) {
  double most = 1.0;
  for (std::size_t i = 0; i < elevation.size(); ++i)
    if (FeatureZone(constraints.zone[i]) == FeatureZone::Plateau)
      most = std::max(most, std::fabs(double(constraints.elevation[i]) - elevation[i]));
  return most;
}

}  // namespace

FeatureReport apply_features(Raster<float>& elevation, const FeatureConstraints& constraints,
                             const FeatureParameters& parameters, Context& context) {
  check_parameters(parameters);
  const Diffusion diffusion(elevation, constraints, parameters, context);
  const FivePointSystem& system = diffusion.system();
  std::vector<double> height = diffusion.start();
  const double tolerance = kTolerance * tallest(elevation, constraints);
  const FivePointSolution found =
      solve_five_point(system, diffusion.right_side(), height, tolerance, context);
  for (std::int32_t i = 0; i < system.size(); ++i)
    elevation(system.row[i], system.column[i]) = float(height[i]);
  return {found.iterations, found.residual, std::size_t(system.size())};
}

}  // namespace orogen
