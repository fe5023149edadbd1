#include "island/island_relief.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "foundation/bilinear.h"
#include "foundation/distance_transform.h"
#include "foundation/noise.h"
#include "foundation/parallel.h"
#include "foundation/tin_sampling.h"
#include "hydrology/sea.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 65536;
constexpr double kBend = 4.0;  // polygons: wavelength of their sides' bends
constexpr int kBendOctaves = 4;
constexpr double kLakeSlope = 0.1;  // of lakes' beds
constexpr double kRim = 3.0;        // polygons: how far from the sides noise may raise no land
constexpr double kTurnedUp = 1e-3;  // height of what is turned up, of its depth

/// What the polygon map says, cell by cell of a grid.
struct Drawn {
  Raster<float> height, temperature, moisture, amplitude, roughness;
  Raster<std::int32_t> center;
};

/// Centers, then corners; a triangle's first vertex is its center.
Tin triangles_of(const PolygonMap& map) {
  Tin tin{.domain = {map.low, map.high - map.low}, .points = map.centers};
  tin.points.insert(tin.points.end(), map.corners.begin(), map.corners.end());
  const std::int32_t centers = std::int32_t(map.centers.size());
  for (std::int32_t c = 0; c < centers; ++c) {
    const auto ring = map.center_corners.of(c);
    for (std::size_t i = 0; i < ring.size(); ++i)
      tin.triangles.push_back({c, centers + ring[i], centers + ring[(i + 1) % ring.size()]});
  }
  return tin;
}

/// A value of biomes: centers have their own, corners the mean of what they touch.
template <class Value>
std::vector<double> of_biomes(const Island& island, Value&& value) {
  std::vector<double> all;
  for (const Biome biome : island.biomes) all.push_back(value(info(biome)));
  for (std::int32_t v = 0; v < std::int32_t(island.map.corners.size()); ++v) {
    const auto touched = island.map.corner_centers.of(v);
    double sum = 0.0;
    for (const std::int32_t c : touched) sum += all[c];
    all.push_back(sum / double(touched.size()));
  }
  return all;
}

Drawn draw(const Island& island, const Grid& grid, const Context& context) {
  const Tin tin = triangles_of(island.map);
  const auto both = [&](const std::vector<float>& centers, const std::vector<float>& corners) {
    std::vector<double> all(centers.begin(), centers.end());
    all.insert(all.end(), corners.begin(), corners.end());
    return sample_to_grid(tin, all, grid, context);
  };
  const IslandValues &a = island.centers, &b = island.corners;
  Drawn drawn{
      both(a.elevation, b.elevation),
      both(a.temperature, b.temperature),
      both(a.moisture, b.moisture),
      sample_to_grid(tin, of_biomes(island, [](auto& i) { return i.amplitude; }), grid, context),
      sample_to_grid(tin, of_biomes(island, [](auto& i) { return i.roughness; }), grid, context),
      triangles_on(tin, grid, context)};
  for (std::int32_t& label : drawn.center.values()) label = tin.triangles[std::max(label, 0)][0];
  return drawn;
}

/// Every cell takes what lies an offset away; the offset is noise.
Drawn bend(const Drawn& drawn, double polygon, double perturbation, std::uint32_t seed,
           const Context& context) {
  const Grid& grid = drawn.height.grid();
  const auto offset = [&](std::uint32_t which) {
    const FbmParameters noise{
        .seed = seed + which, .wavelength = kBend * polygon, .octaves = kBendOctaves};
    return fbm(noise, grid, context);
  };
  const Raster<float> east = offset(1), north = offset(2);
  const double reach = 0.5 * perturbation * polygon;  // of a standard deviation
  Drawn bent = drawn;
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const std::size_t i = grid.index(r, c);
      const glm::dvec2 from = grid.center(r, c) + reach * glm::dvec2(east[i], north[i]);
      const Bilinear at = bilinear_at(grid, from);
      bent.height[i] = float(at(drawn.height));
      bent.temperature[i] = float(at(drawn.temperature));
      bent.moisture[i] = float(at(drawn.moisture));
      bent.amplitude[i] = float(at(drawn.amplitude));
      bent.roughness[i] = float(at(drawn.roughness));
      bent.center[i] = drawn.center(at.v < 0.5 ? at.r0 : at.r1, at.u < 0.5 ? at.c0 : at.c1);
    }
  });
  return bent;
}

