// A hundred TINs with every odd size and surface, for properties that hold for all.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "foundation/random.h"
#include "foundation/tin.h"

namespace orogen {

struct RandomTin {
  Tin tin;
  std::vector<double> elevation;
  std::vector<std::uint8_t> base;
};

inline RandomTin random_tin(int number, const Context& context) {
  const auto uniform = [&](std::uint64_t what) {
    return random_uniform(std::uint64_t(number), 910, what);
  };
  const TinDomain domain{{3.0, -7.0}, {100.0 + 9900.0 * uniform(0), 100.0 + 9900.0 * uniform(1)}};
  const double spacing = std::sqrt(domain.area()) / std::pow(10.0, 1.8 * uniform(2) - 0.1);
  RandomTin t{
      (number % 2 ? poisson_tin : jittered_tin)(domain, spacing, std::uint32_t(number), context),
      {},
      {}};
  const std::size_t n = t.tin.size();
  t.elevation.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 p = t.tin.points[i] - domain.origin - 0.5 * domain.size;
    const double u = random_uniform(std::uint64_t(number), 911, i);
    double& z = t.elevation[i];
    switch (number / 2 % 8) {
      case 0:
        z = u;
        break;  // noise
      case 1:
        z = 5.0;
        break;  // flat
      case 2:
        z = double(i % 2);
        break;  // up and down
      case 3:
        z = u < 0.02 ? 1000.0 : u > 0.98 ? -1000.0 : 1.0;
        break;  // spikes
      case 4:
        z = std::floor(4.0 * u);
        break;  // terraces of noise
      case 5:
        z = p.x + 0.5 * p.y;
        break;  // plane
      case 6:
        z = std::hypot(p.x, p.y);
        break;  // bowl
      default:
        z = std::floor(3.0 * std::sin(p.x / (4 * spacing)) * std::cos(p.y / (5 * spacing)));
    }
  }
  const int shore = int(random_bits(std::uint64_t(number), 910, 3) % 4);
  t.base = side_mask(t.tin, shore == 0 ? 15u : shore == 1 ? 4u : 0u);
  if (shore == 2)
    for (std::size_t i = 0; i < n; ++i)
      t.base[i] = random_uniform(std::uint64_t(number), 912, i) < 0.05;
  t.base[random_bits(std::uint64_t(number), 910, 4) % n] = 1;
  return t;
}

}  // namespace orogen
