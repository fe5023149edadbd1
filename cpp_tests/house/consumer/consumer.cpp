// A program outside the tree that uses the installed library: an island from a map of one peak.
#include <algorithm>
#include <cstdio>

#include "pipeline/pipeline.h"

constexpr const char* kMap = R"({
  "type": "FeatureCollection", "units": "km", "frame": {"size_km": [40, 30]},
  "features": [
    {"type": "Feature", "properties": {"kind": "coast"},
     "geometry": {"type": "Polygon", "coordinates": [[[5, 5], [35, 6], [33, 25], [8, 24], [5, 5]]]}},
    {"type": "Feature", "properties": {"kind": "peak", "height_m": 900},
     "geometry": {"type": "Point", "coordinates": [20, 15]}}]})";

int main() {
  orogen::Context context;
  const orogen::Recipe recipe = orogen::read_recipe(kMap);
  const orogen::Generated made = orogen::generate(recipe, {.resolution = 64}, context);
  const auto& elevation = made.terrain.real("elevation");
  const float* values = elevation.data();
  const float highest = *std::max_element(values, values + elevation.size());
  std::printf("%.1f m\n", highest);
  return highest > 800.0f && highest < 1000.0f ? 0 : 1;
}
