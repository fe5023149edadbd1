// Sparse systems on some of a grid's cells, each joined to its four neighbours, solved by
// multigrid.
//
//   d_i x_i - sum over neighbours j of w_ij x_j = b_i,    w_ij >= 0,  sum of w_ij <= d_i
//
// not necessarily symmetric. BiCGSTAB, with a W-cycle in float on aggregates of 2 x 2 cells
// (Galerkin: weights between aggregates are sums) and red-black Gauss-Seidel before and after. The
// number of iterations hardly depends on the number of cells. Sums are taken in a fixed order.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

/// Neighbours and weights in the order west, east, south, north; -1: none.
struct FivePointSystem {
  std::vector<std::array<std::int32_t, 4>> neighbors;
  std::vector<std::array<float, 4>> weights;
  std::vector<float> diagonal;
  std::vector<std::int32_t> row, column;
  std::int32_t reds = 0;  // cells whose row and column add up to an even number come first

  std::int32_t size() const { return std::int32_t(diagonal.size()); }
};

/// The cells that are not 0 in `active`, joined; weights are 0 and diagonals 1. `number`: which
/// unknown a cell is, -1 for none.
FivePointSystem five_point_system(const Raster<std::uint8_t>& active, Raster<std::int32_t>& number);

struct FivePointSolution {
  int iterations = 0;
  double residual = 0.0;  // largest of |d_i x_i - sum w_ij x_j - b_i|
};

/// Improves x until the residual is at most `tolerance`, or for 200 iterations.
FivePointSolution solve_five_point(const FivePointSystem& system, const std::vector<double>& b,
                                   std::vector<double>& x, double tolerance, Context& context);

}  // namespace orogen
