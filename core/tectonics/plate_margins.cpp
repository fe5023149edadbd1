#include "tectonics/plate_margins.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "foundation/distance_transform.h"
#include "foundation/gaussian_blur.h"
#include "foundation/parallel.h"
#include "foundation/random.h"
#include "tectonics/collision_uplift.h"

namespace orogen {

namespace {

// A place on the border of two influence regions.
struct Margin {
  glm::dvec2 position;
  int lower = -1, upper = -1;            // plates, where one dives under the other
  glm::dvec2 to_upper{0.0, 0.0};         // unit normal
  double opening = 0.0;                  // m a step
  float rift = 0.0f, subduction = 0.0f;  // activity, [0, 1]
};

double dot(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.x + a.y * b.y;
}

glm::dvec2 away_from(const TransportField& transport, int plate, glm::dvec2 p) {
  const glm::dvec2 d = p - nearest_on_hull(transport.plates()[plate].moved_hull, p);
  const double length = std::sqrt(dot(d, d));
  return length > 0.0 ? d / length : glm::dvec2(0.0);
}

// Whether plate i dives under plate j.
bool dives(const TransportField& transport, int i, int j) {
  const RigidPlate &a = transport.plates()[i], &b = transport.plates()[j];
  if (a.crust != b.crust) return a.crust == PlateCrust::Oceanic;
  const double fast = a.displacement(), slow = b.displacement();
  return a.crust == PlateCrust::Oceanic && (fast > slow || (fast == slow && i > j));
}

// The border between two cells that lie nearest to plates i and j.
Margin margin_between(const TransportField& transport, glm::dvec2 at_i, int i, glm::dvec2 at_j,
                      int j) {
  const double before = transport.distance(j, at_i) - transport.distance(i, at_i);
  const double after = transport.distance(i, at_j) - transport.distance(j, at_j);
  const double t = before + after > 0.0 ? before / (before + after) : 0.5;
  Margin m;
  m.position = at_i + t * (at_j - at_i);
  glm::dvec2 normal = away_from(transport, i, m.position) - away_from(transport, j, m.position);
  const double length = std::sqrt(dot(normal, normal));
  if (length > 0.0) normal /= length;
  m.opening =
      dot(transport.plate_displacement(j, m.position) - transport.plate_displacement(i, m.position),
          normal);
  if (dives(transport, i, j)) {
    m.lower = i;
    m.upper = j;
    m.to_upper = normal;
  } else if (dives(transport, j, i)) {
    m.lower = j;
    m.upper = i;
    m.to_upper = -normal;
  }
  return m;
}

std::vector<Margin> trace_margins(const TransportField& transport, const CompressionField& field,
                                  const Raster<float>& thickening, const Context& context) {
  const Grid& grid = field.plate.grid();
  std::vector<std::vector<Margin>> rows(grid.ny);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c)
      for (const auto& [up, across] : {std::pair{0, 1}, std::pair{1, 0}}) {
        const int k = r + up, l = c + across;
        if (!grid.contains(k, l) || field.plate(r, c) == field.plate(k, l)) continue;
        Margin m = margin_between(transport, grid.center(r, c), field.plate(r, c),
                                  grid.center(k, l), field.plate(k, l));
        const float change = 0.5f * (thickening(r, c) + thickening(k, l));
        if (m.opening > 0.0) m.rift = std::max(-change, 0.0f);
        if (m.opening < 0.0 && m.lower >= 0) m.subduction = std::max(change, 0.0f);
        rows[r].push_back(m);
      }
  });
  std::vector<Margin> margins;
  float most_rift = 1e-5f, most_subduction = 1e-5f;  // less is no motion
  for (const auto& row : rows)
    for (const Margin& m : row) {
      most_rift = std::max(most_rift, m.rift);
      most_subduction = std::max(most_subduction, m.subduction);
      margins.push_back(m);
    }
  for (Margin& m : margins) {
    m.rift /= most_rift;
    m.subduction /= most_subduction;
  }
  return margins;
}

struct Profiles {
  explicit Profiles(const MarginParameters& parameters) : p(parameters) {}

  double rift(double d) const {
    const double ratio = d / p.rift_width, square = ratio * ratio, v = 2.414 * square * square;
    return p.rift_depth * (v - 1.0) / (1.0 + v * v);
  }
  double lower_plate(double d) const {
    const double x = d / p.trench_width;
    return -p.trench_depth * std::exp(-x) * (std::cos(x) + std::sin(x));
  }
  double upper_plate(double d) const {
    const double x = d / p.trench_width, y = (d - p.arc_distance) / p.arc_width;
    return -p.trench_depth * std::exp(-4.0 * x * x) + p.arc_height * std::exp(-0.5 * y * y);
  }

