#include "erosion/growth_level.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "erosion/levels.h"
#include "erosion/slope_limit.h"
#include "foundation/disc.h"
#include "foundation/distance_transform.h"
#include "foundation/gaussian_blur.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"
#include "foundation/resample.h"
#include "foundation/units.h"
#include "hydrology/drainage.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 16384;
constexpr double kFirstSlope = 0.5, kFirstArea = 1e6;  // m², of the first guess of uplift
constexpr double kHackCoefficient = 1.4;               // km^(1 - 2 · 0.6)
constexpr double kHackExponent = 0.6;
constexpr double kLeastBedLength = 300.0;  // m, of a spring's catchment
constexpr double kBesideBed = 500.0;       // m, where ground counts as beside a bed
constexpr double kBesideSlope = 0.03;
constexpr double kSpurCells = 1.5, kSpurReach = 300.0;  // m; of spurs that carry beds
constexpr float kPerchedBy = 25.0f;                     // m
constexpr float kLargestBedShare = 200.0f;
constexpr double kMassif = 2000.0, kMassifFall = 0.17;  // m around a peak; mean share below it
constexpr double kHeldWidth = 600.0, kHeldRate = 0.5;   // m; of ground held down or up
constexpr double kSteepestUplift = 1.3;                 // over that of hillslopes at talus
constexpr float kTalusByRock = 0.6f, kTalusSpread = 0.4f;

/// Hack's law: drainage area (m²) of a river `length` m below its source.
double hack_area(double length) {
  const double km = std::max(length, kLeastBedLength) / kMetresPerKilometre;
  return 1e6 * std::pow(km / kHackCoefficient, 1.0 / kHackExponent);
}

double talus_slope(const ReliefGrowthParameters& p) {
  return std::tan(radians(p.talus_angle_deg));
}

StreamPowerParameters solver_parameters(const ReliefGrowthParameters& p) {
  StreamPowerParameters solver;
  solver.area_exponent = p.area_exponent;
  return solver;
}

/// exp(sigma n - sigma²/2) times `mean`, n fBm.
Raster<float> lognormal(const Grid& grid, double mean, double sigma, double wavelength, double gain,
                        std::uint32_t seed, const Context& context) {
  if (sigma <= 0.0) return Raster<float>(grid, float(mean));
  Raster<float> field =
      fbm({.seed = seed, .wavelength = wavelength, .octaves = 7, .gain = gain}, grid, context);
  const float s = float(sigma), scale = float(mean * std::exp(-0.5 * sigma * sigma));
  parallel_chunks(context, field.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) field[i] = scale * std::exp(s * field[i]);
  });
  return field;
}

}  // namespace

GrowthLevel::GrowthLevel(const VectorMap& map, Raster<std::uint8_t> land, RiverBeds beds,
                         const Raster<float>& aim, const Raster<float>& folds,
                         const ReliefGrowthParameters& parameters, std::uint32_t seed,
                         Context& context)
    : parameters_(parameters),
      context_(context),
      grid_(land.grid()),
      land_(std::move(land)),
      beds_(std::move(beds)),
      base_(base_level(map, land_, beds_)),
      power_(solver_parameters(parameters)),
      elevation_(grid_),
      uplift_(grid_),
      forcing_(grid_),
      talus_slope_(grid_),
      summits_(collect_summits(map, land_)),
      pyramids_(summit_pyramids(summits_, beds_, context)),
      cap_(summit_cap(summits_, grid_, parameters.peak_reach, context)) {
  bed_share_.assign(beds_.cells.size(), float(parameters.bed_area_factor));
  flow_.emplace(base_.cells);
  flow_->force_receivers(forced_receivers(beds_));
  vary_rock(folds, seed);
  std::vector<glm::dvec2> places;
  for (const Summit& s : summits_) places.push_back(s.center);
  if (!places.empty()) nearest_summit_ = nearest_point(places, grid_, context_).nearest;
  set_aim(aim);
}

void GrowthLevel::hold_base_level() {
  for (std::size_t i = 0; i < elevation_.size(); ++i)
    if (base_.cells[i]) elevation_[i] = base_.height[i];
}

