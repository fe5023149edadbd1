#include "erosion/slippage_sweep.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "foundation/parallel.h"
#include "foundation/simd.h"

namespace orogen::pipes {

namespace {

constexpr int kReach = kTileColumns + 4;  // columns of a tile's scratch rows
constexpr double kOutOfReach = 1e9;       // m, the height of cells that take nothing
constexpr double kShare = 0.125;          // of an excess that moves in a sweep

template <class Real>
struct Rows {  // of one field: south, here, north
  const Real *s, *c, *n;
};

template <class Real>
struct Falls {
  Real side, corner;          // l tan theta
  Real side_tol, corner_tol;  // excess below which nothing moves, half of what may be left
};

#define OROGEN_BODY     \
  template <class Real> \
  __attribute__((always_inline)) inline

OROGEN_BODY Real moving(Real drop, Real fall, Real tolerance) {
  const Real excess = drop - fall;
  return excess > tolerance ? excess : Real(0);
}

OROGEN_BODY void prepare_body(const Real* sediment, const Real* wear, const Real* code, Real* rel,
                              Real* loose, int n) {
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    const Real height = sediment[i] - wear[i];
    const bool takes = (code[i] >= 0) | (code[i] == Real(kSink));
    rel[i] = takes ? height : Real(kOutOfReach);
    loose[i] = code[i] >= 0 ? sediment[i] : Real(0);
  }
}

/// Excess of cell i over the neighbour at offset o in rows (b, r).
OROGEN_BODY Real given_to(const Rows<Real>& base, const Rows<Real>& rel, const Real* b,
                          const Real* r, int i, int o, Real fall, Real tolerance) {
  return moving((base.c[i] - b[i + o]) + (rel.c[i] - r[i + o]), fall, tolerance);
}

/// How much a cell would give in all, and the share of it that it has.
OROGEN_BODY int offer_body(const Rows<Real>& base, const Rows<Real>& rel, const Real* loose,
                           const Falls<Real>& f, Real* offer, Real* share, int n) {
  int moved = 0;
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    const Real sides = (given_to(base, rel, base.c, rel.c, i, -1, f.side, f.side_tol) +
                        given_to(base, rel, base.c, rel.c, i, 1, f.side, f.side_tol)) +
                       (given_to(base, rel, base.s, rel.s, i, 0, f.side, f.side_tol) +
                        given_to(base, rel, base.n, rel.n, i, 0, f.side, f.side_tol));
    const Real corners = (given_to(base, rel, base.s, rel.s, i, -1, f.corner, f.corner_tol) +
                          given_to(base, rel, base.n, rel.n, i, 1, f.corner, f.corner_tol)) +
                         (given_to(base, rel, base.s, rel.s, i, 1, f.corner, f.corner_tol) +
                          given_to(base, rel, base.n, rel.n, i, -1, f.corner, f.corner_tol));
    const Real all = Real(kShare) * (sides + corners);
    offer[i] = all;
    share[i] = Real(kShare) * std::min(Real(1), loose[i] / std::max(all, Real(1e-30)));
    moved |= int(all > 0) & int(loose[i] > 0);
  }
  return moved;
}

OROGEN_BODY void gather_body(const Rows<Real>& base, const Rows<Real>& rel, const Rows<Real>& share,
                             const Real* sediment, const Real* loose, const Real* offer,
                             const Falls<Real>& f, Real* next, int n) {
  // What the neighbour at offset o gives to cell i.
  const auto from = [&](const Real* b, const Real* r, const Real* s, int i, int o, Real fall,
                        Real tolerance) __attribute__((always_inline)) {
    return moving((b[i + o] - base.c[i]) + (r[i + o] - rel.c[i]), fall, tolerance) * s[i + o];
  };
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    const Real sides = (from(base.c, rel.c, share.c, i, -1, f.side, f.side_tol) +
                        from(base.c, rel.c, share.c, i, 1, f.side, f.side_tol)) +
                       (from(base.s, rel.s, share.s, i, 0, f.side, f.side_tol) +
                        from(base.n, rel.n, share.n, i, 0, f.side, f.side_tol));
    const Real corners = (from(base.s, rel.s, share.s, i, -1, f.corner, f.corner_tol) +
                          from(base.n, rel.n, share.n, i, 1, f.corner, f.corner_tol)) +
                         (from(base.s, rel.s, share.s, i, 1, f.corner, f.corner_tol) +
                          from(base.n, rel.n, share.n, i, -1, f.corner, f.corner_tol));
    next[i] = (sediment[i] - std::min(offer[i], loose[i])) + (sides + corners);
  }
}

