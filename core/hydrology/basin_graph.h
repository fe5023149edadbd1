// Closed basins joined to base level over their lowest passes.
//
// Basins are the nodes of a graph, passes its edges; basin 0 is what drains already. A minimum
// spanning tree by the height of the passes (Boruvka's algorithm) leads water from every basin to
// basin 0 over no higher pass than it must (Cordonnier, Bovy and Braun 2019,
// doi:10.5194/esurf-7-549-2019). Of passes with equal keys the one given first is the lower: one
// order for all, so that there is one tree.
// Cost: O(p log b) for b basins with p passes. Buffers are kept between calls.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace orogen {

/// A crossing between two basins.
struct BasinPass {
  std::uint64_t key;       // rises with the height
  std::int32_t basins[2];  // numbers
  std::int32_t cells[2];   // side by side, one in each basin
};

/// Where a basin's water leaves it over the tree.
struct BasinOutlet {
  std::int32_t from;  // cell in the basin
  std::int32_t to;    // cell beside it, in the basin that receives
};

class BasinGraph {
 public:
  std::vector<BasinPass> passes;  // to be filled in; used up by `join`

  /// One outlet for each basin but 0 that passes connect to it. `labels`: the basin of each cell.
  std::span<const BasinOutlet> join(std::size_t basins, std::span<const std::int32_t> labels);

 private:
  void span_tree(std::size_t basins);
  void drain(std::size_t basins, std::span<const std::int32_t> labels);

  std::vector<BasinPass> tree_;
  std::vector<std::uint64_t> lowest_key_;  // of a basin's passes
  std::vector<std::int32_t> lowest_, merged_, edge_begin_, edges_, queue_;
  std::vector<std::uint8_t> reached_;
  std::vector<BasinOutlet> outlets_;
};

/// A float's bits, so that unsigned order is the order of values.
inline std::uint32_t rising_bits(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value + 0.0f);
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}
inline std::uint64_t rising_bits(double value) {
  constexpr std::uint64_t sign = 1ull << 63;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(value + 0.0);
  return bits & sign ? ~bits : bits | sign;
}

}  // namespace orogen
