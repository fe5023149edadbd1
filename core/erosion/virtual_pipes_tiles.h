// How virtual pipes and slippage store fields and share out work: rows padded by two cells on each
// side, so that no stencil asks where the map ends, and tiles that fit a core's cache.
//
// Every cell has a code: 0 or more, ground that may change (in virtual pipes, the share of the
// deficit that the exposed rock gives up in a step); below 0, one of the kinds here.
#pragma once

#include <cstddef>
#include <vector>

namespace orogen::pipes {

inline constexpr int kPad = 2;
inline constexpr int kTileRows = 32, kTileColumns = 256;

inline constexpr double kPinned = -1.0;  // height must not change
inline constexpr double kSink = -2.0;    // sea: takes all that reaches it
inline constexpr double kWall = -3.0;    // outside the map

/// Rows [row0, row1), columns [column0, column1).
struct Tile {
  int row0 = 0, row1 = 0, column0 = 0, column1 = 0;
  std::vector<std::size_t> sinks;  // sea cells beside land, as padded indices, row by row
  std::vector<int> around;         // the tiles that share a side or corner, itself included
};

struct PaddedShape {
  int nx = 0, ny = 0;
  std::size_t stride = 0;

  PaddedShape() = default;
  PaddedShape(int columns, int rows)
      : nx(columns), ny(rows), stride(std::size_t(columns) + 2 * kPad) {}
  std::size_t index(int row, int column) const {
    return std::size_t(row + kPad) * stride + std::size_t(column + kPad);
  }
  std::size_t size() const { return stride * (std::size_t(ny) + 2 * kPad); }
};

/// Tiles that hold every cell which is not a sink, and the sinks beside them; each cut down to the
/// smallest rectangle. Open sea far from land is in no tile.
template <class Real>
std::vector<Tile> make_tiles(const PaddedShape& shape, const Real* code);

}  // namespace orogen::pipes
