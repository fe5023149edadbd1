#include "sculpting/five_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 8192;
constexpr std::int32_t kCoarsest = 12;
constexpr int kCoarsestSweeps = 12;
constexpr int kMostIterations = 200;

using Numbers = Raster<std::int32_t>;

/// The unknowns of each colour, row by row.
void number_cells(FivePointSystem& system, Numbers& number, auto&& is_active) {
  const Grid& grid = number.grid();
  std::ranges::fill(number.values(), -1);
  for (const int colour : {0, 1}) {
    for (int r = 0; r < grid.ny; ++r)
      for (int c = (r + colour) % 2; c < grid.nx; c += 2) {
        if (!is_active(r, c)) continue;
        number(r, c) = std::int32_t(system.row.size());
        system.row.push_back(r);
        system.column.push_back(c);
      }
    if (colour == 0) system.reds = std::int32_t(system.row.size());
  }
  const std::size_t n = system.row.size();
  system.diagonal.assign(n, 1.0f);
  system.weights.assign(n, {});
  system.neighbors.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int r = system.row[i], c = system.column[i];
    const auto at = [&](int row, int column) {
      return grid.contains(row, column) ? number(row, column) : -1;
    };
    system.neighbors[i] = {at(r, c - 1), at(r, c + 1), at(r - 1, c), at(r + 1, c)};
  }
}

/// A system on aggregates of 2 x 2 cells, and which aggregate each cell is in.
struct Coarser {
  FivePointSystem system;
  std::vector<std::int32_t> parent;
};

Coarser coarsen(const FivePointSystem& fine, Grid& grid) {
  grid = {(grid.nx + 1) / 2, (grid.ny + 1) / 2, 2.0 * grid.cell_size, grid.origin};
  Raster<std::uint8_t> active(grid);
  for (std::int32_t i = 0; i < fine.size(); ++i) active(fine.row[i] / 2, fine.column[i] / 2) = 1;
  Coarser made;
  Numbers number(grid);
  number_cells(made.system, number, [&](int r, int c) { return active(r, c) != 0; });
  made.parent.resize(fine.size());
  std::vector<double> diagonal(made.system.size(), 0.0);
  for (std::int32_t i = 0; i < fine.size(); ++i) {
    const std::int32_t parent = number(fine.row[i] / 2, fine.column[i] / 2);
    made.parent[i] = parent;
    diagonal[parent] += fine.diagonal[i];
  }
  for (std::int32_t i = 0; i < fine.size(); ++i)
    for (int k = 0; k < 4; ++k) {
      const std::int32_t j = fine.neighbors[i][k];
      if (j < 0) continue;
      if (made.parent[j] == made.parent[i])
        diagonal[made.parent[i]] -= fine.weights[i][k];
      else
        made.system.weights[made.parent[i]][k] += fine.weights[i][k];
    }
  for (std::int32_t i = 0; i < made.system.size(); ++i)
    made.system.diagonal[i] = float(diagonal[i]);
  return made;
}

template <class Real>
Real from_neighbors(const FivePointSystem& system, const std::vector<Real>& x, std::int32_t i) {
  Real sum = 0;
  for (int k = 0; k < 4; ++k)
    if (const std::int32_t j = system.neighbors[i][k]; j >= 0)
      sum += Real(system.weights[i][k]) * x[j];
  return sum;
}

class Cycle {
 public:
  Cycle(const FivePointSystem& system, const Context& context) : context_(context) {
    finest_ = &system;
    Grid grid{1, 1};
    for (std::int32_t i = 0; i < system.size(); ++i) {
      grid.nx = std::max(grid.nx, system.column[i] + 1);
      grid.ny = std::max(grid.ny, system.row[i] + 1);
    }
    while (at(levels_.size()).size() > kCoarsest && std::max(grid.nx, grid.ny) > 1)
      levels_.push_back(coarsen(at(levels_.size()), grid));
    x_.resize(levels_.size() + 1);
    b_.resize(levels_.size() + 1);
    for (std::size_t level = 0; level <= levels_.size(); ++level) {
      x_[level].resize(at(level).size());
      b_[level].resize(at(level).size());
    }
  }

  /// out: about the solution for b.
  void apply(const std::vector<double>& b, std::vector<double>& out) {
    for_all(b.size(), [&](std::size_t i) { b_[0][i] = float(b[i]); });
    std::ranges::fill(x_[0], 0.0f);
    run(0);
    for_all(b.size(), [&](std::size_t i) { out[i] = x_[0][i]; });
  }

 private:
  const FivePointSystem& at(std::size_t level) const {
    return level == 0 ? *finest_ : levels_[level - 1].system;
  }

