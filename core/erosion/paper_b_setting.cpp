#include "erosion/paper_b_setting.h"

#include <cmath>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr double kGravity = 10.0, kTimeStep = 0.01, kCapacity = 0.1, kExchange = 0.002;
constexpr double kEvaporation = 0.1, kLeastSlope = 0.005, kMostSlope = 0.5;
constexpr double kRain = 0.001, kMostChange = 0.05, kHalvingDepth = 0.02;  // the paper names none

constexpr double kMmPerHour = 3.6e6;  // in a m/s

void check_positive(double value, const char* name, const char* unit) {
  if (!(value > 0.0 && std::isfinite(value)))
    throw InputError(std::string(name) + ": " + std::to_string(value) + " is not above 0 " + unit);
}

}  // namespace

PipeParameters paper_b_setting(double cell_size, double height_unit, double units) {
  check_positive(cell_size, "cell_size", "m");
  check_positive(height_unit, "height_unit", "m");
  check_positive(units, "units", "of the paper's time");
  PipeParameters p;
  const double time = cell_size * std::sqrt(kGravity / (p.gravity * p.pipe_depth));
  const double slope = height_unit / cell_size;
  p.duration = units * time;
  p.time_step = kTimeStep * time;
  p.drag_coefficient = 0.0;
  p.rain_rate_mm_per_h = kMmPerHour * kRain * height_unit / time;
  p.drop_probability = 1.0;  // that of the paper is the moisture
  p.evaporation_rate = kEvaporation / time;
  p.capacity_law = CapacityLaw::Velocity;
  p.sediment_capacity = kCapacity * time;
  p.bed_slope = BedSlope::Steepest;
  p.min_slope = kLeastSlope * slope;
  p.max_slope = kMostSlope * slope;
  p.sediment_dissolution_rate = p.rock_dissolution_rate = p.deposition_rate =
      -std::log1p(-kExchange) / p.time_step;
  p.erosion_halving_depth = p.deposition_halving_depth = kHalvingDepth * height_unit;
  p.max_change = kMostChange * height_unit;
  p.sediment_talus_angle_deg = 89.0;  // the paper has no slippage
  p.slippage_interval = 0;
  p.limit_to_neighbours = false;
  p.sea_keeps_sediment = true;
  return p;
}

}  // namespace orogen
