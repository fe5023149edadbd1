#include "pipeline/raster_inputs.h"

#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cmath>
#include <cstring>

#include "foundation/parameters.h"

namespace orogen {

namespace {

namespace iterators = boost::archive::iterators;

constexpr int kMostCells = 65536;  // along a side
static_assert(std::endian::native == std::endian::little);

std::string to_base64(std::string_view bytes) {
  using Digits = iterators::base64_from_binary<
      iterators::transform_width<std::string_view::const_iterator, 6, 8>>;
  std::string text(Digits(bytes.begin()), Digits(bytes.end()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

/// Text of a length that is a multiple of 4, of which the last characters may be '='.
std::string from_base64(const JsonValue& value) {
  using Bytes =
      iterators::transform_width<iterators::binary_from_base64<std::string_view::const_iterator>, 8,
                                 6>;
  const std::string text = value.text(std::size_t(1) << 33);
  if (text.size() % 4 != 0) value.refuse("is no base64");
  std::string_view digits = text;
  while (digits.ends_with('=') && text.size() - digits.size() < 2) digits.remove_suffix(1);
  try {
    // The last digit's spare bits would be read past the end: only whole bytes are taken.
    std::string bytes(digits.size() * 6 / 8, '\0');
    Bytes at(digits.begin());
    for (char& byte : bytes) byte = *at++;
    return bytes;
  } catch (const iterators::dataflow_exception&) {
    value.refuse("is no base64");
  }
}

GivenRaster read_packed(const JsonValue& packed) {
  packed.only_members({"rows", "columns", "float32"});
  GivenRaster raster;
  raster.rows = int(packed.member("rows").integer(1, kMostCells));
  raster.columns = int(packed.member("columns").integer(1, kMostCells));
  const std::string bytes = from_base64(packed.member("float32"));
  const std::size_t wanted = std::size_t(raster.rows) * raster.columns * sizeof(float);
  if (bytes.size() != wanted)
    packed.member("float32").refuse(std::to_string(bytes.size()) +
                                    " bytes, but rows x columns are " + std::to_string(wanted));
  raster.values.resize(wanted / sizeof(float));
  std::memcpy(raster.values.data(), bytes.data(), wanted);
  return raster;
}

void check_values(const GivenRaster& raster, const GivenRasterInfo& info, const JsonValue& place) {
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    const double value = raster.values[i];
    if (value >= float(info.least) && value <= float(info.most) &&
        !(info.whole && value != std::round(value)))
      continue;
    place.refuse("row " + std::to_string(i / raster.columns) + ", column " +
                 std::to_string(i % raster.columns) + ": " + detail::format_number(value) +
                 " is not allowed; " + detail::format_number(info.least) + " to " +
                 detail::format_number(info.most) + (info.unit == "1" ? "" : " m") +
                 (info.whole ? ", whole, is wanted" : " is wanted"));
  }
}

}  // namespace

GivenRasters read_rasters(const JsonValue& rasters) {
  if (!rasters.json().is_object()) rasters.refuse("an object is wanted");
  GivenRasters result;
  for (const auto& [name, value] : rasters.json().items()) {
    const GivenRasterInfo* info = find_given_raster(name);
    if (!info) {
      std::string names;
      for (const auto& known : known_given_rasters())
        names += (names.empty() ? "" : ", ") + std::string(known.name);
      rasters.refuse("there is no raster '" + name.substr(0, 60) + "'; there are " + names);
    }
    const JsonValue one{value, rasters.place() + "." + name};
    GivenRaster raster =
        value.is_array() ? read_rows<GivenRaster>(one, -1e30, 1e30) : read_packed(one);
    check_values(raster, *info, one);
    result[name] = std::make_shared<const GivenRaster>(std::move(raster));
  }
  return result;
}

nlohmann::json write_raster(const GivenRaster& raster) {
  const std::string_view bytes(reinterpret_cast<const char*>(raster.values.data()),
                               raster.values.size() * sizeof(float));
  return {{"rows", raster.rows}, {"columns", raster.columns}, {"float32", to_base64(bytes)}};
}

}  // namespace orogen
