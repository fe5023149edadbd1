#include "strata/horizon_trace.h"

#include "strata/block.h"
#include "tectonics/iso_lines.h"

namespace orogen {

std::vector<Trace> horizon_traces(const RockBody& body, int horizon, const Context& context) {
  check_horizon(body, horizon);
  const Grid& grid = body.elevation.grid();
  Raster<float> above(grid);
  std::vector<float> h(body.horizons.heights.size());
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      body.horizons.at(grid.center(r, c), h.data());
      above(r, c) = h[horizon] - body.elevation(r, c);
    }
  // As rock_at() has it: ground a little above the highest horizon still is its layer.
  const float level = horizon == body.horizons.layers() ? -kSedimentGap : 0.0f;
  std::vector<Trace> traces;
  for (const Polyline& line : iso_lines(above, level, context)) {
    Trace& trace = traces.emplace_back();
    for (const glm::dvec2 p : line) {
      const glm::dvec2 place = p - grid.origin;
      trace.emplace_back(place.x, place.y, body.ground_at(p));
    }
  }
  return traces;
}

}  // namespace orogen
