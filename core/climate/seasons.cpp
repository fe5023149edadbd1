#include "climate/seasons.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orogen {

namespace {

constexpr double kHottest = 30.0;           // °C that plants make use of
constexpr double kMetresADegree = 0.05893;  // a year
constexpr double kColdest = -15.0;          // °C of warmth 0
constexpr double kLeastGivenOff = 0.2;      // m/yr: dry wind takes snow too

/// Half the part of the year above the threshold, as an angle from midsummer.
double angle_above(double threshold, double mean, double swing) {
  if (swing <= 0.0) return mean > threshold ? std::numbers::pi : 0.0;
  return std::acos(std::clamp((threshold - mean) / swing, -1.0, 1.0));
}

}  // namespace

double mean_above(double threshold, double mean, double swing) {
  const double angle = angle_above(threshold, mean, swing);
  return ((mean - threshold) * angle + swing * std::sin(angle)) / std::numbers::pi;
}

double biotemperature(double mean, double swing) {
  return mean_above(0.0, mean, swing) - mean_above(kHottest, mean, swing);
}

double evapotranspiration(double biotemperature) {
  return kMetresADegree * biotemperature;
}

double snow_cover(double mean, double swing, double rain, double melt) {
  const double frost = 1.0 - angle_above(0.0, mean, swing) / std::numbers::pi;
  const double fallen = rain * frost, melted = melt * mean_above(0.0, mean, swing);
  if (fallen <= 0.0) return 0.0;
  return fallen >= melted ? 1.0 : frost + (1.0 - frost) * fallen / melted;
}

double warmth(double mean) {
  return std::clamp((mean - kColdest) / kWarmthDegrees, 0.0, 1.0);
}

double wetness(double rain, double evapotranspiration) {
  return rain / (rain + std::max(evapotranspiration, kLeastGivenOff));
}

double rain_of_wetness(double wetness, double evapotranspiration) {
  return std::max(evapotranspiration, kLeastGivenOff) * wetness / (1.0 - wetness);
}

}  // namespace orogen
