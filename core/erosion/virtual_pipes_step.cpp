// One step of a run, tile by tile. A tile works out the fluxes it needs from its neighbours' cells
// itself, so that tiles need nothing of each other within a step.
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>

#include "erosion/virtual_pipes_state.h"
#include "foundation/parallel.h"
#include "foundation/random.h"

namespace orogen::pipes {

namespace {

constexpr int kReach = kTileColumns + 4;
constexpr int kRing = 8;  // rows that are kept of each scratch field: they stay in the first cache

template <class Real>
struct Scratch {
  // The last rows, columns from two left of the tile.
  std::vector<Real> rel, flux_x, flux_y, scale, concentration;
  std::vector<Real> x, sx, south, s_south, north, s_north, spare;  // of one row
  std::vector<Real> rain, evaporated, ease_erosion, hold_erosion, ease_deposition;
  std::vector<Real> zeros, ones, endless;

  Scratch() {
    for (auto* v : {&rel, &flux_x, &flux_y, &scale, &concentration})
      v->assign(std::size_t(kRing) * kReach, Real(0));
    for (auto* v : {&x, &sx, &south, &s_south, &north, &s_north, &spare, &rain, &evaporated,
                    &ease_erosion, &hold_erosion, &ease_deposition, &zeros})
      v->assign(kReach, Real(0));
    ones.assign(kReach, Real(1));
    endless.assign(kReach, Real(1e30));
  }
};

/// Sediment that reaches a sink stays there up to the sea's level.
template <class Real>
void fill_sea(PipeState<Real>& s, std::size_t i) {
  s.sea_room[i] = std::max(s.sea_room[i] - s.suspended.next[i], Real(0));
}

/// A tile at work on a step.
template <class Real>
class TileStep {
 public:
  TileStep(PipeState<Real>& state, const Tile& tile, TileSums& sums, Scratch<Real>& scratch,
           std::uint32_t rain_key)
      : s_(state),
        tile_(tile),
        sums_(sums),
        x_(scratch),
        rain_key_(rain_key),
        n_(tile.column1 - tile.column0) {}

  void run() {
    const int first = tile_.row0 - 1;
    for (int r = first - 1; r <= first + 1; ++r) bed(r);
    wanted_north(first - 1);
    wanted_fluxes(first);
    for (int r = first; r < tile_.row1; ++r) {
      bed(r + 2);
      wanted_fluxes(r + 1);
      std::swap(x_.south, x_.north);
      std::swap(x_.s_south, x_.s_north);
      edges_north(r);
      if (r < tile_.row0) continue;
      edges_east(r);
      export_through_sides(r);
      ease(r);
      update(r);
    }
    empty_sinks();
  }

 private:
  // Index of column `column0 + shift` of a row, in the state and in the scratch.
  std::size_t at(int row, int shift = 0) const {
    return std::size_t(std::ptrdiff_t(s_.shape.index(row, tile_.column0)) + shift);
  }
  Real* line(std::vector<Real>& v, int row, int shift = 0) const {
    return v.data() + std::size_t((row + kRing) % kRing) * kReach + 2 + shift;
  }
  const Real* optional(const std::vector<Real>& field, int row, const std::vector<Real>& other) {
    return field.empty() ? other.data() : field.data() + at(row);
  }
  bool at_west() const { return tile_.column0 == 0; }
  bool at_east() const { return tile_.column1 == s_.shape.nx; }
  bool at_south() const { return tile_.row0 == 0; }
  bool at_north() const { return tile_.row1 == s_.shape.ny; }

  /// Change of the bed; outside closed sides that of the cell inside.
  void bed(int r) {
    const std::size_t from = at(s_.open_sides ? r : std::clamp(r, 0, s_.shape.ny - 1), -2);
    subtract_row(&s_.sediment.now[from], &s_.wear.now[from], line(x_.rel, r, -2), n_ + 4);
    if (s_.open_sides) return;
    if (at_west()) *line(x_.rel, r, -1) = *line(x_.rel, r, 0);
    if (at_east()) *line(x_.rel, r, n_) = *line(x_.rel, r, n_ - 1);
  }

