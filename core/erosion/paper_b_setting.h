// Paper B's own setting of hydraulic erosion (chapter VI), and its scaling to metres and seconds.
//
// The paper counts in cells, in heights within 1, and in a time of its own: g = 10, Δt = 0.01,
// K_c = 0.1, K_s = K_d = 0.002 a step, K_e = 0.1. With cells of l metres, heights of H metres and
// pipes of D metres a unit of its time is
//
//   T = l sqrt(10 / (g D)) seconds,      and so
//
//   Δt = 0.01 T    rates = 0.2 / T    K_e = 0.1 / T    capacity = 0.1 T (|v| in m/s, S = Δb / l)
//   slopes clamped to 0.005 H / l .. 0.5 H / l         rain = 0.001 H / T where moisture is 1
//
// Erosion so scaled is the paper's to rounding, whatever l and H. What the paper leaves open: rain
// (0.001 here), the bound of change (0.05 H), the halving depths (0.02 H).
#pragma once

#include "erosion/virtual_pipes_parameters.h"

namespace orogen {

/// `units` of the paper's time long. Cell size and height unit in metres, above 0.
PipeParameters paper_b_setting(double cell_size, double height_unit, double units);

}  // namespace orogen
