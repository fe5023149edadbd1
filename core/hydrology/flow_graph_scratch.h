// What FlowGraph keeps between calls only to save allocations. Private to flow_graph*.cpp.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "hydrology/basin_graph.h"
#include "hydrology/flow_graph.h"

namespace orogen {

inline constexpr int kColumnStep[8] = {1, 1, 0, -1, -1, -1, 0, 1};
inline constexpr int kRowStep[8] = {0, 1, 1, 1, 0, -1, -1, -1};

struct FlowGraph::Scratch {
  std::vector<std::array<std::int32_t, 8>> donor_steps;  // index steps to the donors of each mask
  std::vector<float> outside_row;                        // +infinity
  std::vector<std::uint8_t> outside_direction;
  std::vector<std::int32_t> pits;
  std::vector<std::int32_t> labels;  // 1 + number of the pit a cell drains to; 0 between calls
  std::vector<std::vector<std::int32_t>> basin_cells;  // by task
  std::vector<std::vector<BasinPass>> row_passes;      // by task
  BasinGraph basins;
  std::vector<std::int32_t> heads, next_heads, queues;
  std::vector<std::uint16_t> queue_parents;
  std::vector<std::int32_t> queue_placed, queue_length;

  /// Appends the donors that `mask` names to a queue with room for 8 more.
  void append_donors(std::int32_t cell, std::uint8_t mask, std::int32_t* queue,
                     std::int32_t& length) const {
    const auto& steps = donor_steps[mask];
    for (int k = 0; k < 8; ++k) queue[length + k] = cell + steps[k];
    length += std::popcount(mask);
  }
};

/// 32 random bits of a place and a seed.
inline std::uint32_t hash_place(std::uint32_t row_key, std::uint32_t column) {
  std::uint32_t x = (column * 0x9e3779b1u) ^ row_key;
  x ^= x >> 15;
  x *= 0x85ebca77u;
  x ^= x >> 13;
  x *= 0xc2b2ae3du;
  return x ^ (x >> 16);
}

inline bool FlowGraph::has_neighbor(std::int32_t cell, int k) const {
  const std::int32_t row = cell / grid_.nx, column = cell - row * grid_.nx;
  return grid_.contains(row + kRowStep[k], column + kColumnStep[k]);
}

}  // namespace orogen
