// Landslides on a TIN. Vertices are looked at in chunks, which lie together in space; a chunk is
// left alone while nothing in it or beside it moves.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "erosion/tin_hillslope.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr std::size_t kChunk = 1024;
constexpr double kLeastMove = 1e-3;  // m; an edge that is steeper by less is at rest

void check_slides(const Tin& tin, std::span<const double> elevation, const VertexValues& talus,
                  double dt_years) {
  if (!(dt_years >= 0.0))
    throw InputError("dt_years: " + std::to_string(dt_years) + " yr is not at least 0");
  if (elevation.size() != tin.size())
    throw InputError("elevation: " + std::to_string(elevation.size()) + " values, the TIN has " +
                     std::to_string(tin.size()) + " vertices");
  talus.check(tin.size(), "talus_slope");
}

class Slides {
 public:
  Slides(const Tin& tin, std::span<double> z, std::span<const std::uint8_t> base,
         const VertexValues& talus, double loosening, const Context& context)
      : tin_(tin),
        z_(z),
        base_(base),
        talus_(talus),
        loosening_(loosening),
        context_(context),
        to_(tin.size(), -1),
        excess_(tin.size()),
        given_(tin.size()),
        taken_(tin.size()),
        beside_((tin.size() + kChunk - 1) / kChunk),
        awake_(beside_.size(), 1),
        moved_(beside_.size()),
        exported_(beside_.size(), 0.0) {
    parallel_chunks(context, beside_.size(), 1, [&](std::size_t c, std::size_t) {
      for_chunk(c, [&](std::int32_t v) {
        for (std::int32_t n : tin_.neighbors_of(v)) {
          const std::int32_t other = n / std::int32_t(kChunk);
          if (std::ranges::find(beside_[c], other) == beside_[c].end()) beside_[c].push_back(other);
        }
      });
    });
  }

  /// True if anything moved.
  bool round() {
    std::fill(moved_.begin(), moved_.end(), 0);
    for_awake([&](std::size_t c) { for_chunk(c, [&](std::int32_t v) { aim(v); }); });
    wake(awake_);
    for_awake([&](std::size_t c) { for_chunk(c, [&](std::int32_t v) { take(v, c); }); });
    for_awake([&](std::size_t c) { for_chunk(c, [&](std::int32_t v) { settle(v, c); }); });
    wake(moved_);
    return std::ranges::any_of(moved_, [](std::uint8_t m) { return m != 0; });
  }

  double exported() const {  // m³
    double sum = 0.0;
    for (double e : exported_) sum += e;
    return sum;
  }

 private:
  template <class Body>
  void for_chunk(std::size_t c, Body&& body) const {
    const std::size_t last = std::min(tin_.size(), (c + 1) * kChunk);
    for (std::size_t v = c * kChunk; v < last; ++v) body(std::int32_t(v));
  }
  template <class Body>
  void for_awake(Body&& body) const {
    parallel_chunks(context_, awake_.size(), 1, [&](std::size_t c, std::size_t) {
      if (awake_[c]) body(c);
    });
  }

  /// These chunks and those beside them.
  void wake(const std::vector<std::uint8_t>& chunks) {
    std::vector<std::uint8_t> awake = chunks;
    for (std::size_t c = 0; c < chunks.size(); ++c)
      if (chunks[c])
        for (std::int32_t other : beside_[c]) awake[other] = 1;
    awake_ = std::move(awake);
  }

  /// Whom a vertex gives to: its steepest neighbour, if that is too steep.
  void aim(std::int32_t v) {
    to_[v] = -1;
    given_[v] = 0.0;
    if (base_[v]) return;
    double steepest = 0.0;
    std::int32_t edge = -1;
    for (std::int32_t e = tin_.first_edge[v]; e < tin_.first_edge[v + 1]; ++e) {
      const double slope = (z_[v] - z_[tin_.neighbors[e]]) / tin_.edge_lengths[e];
      if (slope > steepest) {
        steepest = slope;
        edge = e;
      }
    }
    const double over = steepest - talus_.at(v);
    if (edge < 0 || over * tin_.edge_lengths[edge] <= kLeastMove) return;
    to_[v] = tin_.neighbors[edge];
    excess_[v] = over * tin_.edge_lengths[edge];
    given_[v] = loosening_ * over * tin_.cell_areas[v];  // at most, see `take`
  }

