#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "foundation/errors.h"
#include "inputs/map_checks.h"
#include "inputs/ring_arrangement.h"

namespace orogen {
namespace {

constexpr double kPeakAshore = 500.0;  // m, a peak this far out is moved to the land
constexpr double kSamePeak = 50.0;     // m

std::string words(const VectorMap& map, std::size_t i) {
  return feature_words("peak", map.peaks[i].feature, i, map.peaks[i].name);
}

std::string height_words(double height) {
  char text[40];
  std::snprintf(text, sizeof text, "%g m", height);
  return text;
}

void bring_ashore(VectorMap& map, std::size_t i, const LandRegion& land, MapReport& report) {
  glm::dvec2& position = map.peaks[i].position;
  const bool in_lake = land.lake_at(position) >= 0;
  if (land.on_land(position) && !in_lake) return;
  const auto hit = (in_lake ? land.lakes() : land.coast()).nearest(position);
  const std::string what =
      words(map, i) + ": lies " + (hit ? distance_words(hit->distance) + " " : "") +
      (in_lake ? "inside a lake" : "out at sea") + " at " + report.place(position);
  if (hit && hit->distance > 0.0 && hit->distance <= kPeakAshore) {
    const glm::dvec2 inland = glm::normalize(hit->point - position);
    for (const double step : {200.0, 100.0, 50.0, 20.0, 5.0, 1.0}) {
      const glm::dvec2 p = on_lattice(hit->point + step * inland);
      if (!land.on_land(p) || land.lake_at(p) >= 0) continue;
      position = p;
      report.warn(what + "; moved ashore");
      return;
    }
  }
  throw InputError(what + "; peaks must stand on land");
}

/// Which peaks stand at the place of an earlier one.
std::vector<char> find_repeated(VectorMap& map, MapReport& report) {
  std::vector<char> repeated(map.peaks.size(), 0);
  std::map<std::pair<long, long>, std::vector<std::size_t>> kept;  // by squares of kSamePeak
  for (std::size_t i = 0; i < map.peaks.size(); ++i) {
    const Peak& peak = map.peaks[i];
    const long x = std::lround(peak.position.x / kSamePeak);
    const long y = std::lround(peak.position.y / kSamePeak);
    for (long dx = -1; dx <= 1 && !repeated[i]; ++dx)
      for (long dy = -1; dy <= 1 && !repeated[i]; ++dy) {
        const auto square = kept.find({x + dx, y + dy});
        if (square == kept.end()) continue;
        for (const std::size_t k : square->second) {
          Peak& first = map.peaks[k];
          if (glm::length(first.position - peak.position) > kSamePeak) continue;
          const std::string at = " at " + report.place(peak.position);
          if (first.height_m && peak.height_m && *first.height_m != *peak.height_m)
            throw InputError(words(map, i) + ": stands where " + words(map, k) + " stands," + at +
                             ", with another height (" + height_words(*peak.height_m) + " and " +
                             height_words(*first.height_m) + ")");
          report.warn(words(map, i) + ": repeats " + words(map, k) + at + "; left out");
          if (!first.height_m) first.height_m = peak.height_m;
          repeated[i] = 1;
          break;
        }
      }
    if (!repeated[i]) kept[{x, y}].push_back(i);
  }
  return repeated;
}

}  // namespace

void clean_peaks(VectorMap& map, MapReport& report) {
  for (std::size_t i = 0; i < map.peaks.size(); ++i) {
    Peak& peak = map.peaks[i];
    std::vector<glm::dvec2> place{peak.position};
    clean_points(place, false, words(map, i), report);
    peak.position = place[0];
    if (peak.height_m && !(*peak.height_m > 0.0 && *peak.height_m <= kHighestPeak))
      throw InputError(words(map, i) + ": height_m must be above 0 and at most 12000 m, not " +
                       height_words(*peak.height_m) + ", at " + report.place(peak.position));
  }
}

void check_peaks(VectorMap& map, const LandRegion& land, MapReport& report) {
  for (std::size_t i = 0; i < map.peaks.size(); ++i) bring_ashore(map, i, land, report);
  std::vector<char> left_out = find_repeated(map, report);
  for (std::size_t i = 0; i < map.peaks.size(); ++i)
    if (!left_out[i] && !land.in_frame(map.peaks[i].position)) {
      report.warn(words(map, i) + ": lies outside the frame at " +
                  report.place(map.peaks[i].position) + "; left out");
      left_out[i] = 1;
    }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < map.peaks.size(); ++i)
    if (!left_out[i]) {
      if (kept != i) map.peaks[kept] = std::move(map.peaks[i]);
      ++kept;
    }
  map.peaks.resize(kept);
}

}  // namespace orogen
