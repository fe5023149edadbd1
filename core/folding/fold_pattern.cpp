#include "folding/fold_pattern.h"

#include <algorithm>
#include <cmath>

namespace orogen {

namespace {

constexpr float kFolds = 0.02f;    // of the greatest speed
constexpr double kFarthest = 3.0;  // deviations from the mean

}  // namespace

Raster<float> fold_pattern(const Raster<float>& fold_speed) {
  Raster<float> pattern(fold_speed.grid());
  const auto speeds = fold_speed.values();
  if (speeds.empty()) return pattern;
  double sum = 0.0, square = 0.0, count = 0.0;
  const float least = kFolds * *std::max_element(speeds.begin(), speeds.end());
  for (const float v : speeds)
    if (v > least) {
      sum += v;
      square += double(v) * v;
      count += 1.0;
    }
  if (count == 0.0) return pattern;
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(square / count - mean * mean, 1e-300));
  for (std::size_t i = 0; i < pattern.size(); ++i)
    pattern[i] = float(std::clamp((speeds[i] - mean) / deviation, -kFarthest, kFarthest));
  return pattern;
}

}  // namespace orogen
