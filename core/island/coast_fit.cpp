#include "island/coast_fit.h"

#include <algorithm>

#include "foundation/distance_transform.h"
#include "foundation/parallel.h"

namespace orogen {

void fit_coast(Raster<float>& elevation, const Raster<std::uint8_t>& land, double reach,
               double least_slope, const Context& context) {
  Raster<std::uint8_t> sea(land.grid());
  for (std::size_t i = 0; i < sea.size(); ++i) sea[i] = !land[i];
  const Raster<float> from_land = distance_transform(land, context);
  const Raster<float> from_sea = distance_transform(sea, context);
  const float half_cell = float(0.5 * land.grid().cell_size);
  parallel_chunks(context, land.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float from_coast = (land[i] ? from_sea[i] : from_land[i]) - half_cell;
      const float near = std::min(from_coast / float(reach), 1.0f);
      const float faded = elevation[i] * near * near * (3.0f - 2.0f * near);
      const float least = float(least_slope) * from_coast;
      elevation[i] = land[i] ? std::max(faded, least) : std::min(faded, -least);
    }
  });
}

}  // namespace orogen