/// Eq. 4 without A.
Raster<float> multifractal(const Raster<float>& roughness, const IslandReliefParameters& parameters,
                           std::uint32_t seed, const Context& context) {
  const Grid& grid = roughness.grid();
  Raster<float> sum(grid), gain(grid, 1.0f);
  double wavelength = 0.5 * std::fmax(grid.width(), grid.height()) / parameters.relief_frequency;
  for (int k = 0; k < parameters.relief_octaves; ++k, wavelength *= 0.5) {
    const Raster<float> octave = fbm(
        {.seed = seed + std::uint32_t(k), .wavelength = wavelength, .octaves = 1}, grid, context);
    parallel_chunks(context, grid.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        sum[i] += float(kPerlinDeviation) * gain[i] * octave[i];
        gain[i] *= std::exp2(roughness[i] - 1.0f);
      }
    });
  }
  return sum;
}

/// From 0 to 1, level at both.
float eased(double t) {
  const float near = std::min(float(t), 1.0f);
  return near * near * (3.0f - 2.0f * near);
}

/// Distance of a cell to the nearest side of the grid, in m.
double to_side(const Grid& grid, std::size_t i) {
  const int r = int(i / grid.nx), c = int(i % grid.nx);
  return grid.cell_size * std::min(std::min(r, grid.ny - 1 - r), std::min(c, grid.nx - 1 - c));
}

Raster<std::uint8_t> mask(const Raster<std::int32_t>& labels, auto&& is) {
  Raster<std::uint8_t> result(labels.grid());
  for (std::size_t i = 0; i < labels.size(); ++i) result[i] = is(labels[i]);
  return result;
}

float largest(const Raster<float>& values, float sign, const Context& context) {
  return parallel_reduce(
      context, values.size(), kGrain, 0.0f,
      [&](std::size_t begin, std::size_t end) {
        float most = 0.0f;
        for (std::size_t i = begin; i < end; ++i) most = std::max(most, sign * values[i]);
        return most;
      },
      [](float a, float b) { return std::max(a, b); });
}

}  // namespace

IslandRelief island_relief(const Island& island, const IslandReliefParameters& parameters,
                           const Grid& grid, std::uint32_t seed, const Context& context) {
  check_parameters(parameters);
  const glm::dvec2 size = island.map.high - island.map.low;
  const double polygon = std::sqrt(size.x * size.y / double(island.map.centers.size()));
  Drawn drawn = bend(draw(island, grid, context), polygon, parameters.perturbation, seed, context);
  Raster<float>& height = drawn.height;
  const auto is = [&](Biome biome) {
    return mask(drawn.center, [&](std::int32_t c) { return island.biomes[c] == biome; });
  };
  const Raster<std::uint8_t> lake = is(Biome::Lake);
  const Raster<float> to_lake = distance_transform(lake, context);
  const Raster<float> to_shore = distance_transform(
      mask(drawn.center, [&](std::int32_t c) { return island.biomes[c] != Biome::Lake; }), context);
  const Raster<std::uint8_t> ocean = is(Biome::Ocean);
  const Raster<float> noise = multifractal(drawn.roughness, parameters, seed + 16, context);
  const float power = float(parameters.height_exponent), strength = float(parameters.relief);
  parallel_chunks(context, grid.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float h = lake[i] ? island.centers.elevation[drawn.center[i]] : height[i];
      const float raised = std::copysign(std::pow(std::fabs(h), power), h);
      float share = eased(to_lake[i] / polygon);
      if (ocean[i] && noise[i] > 0.0f) share *= eased(to_side(grid, i) / (kRim * polygon));
      height[i] = raised + strength * drawn.amplitude[i] * noise[i] * share;
    }
  });
  IslandRelief made;
  made.water_depth = Raster<float>(grid);
  made.biome = Raster<std::int32_t>(grid);
  made.land = land_beside_sea(height, ocean);
  const float up = float(parameters.peak_height) / std::max(largest(height, 1.0f, context), 1e-9f);
  const float down = float(parameters.sea_depth) / std::max(largest(height, -1.0f, context), 1e-9f);
  parallel_chunks(context, grid.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float h = height[i] > 0.0f ? up * height[i] : down * height[i];
      if (made.land[i] && h <= 0.0f) h = std::max(float(kTurnedUp) * -h, 1e-3f);
      if (lake[i])
        made.water_depth[i] = float(std::min(parameters.lake_depth, kLakeSlope * to_shore[i]));
      height[i] = h - made.water_depth[i];
      made.biome[i] = std::int32_t(island.biomes[drawn.center[i]]);
    }
  });
  made.elevation = std::move(height);
  made.temperature = std::move(drawn.temperature);
  made.moisture = std::move(drawn.moisture);
  return made;
}

}  // namespace orogen
