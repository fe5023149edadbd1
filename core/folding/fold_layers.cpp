#include "folding/fold_layers.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>

#include "folding/fold_relief.h"
#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {

namespace {

constexpr std::uint64_t kStream = 0x6c617965;

std::string place_of(std::size_t layer) {
  return "fold_layers[" + std::to_string(layer) + "]";
}

FoldWavelength wavelength_of(const FoldLayer& layer, std::size_t number) {
  check_parameters(layer, place_of(number));
  check_fold_edits(layer.edits, place_of(number));
  if (!layer.wavelength_map) return FoldWavelength(layer.fold_wavelength);
  try {
    return FoldWavelength(*layer.wavelength_map);
  } catch (const InputError& error) {
    throw InputError(place_of(number) + "." + error.what());
  }
}

FoldedLayer fold_layer(const CompressionField& field, const FoldLayer& layer,
                       const FoldWavelength& wavelength, const FoldLayersParameters& parameters,
                       std::uint32_t seed, const Context& context) {
  FoldedLayer result;
  result.skeleton = fold_skeleton(field, wavelength, layer.edits, seed, context);
  result.speed = crest_speed(field, layer.speed_share * parameters.uplift_rate, context);
  const auto unmoved = edit_heights(result.skeleton.mesh, wavelength, result.skeleton.choice,
                                    layer.edits, parameters.folding_time, result.speed, context);
  shape_folds(result.skeleton, result.speed, kCreaseRounding * wavelength.lowest(), context);
  const auto& unchosen = result.skeleton.edits_without_effect;
  std::merge(unchosen.begin(), unchosen.end(), unmoved.begin(), unmoved.end(),
             std::back_inserter(result.edits_without_effect));
  return result;
}

}  // namespace

std::vector<FoldedLayer> fold_layers(const CompressionField& field,
                                     std::span<const FoldLayer> layers,
                                     const FoldLayersParameters& parameters, std::uint32_t seed,
                                     const Context& context) {
  check_parameters(parameters, "fold_layers");
  std::vector<FoldWavelength> wavelengths;
  for (std::size_t i = 0; i < layers.size(); ++i)
    wavelengths.push_back(wavelength_of(layers[i], i));
  std::vector<FoldedLayer> result(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (wavelengths[i].highest() < parameters.shortest_wavelength) {
      result[i].speed = Raster<float>(field.compression_x.grid());
      continue;
    }
    const auto layer_seed = std::uint32_t(random_bits(seed, kStream, i));
    result[i] = fold_layer(field, layers[i], wavelengths[i], parameters, layer_seed, context);
  }
  return result;
}

}  // namespace orogen
