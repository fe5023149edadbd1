#include "tectonics/felt_compression.h"

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "tectonics/smoothed_compression.h"

namespace orogen {

namespace {

constexpr float kUplifted = 0.01f;  // of the greatest uplift
constexpr double kLeastMean = 1e-3;

}  // namespace

CompressionField felt_compression(const TransportField& transport, CompressionField field,
                                  const Raster<float>& convergence, double smoothing,
                                  const Context& context) {
  const Grid& grid = field.crust.grid();
  if (convergence.grid() != grid) throw InputError("convergence: must lie on the field's grid");
  parallel_rows(context, grid.ny, [&](int r) {
    for (std::size_t i = grid.index(r, 0); i < grid.index(r, 0) + grid.nx; ++i) {
      const int plate = field.plate[i];
      const bool oceanic = plate >= 0 && transport.plates()[plate].crust == PlateCrust::Oceanic;
      const float felt = oceanic ? 0.0f : convergence[i];
      field.compression_x[i] *= felt;
      field.compression_y[i] *= felt;
    }
  });
  return smoothed_compression(field, smoothing, context);
}

double mean_compression(const CompressionField& field, const Raster<float>& uplift_rate,
                        const Context& context) {
  const auto rates = uplift_rate.values();
  if (rates.empty()) return 1.0;
  const float least = kUplifted * *std::max_element(rates.begin(), rates.end());
  const double sum = parallel_sum(context, rates.size(), [&](std::size_t i) {
    return rates[i] > least ? std::hypot(field.compression_x[i], field.compression_y[i]) : 0.0;
  });
  const double count = parallel_sum(context, rates.size(),
                                    [&](std::size_t i) { return rates[i] > least ? 1.0 : 0.0; });
  return count > 0.0 ? std::max(sum / count, kLeastMean) : 1.0;
}

}  // namespace orogen
