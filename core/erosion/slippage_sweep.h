// Slippage on padded fields, as slip_sediment and virtual pipes share it (slippage.h has the
// equations).
#pragma once

#include <cstdint>
#include <vector>

#include "erosion/virtual_pipes_tiles.h"
#include "foundation/context.h"

namespace orogen::pipes {

inline constexpr double kSlopeTolerance = 1e-3;  // above tan theta, that may be left

/// What slides where. Bed height: base + sediment - wear. A sink takes sediment, at its base; a
/// pinned cell or a wall does not.
template <class Real>
struct SlideField {
  PaddedShape shape;
  const std::vector<Tile>* tiles = nullptr;
  const Real *base = nullptr, *wear = nullptr, *code = nullptr;
  double cell_size = 1.0, tan_repose = 0.65;
};

/// Keeps between sweeps which tiles still move. `sediment` and `next` must agree wherever a tile is
/// asleep; wake() makes them all move again after others have changed the field, or the tiles.
template <class Real>
class Slider {
 public:
  explicit Slider(std::size_t tiles) : awake_(tiles, 1) {}

  void wake(std::size_t tiles) { awake_.assign(tiles, 1); }

  /// One sweep from `sediment` to `next`, which are then swapped. False if nothing moved.
  bool sweep(const SlideField<Real>& field, std::vector<Real>& sediment, std::vector<Real>& next,
             const Context& context);

  /// Sweeps until nothing moves; returns their number.
  int settle(const SlideField<Real>& field, std::vector<Real>& sediment, std::vector<Real>& next,
             int max_sweeps, const Context& context);

  /// Sediment that slid into sinks so far, in metres times cells.
  double exported() const { return exported_; }

 private:
  std::vector<std::uint8_t> awake_;
  double exported_ = 0.0;
};

/// Largest slope above tan_repose from a cell with sediment down to one that could take it.
template <class Real>
double steepest_excess(const SlideField<Real>& field, const std::vector<Real>& sediment,
                       const Context& context);

/// Turns rock that stands steeper than tan_rock[layer[cell]] into sediment in place: a quarter of
/// the excess over the lowest neighbour, less the sediment that already lies on it.
template <class Real>
void loosen_rock(const SlideField<Real>& field, const std::vector<std::uint8_t>& layer,
                 const std::vector<double>& tan_rock, const std::vector<Real>& sediment,
                 std::vector<Real>& new_sediment, std::vector<Real>& new_wear,
                 const Context& context);

}  // namespace orogen::pipes
