// Horizons: the folded tops of a column's layers, and the rock between them (paper C, section 6.2).
//
// Horizon k is the top of layer k, horizon 0 that of the basement; h_{k-1} <= h_k everywhere.
// Before anything moves the top one lies at height 0 and each layer has its thickness. With uplift
// rates
//
//   v_0 = u_0,  v_k = v_{k-1} + u_k     (m/yr, u_k >= 0: folds of layer k)
//   h_k += v_k dt                        (paper C: h_k = h_{k-1} + u_k t)
//
// A point at height z belongs to the layer k with h_{k-1} < z <= h_k; 0 below the lowest horizon,
// n + 1 (loose sediment) above the highest. γ = (h_k - z) / (h_k - h_{k-1}) says how far below its
// top it lies, which gives the sub-layer; rock there rises at (1 - γ) v_k + γ v_{k-1}.
// (The paper lifts the surface by the sum of all u_k, also where those layers are gone; rock that
// is carried by what lies below it alone keeps horizons and surface consistent.)
//
// Limits: horizons are functions of the place: no overturned folds.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "foundation/bilinear.h"
#include "foundation/context.h"
#include "foundation/raster.h"
#include "strata/column.h"

namespace orogen {

/// Ground within this above the highest horizon still counts as its layer (rounding).
inline constexpr float kSedimentGap = 0.1f;  // m

/// A rock: layer 0 is the basement, n + 1 loose sediment.
struct Rock {
  int layer = 0;
  int sub_layer = 0;   // from the layer's bottom
  float gamma = 0.0f;  // share of the layer that lies above
};

/// What a column's sub-layers are to erosion and to the eye, laid out for quick look-up.
class RockTable {
 public:
  RockTable(const StratigraphicColumn& column, const RockStrengthParameters& strength,
            StrataPalette palette);

  int layers() const { return layers_; }  // n
  /// Rock at height z in a place whose horizons are h[0 .. n].
  Rock rock_at(const float* h, float z) const;

  float erodibility(Rock rock) const { return entry(rock).erodibility; }
  float talus_slope(Rock rock) const { return entry(rock).talus_slope; }
  std::uint32_t color(Rock rock) const { return entry(rock).color; }
  /// Number of a rock's sub-layer, counted from the basement's lowest, and back.
  int number(Rock rock) const { return first_[rock.layer] + rock.sub_layer; }
  std::uint32_t color_of(int number) const { return entries_[number].color; }
  Lithology lithology(Rock rock) const { return entry(rock).lithology; }
  int sub_layers(int layer) const { return first_[layer + 1] - first_[layer]; }
  /// Share of a layer's thickness below the top of one of its sub-layers.
  float top_share(int layer, int sub_layer) const {
    return entries_[first_[layer] + sub_layer].top;
  }
  /// Height of a layer's bottom. The basement's lowest sub-layer goes on below its own.
  float bottom_of(int layer, const float* h) const {
    return layer > 0 ? h[layer - 1] : h[0] - float(thickness_[0]);
  }
  /// Years between a rock's deposition and the start, at `deposition_rate` (m/yr).
  double age(Rock rock, double deposition_rate) const;

 private:
  struct Entry {
    float top;  // share of the layer's thickness at or below which the sub-layer lies
    float erodibility, talus_slope;
    std::uint32_t color;
    Lithology lithology;
  };
  const Entry& entry(Rock rock) const { return entries_[first_[rock.layer] + rock.sub_layer]; }
  void add(const Layer& layer, const RockStrengthParameters& strength, StrataPalette palette);

  int layers_;
  std::vector<Entry> entries_;
  std::vector<int> first_;
  std::vector<double> thickness_;  // m, of each layer from the basement up
};

inline Rock RockTable::rock_at(const float* h, float z) const {
  if (z > h[layers_] + kSedimentGap) return {layers_ + 1, 0, 0.0f};
  int k = layers_;
  while (k > 0 && z <= h[k - 1]) --k;
  const float bottom = bottom_of(k, h);
  Rock rock{k, 0, std::clamp((h[k] - z) / std::max(h[k] - bottom, 1e-6f), 0.0f, 1.0f)};
  const float height = 1.0f - rock.gamma;
  const int last = sub_layers(k) - 1;
  while (rock.sub_layer < last && height > top_share(k, rock.sub_layer)) ++rock.sub_layer;
  return rock;
}

/// What lies above a column, as a rock.
inline Rock loose_sediment(const RockTable& rocks) {
  return {rocks.layers() + 1, 0, 0.0f};
}

/// The horizons on a grid: heights[k] is that of horizon k in metres.
struct HorizonStack {
  std::vector<Raster<float>> heights;

  const Grid& grid() const { return heights.front().grid(); }
  int layers() const { return int(heights.size()) - 1; }
  /// All horizons at a place, bilinearly, those of the border beyond it; `out` has layers() + 1.
  void at(glm::dvec2 position, float* out) const;
};

/// Horizons before anything has moved. The column has been checked.
HorizonStack initial_horizons(const StratigraphicColumn& column, const Grid& grid,
                              const Context& context);

/// Thickness of a layer (m) at each cell.
Raster<float> thickness_raster(const Layer& layer, const Grid& grid, const Context& context);

}  // namespace orogen