#define OROGEN_SLIDE_KERNELS(Real)                                                                \
  OROGEN_CLONES void prepare_row(const Real* sediment, const Real* wear, const Real* code,        \
                                 Real* __restrict rel, Real* __restrict loose, int n) {           \
    prepare_body(sediment, wear, code, rel, loose, n);                                            \
  }                                                                                               \
  OROGEN_CLONES int offer_row(const Rows<Real>& base, const Rows<Real>& rel, const Real* loose,   \
                              const Falls<Real>& falls, Real* __restrict offer,                   \
                              Real* __restrict share, int n) {                                    \
    return offer_body(Rows<Real>(base), Rows<Real>(rel), loose, Falls<Real>(falls), offer, share, \
                      n);                                                                         \
  }                                                                                               \
  OROGEN_CLONES void gather_row(const Rows<Real>& base, const Rows<Real>& rel,                    \
                                const Rows<Real>& share, const Real* sediment, const Real* loose, \
                                const Real* offer, const Falls<Real>& falls,                      \
                                Real* __restrict next, int n) {                                   \
    gather_body(Rows<Real>(base), Rows<Real>(rel), Rows<Real>(share), sediment, loose, offer,     \
                Falls<Real>(falls), next, n);                                                     \
  }
OROGEN_SLIDE_KERNELS(float)
OROGEN_SLIDE_KERNELS(double)

template <class Real>
Falls<Real> falls_of(const SlideField<Real>& field) {
  const double side = field.cell_size, corner = side * std::numbers::sqrt2;
  return {Real(side * field.tan_repose), Real(corner * field.tan_repose),
          Real(0.5 * kSlopeTolerance * side), Real(0.5 * kSlopeTolerance * corner)};
}

template <class Real>
struct SlideScratch {
  std::vector<Real> rel, loose, offer, share;
  SlideScratch() {
    for (auto* v : {&rel, &loose, &offer, &share}) v->resize(std::size_t(kTileRows + 4) * kReach);
  }
};

/// Scratch rows count from two rows below the tile, scratch columns from two columns left of it.
template <class Real>
bool slide_tile(const SlideField<Real>& field, const Tile& tile, const Real* sediment, Real* next,
                SlideScratch<Real>& scratch) {
  const Falls<Real> falls = falls_of(field);
  const int n = tile.column1 - tile.column0;
  const auto at = [&](int row) { return field.shape.index(row, tile.column0) - 2; };
  const auto line = [&](std::vector<Real>& v, int row) {
    return v.data() + std::size_t(row - tile.row0 + 2) * kReach;
  };
  const auto rows = [&](std::vector<Real>& v, int row, int shift) {
    return Rows<Real>{line(v, row - 1) + shift, line(v, row) + shift, line(v, row + 1) + shift};
  };
  const auto base = [&](int row, int shift) {
    return Rows<Real>{field.base + at(row - 1) + shift, field.base + at(row) + shift,
                      field.base + at(row + 1) + shift};
  };
  for (int r = tile.row0 - 2; r < tile.row1 + 2; ++r)
    prepare_row(sediment + at(r), field.wear + at(r), field.code + at(r), line(scratch.rel, r),
                line(scratch.loose, r), n + 4);
  int moved = 0;
  for (int r = tile.row0 - 1; r < tile.row1 + 1; ++r)
    moved |= offer_row(base(r, 1), rows(scratch.rel, r, 1), line(scratch.loose, r) + 1, falls,
                       line(scratch.offer, r) + 1, line(scratch.share, r) + 1, n + 2);
  for (int r = tile.row0; r < tile.row1; ++r) {
    const Real* from = sediment + at(r) + 2;
    Real* to = next + at(r) + 2;
    if (!moved) {
      std::copy(from, from + n, to);
      continue;
    }
    gather_row(base(r, 2), rows(scratch.rel, r, 2), rows(scratch.share, r, 2), from,
               line(scratch.loose, r) + 2, line(scratch.offer, r) + 2, falls, to, n);
  }
  return moved != 0;
}

}  // namespace

template <class Real>
bool Slider<Real>::sweep(const SlideField<Real>& field, std::vector<Real>& sediment,
                         std::vector<Real>& next, const Context& context) {
  const auto& tiles = *field.tiles;
  static tbb::enumerable_thread_specific<SlideScratch<Real>> scratch;
  std::vector<std::uint8_t> moved(tiles.size(), 0);
  parallel_chunks(context, tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      if (awake_[t])
        moved[t] = slide_tile(field, tiles[t], sediment.data(), next.data(), scratch.local());
  });
  sediment.swap(next);
  bool any = false;
  std::fill(awake_.begin(), awake_.end(), std::uint8_t(0));
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const std::size_t i : tiles[t].sinks) {
      exported_ += double(sediment[i]);
      sediment[i] = next[i] = 0;
    }
    if (!moved[t]) continue;
    any = true;
    for (const int other : tiles[t].around) awake_[std::size_t(other)] = 1;
  }
  return any;
}

