#include "tectonics/collision_uplift.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "foundation/errors.h"
#include "foundation/gaussian_blur.h"
#include "foundation/parallel.h"
#include "foundation/resample.h"
#include "tectonics/iso_lines.h"

namespace orogen {

namespace {

constexpr float kNoThickening = 1e-5f;
constexpr float kUplifted = 0.01f;  // of the greatest uplift

// 1 where the two plates nearest to p come together, 0 where they part; half of it where they
// slide.
float convergence(const TransportField& transport, glm::dvec2 p) {
  int nearest[2] = {-1, -1};
  double least[2] = {std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::infinity()};
  for (int i = 0; i < int(transport.plates().size()); ++i) {
    const double d = transport.distance(i, p);
    if (d >= least[1]) continue;
    const int rank = d < least[0] ? 0 : 1;
    if (rank == 0) {
      least[1] = least[0];
      nearest[1] = nearest[0];
    }
    least[rank] = d;
    nearest[rank] = i;
  }
  if (nearest[1] < 0) return 0.0f;
  glm::dvec2 foot[2], moves[2];
  for (int k = 0; k < 2; ++k) {
    foot[k] = nearest_on_hull(transport.plates()[nearest[k]].moved_hull, p);
    moves[k] = transport.plate_displacement(nearest[k], p);
  }
  const glm::dvec2 way = foot[1] - foot[0], closing = moves[0] - moves[1];
  const double scale = std::hypot(way.x, way.y) * std::hypot(closing.x, closing.y);
  if (!(scale > 0.0)) return 0.0f;
  const double head_on = (way.x * closing.x + way.y * closing.y) / scale;
  const double t = std::clamp(0.5 + 2.0 * head_on, 0.0, 1.0);
  return float(t * t * (3.0 - 2.0 * t));
}

}  // namespace

Raster<float> plate_convergence(const TransportField& transport, const Grid& grid, double smoothing,
                                const Context& context) {
  const int step = std::clamp(int(0.5 * smoothing / grid.cell_size), 1, 16);
  const Grid coarse{(grid.nx + step - 1) / step, (grid.ny + step - 1) / step, step * grid.cell_size,
                    grid.origin};
  Raster<float> values(coarse);
  parallel_rows(context, coarse.ny, [&](int r) {
    for (int c = 0; c < coarse.nx; ++c) values(r, c) = convergence(transport, coarse.center(r, c));
  });
  return resample_bilinear(values, grid, context);
}

namespace {

float greatest(const Raster<float>& field, const Context& context) {
  return parallel_reduce(
      context, field.size(), 16384, 0.0f,
      [&](std::size_t begin, std::size_t end) {
        return std::max(0.0f, *std::max_element(field.data() + begin, field.data() + end));
      },
      [](float a, float b) { return std::max(a, b); });
}

// Not negative on the moving side: where another plate is nearer than the stable one, or crust
// has thickened beyond the level.
Raster<float> moving_side(const TransportField& transport, const CompressionField& field,
                          const Raster<float>& thickening, float level, int stable,
                          const Context& context) {
  const Grid& grid = field.plate.grid();
  Raster<float> side(grid);
  const auto nearer = [&](glm::dvec2 p) {  // the other plates', in cells
    double others = std::numeric_limits<double>::infinity();
    for (int i = 0; i < int(transport.plates().size()); ++i)
      if (i != stable) others = std::min(others, transport.distance(i, p));
    return float((transport.distance(stable, p) - others) / grid.cell_size);
  };
  parallel_rows(context, grid.ny, [&](int r) {
    const std::int32_t* plate = field.plate.row(r);
    const std::int32_t* below = field.plate.row(std::max(r - 1, 0));
    const std::int32_t* above = field.plate.row(std::min(r + 1, grid.ny - 1));
    for (int c = 0; c < grid.nx; ++c) {
      const int west = plate[std::max(c - 1, 0)], east = plate[std::min(c + 1, grid.nx - 1)];
      const bool on_stable = plate[c] == stable;
      const int stable_beside =
          (west == stable) + (east == stable) + (below[c] == stable) + (above[c] == stable);
      const float thick = thickening(r, c) / level - 1.0f;
      side(r, c) = on_stable ? thick : 1.0f;
      if (stable_beside != (on_stable ? 4 : 0))  // the border runs by
        side(r, c) = std::max(thick, nearer(grid.center(r, c)));
    }
  });
  return side;
}

// The stretches of a line with ground beside them that rises faster than `least`.
void keep_rising(const Polyline& line, const Raster<float>& uplift, float least,
                 std::vector<Polyline>& out) {
  const Grid& grid = uplift.grid();
  const auto rises = [&](glm::dvec2 p) {
    const int row = grid.row_of(p.y), column = grid.column_of(p.x);
    for (int r = row - 1; r <= row + 1; ++r)
      for (int c = column - 1; c <= column + 1; ++c)
        if (grid.contains(r, c) && uplift(r, c) > least) return true;
    return false;
  };
  Polyline part;
  const auto close = [&] {
    if (part.size() > 1) out.push_back(part);
    part.clear();
  };
  for (const glm::dvec2 p : line) {
    if (rises(p))
      part.push_back(p);
    else
      close();
  }
  close();
}

// The fault all along the stable plate's side; `fault` receives the distance to it.
std::vector<Polyline> lay_fault(const TransportField& transport, const CompressionField& field,
                                const Raster<float>& thickening, float level, int stable,
                                double offset, Raster<float>& fault, const Context& context) {
  const Raster<float> side = moving_side(transport, field, thickening, level, stable, context);
  std::vector<Polyline> lines = iso_lines(side, 0.0f, context);
  fault = signed_distance(side, 0.0f, lines, context);
  if (offset != 0.0 && !lines.empty()) {
    for (float& d : fault.values()) d += float(offset);
    lines = iso_lines(fault, 0.0f, context);
  }
  return lines;
}

}  // namespace

int slowest_plate(const TransportField& transport) {
  int slowest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < int(transport.plates().size()); ++i) {
    const double d = transport.plates()[i].displacement();
    if (d < least) {
      least = d;
      slowest = i;
    }
  }
  return slowest;
}

