#include "erosion/material_layers.h"

#include <cmath>
#include <string>

#include "foundation/errors.h"

namespace orogen {

void check_rock_layers(const std::vector<RockLayer>& layers, const Grid& grid) {
  if (layers.size() > 250)
    throw InputError("layers: " + std::to_string(layers.size()) + " are too many; 250 are allowed");
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const RockLayer& layer = layers[k];
    const std::string name = "layers[" + std::to_string(k) + "].";
    if (layer.thickness.grid() != grid)
      throw InputError(name + "thickness: its grid differs from the elevation's");
    if (!(layer.dissolution_rate >= 0.0 && layer.dissolution_rate <= 1e3))
      throw InputError(name + "dissolution_rate: " + std::to_string(layer.dissolution_rate) +
                       " is outside 0 to 1000 1/s");
    if (!(layer.talus_angle_deg >= 1.0 && layer.talus_angle_deg <= 90.0))
      throw InputError(name + "talus_angle_deg: " + std::to_string(layer.talus_angle_deg) +
                       " is outside 1 to 90 deg");
    for (std::size_t i = 0; i < layer.thickness.size(); ++i)
      if (!(layer.thickness[i] >= 0.0f && layer.thickness[i] <= 1e6f))
        throw InputError(name + "thickness: row " + std::to_string(i / grid.nx) + ", column " +
                         std::to_string(i % grid.nx) + " holds " +
                         std::to_string(layer.thickness[i]) + ", outside 0 to 1000000 m");
  }
}

}  // namespace orogen
