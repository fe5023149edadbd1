// Counter-based random numbers: a value is a pure function of (seed, stream, counter), so that the
// order in which threads ask does not matter.
//
// The generator is a keyed 64-bit mix (two rounds of SplitMix64's finaliser, Steele et al. 2014).
// Not for cryptography.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace orogen {

constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// 64 random bits.
constexpr std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream,
                                    std::uint64_t counter) {
  return mix64(mix64(seed ^ mix64(stream)) + counter);
}

/// Uniform in [0, 1).
constexpr double random_uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
  return double(random_bits(seed, stream, counter) >> 11) * 0x1.0p-53;
}

/// Normal with mean 0 and standard deviation 1 (Box-Muller; two counters' bits).
inline double random_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
  const double u = random_uniform(seed, stream, 2 * counter);
  const double v = random_uniform(seed, stream, 2 * counter + 1);
  return std::sqrt(-2.0 * std::log1p(-u)) * std::cos(2.0 * std::numbers::pi * v);
}

}  // namespace orogen