void GrowthLevel::vary_rock(const Raster<float>& folds, std::uint32_t seed) {
  const auto& p = parameters_;
  erodibility_ = lognormal(grid_, p.erodibility, p.erodibility_variation, p.rock_wavelength,
                           p.rock_roughness, seed + 1, context_);
  const float hardness = float(p.fold_hardness), mean = float(p.erodibility);
  const float talus = float(talus_slope(p));
  parallel_chunks(context_, folds.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float strength = std::pow(erodibility_[i] / mean, -kTalusByRock);
      talus_slope_[i] = talus * std::clamp(strength, 1.0f - kTalusSpread, 1.0f + kTalusSpread);
      erodibility_[i] *= std::exp(-hardness * folds[i]);
    }
  });
  uplift_noise_ =
      lognormal(grid_, 1.0, p.uplift_variation, p.uplift_wavelength, 0.6, seed + 2, context_);
}

Raster<float> GrowthLevel::smooth(const Raster<float>& field, double sigma) {
  Raster<float>& share = land_shares_[sigma];
  if (share.empty()) share = blurred_land(land_, sigma, context_);
  return blur_over_land(field, land_, share, sigma, context_);
}

void GrowthLevel::set_aim(const Raster<float>& aim) {
  Raster<float> heights(grid_);
  float highest = 0.0f;
  for (std::size_t i = 0; i < aim.size(); ++i) {
    heights[i] = std::clamp(aim[i], 0.0f, float(1.0 - kMassifFall) * cap_[i]);
    if (land_[i]) highest = std::max(highest, heights[i]);
  }
  aim_ = smooth(heights, parameters_.fit_radius);
  slack_ = std::max(1.0, 0.01 * highest);
}

void GrowthLevel::set_hillslope_area() {
  const auto& p = parameters_;
  const Raster<float> around = smooth(aim_, 2.0 * p.fit_radius);
  Raster<float> ruggedness(grid_);
  parallel_rows(context_, grid_.ny, [&](int r) {
    for (int c = 0; c < grid_.nx; ++c) {
      double strongest = summits_.empty() ? 1.0 : 0.0;
      for (const Summit& s : summits_) {
        const glm::dvec2 d = grid_.center(r, c) - s.center;
        const double above = s.height - around(r, c);
        if (above <= 0.0) continue;
        const double share = above / std::min(p.range_relief, 0.3 * s.height);
        strongest = std::max(strongest, share * std::exp(-std::hypot(d.x, d.y) / p.range_reach));
      }
      ruggedness(r, c) = float(std::min(1.0, strongest));
    }
  });
  ruggedness = smooth(ruggedness, 0.15 * p.range_reach);
  const double plain = std::log(std::max(1.0, p.plain_area));
  const double range = std::log(std::max(1.0, p.hillslope_area));
  hillslope_area_ = Raster<float>(grid_);
  for (std::size_t i = 0; i < hillslope_area_.size(); ++i)
    hillslope_area_[i] = float(std::exp(plain + (range - plain) * ruggedness[i]));
}

void GrowthLevel::set_most_uplift() {
  // Where hillslopes stand at the talus angle already, more uplift moves no heights.
  const auto& p = parameters_;
  const double steepest = kSteepestUplift * talus_slope(p) * p.erodibility;
  most_uplift_ = Raster<float>(grid_);
  parallel_chunks(context_, most_uplift_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      most_uplift_[i] = float(steepest * std::pow(double(hillslope_area_[i]), p.area_exponent));
  });
}

void GrowthLevel::start(std::uint32_t seed) {
  const Raster<float> rough =
      fbm({.seed = seed + 4, .wavelength = 5000.0, .octaves = 5}, grid_, context_);
  double mean = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < aim_.size(); ++i)
    if (land_[i]) mean += aim_[i], ++count;
  mean = std::max(mean / std::max<std::size_t>(count, 1), 1.0);
  for (std::size_t i = 0; i < aim_.size(); ++i) {
    elevation_[i] = std::max(0.0f, 0.3f * aim_[i] + float(0.03 * mean) * rough[i]);
    const double share = std::clamp(aim_[i] / mean, 0.05, 4.0);
    uplift_[i] = float(kFirstSlope * parameters_.erodibility *
                       std::pow(kFirstArea, parameters_.area_exponent) * share);
  }
  hold_base_level();
  set_hillslope_area();
  set_most_uplift();
}

