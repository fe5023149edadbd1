#include "erosion/slope_limit.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr int kRowsBetweenChecks = 64;

/// One row below what its neighbour row and then its own cells allow; true if anything changed.
class RowLimit {
 public:
  RowLimit(Raster<float>& elevation, const Raster<std::uint8_t>& base, const Raster<float>& least,
           const Varying& slope)
      : z_(elevation),
        base_(base),
        least_(least),
        slope_(slope),
        nx_(elevation.grid().nx),
        straight_(nx_),
        bound_(nx_) {}

  bool operator()(int row, int beside) {
    float* z = &z_(row, 0);
    const std::uint8_t* base = &base_(row, 0);
    const float* least = &least_(row, 0);
    const std::size_t first = z_.grid().index(row, 0);
    const float cell = float(z_.grid().cell_size);
    for (int c = 0; c < nx_; ++c) straight_[c] = slope_.at(first + c) * cell;
    if (beside >= 0 && beside < z_.grid().ny)
      bound_by(&z_(beside, 0));
    else
      std::fill(bound_.begin(), bound_.end(), INFINITY);
    bool changed = false;
    const auto lower = [&](int c, float limit) {
      limit = std::max(limit, least[c]);
      if (z[c] <= limit || base[c]) return;
      z[c] = limit;
      changed = true;
    };
    lower(0, bound_[0]);
    for (int c = 1; c < nx_; ++c) lower(c, std::min(bound_[c], z[c - 1] + straight_[c]));
    for (int c = nx_ - 1; c-- > 0;) lower(c, z[c + 1] + straight_[c]);
    return changed;
  }

 private:
  void bound_by(const float* other) {
    constexpr float diagonal = std::numbers::sqrt2_v<float>;
    for (int c = 0; c < nx_; ++c) bound_[c] = other[c] + straight_[c];
    for (int c = 1; c < nx_; ++c)
      bound_[c] = std::min(bound_[c], other[c - 1] + diagonal * straight_[c]);
    for (int c = 0; c + 1 < nx_; ++c)
      bound_[c] = std::min(bound_[c], other[c + 1] + diagonal * straight_[c]);
  }

  Raster<float>& z_;
  const Raster<std::uint8_t>& base_;
  const Raster<float>& least_;
  const Varying& slope_;
  int nx_;
  std::vector<float> straight_, bound_;  // m
};

}  // namespace

void limit_slope(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                 const Raster<float>& least, const Varying& slope, const Context& context) {
  if (elevation.grid() != base_level.grid() || elevation.grid() != least.grid())
    throw InputError("base_level and least: must lie on the same grid as the elevation");
  slope.check(elevation.grid(), "slope");
  if (!slope.raster && !(slope.value > 0.0))
    throw InputError("slope: " + std::to_string(slope.value) + " is not above 0");
  const int ny = elevation.grid().ny;
  RowLimit limit(elevation, base_level, least, slope);
  // Sweeps to and fro over the rows, until one changes nothing.
  for (bool changed = true, up = true; changed; up = !up) {
    changed = false;
    for (int k = 0; k < ny; ++k) {
      if (k % kRowsBetweenChecks == 0) context.check();
      const int row = up ? k : ny - 1 - k;
      changed |= limit(row, up ? row - 1 : row + 1);
    }
    changed |= up;  // the first two always
  }
}

}  // namespace orogen