  template <class Body>
  void for_all(std::size_t n, Body&& body) {
    parallel_chunks(context_, n, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) body(i);
    });
  }

  void relax(std::size_t level, bool red) {
    const FivePointSystem& system = at(level);
    std::vector<float>& x = x_[level];
    const std::size_t first = red ? 0 : system.reds, last = red ? system.reds : system.size();
    for_all(last - first, [&](std::size_t k) {
      const std::int32_t i = std::int32_t(first + k);
      x[i] = (b_[level][i] + from_neighbors(system, x, i)) / system.diagonal[i];
    });
  }

  void run(std::size_t level) {
    if (level == levels_.size()) {
      for (int sweep = 0; sweep < kCoarsestSweeps; ++sweep)
        for (const bool red : {true, false}) relax(level, red);
      return;
    }
    for (const bool red : {true, false}) relax(level, red);
    restrict_residual(level);
    std::ranges::fill(x_[level + 1], 0.0f);
    run(level + 1);
    if (level + 1 < levels_.size()) run(level + 1);
    for_all(x_[level].size(),
            [&](std::size_t i) { x_[level][i] += x_[level + 1][levels_[level].parent[i]]; });
    for (const bool red : {false, true}) relax(level, red);
  }

  /// After red, then black cells are relaxed only red ones have a residual.
  void restrict_residual(std::size_t level) {
    const FivePointSystem& system = at(level);
    const std::vector<std::int32_t>& parent = levels_[level].parent;
    std::vector<float>& coarse = b_[level + 1];
    std::ranges::fill(coarse, 0.0f);
    for (std::int32_t i = 0; i < system.reds; ++i)
      coarse[parent[i]] +=
          b_[level][i] + from_neighbors(system, x_[level], i) - system.diagonal[i] * x_[level][i];
  }

  const Context& context_;
  const FivePointSystem* finest_;
  std::vector<Coarser> levels_;
  std::vector<std::vector<float>> x_, b_;
};

class BiCgStab {
 public:
  BiCgStab(const FivePointSystem& system, const std::vector<double>& b, std::vector<double>& x,
           Context& context)
      : system_(system), x_(x), context_(context), cycle_(system, context), n_(b.size()) {
    for (auto* vector : {&r_, &p_, &v_, &s_, &t_, &y_}) vector->assign(n_, 0.0);
    multiply(x, r_);
    each([&](std::size_t i) { r_[i] = b[i] - r_[i]; });
    shadow_ = r_;
  }

  FivePointSolution run(double tolerance) {
    FivePointSolution found{0, largest(r_)};
    double rho = 1.0, alpha = 1.0, omega = 1.0;
    while (found.residual > tolerance && found.iterations < kMostIterations) {
      const double next = dot(shadow_, r_), beta = next / rho * (alpha / omega);
      rho = next;
      each([&](std::size_t i) { p_[i] = r_[i] + beta * (p_[i] - omega * v_[i]); });
      cycle_.apply(p_, y_);
      multiply(y_, v_);
      alpha = rho / dot(shadow_, v_);
      each([&](std::size_t i) {
        x_[i] += alpha * y_[i];
        s_[i] = r_[i] - alpha * v_[i];
      });
      cycle_.apply(s_, y_);
      multiply(y_, t_);
      const double tt = dot(t_, t_);
      omega = tt > 0.0 ? dot(t_, s_) / tt : 0.0;
      each([&](std::size_t i) {
        x_[i] += omega * y_[i];
        r_[i] = s_[i] - omega * t_[i];
      });
      found = {found.iterations + 1, largest(r_)};
      if (omega == 0.0 || !std::isfinite(found.residual)) break;
    }
    return found;
  }

 private:
  template <class Body>
  void each(Body&& body) {
    parallel_chunks(context_, n_, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) body(i);
    });
  }
  void multiply(const std::vector<double>& x, std::vector<double>& out) {
    each([&](std::size_t i) {
      out[i] = system_.diagonal[i] * x[i] - from_neighbors(system_, x, std::int32_t(i));
    });
  }
  double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return parallel_sum(context_, n_, [&](std::size_t i) { return a[i] * b[i]; });
  }
  double largest(const std::vector<double>& a) {
    return parallel_reduce(
        context_, n_, kGrain, 0.0,
        [&](std::size_t begin, std::size_t end) {
          double most = 0.0;
          for (std::size_t i = begin; i < end; ++i) most = std::max(most, std::fabs(a[i]));
          return most;
        },
        [](double a, double b) { return std::max(a, b); });
  }

  const FivePointSystem& system_;
  std::vector<double>& x_;
  Context& context_;
  Cycle cycle_;
  std::size_t n_;
  std::vector<double> r_, shadow_, p_, v_, s_, t_, y_;
};

}  // namespace

FivePointSystem five_point_system(const Raster<std::uint8_t>& active,
                                  Raster<std::int32_t>& number) {
  FivePointSystem system;
  number = Numbers(active.grid());
  number_cells(system, number, [&](int r, int c) { return active(r, c) != 0; });
  return system;
}

FivePointSolution solve_five_point(const FivePointSystem& system, const std::vector<double>& b,
                                   std::vector<double>& x, double tolerance, Context& context) {
  if (system.size() == 0) return {};
  return BiCgStab(system, b, x, context).run(tolerance);
}

}  // namespace orogen
