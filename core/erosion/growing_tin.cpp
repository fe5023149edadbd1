#include "erosion/growing_tin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"
#include "foundation/tin_sampling.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 4096;
constexpr double kHollows = 2000.0;     // m, wavelength of the widest
constexpr int kLoadCells = 256;         // along the longer side, of the grid that loads lie on
constexpr double kFarthestCarry = 0.5;  // edges

unsigned open_sides(const MountainGrowthParameters& p) {
  unsigned sides = 0;
  if (p.west_side == MapSide::Open) sides |= kWestSide;
  if (p.east_side == MapSide::Open) sides |= kEastSide;
  if (p.south_side == MapSide::Open) sides |= kSouthSide;
  if (p.north_side == MapSide::Open) sides |= kNorthSide;
  return sides;
}

/// Not 0 where water always leaves: at open sides and in the drawn sea.
std::vector<std::uint8_t> outlets_of(const Tin& tin, const MountainGrowthInput& input,
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

GrowingTin::GrowingTin(std::shared_ptr<const Tin> tin, const MountainGrowthInput& input,
                       const MountainGrowthParameters& parameters)
    : mesh_(std::move(tin)),
      tin_(*mesh_),
      input_(input),
      parameters_(parameters),
      count_(int(input.horizons.heights.size())),
      z_(tin_.size()),
      horizons_(tin_.size() * count_),
      rates_(tin_.size() * count_),
      uplift_(tin_.size()),
      erodibility_(tin_.size()),
      talus_(tin_.size()),
      outlets_(outlets_of(tin_, input, parameters)),
      base_(outlets_),
      flow_(tin_, base_),
      rivers_({.area_exponent = parameters.area_exponent,
               .slope_exponent = parameters.slope_exponent,
               .minimum_drainage_area = parameters.minimum_drainage_area,
               .deposition_coefficient = parameters.deposition_coefficient,
               .deposition_iterations = parameters.deposition_iterations,
               .fill_lakes = parameters.fill_lakes}) {
  if (parameters.diffusivity > 0.0)
    creep_.emplace(tin_, base_, CreepParameters{parameters.diffusivity, parameters.critical_slope});
}

void GrowingTin::sample_inputs(const Context& context) {
  const auto sample = [&](const Raster<float>* raster, std::vector<float>& at_points) {
    if (!raster) return;
    const auto values = sample_at_points(*raster, tin_.points, context);
    at_points.assign(values.begin(), values.end());
  };
  sample(input_.rain, rain_);
  sample(input_.uplift_factor, uplift_factor_);
  sample(input_.erodibility_factor, erodibility_factor_);
}

void GrowingTin::begin(std::uint32_t seed, const Context& context) {
  sample_inputs(context);
  for (int k = 0; k < count_; ++k) {
    const auto h = sample_at_points(input_.horizons.heights[k], tin_.points, context);
    for (std::size_t i = 0; i < h.size(); ++i) horizons_[i * count_ + k] = float(h[i]);
  }
  const Fbm hollows({.seed = seed, .wavelength = kHollows, .octaves = 10, .gain = 0.7});
  parallel_chunks(context, tin_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double depth = 0.5 * parameters_.initial_relief *
                           (1.0 + std::tanh(hollows(tin_.points[i].x, tin_.points[i].y)));
      z_[i] = outlets_[i] ? 0.0 : parameters_.initial_relief - depth;
      // The column is complete: its top is the ground.
      for (int k = 0; k < count_; ++k) horizons_[i * count_ + k] += float(z_[i]);
    }
  });
  if (rivers_.lays_down()) bedrock_ = z_;
}

void GrowingTin::take_over(const GrowingTin& coarse, const Context& context) {
  sample_inputs(context);
  const std::vector<TinPlace> places = locate(coarse.tin_, tin_.points, context);
  parallel_chunks(context, tin_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      z_[i] = places[i].mix([&](std::int32_t v) { return coarse.z_[v]; });
      if (outlets_[i]) z_[i] = std::min(z_[i], 0.0);
      for (int k = 0; k < count_; ++k)
        horizons_[i * count_ + k] =
            float(places[i].mix([&](std::int32_t v) { return coarse.horizons_[v * count_ + k]; }));
    }
  });
  if (!rivers_.lays_down()) return;
  bedrock_.resize(z_.size());
  for (std::size_t i = 0; i < z_.size(); ++i)
    bedrock_[i] = places[i].mix([&](std::int32_t v) { return coarse.bedrock_[v]; });
  cut_bedrock();
}

