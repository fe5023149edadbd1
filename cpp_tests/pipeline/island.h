// A small map with everything in it, and its recipe.
#pragma once

#include <string>

#include "pipeline/recipe.h"

namespace orogen {

inline std::string island_geojson() {
  return R"({"type": "FeatureCollection", "name": "island", "units": "km",
    "frame": {"proj4": "+proj=aeqd +lat_0=42 +lon_0=9 +datum=WGS84 +units=m +no_defs",
              "origin_m": [-20000, -15000], "size_km": [40, 30]},
    "features": [
      {"type": "Feature", "properties": {"kind": "coast"}, "geometry": {"type": "Polygon",
       "coordinates": [[[5, 4], [33, 3], [36, 17], [28, 27], [9, 26], [3, 15], [5, 4]]]}},
      {"type": "Feature", "properties": {"kind": "river", "name": "A"}, "geometry":
       {"type": "LineString", "coordinates": [[19, 16], [15, 12], [10, 9], [4.5, 8]]}},
      {"type": "Feature", "properties": {"kind": "peak", "height_m": 1500, "name": "P"},
       "geometry": {"type": "Point", "coordinates": [21, 18]}},
      {"type": "Feature", "properties": {"kind": "peak", "height_m": 1100},
       "geometry": {"type": "Point", "coordinates": [27, 15]}},
      {"type": "Feature", "properties": {"kind": "peak", "height_m": 900},
       "geometry": {"type": "Point", "coordinates": [14, 19]}},
      {"type": "Feature", "properties": {"kind": "peak", "height_m": 700},
       "geometry": {"type": "Point", "coordinates": [20, 9]}}
    ]})";
}

inline std::string island_document(const std::string& more = "") {
  return R"({"orogen": 1, "name": "island", "seed": 7, "resolution": 64, "map": )" +
         island_geojson() + more + "}";
}

/// Two plates that meet in the middle, and a column.
inline std::string collision_members() {
  return R"(, "column": {"preset": "alps"}, "phases": [{"years": 2e6, "plates": [
    {"name": "south", "points": [[-18000, -14000], [18000, -14000], [0, -9000]],
     "arrows": [[0, 3000], [0, 3000], [0, 3000]]},
    {"name": "north", "points": [[-18000, 13000], [18000, 13000]],
     "arrows": [[0, 0], [0, 0]], "stable": true}]}])";
}

/// Colliding plates without a map.
inline std::string collision_document(const std::string& more = "") {
  return R"({"orogen": 1, "name": "plates", "seed": 7, "resolution": 64,
    "extent": {"origin": [-20000, -15000], "size": [40000, 30000]})" +
         collision_members() + more + "}";
}

/// A recipe with every input that a stage may ask for.
inline Recipe whole_recipe() {
  const std::string rasters = R"(, "rasters": {"elevation": [[-50, 400], [300, 600]],
    "kept": [[1, 0]], "kept_elevation": [[100]]})";
  return read_recipe(island_document(collision_members() + rasters));
}

inline Recipe island_recipe() {
  return read_recipe(island_document());
}

}  // namespace orogen