Raster<float> smoothed_thickening(const CompressionField& field, const Raster<float>& convergence,
                                  double smoothing, const Context& context) {
  const Grid& grid = field.crust.grid();
  if (convergence.grid() != grid) throw InputError("convergence: must lie on the field's grid");
  Raster<float> excess(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    const float *q = field.crust.row(r), *meet = convergence.row(r);
    float* e = excess.row(r);
    for (int c = 0; c < grid.nx; ++c) e[c] = q[c] > 1.0f ? meet[c] * (q[c] - 1.0f) : q[c] - 1.0f;
  });
  return gaussian_blur(excess, smoothing, context);
}

CollisionUplift collision_uplift(const TransportField& transport, const CompressionField& field,
                                 const Raster<float>& convergence,
                                 const CollisionParameters& parameters, const Context& context) {
  check_parameters(parameters, "collision");
  const int plates = int(transport.plates().size());
  if (parameters.stable_plate >= std::max(plates, 1))
    throw InputError("collision.stable_plate: " + std::to_string(parameters.stable_plate) +
                     "; there are " + std::to_string(plates) + " plates, numbered from 0");
  const Grid& grid = field.crust.grid();
  CollisionUplift out{{}, {}, {}, parameters.stable_plate};
  if (out.stable_plate < 0 || plates == 0) out.stable_plate = slowest_plate(transport);
  Raster<float> thickening =
      smoothed_thickening(field, convergence, parameters.crust_smoothing, context);
  const float most = greatest(thickening, context);
  const bool thickens = most > kNoThickening;
  std::vector<Polyline> lines;
  if (thickens && parameters.fault)
    lines = lay_fault(transport, field, thickening, float(parameters.fault_level) * most,
                      out.stable_plate, parameters.fault_offset, out.fault, context);
  else
    out.fault = Raster<float>(grid, float(grid.width() + grid.height()));
  if (!thickens) {
    out.uplift_rate = Raster<float>(grid);
    return out;
  }
  out.uplift_rate = std::move(thickening);

  std::vector<char> oceanic;
  for (const RigidPlate& plate : transport.plates())
    oceanic.push_back(plate.crust == PlateCrust::Oceanic);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      float& u = out.uplift_rate(r, c);
      if (!(u > 0.0f) || out.fault(r, c) < 0.0f || oceanic[field.plate(r, c)]) u = 0.0f;
    }
  });
  const float least = kUplifted * greatest(out.uplift_rate, context);
  const auto& u = out.uplift_rate;
  const double sum = parallel_sum(context, u.size(),
                                  [&](std::size_t i) { return u[i] > least ? double(u[i]) : 0.0; });
  const double count =
      parallel_sum(context, u.size(), [&](std::size_t i) { return u[i] > least ? 1.0 : 0.0; });
  if (count == 0.0) return out;  // oceanic plates alone
  for (const Polyline& line : lines) keep_rising(line, out.uplift_rate, least, out.fault_lines);
  const float scale = float(parameters.target_uplift_rate * count / sum);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) out.uplift_rate(r, c) *= scale;
  });
  return out;
}

}  // namespace orogen
