#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/errors.h"
#include "inputs/map_draft.h"

namespace orogen {

std::vector<Coast> join_coast_pieces(std::vector<CoastPiece> pieces, double tolerance,
                                     MapReport& report) {
  std::vector<Coast> coasts;
  std::vector<char> used(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (used[i]) continue;
    used[i] = 1;
    CoastPiece& line = pieces[i];
    const std::string words = feature_words("coast", line.feature, i, line.name);
    while (line.points.front() != line.points.back()) {
      // The nearest end of the pieces left, and this line's own beginning, from this line's end.
      const glm::dvec2 end = line.points.back();
      double gap = glm::length(line.points.front() - end);
      std::size_t best = i;
      bool turned = false;
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (used[k]) continue;
        for (const bool t : {false, true}) {
          const double d =
              glm::length((t ? pieces[k].points.back() : pieces[k].points.front()) - end);
          if (d < gap) gap = d, best = k, turned = t;
        }
      }
      if (gap > tolerance)
        throw InputError(words + ": the coast stays open at " + report.place(end) +
                         "; the nearest end lies " + distance_words(gap) + " away, at most " +
                         distance_words(tolerance) + " can be closed");
      if (gap > 0.0)
        report.warn(words + ": a gap of " + distance_words(gap) + " at " + report.place(end) +
                    " closed");
      if (best == i) break;
      used[best] = 1;
      Polyline next = std::move(pieces[best].points);
      if (turned) std::reverse(next.begin(), next.end());
      line.points.insert(line.points.end(), next.begin() + (gap == 0.0 ? 1 : 0), next.end());
      line.clipped = line.clipped || pieces[best].clipped;
    }
    if (line.points.front() == line.points.back()) line.points.pop_back();
    coasts.push_back({std::move(line.points), {}, line.clipped, line.name, line.feature});
  }
  return coasts;
}

}  // namespace orogen
