// Vector maps as GeoJSON (RFC 7946).
//
// Positions are longitude and latitude (WGS84) unless the collection's member `units` says "km" or
// "m": then they are planar, from the lower-left corner of the member `frame` {proj4, origin_m,
// size_km}. Longitude and latitude are projected on reading, by `frame.proj4` or else azimuthal
// equidistant about the map's centre. A VectorMap holds metres in the projection.
//
// Features: `kind` coast (Polygon, or lines that close), lake (Polygon), river (LineString), peak
// (Point), their Multi forms and GeometryCollection. Properties: `name`; peak: `height_m`,
// `volcano`; river: `ends` (sea, river, lake, frame), `end_height_m`, `rank`, `direction` ("source
// to mouth"); coast: `clipped`; lake: `level_m`. Without `kind` the geometry decides, with a
// warning; unknown kinds are left out with a warning.
//
// Maps may lie across the antimeridian. A coast that was cut in two there is not put together
// again: its halves touch, and are refused.
//
// Text is limited to 512 MiB, 64 levels, 10⁷ positions. Every refusal is an InputError that names
// a feature, a member or an offset.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "inputs/check_map.h"
#include "inputs/vector_map.h"

namespace orogen {

VectorMap read_geojson(std::string_view text, const ReadOptions& options = {});
VectorMap read_geojson_file(const std::filesystem::path& path, const ReadOptions& options = {});

/// Planar GeoJSON in metres, with its frame: read_geojson gives the same map again.
std::string write_geojson(const VectorMap& map);

}  // namespace orogen
