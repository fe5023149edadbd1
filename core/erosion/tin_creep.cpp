// Creep on a TIN: conjugate gradients, preconditioned by the diagonal. Each vertex gathers from its
// neighbours, so that threads do not matter.
#include <algorithm>
#include <cmath>
#include <string>

#include "erosion/tin_hillslope.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr std::size_t kChunk = 4096;
constexpr double kLeastBrake = 0.05;     // f of the header: diffusivity grows at most 20-fold
constexpr double kLongestSubStep = 0.5;  // D dt / mean A, with a critical slope
constexpr double kTolerance = 1e-12;
constexpr int kMostIterations = 100000;

}  // namespace

MassBalance balance_of(const Tin& tin, std::span<const double> start, std::span<const double> end,
                       double exported_m3) {
  MassBalance result;
  double change = 0.0;
  for (std::size_t i = 0; i < tin.size(); ++i) {
    const double volume = (end[i] - start[i]) * tin.cell_areas[i];
    (volume < 0.0 ? result.eroded_m3 : result.deposited_m3) += std::fabs(volume);
    change += volume;
  }
  result.exported_m3 = exported_m3;
  result.residual_m3 = change + exported_m3;
  return result;
}

TinCreep::TinCreep(const Tin& tin, std::span<const std::uint8_t> base_level,
                   const CreepParameters& parameters)
    : tin_(&tin),
      parameters_(parameters),
      triangles_(tin.neighbors.size(), {-1, -1}),
      cotangents_(tin.neighbors.size(), {0.0f, 0.0f}),
      diffusivity_(tin.triangles.size(), parameters.diffusivity),
      weight_(tin.neighbors.size()),
      diagonal_(tin.size()) {
  check_parameters(parameters);
  set_base_level(base_level);
  const auto edge = [&](std::int32_t from, std::int32_t to) {
    const auto neighbors = tin.neighbors_of(from);
    return tin.first_edge[from] +
           (std::lower_bound(neighbors.begin(), neighbors.end(), to) - neighbors.begin());
  };
  for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = tin.triangles[t][k], b = tin.triangles[t][(k + 1) % 3];
      const glm::dvec2 apex = tin.points[tin.triangles[t][(k + 2) % 3]];
      const glm::dvec2 p = tin.points[a] - apex, q = tin.points[b] - apex;
      const float cotangent = float((p.x * q.x + p.y * q.y) / (p.x * q.y - p.y * q.x));
      for (const auto& [e, side] : {std::pair(edge(a, b), 0), std::pair(edge(b, a), 1)}) {
        triangles_[e][side] = std::int32_t(t);
        cotangents_[e][side] = cotangent;
      }
    }
}

void TinCreep::set_base_level(std::span<const std::uint8_t> base_level) {
  if (base_level.size() != tin_->size())
    throw InputError("base_level: " + std::to_string(base_level.size()) + " values, the TIN has " +
                     std::to_string(tin_->size()) + " vertices");
  base_.assign(base_level.begin(), base_level.end());
}

MassBalance TinCreep::step(std::span<double> elevation, double dt_years, const Context& context) {
  if (!(dt_years >= 0.0 && std::isfinite(dt_years)))
    throw InputError("dt_years: " + std::to_string(dt_years) + " yr is not finite and at least 0");
  if (elevation.size() != tin_->size())
    throw InputError("elevation: " + std::to_string(elevation.size()) + " values, the TIN has " +
                     std::to_string(tin_->size()) + " vertices");
  for (std::size_t i = 0; i < elevation.size(); ++i)
    if (!std::isfinite(elevation[i]))
      throw InputError("elevation: not finite at vertex " + std::to_string(i));
  if (parameters_.diffusivity == 0.0 || dt_years == 0.0) return {};
  const bool linear = parameters_.critical_slope == 0.0;
  const double mean_area = tin_->domain.area() / double(tin_->size());
  const double total = parameters_.diffusivity * dt_years / mean_area / kLongestSubStep;
  const int sub_steps = linear ? 1 : std::max(1, int(std::ceil(std::min(total, 1e6))));
  std::vector<double> z(elevation.begin(), elevation.end());
  double exported = 0.0;
  for (int i = 0; i < sub_steps; ++i) {
    if (!linear) find_diffusivity(z, context);
    if (i == 0 || !linear) find_weights(context);
    exported += solve(z, dt_years / sub_steps, context);
  }
  const MassBalance result = balance_of(*tin_, elevation, z, exported);
  std::copy(z.begin(), z.end(), elevation.begin());
  return result;
}

