// Landslides: pairs of cells are relaxed in place. Rows three apart share no cell, so that each
// third of the rows runs in parallel; the direction along a row alternates.
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

constexpr double kLeastMove = 1e-3;  // m; a pair that is steeper by less is at rest

class Slides {
 public:
  Slides(const Raster<float>& elevation, const Raster<std::uint8_t>& base, const Varying& talus,
         double loosening, const Context& context)
      : grid_(elevation.grid()),
        base_(base),
        talus_(talus),
        loosening_(loosening),
        context_(context),
        z_(elevation.values().begin(), elevation.values().end()),
        active_(grid_.ny + 2, 1),
        moved_(grid_.ny + 2, 0),
        exported_(grid_.ny, 0.0) {}

  /// True if anything moved.
  bool round(bool eastward) {
    std::fill(moved_.begin(), moved_.end(), 0);
    for (int third = 0; third < 3; ++third) {
      const int rows = (grid_.ny - third + 2) / 3;
      parallel_chunks(context_, std::size_t(rows), 4, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
          const int r = third + 3 * int(k);
          if (r < grid_.ny && active_[r + 1]) relax_row(r, eastward);
        }
      });
    }
    for (int r = 0; r < grid_.ny; ++r) {  // a row is looked at again if one beside it changed
      active_[r + 1] = 0;
      for (int near = std::max(0, r - 2); near <= std::min(grid_.ny - 1, r + 2); ++near)
        active_[r + 1] |= moved_[near + 1];
    }
    return std::any_of(moved_.begin(), moved_.end(), [](std::uint8_t m) { return m; });
  }

  const std::vector<double>& heights() const { return z_; }
  double exported() const {
    double sum = 0.0;
    for (double e : exported_) sum += e;
    return sum;
  }

 private:
  void relax_row(int r, bool eastward) {
    const int nx = grid_.nx;
    for (int k = 0; k < nx; ++k) {
      const int c = eastward ? k : nx - 1 - k;
      const std::size_t i = grid_.index(r, c);
      if (base_[i]) continue;
      const double slope = talus_.at(i);
      double worst = kLeastMove;
      std::size_t to = i;
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc) {
          if ((dr == 0 && dc == 0) || !grid_.contains(r + dr, c + dc)) continue;
          const double length = grid_.cell_size * (dr && dc ? std::sqrt(2.0) : 1.0);
          const std::size_t j = grid_.index(r + dr, c + dc);
          const double excess = z_[i] - z_[j] - slope * length;
          if (excess > worst * (dr && dc ? std::sqrt(2.0) : 1.0)) {
            worst = excess / (dr && dc ? std::sqrt(2.0) : 1.0);
            to = j;
          }
        }
      if (to == i) continue;
      move(i, to, worst, r);
    }
  }

  /// `steepness`: height above the talus slope for each cell size of way.
  void move(std::size_t from, std::size_t to, double steepness, int row) {
    const bool leaves = base_[to];
    const bool diagonal = from % grid_.nx != to % grid_.nx && from / grid_.nx != to / grid_.nx;
    const double excess = steepness * (diagonal ? std::sqrt(2.0) : 1.0);
    const double most = leaves ? excess : 0.5 * excess;
    const double amount = std::min(most, loosening_ * steepness / grid_.cell_size);
    z_[from] -= amount;
    if (leaves)
      exported_[row] += amount;
    else
      z_[to] += amount;
    moved_[row + 1] = 1;
  }

  const Grid grid_;
  const Raster<std::uint8_t>& base_;
  const Varying& talus_;
  const double loosening_;  // m for each unit of slope in excess, a round
  const Context& context_;
  std::vector<double> z_;
  std::vector<std::uint8_t> active_, moved_;
  std::vector<double> exported_;  // by row
};

}  // namespace

MassBalance landslide(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                      const Varying& talus_slope, const LandslideParameters& parameters,
                      double dt_years, const Context& context) {
  check_parameters(parameters);
  if (!(dt_years >= 0.0))
    throw InputError("dt_years: " + std::to_string(dt_years) + " yr is not at least 0");
  if (base_level.grid() != elevation.grid())
    throw InputError("base_level: must lie on the same grid as the elevation");
  talus_slope.check(elevation.grid(), "talus_slope");
  const double loosening =
      std::isinf(dt_years) ? dt_years : parameters.landslide_rate * dt_years / parameters.rounds;
  if (loosening == 0.0) return {};
  Slides slides(elevation, base_level, talus_slope, loosening, context);
  for (int i = 0; i < parameters.rounds && slides.round(i % 2 == 0); ++i) {
  }
  return set_heights(elevation, slides.heights(), slides.exported());
}

}  // namespace orogen
