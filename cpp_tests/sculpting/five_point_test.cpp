#include "sculpting/five_point.h"

#include <gtest/gtest.h>

#include <Eigen/SparseLU>
#include <cmath>

#include "foundation/random.h"

namespace orogen {
namespace {

/// Random weights that favour one side, as eq. 9's slopes do; random cells.
FivePointSystem random_system(int nx, int ny, std::uint64_t seed, double share) {
  const Grid grid{nx, ny, 1.0};
  Raster<std::uint8_t> active(grid);
  for (std::size_t i = 0; i < active.size(); ++i) active[i] = random_uniform(seed, 0, i) < share;
  Raster<std::int32_t> number;
  FivePointSystem system = five_point_system(active, number);
  for (std::int32_t i = 0; i < system.size(); ++i)
    for (int k = 0; k < 4; ++k)
      if (system.neighbors[i][k] >= 0)
        system.weights[i][k] = float(0.24 * random_uniform(seed, 1, 4 * i + k));
  return system;
}

TEST(FivePoint, NumbersAndJoinsCells) {
  const FivePointSystem system = random_system(9, 7, 1, 0.6);
  for (std::int32_t i = 0; i < system.size(); ++i) {
    EXPECT_EQ((system.row[i] + system.column[i]) % 2, i < system.reds ? 0 : 1);
    for (int k = 0; k < 4; ++k)
      if (const std::int32_t j = system.neighbors[i][k]; j >= 0) {
        EXPECT_EQ(system.column[j] - system.column[i], k == 0 ? -1 : k == 1 ? 1 : 0);
        EXPECT_EQ(system.row[j] - system.row[i], k == 2 ? -1 : k == 3 ? 1 : 0);
        EXPECT_EQ(system.neighbors[j][k ^ 1], i);
      }
  }
}

TEST(FivePoint, AgreesWithADirectSolver) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const FivePointSystem system =
        random_system(20 + int(seed), 31, seed, 0.3 + 0.035 * double(seed));
    const std::int32_t n = system.size();
    Eigen::SparseMatrix<double> matrix(n, n);
    Eigen::VectorXd right(n);
    std::vector<double> b(n), x(n, 0.0);
    for (std::int32_t i = 0; i < n; ++i) {
      right[i] = b[i] = random_uniform(seed, 2, i);
      matrix.insert(i, i) = system.diagonal[i];
      for (int k = 0; k < 4; ++k)
        if (const std::int32_t j = system.neighbors[i][k]; j >= 0)
          matrix.insert(i, j) = -double(system.weights[i][k]);
    }
    matrix.makeCompressed();
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> direct(matrix);
    const Eigen::VectorXd exact = direct.solve(right);
    Context context;
    const auto found = solve_five_point(system, b, x, 1e-12, context);
    EXPECT_LE(found.residual, 1e-12);
    for (std::int32_t i = 0; i < n; ++i) ASSERT_NEAR(x[i], exact[i], 1e-9);
  }
}

TEST(FivePoint, NeedsAsManyIterationsOnAnySize) {
  for (const int n : {32, 128, 512}) {
    const Grid grid{n, n, 1.0};
    Raster<std::int32_t> number;
    FivePointSystem system = five_point_system(Raster<std::uint8_t>(grid, 1), number);
    for (auto& weights : system.weights) weights.fill(0.25f);  // beyond the sides: held at 0
    std::vector<double> b(grid.size(), 1.0), x(grid.size(), 0.0);
    Context context;
    const auto found = solve_five_point(system, b, x, 1e-6, context);
    EXPECT_LE(found.residual, 1e-6);
    EXPECT_LE(found.iterations, 25) << n;
  }
}

TEST(FivePoint, TakesNoCellsAndIsTheSameWithAnyThreads) {
  Raster<std::int32_t> number;
  const FivePointSystem none = five_point_system(Raster<std::uint8_t>(Grid{3, 3, 1.0}), number);
  std::vector<double> nothing;
  Context context;
  EXPECT_EQ(solve_five_point(none, {}, nothing, 1e-9, context).iterations, 0);
  const FivePointSystem system = random_system(200, 200, 5, 0.8);
  const auto once = [&](int threads) {
    std::vector<double> b(system.size(), 1.0), x(system.size(), 0.0);
    Context limited({}, threads);
    limited.run([&] { solve_five_point(system, b, x, 1e-9, limited); });
    return x;
  };
  EXPECT_EQ(once(1), once(4));
}

}  // namespace
}  // namespace orogen
