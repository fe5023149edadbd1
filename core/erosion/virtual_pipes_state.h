// The fields of a virtual-pipe run, padded, as structure of arrays, and one step of it.
#pragma once

#include <cstdint>
#include <vector>

#include "erosion/virtual_pipes.h"
#include "erosion/virtual_pipes_kernels.h"
#include "erosion/virtual_pipes_tiles.h"

namespace orogen::pipes {

/// What a tile let in and out so far, in metres times cells. Each on its own cache line.
struct alignas(64) TileSums {
  double rain = 0.0, evaporated = 0.0, exported_water = 0.0, exported_sediment = 0.0;

  void add(const TileSums& other) {
    rain += other.rain;
    evaporated += other.evaporated;
    exported_water += other.exported_water;
    exported_sediment += other.exported_sediment;
  }
};

/// A field that a step reads, and the one it writes.
template <class Real>
struct Pair {
  std::vector<Real> now, next;
};

template <class Real>
struct PipeState {
  PaddedShape shape;
  double cell_size = 1.0, time_step = 0.0;
  bool open_sides = true, traced = false;  // traced: semi-Lagrangian sediment
  std::uint32_t seed = 0;
  StepConstants<Real> k{};

  // Heights of the first bed less the first sediment. At sea 0, the level of the water: a sink
  // stands as dry ground at that level. Around the map: its fixed height there.
  std::vector<Real> base;
  Pair<Real> sediment, wear, depth, suspended, flux_x, flux_y;  // flux_x: to the eastern neighbour
  std::vector<Real> carry;                                      // of depth, what rounding left out
  std::vector<Real> code;  // share of its deficit that the exposed rock gives, or a kind of cell
  std::vector<Real> sea_room;  // m of sea that sediment has not filled; empty: it leaves
  std::vector<Real> original_sediment, moisture, temperature;  // empty: 0, 1, 1

  // Layers of rock: the exposed one, and how much wear takes it all. Empty: bedrock only.
  std::vector<std::uint8_t> layer;
  std::vector<Real> floor;
  const std::vector<RockLayer>* layers = nullptr;
  const Raster<float>* erodibility = nullptr;
  double bedrock_rate = 0.0;  // 1/s
  Real bedrock_share = 0;     // what that is in a step
  double erosion_halving_depth = 0.0, deposition_halving_depth = 0.0;

  std::vector<Tile> tiles;
  std::vector<TileSums> sums;
  TileSums sums_before;  // of tiles that were laid out anew since
  struct Source {
    std::size_t cell;
    double gain;  // m a step
  };
  std::vector<Source> sources;
  double source_water = 0.0;  // m times cells, so far

  /// The exposed layer's share of a deficit in a step; moves on to the next layer with thickness.
  void expose(int row, int column);
};

template <class Real>
PipeState<Real> make_pipe_state(const Raster<float>& elevation, const PipeForcing& forcing,
                                const PipeParameters& parameters, double time_step);

/// Everything but slippage, for one time step.
template <class Real>
void advance(PipeState<Real>& state, int step, const Context& context);

/// Makes land of the sea that its sediment has filled to the level of the water; `elevation` is the
/// first one. Steps run between its calls, which lay out the tiles anew.
template <class Real>
void silt_up(PipeState<Real>& state, const Raster<float>& elevation);

}  // namespace orogen::pipes