  /// What a vertex gets: settles what each giver gives.
  void take(std::int32_t v, std::size_t chunk) {
    const auto neighbors = tin_.neighbors_of(v);
    const auto givers = std::ranges::count_if(neighbors, [&](auto n) { return to_[n] == v; });
    const double softness = base_[v] ? 0.0 : double(givers) / tin_.cell_areas[v];
    taken_[v] = 0.0;
    if (givers == 0) return;
    for (std::int32_t n : neighbors) {
      if (to_[n] != v) continue;
      given_[n] = std::min(given_[n], excess_[n] / (1.0 / tin_.cell_areas[n] + softness));
      taken_[v] += given_[n];
    }
    if (base_[v]) exported_[chunk] += taken_[v];
  }

  void settle(std::int32_t v, std::size_t chunk) {
    if (to_[v] < 0 && taken_[v] == 0.0) return;
    moved_[chunk] = 1;
    if (!base_[v]) z_[v] += (taken_[v] - given_[v]) / tin_.cell_areas[v];
  }

  const Tin& tin_;
  std::span<double> z_;
  std::span<const std::uint8_t> base_;
  const VertexValues& talus_;
  const double loosening_;  // m for each unit of slope in excess, a round
  const Context& context_;
  std::vector<std::int32_t> to_;
  std::vector<double> excess_, given_, taken_;     // m, m³, m³
  std::vector<std::vector<std::int32_t>> beside_;  // chunks
  std::vector<std::uint8_t> awake_, moved_;        // chunks
  std::vector<double> exported_;                   // m³, by chunk
};

}  // namespace

MassBalance landslide(const Tin& tin, std::span<double> elevation,
                      std::span<const std::uint8_t> base_level, const VertexValues& talus_slope,
                      const LandslideParameters& parameters, double dt_years,
                      const Context& context) {
  check_parameters(parameters);
  check_slides(tin, elevation, talus_slope, dt_years);
  if (base_level.size() != tin.size())
    throw InputError("base_level: " + std::to_string(base_level.size()) + " values, the TIN has " +
                     std::to_string(tin.size()) + " vertices");
  const double loosening =
      std::isinf(dt_years) ? dt_years : parameters.landslide_rate * dt_years / parameters.rounds;
  if (loosening == 0.0) return {};
  const std::vector<double> start(elevation.begin(), elevation.end());
  Slides slides(tin, elevation, base_level, talus_slope, loosening, context);
  for (int i = 0; i < parameters.rounds && slides.round(); ++i) {
  }
  return balance_of(tin, start, elevation, slides.exported());
}

MassBalance shed_landslides(const TinFlow& flow, std::span<double> elevation,
                            const VertexValues& talus_slope, double landslide_rate, double dt_years,
                            const Context& context, std::span<double> debris) {
  const Tin& tin = flow.tin();
  check_slides(tin, elevation, talus_slope, dt_years);
  if (!(landslide_rate >= 0.0 && std::isfinite(landslide_rate)))
    throw InputError("landslide_rate: " + std::to_string(landslide_rate) +
                     " m/yr is not finite and at least 0");
  if (!debris.empty() && debris.size() != tin.size())
    throw InputError("debris: " + std::to_string(debris.size()) + " values, the TIN has " +
                     std::to_string(tin.size()) + " vertices");
  std::vector<double> lost(flow.part_count(), 0.0);
  flow.visit(context, [&](const FlowTrees& part, std::size_t p) {
    for (std::size_t k = part.roots; k < part.vertices.size(); ++k) {
      const std::int32_t v = part.vertices[k];
      const double length = flow.distances()[v], below = elevation[flow.receivers()[v]];
      const double above = elevation[v] - below, stable = talus_slope.at(v) * length;
      if (!(above > stable)) continue;
      const double pull = landslide_rate * dt_years / length;
      const double left = std::isinf(dt_years) ? stable : (above + pull * stable) / (1.0 + pull);
      const double volume = (above - left) * tin.cell_areas[v];
      lost[p] += volume;
      if (!debris.empty()) debris[flow.receivers()[v]] += volume;
      elevation[v] = below + left;
    }
  });
  MassBalance result;
  for (double volume : lost) result.eroded_m3 += volume;
  result.exported_m3 = result.eroded_m3;
  return result;
}

}  // namespace orogen
