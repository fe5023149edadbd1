#include "vegetation/placement.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <string>

#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/random.h"
#include "vegetation/plant_ground.h"
#include "vegetation/plant_rates.h"

namespace orogen {

namespace {

constexpr double kSquareMetres = 1e4;   // a hectare
constexpr double kTriesASpot = 2.0;     // at least, of the mean
constexpr double kPoissonPiece = 64.0;  // a larger mean is drawn in pieces
constexpr int kBandRows = 32;           // spots
constexpr std::uint64_t kNumbersATry = 8;

struct Try {
  float x, y, z;  // m
  std::uint32_t rank;
  std::uint32_t number;  // in its spot
  std::uint8_t kind;
};

/// Everything that says where plants go.
struct Rules {
  const PlantGround& ground;
  const PlantTable& table;
  PlantRates rates;
  std::vector<KindLimits> limits;
  PlantRegion region;
  std::uint64_t seed;
  double side = 0.0;                     // m, of a spot
  int rows = 0;                          // of spots, over the grid
  int first_column = 0, end_column = 0;  // of spots that are looked at

  std::uint64_t stream(int row, int column) const {
    return std::uint64_t(row) << 32 | std::uint32_t(column);
  }
};

/// A Poisson number, from a stream of its own (Knuth's product of uniforms).
int poisson(double mean, std::uint64_t seed, std::uint64_t stream) {
  int count = 0;
  std::uint64_t counter = 0;
  for (; mean > 0.0; mean -= kPoissonPiece) {
    const double end = std::exp(-std::min(mean, kPoissonPiece));
    double product = random_uniform(seed, stream, counter++);
    for (; product > end; product *= random_uniform(seed, stream, counter++)) ++count;
  }
  return count;
}

/// Spots in rows `first` to `end`, with a row more on either side to compare with.
class Band {
 public:
  Band(const Rules& rules, int first, int end)
      : rules_(rules), first_(first), end_(end), low_(std::max(first - 1, 0)) {
    const int high = std::min(end + 1, rules.rows);
    start_.push_back(0);
    for (int row = low_; row < high; ++row)
      for (int column = rules.first_column; column < rules.end_column; ++column) {
        fill_spot(row, column);
        start_.push_back(tries_.size());
      }
  }

  /// Adds what stays, and lies in the region, to a cloud.
  void add_to(PlantCloud& cloud) const {
    for (int row = first_; row < end_; ++row)
      for (int column = rules_.first_column; column < rules_.end_column; ++column)
        for (std::size_t i = start_[spot(row, column)]; i < start_[spot(row, column) + 1]; ++i)
          if (in_region(tries_[i]) && stays(i, row, column))
            add(cloud, tries_[i], rules_.stream(row, column));
  }

 private:
  std::size_t spot(int row, int column) const {
    return std::size_t(row - low_) * (rules_.end_column - rules_.first_column) +
           (column - rules_.first_column);
  }

  double number(std::uint64_t stream, std::uint64_t of_try, std::uint64_t which) const {
    return random_uniform(rules_.seed, ~stream, kNumbersATry * of_try + which);
  }

  bool nothing_grows(int row, int column) const {
    const Grid& grid = rules_.ground.elevation.grid();
    const auto cell = [&](double at, int cells, int more) {
      return std::clamp(int(at * rules_.side / grid.cell_size) + more, 0, cells - 1);
    };
    for (int r = cell(row, grid.ny, -1); r <= cell(row + 1, grid.ny, 1); ++r)
      for (int c = cell(column, grid.nx, -1); c <= cell(column + 1, grid.nx, 1); ++c)
        if (rules_.rates.of_biome(std::size_t(rules_.ground.biome(r, c))) > 0.0) return false;
    return true;
  }

  void fill_spot(int row, int column) {
    if (nothing_grows(row, column)) return;
    const std::uint64_t stream = rules_.stream(row, column);
    const int count = poisson(rules_.rates.most * rules_.side * rules_.side, rules_.seed, stream);
    for (int n = 0; n < count; ++n) {
      Try made{};
      made.x = float((column + number(stream, n, 0)) * rules_.side);
      made.y = float((row + number(stream, n, 1)) * rules_.side);
      made.number = std::uint32_t(n);
      if (grow(made, stream)) tries_.push_back(made);
    }
  }

