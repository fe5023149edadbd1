// A recipe's rasters, from JSON and to it.
//
//   "rasters": {"uplift_factor": [[1, 2], [1, 1]],                    rows from the south
//               "elevation": {"rows": 512, "columns": 512, "float32": "base64 of little-endian"}}
//
// Names, units and what is allowed: inputs/given_raster.h. What a document holds of a raster is
// kept in the second form.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "inputs/given_raster.h"
#include "pipeline/strict_json.h"

namespace orogen {

using GivenRasters = std::map<std::string, std::shared_ptr<const GivenRaster>, std::less<>>;

/// InputError for an unknown name, a shape that is none, a value that is not allowed.
GivenRasters read_rasters(const JsonValue& rasters);
nlohmann::json write_raster(const GivenRaster& raster);

}  // namespace orogen