  FluxRow<Real> pipes(std::size_t a, std::size_t b, const Real* rel_a, const Real* rel_b,
                      const std::vector<Real>& old_flux, Real* flux) const {
    return {&s_.base[a],      &s_.base[b],      rel_a,        rel_b,
            &s_.depth.now[a], &s_.depth.now[b], &old_flux[a], flux};
  }

  /// Fluxes to the north as the pressures want them, and one column around the tile's.
  void wanted_north(int r) {
    const bool wall = !s_.open_sides && (r == -1 || r == s_.shape.ny - 1);
    Real* flux = line(x_.flux_y, r, -1);
    if (wall)
      std::fill_n(flux, n_ + 2, Real(0));
    else
      flux_row(pipes(at(r, -1), at(r + 1, -1), line(x_.rel, r, -1), line(x_.rel, r + 1, -1),
                     s_.flux_y.now, flux),
               s_.k, n_ + 2);
  }

  /// The row's fluxes to the east and to the north, and what its cells can give of them.
  void wanted_fluxes(int r) {
    flux_row(pipes(at(r, -2), at(r, -1), line(x_.rel, r, -2), line(x_.rel, r, -1), s_.flux_x.now,
                   line(x_.flux_x, r, -2)),
             s_.k, n_ + 3);
    if (!s_.open_sides && at_west()) *line(x_.flux_x, r, -1) = 0;
    if (!s_.open_sides && at_east()) *line(x_.flux_x, r, n_ - 1) = 0;
    wanted_north(r);
    limit_row(LimitRow<Real>{line(x_.flux_x, r, -2), line(x_.flux_x, r, -1),
                             line(x_.flux_y, r - 1, -1), line(x_.flux_y, r, -1),
                             &s_.depth.now[at(r, -1)], &s_.suspended.now[at(r, -1)],
                             line(x_.scale, r, -1), line(x_.concentration, r, -1)},
              s_.k, n_ + 2);
    if (s_.traced) std::fill_n(line(x_.concentration, r, -1), n_ + 2, Real(0));
  }

  EdgeRow<Real> edges(const Real* wanted, int r, int shift, int up, int right) const {
    return {wanted,
            line(x_.scale, r, shift),
            line(x_.scale, r + up, shift + right),
            line(x_.concentration, r, shift),
            line(x_.concentration, r + up, shift + right),
            nullptr,
            nullptr,
            nullptr};
  }

  /// Final fluxes through the row's edges, from the western edge of the first cell, which is
  /// another tile's to keep.
  void edges_east(int r) {
    EdgeRow<Real> west = edges(line(x_.flux_x, r, -1), r, -1, 0, 1);
    west.flux = x_.x.data();
    west.sediment_flux = x_.sx.data();
    west.kept = at_west() ? &s_.flux_x.next[at(r, -1)] : x_.spare.data();
    edge_row(west, 1);
    EdgeRow<Real> rest = edges(line(x_.flux_x, r), r, 0, 0, 1);
    rest.flux = x_.x.data() + 1;
    rest.sediment_flux = x_.sx.data() + 1;
    rest.kept = &s_.flux_x.next[at(r)];
    edge_row(rest, n_);
  }

  /// Final fluxes from a row to the one north of it.
  void edges_north(int r) {
    EdgeRow<Real> north = edges(line(x_.flux_y, r), r, 0, 1, 0);
    north.flux = x_.north.data();
    north.sediment_flux = x_.s_north.data();
    north.kept = r >= tile_.row0 || at_south() ? &s_.flux_y.next[at(r)] : x_.spare.data();
    edge_row(north, n_);
  }

  void leave(Real water, Real sediment) {
    sums_.exported_water += double(s_.k.lambda) * double(water);
    sums_.exported_sediment += double(s_.k.lambda) * double(sediment);
  }

