// Place along Hilbert's curve: points that lie near each other get numbers near each other, so that
// fields over scattered points stay in cache.
//
// Hilbert, D. (1891), doi:10.1007/BF01199431.
#pragma once

#include <cstdint>
#include <utility>

namespace orogen {

/// Number of the cell (x, y) of a square of 65536 x 65536 cells along the curve.
constexpr std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0;
  for (std::uint32_t side = 1u << 15; side > 0; side >>= 1) {
    const std::uint32_t right = x & side ? 1 : 0, upper = y & side ? 1 : 0;
    key = key << 2 | ((3 * right) ^ upper);
    if (upper) continue;
    if (right) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return key;
}

}  // namespace orogen
