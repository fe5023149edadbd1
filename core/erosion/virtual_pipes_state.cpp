#include "erosion/virtual_pipes_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orogen::pipes {

namespace {

template <class Real>
void copy_padded(const PaddedShape& shape, const Raster<float>* raster, std::vector<Real>& out) {
  if (!raster) return;
  out.assign(shape.size(), Real(0));
  for (int r = 0; r < shape.ny; ++r)
    std::copy_n(raster->row(r), shape.nx, out.begin() + std::ptrdiff_t(shape.index(r, 0)));
}

bool is_sea(const Raster<float>& elevation, const PipeForcing& forcing, std::size_t i) {
  return forcing.land ? !(*forcing.land)[i] : !(elevation[i] > 0.0f);
}

/// Outside open sides the ground goes on as it comes, but neither upwards nor below the sea;
/// outside closed ones it is level.
template <class Real>
void lay_surroundings(PipeState<Real>& s) {
  const int nx = s.shape.nx, ny = s.shape.ny;
  const auto beyond = [&](int r, int c, int inner_r, int inner_c) {
    const Real edge = s.base[s.shape.index(r, c)];
    if (!s.open_sides) return edge;
    const Real on = std::max(2 * edge - s.base[s.shape.index(inner_r, inner_c)], Real(0));
    return std::min(edge, on);
  };
  for (int r = 0; r < ny; ++r) {
    s.base[s.shape.index(r, -1)] = beyond(r, 0, r, std::min(1, nx - 1));
    s.base[s.shape.index(r, nx)] = beyond(r, nx - 1, r, std::max(0, nx - 2));
  }
  for (int c = 0; c < nx; ++c) {
    s.base[s.shape.index(-1, c)] = beyond(0, c, std::min(1, ny - 1), c);
    s.base[s.shape.index(ny, c)] = beyond(ny - 1, c, std::max(0, ny - 2), c);
  }
}

template <class Real>
StepConstants<Real> step_constants(const PipeParameters& p, double cell, double dt) {
  const auto share = [&](double rate) { return Real(-std::expm1(-rate * dt)); };
  const double rain = p.rain_rate_mm_per_h / 3.6e6 * dt;  // m a step
  const double spacing = p.bed_slope == BedSlope::Steepest ? cell : 2.0 * cell;
  StepConstants<Real> k{};
  k.lambda = Real(dt / cell);
  k.push = Real(dt * p.gravity * p.pipe_depth / cell);
  k.drag = Real(4.0 * dt * p.drag_coefficient * p.pipe_depth);
  k.inverse_cell2 = Real(1.0 / (spacing * spacing));
  k.steepest = p.bed_slope == BedSlope::Steepest;
  k.law = p.capacity_law;
  k.least_fall = Real(1e-4 * cell);
  k.unlimited = p.limit_to_neighbours ? Real(0) : Real(1e12);
  k.capacity = Real(p.sediment_capacity);
  k.min_slope2 = Real(p.min_slope * p.min_slope);
  k.max_slope2 = Real(p.max_slope * p.max_slope);
  k.dissolve_sediment = share(p.sediment_dissolution_rate);
  k.sediment_cost = 1 / k.dissolve_sediment;
  k.deposit = share(p.deposition_rate);
  k.max_change = Real(p.max_change);
  k.evaporate = share(p.evaporation_rate);
  k.even_rain = p.random_rain ? Real(0) : Real(rain);
  k.drop = p.random_rain ? Real(rain / p.drop_probability) : Real(0);
  k.drop_chance = Real(p.drop_probability * 16777216.0);
  return k;
}

template <class Real>
void lay_cell(PipeState<Real>& s, const Raster<float>& elevation, const PipeForcing& forcing, int r,
              int c) {
  const std::size_t i = s.shape.index(r, c), j = elevation.grid().index(r, c);
  if (is_sea(elevation, forcing, j)) {
    s.base[i] = 0;
    s.code[i] = Real(kSink);
    if (!s.sea_room.empty()) s.sea_room[i] = std::max(Real(-elevation[j]), Real(0));
    return;
  }
  const Real loose = forcing.sediment_thickness ? Real((*forcing.sediment_thickness)[j]) : Real(0);
  s.base[i] = Real(elevation[j]) - loose;
  s.sediment.now[i] = s.sediment.next[i] = loose;
  if (!s.original_sediment.empty()) s.original_sediment[i] = loose;
  if (forcing.water_depth) s.depth.now[i] = Real((*forcing.water_depth)[j]);
  if (!s.floor.empty()) s.floor[i] = Real(forcing.layers.front().thickness[j]);
  s.expose(r, c);
  if (forcing.pinned && (*forcing.pinned)[j]) s.code[i] = Real(kPinned);
}

}  // namespace

