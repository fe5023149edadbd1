#include "strata/horizons.h"

#include <cmath>

namespace orogen {

namespace {

constexpr double kShade = 0.18;  // of the bands within a layer

}  // namespace

RockTable::RockTable(const StratigraphicColumn& column, const RockStrengthParameters& strength,
                     StrataPalette palette)
    : layers_(int(column.layers.size())) {
  check_column(column);
  check_parameters(strength);
  add(column.basement, strength, palette);
  for (const Layer& layer : column.layers) add(layer, strength, palette);
  Layer sediment{"sediment", 1.0, 1.0, 0.0, 0.0, {{1.0, Lithology::Sediment, {}}}, {}};
  add(sediment, strength, palette);
  first_.push_back(int(entries_.size()));
}

void RockTable::add(const Layer& layer, const RockStrengthParameters& strength,
                    StrataPalette palette) {
  first_.push_back(int(entries_.size()));
  thickness_.push_back(layer.thickness);
  double whole = 0.0, below = 0.0;
  for (const SubLayer& s : layer.sub_layers) whole += s.share;
  for (std::size_t i = 0; i < layer.sub_layers.size(); ++i) {
    const SubLayer& s = layer.sub_layers[i];
    below += s.share;
    const double resistance = resistance_of(s);
    const double shade = i % 2 ? 0.5 * kShade : -0.5 * kShade;  // bands of one lithology stay apart
    const std::uint32_t color = lithology_color(s.lithology, palette);
    entries_.push_back({float(below / whole), float(erodibility_of(resistance, strength)),
                        float(talus_slope_of(resistance, strength)),
                        layer.sub_layers.size() > 1 ? shaded_color(color, shade) : color,
                        s.lithology});
  }
}

double RockTable::age(Rock rock, double deposition_rate) const {
  if (rock.layer > layers_) return 0.0;
  double above = rock.gamma * thickness_[rock.layer];
  for (int k = rock.layer + 1; k <= layers_; ++k) above += thickness_[k];
  return above / deposition_rate;
}

void HorizonStack::at(glm::dvec2 position, float* out) const {
  const Bilinear place = bilinear_at(grid(), position);
  for (std::size_t k = 0; k < heights.size(); ++k) out[k] = float(place(heights[k]));
}

Raster<float> thickness_raster(const Layer& layer, const Grid& grid, const Context& context) {
  if (layer.thickness_map) return on_grid(*layer.thickness_map, grid, context);
  return Raster<float>(grid, float(layer.thickness));
}

HorizonStack initial_horizons(const StratigraphicColumn& column, const Grid& grid,
                              const Context& context) {
  HorizonStack stack;
  stack.heights.resize(column.layers.size() + 1);
  stack.heights.back() = Raster<float>(grid);
  for (std::size_t k = column.layers.size(); k-- > 0;) {
    Raster<float> thickness = thickness_raster(column.layers[k], grid, context);
    for (std::size_t i = 0; i < thickness.size(); ++i)
      thickness[i] = stack.heights[k + 1][i] - thickness[i];
    stack.heights[k] = std::move(thickness);
  }
  return stack;
}

}  // namespace orogen
