// Sea that fills up with sediment becomes land: deltas grow, and the coast moves.
#include "erosion/virtual_pipes_state.h"

namespace orogen::pipes {

namespace {

/// The ground that a sink has become, its bed where the sea's was.
template <class Real>
void raise_cell(PipeState<Real>& s, int row, int column, float sea_bed) {
  const std::size_t i = s.shape.index(row, column);
  s.base[i] = Real(sea_bed);
  s.sediment.now[i] = s.sediment.next[i] = Real(-sea_bed);
  if (!s.floor.empty()) s.floor[i] = Real(s.layers->front().thickness(row, column));
  s.expose(row, column);
}

}  // namespace

template <class Real>
void silt_up(PipeState<Real>& s, const Raster<float>& elevation) {
  if (s.sea_room.empty()) return;
  double raised = 0.0;
  for (const Tile& tile : s.tiles)
    for (const std::size_t i : tile.sinks) {
      const int row = int(i / s.shape.stride) - kPad, column = int(i % s.shape.stride) - kPad;
      const float bed = elevation(row, column);
      if (s.sea_room[i] > 0 || bed >= 0.0f) continue;
      raise_cell(s, row, column, bed);
      raised -= double(bed);
    }
  if (raised == 0.0) return;
  for (const TileSums& sums : s.sums) s.sums_before.add(sums);
  s.sums_before.exported_sediment -= raised;
  s.tiles = make_tiles(s.shape, s.code.data());
  s.sums.assign(s.tiles.size(), {});
}

template void silt_up(PipeState<float>&, const Raster<float>&);
template void silt_up(PipeState<double>&, const Raster<float>&);

}  // namespace orogen::pipes