template <class Real>
void PipeState<Real>::expose(int row, int column) {
  const std::size_t i = shape.index(row, column);
  double rate = bedrock_rate;
  if (!layer.empty()) {
    std::uint8_t& exposed = layer[i];
    while (exposed < layers->size() && wear.now[i] >= floor[i])
      floor[i] +=
          ++exposed < layers->size() ? Real((*layers)[exposed].thickness(row, column)) : Real(1e30);
    if (exposed < layers->size()) rate = (*layers)[exposed].dissolution_rate;
  }
  if (erodibility) rate *= double((*erodibility)(row, column));
  code[i] = erodibility || !layer.empty() ? Real(-std::expm1(-rate * time_step)) : bedrock_share;
}

template <class Real>
PipeState<Real> make_pipe_state(const Raster<float>& elevation, const PipeForcing& forcing,
                                const PipeParameters& p, double time_step) {
  const Grid& grid = elevation.grid();
  PipeState<Real> s;
  s.shape = PaddedShape(grid.nx, grid.ny);
  s.cell_size = grid.cell_size;
  s.time_step = time_step;
  s.open_sides = p.open_sides;
  s.traced = p.transport == TransportScheme::SemiLagrangian;
  s.seed = std::uint32_t(p.seed);
  s.k = step_constants<Real>(p, grid.cell_size, time_step);
  s.layers = &forcing.layers;
  s.erodibility = forcing.erodibility;
  s.bedrock_rate = p.rock_dissolution_rate;
  s.bedrock_share = Real(-std::expm1(-p.rock_dissolution_rate * time_step));
  s.erosion_halving_depth = p.erosion_halving_depth;
  s.deposition_halving_depth = p.deposition_halving_depth;

  const std::size_t size = s.shape.size();
  for (auto* pair : {&s.sediment, &s.wear, &s.depth, &s.suspended, &s.flux_x, &s.flux_y}) {
    pair->now.assign(size, Real(0));
    pair->next.assign(size, Real(0));
  }
  for (auto* field : {&s.base, &s.carry}) field->assign(size, Real(0));
  s.code.assign(size, Real(kWall));
  if (p.sea_keeps_sediment) s.sea_room.assign(size, Real(0));
  if (forcing.sediment_thickness) s.original_sediment.assign(size, Real(0));
  if (!forcing.layers.empty()) {
    s.layer.assign(size, 0);
    s.floor.assign(size, Real(0));
  }
  copy_padded(s.shape, forcing.moisture, s.moisture);
  copy_padded(s.shape, forcing.temperature, s.temperature);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) lay_cell(s, elevation, forcing, r, c);
  lay_surroundings(s);
  s.tiles = make_tiles(s.shape, s.code.data());
  s.sums.assign(s.tiles.size(), {});
  for (const RiverSource& source : forcing.sources)
    s.sources.push_back(
        {s.shape.index(grid.row_of(source.position.y), grid.column_of(source.position.x)),
         source.discharge * time_step / grid.cell_area()});
  return s;
}

#define OROGEN_PIPE_STATE(Real)                                                      \
  template struct PipeState<Real>;                                                   \
  template PipeState<Real> make_pipe_state(const Raster<float>&, const PipeForcing&, \
                                           const PipeParameters&, double);
OROGEN_PIPE_STATE(float)
OROGEN_PIPE_STATE(double)

}  // namespace orogen::pipes
