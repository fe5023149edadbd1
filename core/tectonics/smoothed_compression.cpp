#include "tectonics/smoothed_compression.h"

#include <cmath>

#include "foundation/gaussian_blur.h"
#include "foundation/parallel.h"

namespace orogen {

CompressionField smoothed_compression(const CompressionField& field, double smoothing,
                                      const Context& context) {
  CompressionField result = field;
  if (smoothing == 0.0) return result;
  const Grid& grid = field.crust.grid();
  // With e₁ at the angle φ: trace |C|, and |C| cos 2φ and |C| sin 2φ, whose length is s₁ - s₂.
  Raster<float> cosine(grid), sine(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    for (std::size_t i = grid.index(r, 0); i < grid.index(r, 0) + grid.nx; ++i) {
      const float x = field.compression_x[i], y = field.compression_y[i];
      const float strength = std::sqrt(x * x + y * y);
      cosine[i] = strength > 0.0f ? (x * x - y * y) / strength : 0.0f;
      sine[i] = strength > 0.0f ? 2.0f * x * y / strength : 0.0f;
    }
  });
  cosine = gaussian_blur(cosine, smoothing, context);
  sine = gaussian_blur(sine, smoothing, context);
  parallel_rows(context, grid.ny, [&](int r) {
    for (std::size_t i = grid.index(r, 0); i < grid.index(r, 0) + grid.nx; ++i) {
      const double strength = std::hypot(cosine[i], sine[i]);
      const double angle = 0.5 * std::atan2(sine[i], cosine[i]);
      result.compression_x[i] = strength > 1e-9 ? float(strength * std::cos(angle)) : 0.0f;
      result.compression_y[i] = strength > 1e-9 ? float(strength * std::sin(angle)) : 0.0f;
    }
  });
  return result;
}

}  // namespace orogen
