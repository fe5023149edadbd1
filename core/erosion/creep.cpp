// Creep: each sub-step solves along rows, then along columns (in turn the other way round),
// backward in time. Every solve is in flux form, so that mass is kept.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "erosion/hillslope.h"
#include "erosion/moved_ground.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr double kLeastBrake = 0.05;     // f of the header: diffusivity grows at most 20-fold
constexpr double kLongestSubStep = 2.0;  // D dt / cell size², for accuracy of the splitting
constexpr int kColumns = 64;             // solved side by side

class Creep {
 public:
  Creep(const Raster<float>& elevation, const Raster<std::uint8_t>& base,
        const CreepParameters& parameters, double dt, const Context& context)
      : grid_(elevation.grid()),
        base_(base),
        parameters_(parameters),
        context_(context),
        z_(elevation.values().begin(), elevation.values().end()),
        factor_(z_.size(), 1.0f) {
    const double total = parameters.diffusivity * dt / grid_.cell_area();
    const double longest = parameters.critical_slope > 0.0 ? 0.5 : kLongestSubStep;
    sub_steps_ = std::max(1, int(std::ceil(std::min(total / longest, 1e6))));
    number_ = total / sub_steps_;
  }

  void run() {
    for (int i = 0; i < sub_steps_; ++i) {
      if (parameters_.critical_slope > 0.0) find_factors();
      if (i % 2 == 0) solve_rows();
      solve_columns();
      if (i % 2 == 1) solve_rows();
    }
  }

  const std::vector<double>& heights() const { return z_; }
  double exported() const { return exported_; }  // m, over cells

 private:
  /// Diffusion number of the face between two cells.
  double face(std::size_t a, std::size_t b) const {
    return number_ * 0.5 * (double(factor_[a]) + double(factor_[b]));
  }

  void find_factors() {
    const double per_length = 0.5 / (grid_.cell_size * parameters_.critical_slope);
    parallel_rows(context_, grid_.ny, [&](int r) {
      const double* middle = z_.data() + grid_.index(r, 0);
      const double* south = z_.data() + grid_.index(std::max(r - 1, 0), 0);
      const double* north = z_.data() + grid_.index(std::min(r + 1, grid_.ny - 1), 0);
      for (int c = 0; c < grid_.nx; ++c) {
        const double x = (middle[std::min(c + 1, grid_.nx - 1)] - middle[std::max(c - 1, 0)]);
        const double y = north[c] - south[c];
        const double square = (x * x + y * y) * per_length * per_length;
        factor_[grid_.index(r, c)] = float(1.0 / std::max(1.0 - square, kLeastBrake));
      }
    });
  }

  /// Thomas algorithm along a row.
  void solve_rows() {
    const int nx = grid_.nx;
    exported_ += parallel_reduce(
        context_, std::size_t(grid_.ny), 8, 0.0,
        [&](std::size_t first, std::size_t last) {
          double out = 0.0;
          std::vector<double> upper(nx);
          for (std::size_t r = first; r < last; ++r) {
            const std::size_t row = r * nx;
            double* z = z_.data() + row;
            double before = 0.0;  // upper of the cell to the west
            for (int c = 0; c < nx; ++c) {
              const bool held = base_[row + c];
              const double west = held || c == 0 ? 0.0 : face(row + c - 1, row + c);
              const double east = held || c == nx - 1 ? 0.0 : face(row + c, row + c + 1);
              const double pivot = 1.0 / (1.0 + west + east - west * before);
              before = upper[c] = east * pivot;
              z[c] = (z[c] + (c > 0 ? west * z[c - 1] : 0.0)) * pivot;
            }
            for (int c = nx - 1; c-- > 0;) z[c] += upper[c] * z[c + 1];
            for (int c = 0; c + 1 < nx; ++c) out += flux_out(row + c, row + c + 1);
          }
          return out;
        },
        std::plus<>());
  }

  void solve_columns() {
    const int nx = grid_.nx, ny = grid_.ny;
    const std::size_t strips = (nx + kColumns - 1) / kColumns;
    exported_ += parallel_reduce(
        context_, strips, 1, 0.0,
        [&](std::size_t strip, std::size_t) {
          const int begin = int(strip) * kColumns, end = std::min(nx, begin + kColumns);
          std::vector<double> upper(std::size_t(ny) * kColumns);
          for (int r = 0; r < ny; ++r)
            for (int c = begin; c < end; ++c) {
              const std::size_t i = grid_.index(r, c);
              const bool held = base_[i];
              const double south = held || r == 0 ? 0.0 : face(i - nx, i);
              const double north = held || r == ny - 1 ? 0.0 : face(i, i + nx);
              const std::size_t u = std::size_t(r) * kColumns + (c - begin);
              const double before = r > 0 ? upper[u - kColumns] : 0.0;
              const double pivot = 1.0 / (1.0 + south + north - south * before);
              upper[u] = north * pivot;
              z_[i] = (z_[i] + (r > 0 ? south * z_[i - nx] : 0.0)) * pivot;
            }
          double out = 0.0;
          for (int r = ny - 1; r-- > 0;)
            for (int c = begin; c < end; ++c) {
              const std::size_t i = grid_.index(r, c);
              z_[i] += upper[std::size_t(r) * kColumns + (c - begin)] * z_[i + nx];
              out += flux_out(i, i + nx);
            }
          return out;
        },
        std::plus<>());
  }

  /// What passed in this solve from a free cell to a held one beside it (m).
  double flux_out(std::size_t a, std::size_t b) const {
    if (bool(base_[a]) == bool(base_[b])) return 0.0;
    return face(a, b) * (base_[a] ? z_[b] - z_[a] : z_[a] - z_[b]);
  }

  const Grid grid_;
  const Raster<std::uint8_t>& base_;
  const CreepParameters& parameters_;
  const Context& context_;
  std::vector<double> z_;
  std::vector<float> factor_;  // of the diffusivity, by slope
  int sub_steps_ = 1;
  double number_ = 0.0, exported_ = 0.0;
};

}  // namespace

MassBalance creep(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                  const CreepParameters& parameters, double dt_years, const Context& context) {
  check_parameters(parameters);
  if (!(dt_years >= 0.0 && std::isfinite(dt_years)))
    throw InputError("dt_years: " + std::to_string(dt_years) + " yr is not finite and at least 0");
  if (base_level.grid() != elevation.grid())
    throw InputError("base_level: must lie on the same grid as the elevation");
  if (parameters.diffusivity == 0.0 || dt_years == 0.0) return {};
  Creep solver(elevation, base_level, parameters, dt_years, context);
  solver.run();
  return set_heights(elevation, solver.heights(), solver.exported());
}

}  // namespace orogen
