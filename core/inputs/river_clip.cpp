#include "inputs/river_clip.h"

#include <algorithm>
#include <cmath>

#include "inputs/ring_arrangement.h"

namespace orogen {
namespace {

constexpr double kSlip = 2.0;  // m, shorter stretches on the wrong side are no crossing

/// t in [0, 1] where a -> b crosses segments of the tree.
void crossings(const SegmentTree& tree, glm::dvec2 a, glm::dvec2 b, std::vector<double>& at) {
  Box box;
  box.add(a);
  box.add(b);
  const glm::dvec2 u = b - a;
  tree.visit(box, [&](std::size_t i) {
    const Segment& s = tree.segments()[i];
    const glm::dvec2 v = s.b - s.a, w = s.a - a;
    const double cross = u.x * v.y - u.y * v.x;
    if (cross == 0.0) return;
    const double t = (w.x * v.y - w.y * v.x) / cross, q = (w.x * u.y - w.y * u.x) / cross;
    if (t >= 0.0 && t <= 1.0 && q >= 0.0 && q <= 1.0) at.push_back(t);
  });
}

/// A stretch of a river on one side of the coast.
struct Run {
  bool inside;
  Polyline points;
  double length;
};

std::vector<Run> split_runs(const Polyline& line, const LandRegion& land) {
  std::vector<Run> runs;
  std::vector<double> at;
  bool inside = false, known = false;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const glm::dvec2 a = line[k], b = line[k + 1];
    at.assign({0.0, 1.0});
    crossings(land.rings(), a, b, at);
    crossings(land.frame(), a, b, at);
    const bool crossed = at.size() > 2;
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      const glm::dvec2 middle = a + 0.5 * (at[i] + at[i + 1]) * (b - a);
      if (crossed || !known) inside = land.in_frame(middle) && land.on_land(middle);
      known = !crossed;
      const glm::dvec2 from = at[i] == 0.0 ? a : on_lattice(a + at[i] * (b - a));
      const glm::dvec2 to = at[i + 1] == 1.0 ? b : on_lattice(a + at[i + 1] * (b - a));
      if (from == to) continue;
      if (runs.empty() || runs.back().inside != inside) runs.push_back({inside, {from}, 0.0});
      runs.back().points.push_back(to);
      runs.back().length += glm::length(to - from);
    }
  }
  return runs;
}

/// Turns runs too short to be meant and joins neighbours of one side.
std::vector<Run> without_slips(std::vector<Run> runs, bool side) {
  std::vector<Run> joined;
  for (Run& run : runs) {
    if (run.inside == side && run.length < kSlip && runs.size() > 1) run.inside = !side;
    if (!joined.empty() && joined.back().inside == run.inside) {
      joined.back().points.insert(joined.back().points.end(), run.points.begin() + 1,
                                  run.points.end());
      joined.back().length += run.length;
    } else {
      joined.push_back(std::move(run));
    }
  }
  return joined;
}

/// Cuts the beginning of a line off where it leaves a lake; the length cut, all of it if the line
/// never leaves.
double cut_lake(Polyline& line, const LandRegion& land) {
  if (land.lake_at(line.front()) < 0) return 0.0;
  const auto shore = land.lakes().nearest(line.front());
  if (shore && shore->distance <= kTouch) return 0.0;
  double cut = 0.0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    if (const auto x = first_crossing(land.lakes(), line[k], line[k + 1])) {
      cut += glm::length(*x - line[k]);
      line.erase(line.begin(), line.begin() + std::ptrdiff_t(k));
      line.front() = on_lattice(*x);
      if (line.size() > 1 && line[0] == line[1]) line.erase(line.begin());
      return cut;
    }
    cut += glm::length(line[k + 1] - line[k]);
  }
  line.clear();
  return cut;
}

}  // namespace

std::optional<glm::dvec2> first_crossing(const SegmentTree& tree, glm::dvec2 a, glm::dvec2 b) {
  std::vector<double> at;
  crossings(tree, a, b, at);
  if (at.empty()) return {};
  return a + *std::min_element(at.begin(), at.end()) * (b - a);
}

double length_of(const Polyline& line) {
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) length += glm::length(line[k + 1] - line[k]);
  return length;
}

std::vector<RiverLine> clip_rivers(const std::vector<River>& rivers, const LandRegion& land,
                                   MapReport& report) {
  std::vector<RiverLine> lines;
  for (std::size_t r = 0; r < rivers.size(); ++r) {
    const std::string words = feature_words("river", rivers[r].feature, r, rivers[r].name);
    if (rivers[r].points.size() < 2) {
      report.warn(words + ": has no length; left out");
      continue;
    }
    std::vector<Run> runs =
        without_slips(without_slips(split_runs(rivers[r].points, land), false), true);
    if (runs.size() == 1 && runs[0].inside) runs[0].points = rivers[r].points;
    double total = 0.0, longest = 0.0, cut = 0.0;
    const Run* first_cut = nullptr;
    for (const Run& run : runs)
      if (run.inside) total += run.length, longest = std::fmax(longest, run.length);
    for (Run& run : runs) {
      if (run.inside && (run.length >= 0.25 * total || run.length == longest)) {
        lines.push_back({std::move(run.points), int(r)});
        continue;
      }
      cut += run.length;
      if (!first_cut) first_cut = &run;
    }
    if (first_cut) {
      const glm::dvec2 p = first_cut->points[first_cut->points.size() / 2];
      const std::string where = land.in_frame(p) ? "in the sea" : "outside the frame";
      report.warn(words + ": " +
                  (total > 0.0 ? distance_words(cut) + " of it lie " + where + " by " +
                                     report.place(p) + "; cut off"
                               : "lies " + where + " at " + report.place(p) + "; left out"));
    }
  }
  std::vector<RiverLine> kept;
  for (RiverLine& line : lines) {
    double cut = 0.0;
    const glm::dvec2 front = line.points.front();
    for (int end = 0; end < 2 && !line.points.empty(); ++end) {
      cut += cut_lake(line.points, land);
      std::reverse(line.points.begin(), line.points.end());
    }
    const std::string words = feature_words("river", rivers[line.river].feature,
                                            std::size_t(line.river), rivers[line.river].name);
    if (line.points.size() < 2) {
      report.warn(words + ": lies inside a lake at " + report.place(front) + "; left out");
      continue;
    }
    if (cut > 0.0) report.warn(words + ": " + distance_words(cut) + " inside a lake cut off");
    kept.push_back(std::move(line));
  }
  return kept;
}

}  // namespace orogen
