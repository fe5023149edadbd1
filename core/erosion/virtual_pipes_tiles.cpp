#include "erosion/virtual_pipes_tiles.h"

#include <algorithm>

namespace orogen::pipes {

namespace {

template <class Real>
bool is_sink(Real code) {
  return code == Real(kSink);
}

template <class Real>
bool beside_ground(const Real* code, std::size_t i, std::size_t stride) {
  for (const Real* row : {code + i - stride, code + i, code + i + stride})
    for (int c = -1; c <= 1; ++c)
      if (row[c] > Real(kSink)) return true;
  return false;
}

template <class Real>
Tile shrink(const PaddedShape& shape, const Real* code, const Tile& whole) {
  Tile tile{whole.row1, whole.row0, whole.column1, whole.column0, {}, {}};
  for (int r = whole.row0; r < whole.row1; ++r) {
    for (int c = whole.column0; c < whole.column1; ++c) {
      const std::size_t i = shape.index(r, c);
      const bool sink = is_sink(code[i]);
      if (sink && !beside_ground(code, i, shape.stride)) continue;
      tile.row0 = std::min(tile.row0, r);
      tile.row1 = std::max(tile.row1, r + 1);
      tile.column0 = std::min(tile.column0, c);
      tile.column1 = std::max(tile.column1, c + 1);
      if (sink) tile.sinks.push_back(i);
    }
  }
  return tile;
}

}  // namespace

template <class Real>
std::vector<Tile> make_tiles(const PaddedShape& shape, const Real* code) {
  const int rows = (shape.ny + kTileRows - 1) / kTileRows;
  const int columns = (shape.nx + kTileColumns - 1) / kTileColumns;
  std::vector<Tile> tiles;
  std::vector<int> number(std::size_t(rows) * columns, -1);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const Tile whole{r * kTileRows,
                       std::min(shape.ny, (r + 1) * kTileRows),
                       c * kTileColumns,
                       std::min(shape.nx, (c + 1) * kTileColumns),
                       {},
                       {}};
      Tile tile = shrink(shape, code, whole);
      if (tile.row0 >= tile.row1) continue;
      number[std::size_t(r) * columns + c] = int(tiles.size());
      tiles.push_back(std::move(tile));
    }
  }
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int tile = number[std::size_t(r) * columns + c];
      if (tile < 0) continue;
      for (int a = std::max(0, r - 1); a <= std::min(rows - 1, r + 1); ++a)
        for (int b = std::max(0, c - 1); b <= std::min(columns - 1, c + 1); ++b)
          if (const int other = number[std::size_t(a) * columns + b]; other >= 0)
            tiles[tile].around.push_back(other);
    }
  return tiles;
}

template std::vector<Tile> make_tiles(const PaddedShape&, const float*);
template std::vector<Tile> make_tiles(const PaddedShape&, const double*);

}  // namespace orogen::pipes