void GrowthLevel::start_from(const GrowthLevel& coarser) {
  elevation_ = resample_bilinear(coarser.elevation_, grid_, context_);
  uplift_ = resample_bilinear(coarser.uplift_, grid_, context_);
  hillslope_area_ = resample_bilinear(coarser.hillslope_area_, grid_, context_);
  set_most_uplift();
  hold_base_level();
}

void GrowthLevel::add_river_belts(double width) {
  std::vector<std::int32_t> receivers = forced_receivers(beds_);
  std::vector<std::int32_t> ring = beds_.cells;
  Raster<std::uint8_t> reached(grid_);
  for (const std::int32_t cell : ring) reached[cell] = 1;
  const int rings = int(std::lround(width / grid_.cell_size));
  for (int k = 0; k < rings; ++k) {
    std::vector<std::int32_t> next;
    for (const std::int32_t cell : ring) {
      const int row = cell / grid_.nx, column = cell % grid_.nx;
      for (const auto& [dr, dc] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
        if (!grid_.contains(row + dr, column + dc)) continue;
        const auto beside = std::int32_t(grid_.index(row + dr, column + dc));
        if (reached[beside] || base_.cells[beside]) continue;
        reached[beside] = 1;
        receivers[beside] = cell;
        next.push_back(beside);
      }
    }
    ring = std::move(next);
  }
  flow_->force_receivers(receivers);
}

void GrowthLevel::set_channel_area() {
  channel_area_.resize(area_.size());
  for (std::size_t i = 0; i < beds_.cells.size(); ++i) {
    double& area = area_[beds_.cells[i]];
    area = std::max(area, bed_share_[i] * hack_area(beds_.source_length[i]));
  }
  parallel_chunks(context_, area_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) channel_area_[i] = area_[i] + hillslope_area_[i];
  });
}

void GrowthLevel::lower_perched_beds() {
  // From the sources down: no bed may stand above the lowest ground beside the beds upstream of it.
  Raster<float> lowest_so_far(grid_, INFINITY);
  for (std::size_t i = beds_.cells.size(); i-- > 0;) {
    const std::int32_t cell = beds_.cells[i];
    const glm::dvec2 at = grid_.center(cell / grid_.nx, cell % grid_.nx);
    const double radius = std::max(kBesideBed, 2.0 * grid_.cell_size);
    float lowest = lowest_so_far[cell];
    for_disc(grid_, at, radius, [&](std::size_t k, double) {
      lowest = std::min(lowest, elevation_[k] + float(kBesideSlope * radius));
    });
    const bool perched = elevation_[cell] > lowest + kPerchedBy;
    bed_share_[i] = std::min(bed_share_[i] * (perched ? 1.5f : 1.0f), kLargestBedShare);
    if (beds_.receivers[i] >= 0) {
      float& below = lowest_so_far[beds_.receivers[i]];
      below = std::min(below, lowest);
    }
  }
}

Raster<float> GrowthLevel::carry_beds() {
  // Where a valley beside would undercut a bed, a spur at the talus angle carries the bed past it:
  // cut down to that valley, it would run in a canyon all the way below.
  Raster<float> least = pyramids_;
  const double slope = talus_slope(parameters_);
  const double flat = kSpurCells * grid_.cell_size;
  for (const std::int32_t cell : beds_.cells) {
    const float bed = elevation_[cell];
    const glm::dvec2 at = grid_.center(cell / grid_.nx, cell % grid_.nx);
    for_disc(grid_, at, std::max(kSpurReach, flat), [&](std::size_t k, double square) {
      const auto height = float(bed - slope * std::max(0.0, std::sqrt(square) - flat));
      if (height <= least[k] || base_.cells[k] || (beds_.river[k] && k != std::size_t(cell)))
        return;
      least[k] = height;
      elevation_[k] = std::max(elevation_[k], height);
    });
  }
  return least;
}

