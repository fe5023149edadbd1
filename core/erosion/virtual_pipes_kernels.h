// The row loops of a virtual-pipe step (virtual_pipes.h gives the equations). Each works on n
// neighbouring cells or edges; pointers may have been moved by a cell or a row. All neighbours'
// heights enter as differences (base_i - base_j) + (rel_i - rel_j), rel = sediment - wear: small
// changes are not lost in kilometres, even in float.
#pragma once

#include <cstdint>

#include "erosion/virtual_pipes_parameters.h"

namespace orogen::pipes {

template <class Real>
struct StepConstants {
  Real lambda;         // dt / cell
  Real push;           // dt g D / cell
  Real drag;           // 4 dt cf D
  Real inverse_cell2;  // 1 / (2 cell)² for central differences, 1 / cell² for the steepest
  CapacityLaw law;
  // Options as numbers: a loop with a yes or no in it does not become SIMD.
  Real steepest;    // 0 or 1
  Real least_fall;  // m, of a cell to its lowest neighbour that digging leaves
  Real unlimited;   // 0 where neighbours limit changes, else more than any change
  Real capacity;
  Real min_slope2, max_slope2;
  Real dissolve_sediment;  // 1 - exp(-k dt)
  Real sediment_cost;      // its reciprocal
  Real deposit;
  Real max_change;
  Real evaporate;
  Real even_rain;    // m a step
  Real drop;         // m, of random rain
  Real drop_chance;  // of 2^24
};

template <class Real>
struct FluxRow {
  const Real *base_a, *base_b, *rel_a, *rel_b, *depth_a, *depth_b, *old_flux;
  Real* flux;
};

template <class Real>
struct LimitRow {
  const Real *west, *east, *south, *north, *depth, *suspended;
  Real *scale, *concentration;
};

template <class Real>
struct EdgeRow {
  const Real *wanted, *scale_a, *scale_b, *concentration_a, *concentration_b;
  Real *flux, *sediment_flux, *kept;  // kept: the flux once more, for the next step
};

template <class Real>
struct UpdateRow {
  const Real *west, *east, *south, *north;          // water fluxes
  const Real *s_west, *s_east, *s_south, *s_north;  // sediment fluxes
  const Real *base, *base_south, *base_north, *rel, *rel_south, *rel_north;
  const Real *depth, *suspended, *sediment, *wear, *original_sediment;
  const Real *code, *floor, *moisture, *temperature, *ease_erosion, *hold_erosion,
      *ease_deposition;  // hold_erosion: 1 / ease_erosion
  std::uint32_t rain_key, first_cell;
  Real *new_depth, *carry, *new_suspended, *new_sediment, *new_wear, *rain, *evaporated;
};

// Overloads for float and double.
#define OROGEN_PIPE_KERNELS(Real)                                                   \
  void subtract_row(const Real* a, const Real* b, Real* out, int n);                \
  void flux_row(const FluxRow<Real>& row, const StepConstants<Real>& k, int n);     \
  void limit_row(const LimitRow<Real>& row, const StepConstants<Real>& k, int n);   \
  void edge_row(const EdgeRow<Real>& row, int n);                                   \
  void update_row(const UpdateRow<Real>& row, const StepConstants<Real>& k, int n); \
  double sum_row(const Real* values, int n);

OROGEN_PIPE_KERNELS(float)
OROGEN_PIPE_KERNELS(double)
#undef OROGEN_PIPE_KERNELS

}  // namespace orogen::pipes
