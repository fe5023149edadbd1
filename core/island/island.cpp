#include "island/island.h"

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"
#include "island/island_steps.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 4096;

/// Eq. 2 at places across the rectangle.
class Shape {
 public:
  Shape(const IslandParameters& p, glm::dvec2 low, glm::dvec2 high, std::uint32_t seed)
      : middle_(0.5 * (low + high)), half_(0.5 / p.window * (high - low)), parameters_(p) {
    noise_ = {.seed = seed,
              .wavelength = 1.0 / p.base_octave,
              .octaves = p.octaves,
              .lacunarity = p.octave_scale,
              .gain = 1.0 / p.amplitude_scale};
    double energy = 0.0;
    for (int i = 0; i < p.octaves; ++i) energy += std::pow(p.amplitude_scale, -2.0 * i);
    amplitude_ = kPerlinDeviation * p.base_amplitude * std::sqrt(energy);
  }
  double operator()(glm::dvec2 place) const {
    const glm::dvec2 p = (place - middle_) / half_;
    return amplitude_ * fbm(noise_, p.x, p.y) - parameters_.offset -
           parameters_.distance_scale * (p.x * p.x + p.y * p.y);
  }

 private:
  glm::dvec2 middle_, half_;
  const IslandParameters& parameters_;
  FbmParameters noise_;
  double amplitude_ = 0.0;
};

void shape_corners(Island& island, const Shape& shape, const IslandInputs& inputs,
                   const Context& context) {
  island.corners.water.resize(island.map.corners.size());
  parallel_chunks(context, island.map.corners.size(), kGrain,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t v = begin; v < end; ++v) {
                      const glm::dvec2 p = island.map.corners[v];
                      const bool land = inputs.is_land ? inputs.is_land(p) : shape(p) >= 0.0;
                      island.corners.water[v] = !land;
                    }
                  });
}

bool has_land(const Island& island) {
  return std::ranges::count(island.centers.ocean, 0) > 0;
}

void edit_heights(Island& island, const IslandParameters& parameters, const IslandInputs& inputs) {
  if (!inputs.elevation) return;
  for (std::size_t v = 0; v < island.map.corners.size(); ++v) {
    float& height = island.corners.elevation[v];
    const float before = height;
    height = float(std::clamp(height + inputs.elevation(island.map.corners[v]), -1.0, 1.0));
    if ((before > 0.0f) != (height > 0.0f)) island.corners.water[v] = height <= 0.0f;
  }
  mark_water(island, parameters.water_share, !inputs.is_land);
}

void add_change(const Island& island, std::vector<float>& values,
                const std::function<double(glm::dvec2)>& change) {
  if (!change) return;
  for (std::size_t v = 0; v < values.size(); ++v)
    values[v] = float(std::clamp(values[v] + change(island.map.corners[v]), 0.0, 1.0));
}

/// Centers have the mean of their corners.
void average(const Island& island, const std::vector<float>& corners, std::vector<float>& centers) {
  centers.resize(island.map.centers.size());
  for (std::int32_t c = 0; c < std::int32_t(centers.size()); ++c) {
    const auto ring = island.map.center_corners.of(c);
    double sum = 0.0;
    for (const std::int32_t v : ring) sum += corners[v];
    centers[c] = float(sum / double(ring.size()));
  }
}

bool by_the_sea(const Island& island, std::int32_t center) {
  return std::ranges::any_of(island.map.center_edges.of(center), [&](std::int32_t edge) {
    const std::int32_t other = island.map.beyond(edge, center);
    return other >= 0 && island.centers.ocean[other];
  });
}

void settle_biomes(Island& island) {
  const IslandValues& centers = island.centers;
  for (std::int32_t c = 0; c < std::int32_t(island.map.centers.size()); ++c) {
    const Biome dry = biome_of(centers.temperature[c], centers.moisture[c]);
    island.biomes.push_back(centers.ocean[c]        ? Biome::Ocean
                            : centers.water[c]      ? Biome::Lake
                            : by_the_sea(island, c) ? Biome::Beach
                                                    : dry);
  }
}

}  // namespace

Island make_island(const IslandParameters& parameters, glm::dvec2 low, glm::dvec2 high,
                   std::uint32_t seed, const IslandInputs& inputs, const Context& context) {
  check_parameters(parameters);
  Island island;
  island.map =
      random_polygon_map(parameters.cells, parameters.relaxations, low, high, seed, context);
  shape_corners(island, Shape(parameters, low, high, seed), inputs, context);
  mark_water(island, parameters.water_share, !inputs.is_land);
  if (!has_land(island)) throw InputError("island: has no land; a lower offset makes it larger");
  raise_from_coast(island);
  edit_heights(island, parameters, inputs);
  level_lakes(island);
  const std::vector<std::int32_t> upwards = drain(island);
  start_rivers(island, parameters, seed, upwards);
  spread_moisture(island, parameters);
  for (const float height : island.corners.elevation)
    island.corners.temperature.push_back(1.0f - std::max(height, 0.0f));
  add_change(island, island.corners.temperature, inputs.temperature);
  add_change(island, island.corners.moisture, inputs.moisture);
  average(island, island.corners.elevation, island.centers.elevation);
  average(island, island.corners.temperature, island.centers.temperature);
  average(island, island.corners.moisture, island.centers.moisture);
  settle_biomes(island);
  return island;
}

double island_function(const IslandParameters& parameters, glm::dvec2 low, glm::dvec2 high,
                       std::uint32_t seed, glm::dvec2 place) {
  return Shape(parameters, low, high, seed)(place);
}

}  // namespace orogen