void GrowthLevel::step(bool fit) {
  flow_->route(elevation_, context_);
  accumulate_drainage_area(*flow_, area_, context_);
  set_channel_area();
  forcing_ = uplift_rate();
  StreamPowerForcing forcing;
  forcing.uplift_rate = forcing_;
  forcing.erodibility = erodibility_;
  forcing.least_height = pyramids_;
  forcing.greatest_height = cap_;
  forcing.talus_slope = talus_slope_;
  power_.solve(*flow_, channel_area_, elevation_, forcing, std::numeric_limits<double>::infinity(),
               context_);
  // Across divides, too.
  limit_slope(elevation_, base_.cells, carry_beds(), talus_slope_, context_);
  if (!fit) return;
  lower_perched_beds();
  fit_to_aim();
  fit_to_peaks();
  fit_to_bounds();
}

Raster<float> GrowthLevel::uplift_rate() const {
  Raster<float> rate(grid_);
  parallel_chunks(context_, rate.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) rate[i] = uplift_[i] * uplift_noise_[i];
  });
  return rate;
}

void GrowthLevel::fit_to_aim() {
  const Raster<float> smoothed = smooth(elevation_, parameters_.fit_radius);
  const float rate = float(parameters_.fit_rate), slack = float(slack_);
  parallel_chunks(context_, uplift_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!land_[i]) continue;
      const float ratio = std::clamp((aim_[i] + slack) / (smoothed[i] + slack), 0.5f, 2.0f);
      uplift_[i] *= std::pow(ratio, rate);
    }
  });
}

void GrowthLevel::fit_to_peaks() {
  const double reach = parameters_.peak_reach;
  const auto ratio_of = [](double want, double is) {
    return is > 0.0 ? std::log(std::clamp(want / is, 0.6, 1.6)) : 0.0;
  };
  std::vector<double> wide(summits_.size()), narrow(summits_.size());
  for (std::size_t s = 0; s < summits_.size(); ++s) {
    double highest = 0.0, sum = 0.0, count = 0.0;
    for_disc(grid_, summits_[s].center, reach, [&](std::size_t i, double square) {
      if (nearest_summit_[i] != std::int32_t(s)) return;
      if (elevation_[i] > pyramids_[i]) highest = std::max<double>(highest, elevation_[i]);
      if (square < kMassif * kMassif) sum += elevation_[i], ++count;
    });
    wide[s] = 0.7 * parameters_.fit_rate * ratio_of(summits_[s].height, highest);
    narrow[s] = 0.5 * parameters_.fit_rate *
                ratio_of((1.0 - kMassifFall) * summits_[s].height, sum / std::max(count, 1.0));
  }
  const auto raise = [&](const std::vector<double>& logarithm, double width) {
    for (std::size_t s = 0; s < summits_.size(); ++s)
      for_disc(grid_, summits_[s].center, 3.0 * width, [&](std::size_t i, double square) {
        uplift_[i] *= float(std::exp(logarithm[s] * std::exp(-0.5 * square / (width * width))));
      });
  };
  raise(wide, 1.1 * reach);
  raise(narrow, kMassif);
}

void GrowthLevel::fit_to_bounds() {
  // Ground that the named peaks around hold down rises less, what they hold up more.
  Raster<float> held(grid_);
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!land_[i]) continue;
    const bool down = elevation_[i] >= cap_[i];
    const bool up = pyramids_[i] > 0.0f && elevation_[i] <= pyramids_[i];
    held[i] = down ? 1.0f : up ? -1.0f : 0.0f;
  }
  held = gaussian_blur(held, std::max(kHeldWidth, grid_.cell_size), context_);
  const float rate = float(kHeldRate * parameters_.fit_rate);
  parallel_chunks(context_, held.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      uplift_[i] = std::min(uplift_[i] * std::exp(-rate * held[i]), most_uplift_[i]);
  });
}

}  // namespace orogen