  const MarginParameters& p;
};

// Where volcanoes stand: behind the trench, apart by the spacing, give or take a quarter.
std::vector<std::pair<glm::dvec2, float>> place_volcanoes(const std::vector<Margin>& margins,
                                                          const CompressionField& field,
                                                          const Raster<float>& distance,
                                                          const MarginParameters& p,
                                                          std::uint32_t seed) {
  constexpr float kLeastActivity = 0.1f;
  const Grid& grid = distance.grid();
  std::vector<std::pair<glm::dvec2, float>> placed;
  for (std::size_t k = 0; k < margins.size(); ++k) {
    const Margin& m = margins[k];
    if (m.subduction < kLeastActivity) continue;
    const std::uint64_t number = placed.size();
    const double aside = 0.4 * p.arc_width * (2.0 * random_uniform(seed, 0, number) - 1.0);
    const double spacing = p.volcano_spacing * (0.75 + 0.5 * random_uniform(seed, 1, number));
    const glm::dvec2 place = m.position + (p.arc_distance + aside) * m.to_upper;
    const int r = grid.row_of(place.y), c = grid.column_of(place.x);
    if (!grid.contains(r, c) || field.plate(r, c) != m.upper) continue;
    if (distance(r, c) < 0.9 * p.arc_distance + aside) continue;  // another stretch is nearer
    const bool apart = std::all_of(placed.begin(), placed.end(), [&](const auto& other) {
      return dot(place - other.first, place - other.first) >= spacing * spacing;
    });
    if (apart) placed.push_back({place, m.subduction});
  }
  return placed;
}

void raise_volcano(Raster<float>& rate, glm::dvec2 place, double height, double radius) {
  const Grid& grid = rate.grid();
  const int low = std::max(grid.row_of(place.y - radius), 0);
  const int high = std::min(grid.row_of(place.y + radius), grid.ny - 1);
  const int left = std::max(grid.column_of(place.x - radius), 0);
  const int right = std::min(grid.column_of(place.x + radius), grid.nx - 1);
  for (int r = low; r <= high; ++r)
    for (int c = left; c <= right; ++c) {
      const glm::dvec2 d = grid.center(r, c) - place;
      const double rest = 1.0 - std::sqrt(dot(d, d)) / radius;
      if (rest > 0.0) rate(r, c) += float(height * rest * std::sqrt(rest));
    }
}

}  // namespace

PlateMargins plate_margins(const TransportField& transport, const CompressionField& field,
                           const MarginParameters& parameters, std::uint32_t seed,
                           const Context& context) {
  check_parameters(parameters, "margins");
  const Grid& grid = field.plate.grid();
  PlateMargins out{Raster<float>(grid), {}};
  const double smoothing = parameters.margin_smoothing;
  const Raster<float> thickening = smoothed_thickening(
      field, plate_convergence(transport, grid, smoothing, context), smoothing, context);
  const std::vector<Margin> margins = trace_margins(transport, field, thickening, context);
  const auto rests = [](const Margin& m) { return m.rift == 0.0f && m.subduction == 0.0f; };
  if (std::ranges::all_of(margins, rests)) return out;
  std::vector<glm::dvec2> places;
  for (const Margin& m : margins) places.push_back(m.position);
  const NearestFeature near = nearest_point(places, grid, context);
  Raster<float> rift(grid), subduction(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      rift(r, c) = margins[near.nearest(r, c)].rift;
      subduction(r, c) = margins[near.nearest(r, c)].subduction;
    }
  });
  rift = gaussian_blur(rift, smoothing, context);
  subduction = gaussian_blur(subduction, smoothing, context);
  const Profiles profiles(parameters);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const Margin& m = margins[near.nearest(r, c)];
      const double d = near.distance(r, c);
      double height = rift(r, c) > 0.0f ? rift(r, c) * profiles.rift(d) : 0.0;
      if (subduction(r, c) > 0.0f && field.plate(r, c) == m.lower)
        height += subduction(r, c) * profiles.lower_plate(d);
      if (subduction(r, c) > 0.0f && field.plate(r, c) == m.upper)
        height += subduction(r, c) * profiles.upper_plate(d);
      out.uplift_rate(r, c) = float(height / parameters.growth_time);
    }
  });
  for (const auto& [place, activity] :
       place_volcanoes(margins, field, near.distance, parameters, seed)) {
    out.volcanoes.push_back(place);
    raise_volcano(out.uplift_rate, place,
                  activity * parameters.volcano_height / parameters.growth_time,
                  parameters.volcano_radius);
  }
  return out;
}

}  // namespace orogen
