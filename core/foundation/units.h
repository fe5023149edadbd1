// Inside, everything is SI with years for time: metres, years, radians.
#pragma once

#include <numbers>

namespace orogen {

inline constexpr double kMetresPerKilometre = 1000.0;
inline constexpr double kSecondsPerYear = 31557600.0;  // Julian year
inline constexpr double kGravity = 9.80665;            // m/s²

constexpr double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}
constexpr double degrees(double radians) {
  return radians * (180.0 / std::numbers::pi);
}

}  // namespace orogen
