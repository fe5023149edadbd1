// SHA-256 (FIPS 180-4), for keys of the cache and the recipe's hash.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace orogen {

/// 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace orogen
