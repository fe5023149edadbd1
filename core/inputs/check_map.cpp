#include "inputs/check_map.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "foundation/errors.h"
#include "inputs/map_checks.h"
#include "inputs/ring_arrangement.h"
#include "inputs/river_network.h"

namespace orogen {
namespace {

void check_numbers(Frame& f, const ReadOptions& options) {
  if (!(options.snap_distance >= 0.0 && options.snap_distance <= 1e6))
    throw InputError("snap_distance: must be from 0 to 1e6 m");
  if (!(std::fabs(f.origin.x) <= kFarthest && std::fabs(f.origin.y) <= kFarthest))
    throw InputError("frame.origin: must lie within 20,000 km");
  if (!(std::fmin(f.size.x, f.size.y) >= 0.0 && std::fmax(f.size.x, f.size.y) <= kFarthest))
    throw InputError("frame.size: must be from 0 to 20,000 km");
  f.origin = on_lattice(f.origin);
  f.size = on_lattice(f.size);
}

void check_rivers(std::vector<River>& rivers, MapReport& report) {
  for (std::size_t i = 0; i < rivers.size(); ++i) {
    River& river = rivers[i];
    const std::string words = feature_words("river", river.feature, i, river.name);
    clean_points(river.points, false, words, report);
    if (river.end_height_m && !(std::fabs(*river.end_height_m) <= kHighestPeak))
      throw InputError(words + ": end_height_m must be from -12000 to 12000 m, not " +
                       std::to_string(*river.end_height_m));
  }
}

/// A frame without a size: the map's extent and a margin of sea around.
void complete_frame(VectorMap& map, MapReport& report) {
  Frame& f = map.frame;
  Box box;
  bool clipped = false;
  const auto add_all = [&](const auto& points) {
    for (const glm::dvec2 p : points) box.add(p);
  };
  for (const Coast& c : map.coasts) {
    add_all(c.outer);
    clipped = clipped || c.clipped;
  }
  for (const Lake& l : map.lakes) add_all(l.outer);
  if (map.coasts.empty()) {
    for (const River& r : map.rivers) add_all(r.points);
    for (const Peak& p : map.peaks) box.add(p.position);
  }
  if (f.size.x > 0.0 && f.size.y > 0.0) {
    if (!map.coasts.empty() && !Box{f.origin, f.origin + f.size}.meets(box))
      throw InputError("frame: no coast lies inside it; the coasts reach from " +
                       report.place(box.low) + " to " + report.place(box.high));
    return;
  }
  const glm::dvec2 size = box.high - box.low;
  const double margin = clipped ? 0.0 : std::fmax(2000.0, 0.04 * std::fmax(size.x, size.y));
  const bool from_zero = f.proj4.empty() && f.origin == glm::dvec2(0.0) && !clipped &&
                         box.low.x >= 0.0 && box.low.y >= 0.0 && box.low.x <= size.x + margin &&
                         box.low.y <= size.y + margin;
  f.origin = from_zero ? glm::dvec2(0.0) : clipped ? box.low : glm::floor(box.low - margin);
  f.size = clipped ? size : glm::ceil(box.high + margin - f.origin);
}

}  // namespace

void clean_points(std::vector<glm::dvec2>& points, bool closed, const std::string& words,
                  MapReport& report, std::vector<std::uint32_t>* drawn) {
  std::size_t kept = 0, repeated = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 p = points[i];
    if (!(std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest))
      throw InputError(words + ", vertex " + std::to_string(i) + ": (" + std::to_string(p.x) +
                       " m, " + std::to_string(p.y) + " m) is not finite or lies beyond 20,000 km");
    const glm::dvec2 q = on_lattice(p);
    if (kept > 0 && points[kept - 1] == q) {
      ++repeated;
      continue;
    }
    points[kept++] = q;
    if (drawn) drawn->push_back(std::uint32_t(i));
  }
  points.resize(kept);
  if (closed && points.size() > 1 && points.front() == points.back()) {
    points.pop_back();
    if (drawn) drawn->pop_back();
  }
  if (repeated > 0)
    report.warn(words + ": " + std::to_string(repeated) + " repeated point" +
                (repeated > 1 ? "s" : "") + " removed");
}

VectorMap finish_map(MapDraft draft, const ReadOptions& options, MapReport report) {
  VectorMap& map = draft.map;
  draft.hints.resize(map.rivers.size());
  check_numbers(map.frame, options);
  if (map.coasts.empty() && draft.pieces.empty() && map.rivers.empty() && map.peaks.empty() &&
      map.lakes.empty())
    throw InputError("features: none is a coast, river, peak or lake");
  check_rivers(map.rivers, report);
  clean_peaks(map, report);
  check_rings(draft, report);
  complete_frame(map, report);
  carry_clipped_coasts(map, report);
  const LandRegion land(map);
  check_peaks(map, land, report);
  connect_rivers(map, draft.hints, land, options, report);
  for (std::string& warning : report.take_warnings()) map.warnings.push_back(std::move(warning));
  return std::move(draft.map);
}

VectorMap check_map(VectorMap map, const ReadOptions& options) {
  MapDraft draft;
  draft.map = std::move(map);
  for (const River& river : draft.map.rivers) {
    const bool said = river.end != RiverEnd::Sea;  // the default says nothing
    draft.hints.push_back({said ? std::optional(river.end) : std::nullopt, said});
  }
  return finish_map(std::move(draft), options, MapReport(options.strict));
}

bool operator==(const VectorMap& a, const VectorMap& b) {
  const auto frame = [](const Frame& f) { return std::tie(f.origin, f.size, f.proj4); };
  const auto coast = [](const Coast& x, const Coast& y) {
    return std::tie(x.outer, x.holes, x.clipped, x.name) ==
           std::tie(y.outer, y.holes, y.clipped, y.name);
  };
  const auto lake = [](const Lake& x, const Lake& y) {
    return std::tie(x.outer, x.islands, x.level_m, x.name) ==
           std::tie(y.outer, y.islands, y.level_m, y.name);
  };
  const auto river = [](const River& x, const River& y) {
    return std::tie(x.points, x.end, x.joins, x.end_height_m, x.rank, x.name) ==
           std::tie(y.points, y.end, y.joins, y.end_height_m, y.rank, y.name);
  };
  const auto peak = [](const Peak& x, const Peak& y) {
    return std::tie(x.position, x.height_m, x.name, x.volcano) ==
           std::tie(y.position, y.height_m, y.name, y.volcano);
  };
  const auto same = [](const auto& x, const auto& y, const auto& equal) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), equal);
  };
  return a.name == b.name && frame(a.frame) == frame(b.frame) && same(a.coasts, b.coasts, coast) &&
         same(a.lakes, b.lakes, lake) && same(a.rivers, b.rivers, river) &&
         same(a.peaks, b.peaks, peak);
}

}  // namespace orogen