  void export_through_sides(int r) {
    if (!s_.open_sides) return;
    if (at_west()) leave(-x_.x[0], -x_.sx[0]);
    if (at_east()) leave(x_.x[std::size_t(n_)], x_.sx[std::size_t(n_)]);
    if (r == 0)
      for (int i = 0; i < n_; ++i) leave(-x_.south[std::size_t(i)], -x_.s_south[std::size_t(i)]);
    if (r == s_.shape.ny - 1)
      for (int i = 0; i < n_; ++i) leave(x_.north[std::size_t(i)], x_.s_north[std::size_t(i)]);
  }

  /// Paper B, eq. 24: powers of two of the change so far.
  void ease(int r) {
    const double erosion = s_.erosion_halving_depth, deposition = s_.deposition_halving_depth;
    if (!(erosion > 0.0 || deposition > 0.0)) return;
    const Real* first = optional(s_.original_sediment, r, x_.zeros);
    for (int i = 0; i < n_; ++i) {
      const std::size_t j = std::size_t(i);
      const Real rise = *line(x_.rel, r, i) - first[i];
      x_.ease_erosion[j] = erosion > 0.0 ? std::exp2(rise / Real(erosion)) : Real(1);
      x_.ease_erosion[j] = std::clamp(x_.ease_erosion[j], Real(1e-12), s_.k.sediment_cost);
      x_.hold_erosion[j] = 1 / x_.ease_erosion[j];
      x_.ease_deposition[j] = deposition > 0.0 ? std::exp2(-rise / Real(deposition)) : Real(1);
    }
  }

  void update(int r) {
    const std::size_t i = at(r);
    const bool eased = s_.erosion_halving_depth > 0.0 || s_.deposition_halving_depth > 0.0;
    UpdateRow<Real> row{
        x_.x.data(),
        x_.x.data() + 1,
        x_.south.data(),
        x_.north.data(),
        x_.sx.data(),
        x_.sx.data() + 1,
        x_.s_south.data(),
        x_.s_north.data(),
        &s_.base[i],
        &s_.base[at(r - 1)],
        &s_.base[at(r + 1)],
        line(x_.rel, r),
        line(x_.rel, r - 1),
        line(x_.rel, r + 1),
        &s_.depth.now[i],
        &s_.suspended.now[i],
        &s_.sediment.now[i],
        &s_.wear.now[i],
        optional(s_.original_sediment, r, x_.zeros),
        &s_.code[i],
        optional(s_.floor, r, x_.endless),
        optional(s_.moisture, r, x_.ones),
        optional(s_.temperature, r, x_.ones),
        eased ? x_.ease_erosion.data() : x_.ones.data(),
        eased ? x_.hold_erosion.data() : x_.ones.data(),
        eased ? x_.ease_deposition.data() : x_.ones.data(),
        rain_key_,
        std::uint32_t(r) * std::uint32_t(s_.shape.nx) + std::uint32_t(tile_.column0),
        &s_.depth.next[i],
        &s_.carry[i],
        &s_.suspended.next[i],
        &s_.sediment.next[i],
        &s_.wear.next[i],
        x_.rain.data(),
        x_.evaporated.data()};
    update_row(row, s_.k, n_);
    sums_.rain += sum_row(x_.rain.data(), n_);
    sums_.evaporated += sum_row(x_.evaporated.data(), n_);
  }

  /// What reached the sea leaves.
  void empty_sinks() {
    for (const std::size_t i : tile_.sinks) {
      sums_.exported_water += double(s_.depth.next[i]) + double(s_.carry[i]);
      sums_.exported_sediment += double(s_.suspended.next[i]);
      if (!s_.sea_room.empty()) fill_sea(s_, i);
      s_.depth.next[i] = s_.carry[i] = s_.suspended.next[i] = 0;
    }
  }

