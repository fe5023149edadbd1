// A hundred terrains with every odd shape and surface, for properties that hold for all.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "foundation/random.h"
#include "foundation/raster.h"

namespace orogen {

struct RandomTerrain {
  int number;
  Raster<float> elevation;
  Raster<std::uint8_t> base;
};

inline Grid random_grid(int number) {
  const auto pick = [&](std::uint64_t what, int count) {
    return int(random_uniform(std::uint64_t(number), 900, what) * count);
  };
  constexpr int sizes[] = {1, 2, 3, 5, 7, 13, 31, 64, 97, 130};
  const int nx = sizes[pick(0, 10)], ny = nx == 1 ? sizes[1 + pick(1, 9)] : sizes[pick(1, 10)];
  const double cell = 0.5 + 100.0 * random_uniform(std::uint64_t(number), 900, 2);
  return {nx, ny, cell, {3.0, -7.0}};
}

inline RandomTerrain random_terrain(int number, const Grid& grid) {
  const int nx = grid.nx, ny = grid.ny;
  Raster<float> z(grid);
  Raster<std::uint8_t> base(grid);
  const int surface = number % 8;
  for (int r = 0; r < ny; ++r)
    for (int c = 0; c < nx; ++c) {
      const std::size_t i = grid.index(r, c);
      const double u = random_uniform(std::uint64_t(number), 901, i);
      switch (surface) {
        case 0:
          z[i] = float(u);
          break;  // noise
        case 1:
          z[i] = 5.0f;
          break;  // flat
        case 2:
          z[i] = float((r + c) % 2);
          break;  // checkerboard
        case 3:
          z[i] = u < 0.02 ? 1000.0f : u > 0.98 ? -1000.0f : 1.0f;
          break;  // spikes
        case 4:
          z[i] = float(std::floor(4.0 * u));
          break;  // terraces of noise
        case 5:
          z[i] = float(r) + 0.5f * float(c);
          break;  // plane
        case 6:
          z[i] = float(std::hypot(r - ny / 2.0, c - nx / 2.0));
          break;  // bowl
        default:
          z[i] = float(std::floor(3.0 * std::sin(r * 0.3) * std::cos(c * 0.2)));
      }
    }
  const int shore = int(random_bits(std::uint64_t(number), 900, 3) % 4);
  for (std::size_t i = 0; i < base.size(); ++i) {
    const int r = int(i) / nx, c = int(i) % nx;
    const bool side = r == 0 || c == 0 || r == ny - 1 || c == nx - 1;
    if (shore == 0) base[i] = side;
    if (shore == 1) base[i] = r == 0;
    if (shore == 2) base[i] = random_uniform(std::uint64_t(number), 902, i) < 0.05;
  }
  base[random_bits(std::uint64_t(number), 900, 4) % base.size()] = 1;
  return {number, z, base};
}

inline RandomTerrain random_terrain(int number) {
  return random_terrain(number, random_grid(number));
}

}  // namespace orogen
