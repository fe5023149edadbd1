#include "sculpting/kept_region.h"

#include <algorithm>
#include <cstdint>

#include "foundation/distance_transform.h"
#include "foundation/parallel.h"

namespace orogen {

void keep_region(Raster<float>& elevation, const Raster<float>& kept,
                 const Raster<float>& kept_elevation, const KeptRegionParameters& parameters,
                 const Context& context) {
  check_parameters(parameters);
  Raster<std::uint8_t> inside(kept.grid());
  for (std::size_t i = 0; i < kept.size(); ++i) inside[i] = kept[i] >= 0.5f;
  const Raster<float> distance = distance_transform(inside, context);
  const float margin = std::max(float(parameters.margin), 1e-3f);
  parallel_chunks(context, kept.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (inside[i]) {
        elevation[i] = kept_elevation[i];
        continue;
      }
      const float t = std::min(distance[i] / margin, 1.0f);
      const float weight = 1.0f - t * t * (3.0f - 2.0f * t);
      if (weight > 0.0f) elevation[i] += weight * (kept_elevation[i] - elevation[i]);
    }
  });
}

}  // namespace orogen