  /// Draws kind and rank; false if nothing grows there.
  bool grow(Try& made, std::uint64_t stream) const {
    const Raster<float>& elevation = rules_.ground.elevation;
    const Grid& grid = elevation.grid();
    if (made.x >= grid.width() || made.y >= grid.height()) return false;
    const Bilinear at(glm::dvec2(made.x, made.y) / grid.cell_size - 0.5, grid.nx, grid.ny);
    const std::size_t nearest = grid.index(at.v < 0.5 ? at.r0 : at.r1, at.u < 0.5 ? at.c0 : at.c1);
    if (is_bare(rules_.ground, nearest)) return false;
    const int r = number(stream, made.number, 2) < at.v ? at.r1 : at.r0;
    const int c = number(stream, made.number, 3) < at.u ? at.c1 : at.c0;
    const auto& rates = rules_.rates.up_to_kind[std::size_t(rules_.ground.biome(r, c))];
    const double drawn = number(stream, made.number, 4) * rules_.rates.most;
    const auto kind = std::upper_bound(rates.begin(), rates.end(), drawn);
    if (kind == rates.end()) return false;
    made.kind = std::uint8_t(kind - rates.begin());
    const Site site = site_at(elevation, at);
    if (number(stream, made.number, 5) >= rules_.limits[made.kind].share(site)) return false;
    made.z = float(site.height);
    made.rank =
        std::uint32_t(random_bits(rules_.seed, ~stream, kNumbersATry * made.number + 6) >> 32);
    return true;
  }

  bool in_region(const Try& one) const {
    const PlantRegion& region = rules_.region;
    return one.x >= region.low.x && one.y >= region.low.y && one.x < region.high.x &&
           one.y < region.high.y;
  }

  /// No try of a higher rank stands too near.
  bool stays(std::size_t i, int row, int column) const {
    const int left = std::max(column - 1, rules_.first_column);
    const int right = std::min(column + 1, rules_.end_column - 1);
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rules_.rows - 1); ++r)
      for (std::size_t j = start_[spot(r, left)]; j < start_[spot(r, right) + 1]; ++j)
        if (j != i && std::pair(tries_[j].rank, j) > std::pair(tries_[i].rank, i) &&
            too_near(tries_[i], tries_[j]))
          return false;
    return true;
  }

  bool too_near(const Try& a, const Try& b) const {
    const auto& kinds = rules_.table.kinds;
    const double d = 0.5 * (kinds[a.kind].spacing + kinds[b.kind].spacing);
    const double dx = double(a.x) - b.x, dy = double(a.y) - b.y;
    return dx * dx + dy * dy < d * d;
  }

  void add(PlantCloud& cloud, const Try& one, std::uint64_t stream) const {
    const PlantKind& kind = rules_.table.kinds[one.kind];
    const std::uint64_t turn = one.number | std::uint64_t(1) << 32;  // numbers of their own
    cloud.positions.push_back({one.x, one.y, one.z});
    cloud.kinds.push_back(one.kind);
    cloud.scales.push_back(
        float(kind.min_scale + (kind.max_scale - kind.min_scale) * number(stream, turn, 0)));
    cloud.rotations.push_back(float(2.0 * std::numbers::pi * number(stream, turn, 1)));
  }

  const Rules& rules_;
  int first_, end_, low_;
  std::vector<Try> tries_;
  std::vector<std::size_t> start_;  // of spots, row by row from low_
};

void check_ground(const PlantGround& ground) {
  const Grid& grid = ground.biome.grid();
  for (std::size_t i = 0; i < ground.biome.size(); ++i)
    if (ground.biome[i] < 0 || ground.biome[i] >= kBiomes)
      throw InputError("biome: row " + std::to_string(i / grid.nx) + ", column " +
                       std::to_string(i % grid.nx) + ": " + std::to_string(ground.biome[i]) +
                       " is not allowed; 0 to " + std::to_string(kBiomes - 1) + " is wanted");
}

std::array<bool, kBiomes> biomes_of(const PlantGround& ground) {
  std::array<bool, kBiomes> there{};
  for (const std::int32_t biome : ground.biome.values()) there[std::size_t(biome)] = true;
  return there;
}

/// How much of a row's or column's width lies between two places.
double overlap(int cell, double cell_size, double low, double high) {
  return std::max(std::min((cell + 1) * cell_size, high) - std::max(cell * cell_size, low), 0.0);
}