  PipeState<Real>& s_;
  const Tile& tile_;
  TileSums& sums_;
  Scratch<Real>& x_;
  std::uint32_t rain_key_;
  int n_;
};

/// Moves on to the next layer of rock where one has been worn through.
template <class Real>
void expose_layers(PipeState<Real>& s, const Tile& tile) {
  for (int r = tile.row0; r < tile.row1; ++r)
    for (int c = tile.column0; c < tile.column1; ++c) {
      const std::size_t i = s.shape.index(r, c);
      if (s.code[i] >= 0 && s.wear.now[i] >= s.floor[i]) s.expose(r, c);
    }
}

/// Semi-Lagrangian transport (paper B, eq. 21): sediment comes from where the water was.
template <class Real>
void trace_tile(PipeState<Real>& s, const Tile& tile, TileSums& sums) {
  const auto component = [&](Real a, Real b, Real depth) {
    const Real cells = Real(0.5) * (a + b) * s.k.lambda / std::max(depth, Real(1e-6));
    return std::clamp(cells, Real(-1), Real(1));
  };
  const std::vector<Real>& from = s.suspended.now;
  for (int r = tile.row0; r < tile.row1; ++r)
    for (int c = tile.column0; c < tile.column1; ++c) {
      const std::size_t i = s.shape.index(r, c), south = i - s.shape.stride;
      const Real u = component(s.flux_x.now[i - 1], s.flux_x.now[i], s.depth.now[i]);
      const Real v = component(s.flux_y.now[south], s.flux_y.now[i], s.depth.now[i]);
      const std::size_t side = u > 0 ? i - 1 : i + 1;
      const std::ptrdiff_t up = (v > 0 ? -1 : 1) * std::ptrdiff_t(s.shape.stride);
      const Real fx = std::abs(u), fy = std::abs(v);
      const Real here = from[i] + fx * (from[side] - from[i]);
      const std::size_t j = std::size_t(std::ptrdiff_t(i) + up);
      const std::size_t side_j = std::size_t(std::ptrdiff_t(side) + up);
      const Real there = from[j] + fx * (from[side_j] - from[j]);
      s.suspended.next[i] = here + fy * (there - here);
    }
  for (const std::size_t i : tile.sinks) {
    sums.exported_sediment += double(s.suspended.next[i]);
    if (!s.sea_room.empty()) fill_sea(s, i);
    s.suspended.next[i] = 0;
  }
}

template <class Real>
void pour_sources(PipeState<Real>& s) {
  for (const auto& source : s.sources) {
    Real& depth = s.depth.now[source.cell];
    const Real gain = Real(source.gain) + s.carry[source.cell];
    const Real after = depth + gain;
    s.carry[source.cell] = gain - (after - depth);
    depth = after;
    s.source_water += double(Real(source.gain));
  }
}

}  // namespace

template <class Real>
void advance(PipeState<Real>& s, int step, const Context& context) {
  static tbb::enumerable_thread_specific<Scratch<Real>> scratch;
  pour_sources(s);
  const auto key = std::uint32_t(random_bits(s.seed, 0x7261696e, std::uint64_t(step)));
  const auto each_tile = [&](auto&& work) {
    parallel_chunks(context, s.tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) work(s.tiles[t], s.sums[t]);
    });
  };
  each_tile([&](const Tile& tile, TileSums& sums) {
    TileStep<Real>(s, tile, sums, scratch.local(), key).run();
  });
  for (auto* pair : {&s.sediment, &s.wear, &s.depth, &s.suspended, &s.flux_x, &s.flux_y})
    pair->now.swap(pair->next);
  if (!s.layer.empty()) each_tile([&](const Tile& tile, TileSums&) { expose_layers(s, tile); });
  if (s.traced) {
    each_tile([&](const Tile& tile, TileSums& sums) { trace_tile(s, tile, sums); });
    s.suspended.now.swap(s.suspended.next);
  }
}

template void advance(PipeState<float>&, int, const Context&);
template void advance(PipeState<double>&, int, const Context&);

}  // namespace orogen::pipes
