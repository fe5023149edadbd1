// Any bytes at all as a map: read, or refused with an InputError; what is read can be written and
// read again.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "foundation/errors.h"
#include "inputs/geojson.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  orogen::VectorMap map;
  try {
    map = orogen::read_geojson({reinterpret_cast<const char*>(data), size});
  } catch (const orogen::InputError&) {
    return 0;
  }
  try {
    (void)orogen::read_geojson(orogen::write_geojson(map));
  } catch (const orogen::InputError&) {
    std::abort();
  }
  return 0;
}