/// Plants that a density (a hectare) asks for in a region.
double expected(const Raster<float>& density, const PlantRegion& region, const Context& context) {
  const Grid& grid = density.grid();
  const auto inside = [&](std::size_t i) {
    return overlap(int(i % grid.nx), grid.cell_size, region.low.x, region.high.x) *
           overlap(int(i / grid.nx), grid.cell_size, region.low.y, region.high.y);
  };
  return parallel_sum(context, density.size(),
                      [&](std::size_t i) { return density[i] * inside(i); }) /
         kSquareMetres;
}

Rules make_rules(const PlantGround& ground, const PlantTable& table, double factor,
                 const PlantRegion& region, std::uint32_t seed) {
  const Grid& grid = ground.elevation.grid();
  Rules rules{.ground = ground,
              .table = table,
              .rates = plant_rates(table, factor, biomes_of(ground)),
              .limits = limits_of(table),
              .region = region,
              .seed = seed};
  rules.side = std::sqrt(kTriesASpot / std::max(rules.rates.most, 1e-12));
  for (const PlantKind& kind : table.kinds) rules.side = std::max(rules.side, kind.spacing);
  const int columns = int(std::ceil(grid.width() / rules.side));
  rules.rows = int(std::ceil(grid.height() / rules.side));
  rules.first_column = std::clamp(int(region.low.x / rules.side) - 1, 0, columns);
  rules.end_column = std::clamp(int(region.high.x / rules.side) + 2, 0, columns);
  return rules;
}

PlantCloud joined(const std::vector<PlantCloud>& parts) {
  PlantCloud all;
  for (const PlantCloud& part : parts) {
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
    all.kinds.insert(all.kinds.end(), part.kinds.begin(), part.kinds.end());
    all.scales.insert(all.scales.end(), part.scales.begin(), part.scales.end());
    all.rotations.insert(all.rotations.end(), part.rotations.begin(), part.rotations.end());
  }
  return all;
}

}  // namespace

PlantCloud place_plants(const PlantGround& ground, const PlantTable& table,
                        const PlacementParameters& parameters,
                        const std::optional<PlantRegion>& region, std::uint32_t seed,
                        const Context& context) {
  const Raster<float> density = plant_density(ground, table, parameters, context);
  const Grid& grid = density.grid();
  PlantRegion where{{0.0, 0.0}, {grid.width(), grid.height()}};
  if (region)
    where = {glm::max(where.low, region->low),
             glm::max(where.low, glm::min(where.high, region->high))};
  const double asked = expected(density, where, context);
  const double share = asked > parameters.most_plants ? parameters.most_plants / asked : 1.0;
  const Rules rules = make_rules(ground, table, share * parameters.density_factor, where, seed);
  const int first = std::clamp(int(where.low.y / rules.side), 0, rules.rows);
  const int end = std::clamp(int(where.high.y / rules.side) + 1, 0, rules.rows);
  const int first_band = first / kBandRows, end_band = (end + kBandRows - 1) / kBandRows;
  std::vector<PlantCloud> parts(std::size_t(std::max(end_band - first_band, 0)));
  parallel_chunks(context, parts.size(), 1, [&](std::size_t begin, std::size_t) {
    const int low = (first_band + int(begin)) * kBandRows;
    Band(rules, low, std::min(low + kBandRows, rules.rows)).add_to(parts[begin]);
  });
  PlantCloud cloud = joined(parts);
  cloud.density_share = share;
  return cloud;
}

Raster<float> plant_density(const PlantGround& ground, const PlantTable& table,
                            const PlacementParameters& parameters, const Context& context) {
  check_parameters(parameters);
  check_plant_table(table, "plants");
  check_ground(ground);
  const Grid& grid = ground.elevation.grid();
  const std::vector<KindLimits> limits = limits_of(table);
  std::array<std::vector<double>, kBiomes> wanted;
  for (std::size_t b = 0; b < wanted.size(); ++b)
    wanted[b] = wanted_plants(table, b, parameters.density_factor);
  Raster<float> density(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const std::size_t i = grid.index(r, c);
      if (is_bare(ground, i)) continue;
      const Site site = site_at(ground.elevation, Bilinear({c, r}, grid.nx, grid.ny));
      double sum = 0.0;
      for (std::size_t k = 0; k < limits.size(); ++k)
        if (const double plants = wanted[std::size_t(ground.biome[i])][k]; plants > 0.0)
          sum += plants * limits[k].share(site);
      density[i] = float(kSquareMetres * sum);
    }
  });
  return density;
}

}  // namespace orogen