void TinCreep::find_diffusivity(const std::vector<double>& z, const Context& context) {
  const double per_slope = 1.0 / (parameters_.critical_slope * parameters_.critical_slope);
  parallel_chunks(context, tin_->triangles.size(), kChunk, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const auto& t = tin_->triangles[i];
      const glm::dvec2 a = tin_->points[t[1]] - tin_->points[t[0]];
      const glm::dvec2 b = tin_->points[t[2]] - tin_->points[t[0]];
      const double da = z[t[1]] - z[t[0]], db = z[t[2]] - z[t[0]], twice = a.x * b.y - a.y * b.x;
      const double x = (da * b.y - db * a.y) / twice, y = (db * a.x - da * b.x) / twice;
      diffusivity_[i] =
          parameters_.diffusivity / std::max(1.0 - (x * x + y * y) * per_slope, kLeastBrake);
    }
  });
}

void TinCreep::find_weights(const Context& context) {
  const auto half = [&](std::int32_t e, int side) {
    const std::int32_t t = triangles_[e][side];
    return t < 0 ? 0.0 : 0.5 * diffusivity_[t] * double(cotangents_[e][side]);
  };
  parallel_chunks(context, tin_->size(), kChunk, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      diagonal_[i] = 0.0;
      for (std::int32_t e = tin_->first_edge[i]; e < tin_->first_edge[i + 1]; ++e) {
        weight_[e] = std::max(0.0, half(e, 0) + half(e, 1));
        diagonal_[i] += weight_[e];
      }
    }
  });
}

double TinCreep::gain(const std::vector<double>& z, std::size_t vertex) const {
  double sum = 0.0;
  for (std::int32_t e = tin_->first_edge[vertex]; e < tin_->first_edge[vertex + 1]; ++e)
    sum += weight_[e] * (z[tin_->neighbors[e]] - z[vertex]);
  return sum;
}

/// (A / dt - L) change = L z
double TinCreep::solve(std::vector<double>& z, double dt, const Context& context) {
  const std::size_t n = z.size();
  const auto& areas = tin_->cell_areas;
  std::vector<double> change(n, 0.0), rest(n), search(n), product(n);
  const auto preconditioned = [&](std::size_t i) {
    return rest[i] / (areas[i] / dt + diagonal_[i]);
  };
  const auto each = [&](auto&& body) {
    parallel_chunks(context, n, kChunk, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) body(i);
    });
  };
  each([&](std::size_t i) {
    rest[i] = base_[i] ? 0.0 : gain(z, i);
    search[i] = preconditioned(i);
  });
  double norm = parallel_sum(context, n, [&](std::size_t i) { return rest[i] * search[i]; });
  const double enough = norm * kTolerance * kTolerance;
  for (int k = 0; k < kMostIterations && norm > enough; ++k) {
    each([&](std::size_t i) {
      product[i] = base_[i] ? 0.0 : areas[i] / dt * search[i] - gain(search, i);
    });
    const double along =
        norm / parallel_sum(context, n, [&](std::size_t i) { return search[i] * product[i]; });
    each([&](std::size_t i) {
      change[i] += along * search[i];
      rest[i] -= along * product[i];
    });
    const double next =
        parallel_sum(context, n, [&](std::size_t i) { return rest[i] * preconditioned(i); });
    each([&](std::size_t i) { search[i] = preconditioned(i) + next / norm * search[i]; });
    norm = next;
  }
  each([&](std::size_t i) { search[i] = z[i] + change[i]; });
  // What the fluxes and the heights differ by is spread evenly, so that mass is kept.
  const double missing = parallel_sum(context, n, [&](std::size_t i) {
    return base_[i] ? 0.0 : dt * gain(search, i) - areas[i] * change[i];
  });
  const double free =
      parallel_sum(context, n, [&](std::size_t i) { return base_[i] ? 0.0 : areas[i]; });
  each([&](std::size_t i) {
    if (!base_[i]) z[i] = search[i] + missing / free;
  });
  return dt *
         parallel_sum(context, n, [&](std::size_t i) { return base_[i] ? gain(search, i) : 0.0; });
}

}  // namespace orogen