void GrowingTin::set_phase(const UpliftPhase& phase, const Context& context) {
  for (int k = 0; k < count_; ++k) {
    const Raster<float>* raster = k == 0 ? phase.crust : phase.folds[k - 1];
    std::vector<double> rate(tin_.size(), 0.0);
    if (raster) rate = sample_at_points(*raster, tin_.points, context);
    for (std::size_t i = 0; i < rate.size(); ++i)
      rates_[i * count_ + k] = float(rate[i]) + (k > 0 ? rates_[i * count_ + k - 1] : 0.0f);
  }
  for (std::size_t i = 0; i < uplift_factor_.size() * count_; ++i)
    rates_[i] *= uplift_factor_[i / count_];
  carry(context);
  velocity_x_.clear();
  velocity_y_.clear();
  fastest_ = 0.0;
  if (!phase.velocity_x || !phase.velocity_y) return;
  velocity_x_ = sample_at_points(*phase.velocity_x, tin_.points, context);
  velocity_y_ = sample_at_points(*phase.velocity_y, tin_.points, context);
  for (std::size_t i = 0; i < velocity_x_.size(); ++i)
    fastest_ = std::max(fastest_, std::hypot(velocity_x_[i], velocity_y_[i]));
}

/// Ground below 0 is base level.
void GrowingTin::find_sea() {
  for (std::size_t i = 0; i < z_.size(); ++i) base_[i] = outlets_[i] || z_[i] < 0.0;
  flow_.set_base_level(base_);
  if (creep_) creep_->set_base_level(base_);
}

/// No rock stands out of the ground.
void GrowingTin::cut_bedrock() {
  for (std::size_t i = 0; i < bedrock_.size(); ++i) bedrock_[i] = std::min(bedrock_[i], z_[i]);
}

/// Uplift and erodibility of the highest rock, and the talus slope of what lies at the surface.
void GrowingTin::look_at_rock(const Context& context) {
  const RockTable& rocks = input_.rocks;
  const std::vector<double>& top = bedrock_.empty() ? z_ : bedrock_;
  parallel_chunks(context, tin_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float* v = rates_.data() + i * count_;
      const Rock rock = rocks.rock_at(horizons_.data() + i * count_, float(top[i]));
      const int k = std::min(rock.layer, count_ - 1);
      uplift_[i] = k > 0 ? v[k] + rock.gamma * (v[k - 1] - v[k]) : v[0];
      erodibility_[i] = rocks.erodibility(rock);
      if (!erodibility_factor_.empty()) erodibility_[i] *= erodibility_factor_[i];
      const bool loose = z_[i] - top[i] > kSedimentGap;
      talus_[i] = rocks.talus_slope(loose ? loose_sediment(rocks) : rock);
    }
  });
}

MassBalance GrowingTin::step(double years, const Context& context) {
  find_sea();
  look_at_rock(context);
  const std::vector<double> before = z_;
  for (std::size_t i = 0; i < z_.size(); ++i)  // rivers end at the level of the sea
    if (base_[i]) z_[i] = std::max(z_[i], 0.0);
  MassBalance balance =
      rivers_.lays_down() ? wear_and_lay_down(years, context) : wear(years, context);
  if (creep_) balance += creep_->step(z_, years, context);
  cut_bedrock();
  for (std::size_t i = 0; i < z_.size(); ++i)
    if (base_[i]) {  // an outlet may sink, and the sea floor moves as it will
      const double rise = uplift_[i] * years;
      const double moved = outlets_[i] && before[i] >= 0.0 ? std::min(rise, 0.0) : rise;
      z_[i] = before[i] + moved;
      if (!bedrock_.empty()) bedrock_[i] = std::min(bedrock_[i] + moved, z_[i]);
    }
  raise_horizons(years, context);
  if (input_.isostasy.isostasy != Isostasy::None) rebound(before, years, context);
  carried_years_ += years;
  const double edge = std::sqrt(tin_.domain.area() / double(tin_.size()));
  if (fastest_ * carried_years_ > kFarthestCarry * edge) carry(context);
  return balance;
}

TinForcing GrowingTin::forcing() const {
  TinForcing forcing{.uplift_rate = std::span<const float>(uplift_),
                     .erodibility = std::span<const float>(erodibility_)};
  if (!rain_.empty()) forcing.rain_weight = std::span<const float>(rain_);
  return forcing;
}

MassBalance GrowingTin::wear(double years, const Context& context) {
  MassBalance balance = rivers_.step(flow_, z_, forcing(), years, context);
  if (parameters_.landslide_rate > 0.0)
    balance += shed_landslides(flow_, z_, std::span<const float>(talus_),
                               parameters_.landslide_rate, years, context);
  return balance;
}