template <class Real>
int Slider<Real>::settle(const SlideField<Real>& field, std::vector<Real>& sediment,
                         std::vector<Real>& next, int max_sweeps, const Context& context) {
  int sweeps = 0;
  while (sweeps < max_sweeps && sweep(field, sediment, next, context)) ++sweeps;
  return sweeps;
}

namespace {

/// Calls visit(neighbour index, distance) for the eight neighbours.
template <class Visit>
void each_neighbour(std::size_t i, std::size_t stride, double cell, Visit&& visit) {
  for (int dr = -1; dr <= 1; ++dr)
    for (int dc = -1; dc <= 1; ++dc)
      if (dr || dc)
        visit(std::size_t(std::ptrdiff_t(i) + dr * std::ptrdiff_t(stride) + dc),
              dr && dc ? cell * std::numbers::sqrt2 : cell);
}

template <class Real>
double drop_between(const SlideField<Real>& field, const Real* sediment, std::size_t i,
                    std::size_t j) {
  return (double(field.base[i]) - double(field.base[j])) +
         ((double(sediment[i]) - double(field.wear[i])) -
          (double(sediment[j]) - double(field.wear[j])));
}

}  // namespace

template <class Real>
double steepest_excess(const SlideField<Real>& field, const std::vector<Real>& sediment,
                       const Context& context) {
  const auto& tiles = *field.tiles;
  const auto tile_excess = [&](const Tile& tile) {
    double worst = 0.0;
    for (int r = tile.row0; r < tile.row1; ++r)
      for (int c = tile.column0; c < tile.column1; ++c) {
        const std::size_t i = field.shape.index(r, c);
        if (!(field.code[i] >= 0) || !(sediment[i] > 0)) continue;
        each_neighbour(i, field.shape.stride, field.cell_size, [&](std::size_t j, double l) {
          if (!(field.code[j] >= 0) && field.code[j] != Real(kSink)) return;
          const double slope = drop_between(field, sediment.data(), i, j) / l;
          worst = std::max(worst, slope - field.tan_repose);
        });
      }
    return worst;
  };
  return parallel_reduce(
      context, tiles.size(), 1, 0.0,
      [&](std::size_t begin, std::size_t end) {
        double worst = 0.0;
        for (std::size_t t = begin; t < end; ++t) worst = std::max(worst, tile_excess(tiles[t]));
        return worst;
      },
      [](double a, double b) { return std::max(a, b); });
}

template <class Real>
void loosen_rock(const SlideField<Real>& field, const std::vector<std::uint8_t>& layer,
                 const std::vector<double>& tan_rock, const std::vector<Real>& sediment,
                 std::vector<Real>& new_sediment, std::vector<Real>& new_wear,
                 const Context& context) {
  const auto& tiles = *field.tiles;
  parallel_chunks(context, tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      for (int r = tiles[t].row0; r < tiles[t].row1; ++r)
        for (int c = tiles[t].column0; c < tiles[t].column1; ++c) {
          const std::size_t i = field.shape.index(r, c);
          new_sediment[i] = sediment[i];
          new_wear[i] = field.wear[i];
          if (!(field.code[i] >= 0)) continue;
          const double tan = tan_rock[layer.empty() ? tan_rock.size() - 1 : layer[i]];
          double excess = 0.0;
          each_neighbour(i, field.shape.stride, field.cell_size, [&](std::size_t j, double l) {
            if (field.code[j] == Real(kWall)) return;
            excess = std::max(excess, drop_between(field, sediment.data(), i, j) - l * tan);
          });
          const Real loose = Real(std::max(0.0, 0.25 * excess - double(sediment[i])));
          new_wear[i] = field.wear[i] + loose;
          new_sediment[i] = sediment[i] + (new_wear[i] - field.wear[i]);
        }
  });
}

#define OROGEN_SLIPPAGE(Real)                                                          \
  template class Slider<Real>;                                                         \
  template double steepest_excess(const SlideField<Real>&, const std::vector<Real>&,   \
                                  const Context&);                                     \
  template void loosen_rock(const SlideField<Real>&, const std::vector<std::uint8_t>&, \
                            const std::vector<double>&, const std::vector<Real>&,      \
                            std::vector<Real>&, std::vector<Real>&, const Context&);
OROGEN_SLIPPAGE(float)
OROGEN_SLIPPAGE(double)

}  // namespace orogen::pipes
