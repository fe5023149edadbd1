#include "erosion/growing_tin.h"

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"
#include "foundation/tin_sampling.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 4096;
constexpr double kHollows = 2000.0;  // m, wavelength of the widest

unsigned open_sides(const MountainGrowthParameters& p) {
  return (p.west_side == MapSide::Open ? kWestSide : 0u) |
         (p.east_side == MapSide::Open ? kEastSide : 0u) |
         (p.south_side == MapSide::Open ? kSouthSide : 0u) |
         (p.north_side == MapSide::Open ? kNorthSide : 0u);
}

/// Not 0 where water leaves: at open sides and in the sea.
std::vector<std::uint8_t> base_level(const Tin& tin, const MountainGrowthInput& input,
                                     const MountainGrowthParameters& parameters) {
  std::vector<std::uint8_t> base = side_mask(tin, open_sides(parameters));
  if (input.sea) {
    const Grid& grid = input.sea->grid();
    for (std::size_t i = 0; i < tin.size(); ++i) {
      const int r = std::clamp(grid.row_of(tin.points[i].y), 0, grid.ny - 1);
      const int c = std::clamp(grid.column_of(tin.points[i].x), 0, grid.nx - 1);
      base[i] |= (*input.sea)(r, c);
    }
  }
  return base;
}

}  // namespace

GrowingTin::GrowingTin(Tin tin, const MountainGrowthInput& input,
                       const MountainGrowthParameters& parameters)
    : tin_(std::move(tin)),
      input_(input),
      parameters_(parameters),
      count_(int(input.horizons.heights.size())),
      z_(tin_.size()),
      horizons_(tin_.size() * count_),
      rates_(tin_.size() * count_),
      uplift_(tin_.size()),
      erodibility_(tin_.size()),
      talus_(tin_.size()),
      flow_(tin_, base_level(tin_, input, parameters)),
      rivers_({parameters.area_exponent, parameters.slope_exponent,
               parameters.minimum_drainage_area}) {}

void GrowingTin::begin(std::uint32_t seed, const Context& context) {
  for (int k = 0; k < count_; ++k) {
    const auto h = sample_at_points(input_.horizons.heights[k], tin_.points, context);
    for (std::size_t i = 0; i < h.size(); ++i) horizons_[i * count_ + k] = float(h[i]);
  }
  const FbmParameters hollows{.seed = seed, .wavelength = kHollows, .octaves = 10, .gain = 0.7};
  parallel_chunks(context, tin_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double depth = 0.5 * parameters_.initial_relief *
                           (1.0 + std::tanh(fbm(hollows, tin_.points[i].x, tin_.points[i].y)));
      const double top = horizons_[i * count_ + count_ - 1];
      z_[i] = flow_.is_base(std::int32_t(i)) ? 0.0 : std::max(top - depth, 0.0) + 1e-3 * depth;
    }
  });
}

void GrowingTin::take_over(const GrowingTin& coarse, const Context& context) {
  z_ = sample_at_points(coarse.tin_, coarse.z_, tin_.points, context);
  for (std::size_t i = 0; i < z_.size(); ++i)
    if (flow_.is_base(std::int32_t(i))) z_[i] = 0.0;
  for (int k = 0; k < count_; ++k) {
    const auto h = sample_at_points(coarse.tin_, coarse.horizon(k), tin_.points, context);
    for (std::size_t i = 0; i < h.size(); ++i) horizons_[i * count_ + k] = float(h[i]);
  }
}

void GrowingTin::set_phase(const UpliftPhase& phase, const Context& context) {
  for (int k = 0; k < count_; ++k) {
    const Raster<float>* raster = k == 0 ? phase.crust : phase.folds[k - 1];
    std::vector<double> rate(tin_.size(), 0.0);
    if (raster) rate = sample_at_points(*raster, tin_.points, context);
    for (std::size_t i = 0; i < rate.size(); ++i)
      rates_[i * count_ + k] = float(rate[i]) + (k > 0 ? rates_[i * count_ + k - 1] : 0.0f);
  }
}

/// Uplift, erodibility and talus slope of what lies at the surface.
void GrowingTin::look_at_rock(const Context& context) {
  const RockTable& rocks = input_.rocks;
  parallel_chunks(context, tin_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float* v = rates_.data() + i * count_;
      const Rock rock = rocks.rock_at(horizons_.data() + i * count_, float(z_[i]));
      const int k = std::min(rock.layer, count_ - 1);
      uplift_[i] = k > 0 ? v[k] + rock.gamma * (v[k - 1] - v[k]) : v[0];
      erodibility_[i] = rocks.erodibility(rock);
      talus_[i] = rocks.talus_slope(rock);
    }
  });
}

MassBalance GrowingTin::step(double years, const Context& context) {
  look_at_rock(context);
  const TinForcing forcing{.uplift_rate = std::span<const float>(uplift_),
                           .erodibility = std::span<const float>(erodibility_),
                           .talus_slope = std::span<const float>(talus_)};
  const MassBalance balance = rivers_.step(flow_, z_, forcing, years, context);
  parallel_chunks(context, horizons_.size(), 16 * kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) horizons_[i] += float(rates_[i] * years);
  });
  return balance;
}

std::vector<double> GrowingTin::horizon(int k) const {
  std::vector<double> values(tin_.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = horizons_[i * count_ + k];
  return values;
}

HorizonStack GrowingTin::horizons_on(const Grid& grid, const Context& context) const {
  HorizonStack stack;
  for (int k = 0; k < count_; ++k)
    stack.heights.push_back(sample_to_grid(tin_, horizon(k), grid, context));
  return stack;
}

Raster<float> GrowingTin::on_grid(const std::vector<double>& values, const Grid& grid,
                                  const Context& context) const {
  return sample_to_grid(tin_, values, grid, context);
}

std::vector<double> GrowingTin::uplift_rates(const Context& context) {
  look_at_rock(context);
  return {uplift_.begin(), uplift_.end()};
}

std::vector<double> GrowingTin::drainage_areas() const {
  const auto area = rivers_.drainage_area();
  return {area.begin(), area.end()};
}

}  // namespace orogen