/// Landslides come first: rivers take on their debris within the step.
MassBalance GrowingTin::wear_and_lay_down(double years, const Context& context) {
  flow_.route(z_, context);
  MassBalance balance;
  debris_.assign(z_.size(), 0.0);
  if (parameters_.landslide_rate > 0.0) {
    balance = shed_landslides(flow_, z_, std::span<const float>(talus_), parameters_.landslide_rate,
                              years, context, debris_);
    balance.stored_m3 = std::exchange(balance.exported_m3, 0.0);
    for (double& volume : debris_) volume /= years;
    cut_bedrock();
  }
  const double erodibility = parameters_.sediment_erodibility_factor *
                             input_.rocks.erodibility(loose_sediment(input_.rocks));
  balance += rivers_.solve(flow_, z_, forcing(), years, context,
                           {.bedrock = bedrock_, .erodibility = erodibility, .supply = debris_});
  return balance;
}

void GrowingTin::raise_horizons(double years, const Context& context) {
  parallel_chunks(context, horizons_.size(), 16 * kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) horizons_[i] += float(rates_[i] * years);
  });
}

/// What erosion took since `before` weighs no more.
void GrowingTin::rebound(const std::vector<double>& before, double years, const Context& context) {
  std::vector<double> eroded(z_.size());
  for (std::size_t i = 0; i < z_.size(); ++i)
    eroded[i] = base_[i] ? 0.0 : before[i] + uplift_[i] * years - z_[i];
  const Grid grid = grid_over(tin_.domain.origin, tin_.domain.size, kLoadCells);
  Raster<float> rise = sample_to_grid(tin_, eroded, grid, context);
  IsostasyParameters local = input_.isostasy;
  if (local.isostasy == Isostasy::Airy) local.elastic_thickness = 0.0;
  rise = flexural_deflection(rise, local, context, HollowFill::Air);
  const auto rises = sample_at_points(rise, tin_.points, context);
  parallel_chunks(context, z_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!outlets_[i]) {
        z_[i] += rises[i];
        if (!bedrock_.empty()) bedrock_[i] += rises[i];
      }
      for (int k = 0; k < count_; ++k) horizons_[i * count_ + k] += float(rises[i]);
    }
  });
}

void GrowingTin::carry(const Context& context) {
  const double years = std::exchange(carried_years_, 0.0);
  if (!(fastest_ * years > 0.0)) return;
  std::vector<std::int32_t> moving;
  std::vector<glm::dvec2> from;
  for (std::int32_t i = 0; i < std::int32_t(z_.size()); ++i) {
    if (velocity_x_[i] == 0.0 && velocity_y_[i] == 0.0) continue;
    moving.push_back(i);
    from.push_back(tin_.points[i] - years * glm::dvec2(velocity_x_[i], velocity_y_[i]));
  }
  const std::vector<TinPlace> places = locate(tin_, from, context);
  std::vector<double> z = z_, bedrock = bedrock_;
  std::vector<float> h = horizons_;
  parallel_chunks(context, moving.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end; ++m) {
      const std::int32_t i = moving[m];
      if (!outlets_[i]) {
        z[i] = places[m].mix([&](std::int32_t v) { return z_[v]; });
        if (!bedrock.empty())
          bedrock[i] = places[m].mix([&](std::int32_t v) { return bedrock_[v]; });
      }
      for (int k = 0; k < count_; ++k)
        h[i * count_ + k] =
            float(places[m].mix([&](std::int32_t v) { return horizons_[v * count_ + k]; }));
    }
  });
  z_ = std::move(z);
  horizons_ = std::move(h);
  bedrock_ = std::move(bedrock);
  cut_bedrock();
}

std::vector<double> GrowingTin::sediment_thickness() const {
  std::vector<double> thickness(bedrock_.size());
  for (std::size_t i = 0; i < thickness.size(); ++i) thickness[i] = z_[i] - bedrock_[i];
  return thickness;
}

std::vector<double> GrowingTin::horizon(int k) const {
  std::vector<double> values(tin_.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = horizons_[i * count_ + k];
  return values;
}

GroundSample GrowingTin::sample(const Grid& grid, std::vector<VertexField> fields,
                                const Context& context) const {
  const std::size_t others = fields.size();
  std::vector<std::vector<double>> horizons;
  for (int k = 0; k < count_; ++k) horizons.push_back(horizon(k));
  fields.insert(fields.end(), horizons.begin(), horizons.end());
  GroundSample made{sample_to_grid(tin_, fields, grid, context), {}};
  const auto first = made.fields.begin() + std::ptrdiff_t(others);
  made.horizons.heights.assign(std::make_move_iterator(first),
                               std::make_move_iterator(made.fields.end()));
  made.fields.erase(first, made.fields.end());
  return made;
}

std::vector<double> GrowingTin::uplift_rates(const Context& context) {
  look_at_rock(context);
  return {uplift_.begin(), uplift_.end()};
}

}  // namespace orogen
