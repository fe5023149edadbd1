// Compression fields for tests of folds.
#pragma once

#include <cmath>
#include <cstdint>

#include "foundation/random.h"
#include "tectonics/compression.h"

namespace orogen::test {

/// direction(p) at each cell centre.
template <class Direction>
CompressionField field_of(const Grid& grid, Direction&& direction) {
  CompressionField field;
  field.compression_x = Raster<float>(grid);
  field.compression_y = Raster<float>(grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      const glm::dvec2 v = direction(grid.center(r, c));
      field.compression_x(r, c) = float(v.x);
      field.compression_y(r, c) = float(v.y);
    }
  return field;
}

inline CompressionField uniform_field(const Grid& grid, double angle, double strength = 0.3) {
  return field_of(
      grid, [&](glm::dvec2) { return strength * glm::dvec2(std::cos(angle), std::sin(angle)); });
}

/// A belt across the middle third of the grid, as between two plates that meet; 0 beyond.
inline CompressionField belt_field(const Grid& grid, double strength = 0.3) {
  return field_of(grid, [&](glm::dvec2 p) {
    const glm::dvec2 q = p - grid.origin;
    const double u = (q.x / grid.width() - 0.5) * 6.0;
    const double turn = 0.5 * std::sin(6.0 * q.y / grid.height());
    const double fade = std::fmax(0.0, 1.0 - u * u);
    return strength * fade * glm::dvec2(std::cos(turn), std::sin(turn));
  });
}

/// Waves of random direction and strength, with places that are not compressed; the sign of C,
/// which means nothing, is random.
inline CompressionField random_field(const Grid& grid, std::uint64_t seed) {
  const auto number = [&](int i) { return random_uniform(seed, 0x74657374, i); };
  const double kx = 9.0 * number(0), ky = 9.0 * number(1), turn = 6.0 * number(2);
  const double bare = 0.8 * number(3), start = 6.3 * number(4);
  return field_of(grid, [&](glm::dvec2 p) {
    const glm::dvec2 q = (p - grid.origin) / std::fmax(grid.width(), grid.height());
    const double angle = start + turn * std::sin(kx * q.x + 1.0) * std::cos(ky * q.y);
    const double wave = 0.5 + 0.5 * std::sin(ky * q.x - kx * q.y + start);
    const double sign = random_bits(seed, grid.row_of(p.y), grid.column_of(p.x)) & 1 ? 1.0 : -1.0;
    return sign * std::fmax(0.0, wave - bare) * glm::dvec2(std::cos(angle), std::sin(angle));
  });
}

}  // namespace orogen::test
