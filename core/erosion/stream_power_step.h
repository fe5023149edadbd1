// One implicit step of the stream power law. Private to stream_power*.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "erosion/stream_power.h"

namespace orogen {

inline constexpr float kPinned = -1.0f;  // in place of an incision rate

/// Incision as it depends on place: k A'^m / length^n, the rate (m/yr) at a difference in height of
/// 1 m to the receiver.
struct IncisionLaw {
  double area_exponent, slope_exponent, least_area;
  bool add_area;
  float per_straight, per_diagonal;  // 1 / length^n

  IncisionLaw(const StreamPowerParameters& parameters, double cell_size);
  /// For `count` cells; bit 0 of `direction` tells diagonals.
  void rates(const float* erodibility, const double* area, const std::uint8_t* direction, int count,
             float* out) const;
};

/// `z` within the heights allowed; what stands above its receiver is not pressed below it.
inline float held_within(float z, float below, float least, float greatest) {
  return std::min(std::max(z, least), std::max(greatest, below));
}

struct StreamPower::Step {
  const FlowGraph& flow;
  const StreamPowerForcing& forcing;
  IncisionLaw law;
  const double* area;
  float* z;
  double per_dt;  // 1 / dt, 0 for an infinite step
  double dt;      // 0 for an infinite step

  /// What a cell's change of height is to the books.
  void add(float start, float end, float uplift, VolumeSum& sum) const {
    const double change = double(end) - double(start);
    const double supply = per_dt > 0.0 ? uplift * dt : std::max(0.0, change);
    const double lost = supply - change;
    sum.eroded += std::max(0.0, lost);
    sum.deposited += std::max(0.0, -lost);
    sum.supplied += supply;
    sum.change += change;
  }
  MassBalance balance(const std::vector<VolumeSum>& sums) const;
};

}  // namespace orogen
