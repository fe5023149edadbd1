#include "hydrology/flow_graph.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "foundation/errors.h"
#include "foundation/random.h"
#include "foundation/simd.h"
#include "hydrology/flow_graph_scratch.h"

namespace orogen {

namespace {

constexpr std::size_t kMostHeads = 256, kFewestHeads = 16;  // of a block
constexpr std::size_t kBlocksWanted = 32;                   // of a round
constexpr std::size_t kBlocksAtOnce = 256;
constexpr int kPiece = 512;  // columns looked at at once
constexpr float kDiagonal = 0.70710678f;

std::string place(const Grid& grid, std::size_t cell) {
  return "row " + std::to_string(cell / grid.nx) + ", column " + std::to_string(cell % grid.nx);
}

std::uint32_t row_key(std::uint32_t seed, int row) {
  return std::uint32_t(mix64((std::uint64_t(seed) << 32) ^ std::uint32_t(row)));
}

std::uint64_t spread_bits(std::uint32_t v) {
  std::uint64_t x = v;
  x = (x | (x << 16)) & 0x0000ffff0000ffffull;
  x = (x | (x << 8)) & 0x00ff00ff00ff00ffull;
  x = (x | (x << 4)) & 0x0f0f0f0f0f0f0f0full;
  x = (x | (x << 2)) & 0x3333333333333333ull;
  return (x | (x << 1)) & 0x5555555555555555ull;
}

/// Three rows of heights and what judges a slope.
struct Stencil {
  const float *south, *middle, *north;
  float straight;    // 1 / cell size
  float randomness;  // of the diagonal
  std::uint32_t key;
};

/// Directions of at most kPiece columns [begin, end), none of them at a side. Slopes above 0 are
/// compared by their bits, plus one if chance is for the later of two equals.
template <bool kRandom>
[[gnu::always_inline]] inline void steepest(const Stencil& s, int begin, int end,
                                            std::uint8_t* direction) {
  const float* __restrict south = s.south;
  const float* __restrict middle = s.middle;
  const float* __restrict north = s.north;
  const float straight = s.straight;
  const float even = straight * kDiagonal;
  std::int32_t found[kPiece];
  for (int c = begin; c < end; ++c) {
    const float z = middle[c];
    const std::uint32_t bits = hash_place(s.key, std::uint32_t(c));
    float diagonal = even;
    if constexpr (kRandom) {
      const float u = float(std::int32_t(bits >> 9)) * 0x1.0p-23f;
      diagonal = straight * (kDiagonal + s.randomness * (1.0f / (2.0f - u) - kDiagonal));
    }
    std::int32_t best = 0, chosen = FlowGraph::kPit;
    const auto look = [&](int k, float neighbor, float per_length) {
      const std::int32_t slope = std::bit_cast<std::int32_t>((z - neighbor) * per_length);
      const std::int32_t key = slope + std::int32_t((bits >> k) & 1u);
      chosen = key > best ? k : chosen;
      best = key > best ? slope : best;
    };
    look(0, middle[c + 1], straight);
    look(1, north[c + 1], diagonal);
    look(2, north[c], straight);
    look(3, north[c - 1], diagonal);
    look(4, middle[c - 1], straight);
    look(5, south[c - 1], diagonal);
    look(6, south[c], straight);
    look(7, south[c + 1], diagonal);
    found[c - begin] = best > 0 ? chosen : std::int32_t(FlowGraph::kPit);
  }
  for (int c = begin; c < end; ++c) direction[c] = std::uint8_t(found[c - begin]);
}

OROGEN_CLONES void steepest_even(const Stencil& s, int begin, int end, std::uint8_t* direction) {
  steepest<false>(s, begin, end, direction);
}

OROGEN_CLONES void steepest_random(const Stencil& s, int begin, int end, std::uint8_t* direction) {
  steepest<true>(s, begin, end, direction);
}

OROGEN_CLONES bool all_finite(const float* z, int begin, int end) {
  int bad = 0;
  for (int c = begin; c < end; ++c) bad |= !(std::fabs(z[c]) <= std::numeric_limits<float>::max());
  return !bad;
}

/// Masks of the neighbours that flow to each of the columns [begin, end), none at a side.
OROGEN_CLONES void donor_masks(const std::uint8_t* south, const std::uint8_t* middle,
                               const std::uint8_t* north, int begin, int end,
                               std::uint8_t* donors) {
  for (int c = begin; c < end; ++c)
    donors[c] = std::uint8_t((middle[c + 1] == 4 ? 1 : 0) | (north[c + 1] == 5 ? 2 : 0) |
                             (north[c] == 6 ? 4 : 0) | (north[c - 1] == 7 ? 8 : 0) |
                             (middle[c - 1] == 0 ? 16 : 0) | (south[c - 1] == 1 ? 32 : 0) |
                             (south[c] == 2 ? 64 : 0) | (south[c + 1] == 3 ? 128 : 0));
}

}  // namespace

void FlowGraph::ScratchDeleter::operator()(Scratch* scratch) const {
  delete scratch;
}

FlowGraph::FlowGraph(const Raster<std::uint8_t>& base_level)
    : grid_(base_level.grid()),
      direction_(base_level.size()),
      donors_(base_level.size(), 0),
      round_begin_{0},
      scratch_(new Scratch) {
  if (grid_.size() > std::size_t(std::numeric_limits<std::int32_t>::max()) - 8 * kBlockCells)
    throw InputError("grid: " + std::to_string(grid_.size()) +
                     " cells, at most 2147418110 are allowed");
  const float d = float(grid_.cell_size);
  for (int k = 0; k < 8; ++k) {
    offset_[k] = kRowStep[k] * grid_.nx + kColumnStep[k];
    length_[k] = k % 2 ? float(grid_.cell_size * std::sqrt(2.0)) : d;
  }
  std::vector<std::pair<std::uint64_t, std::int32_t>> shore;
  for (int r = 0; r < grid_.ny; ++r)
    for (int c = 0, land_begin = -1, donor_begin = -1; c <= grid_.nx; ++c) {
      const bool inside = c < grid_.nx;
      const bool land = inside && !base_level(r, c);
      bool beside = false;
      for (int k = 0; k < 8 && inside && !land && !beside; ++k) {
        const int row = r + kRowStep[k], column = c + kColumnStep[k];
        beside = grid_.contains(row, column) && !base_level(row, column);
      }
      if (inside) direction_[grid_.index(r, c)] = land ? kPit : kBase;
      if (beside)
        shore.emplace_back(spread_bits(std::uint32_t(r)) * 2 + spread_bits(std::uint32_t(c)),
                           std::int32_t(grid_.index(r, c)));
      land_count_ += land;
      if (land && land_begin < 0) land_begin = c;
      if (!land && land_begin >= 0) land_runs_.push_back({r, std::exchange(land_begin, -1), c});
      const bool wanted = land || beside;
      if (wanted && donor_begin < 0) donor_begin = c;
      if (!wanted && donor_begin >= 0)
        donor_runs_.push_back({r, std::exchange(donor_begin, -1), c});
    }
  if (grid_.size() > 0 && land_count_ == grid_.size())
    throw InputError("base_level: no cell of the grid is base level; water needs at least one");
  std::sort(shore.begin(), shore.end());  // along a Z curve: neighbours share blocks
  for (const auto& [code, cell] : shore) shore_.push_back(cell);
  scratch_->outside_row.assign(grid_.nx, std::numeric_limits<float>::infinity());
  scratch_->outside_direction.assign(grid_.nx, kBase);
  scratch_->donor_steps.resize(256);
  for (int mask = 0; mask < 256; ++mask)
    for (int k = 0, n = 0; k < 8; ++k)
      if (mask >> k & 1) scratch_->donor_steps[mask][n++] = offset_[k];
}

void FlowGraph::force_receivers(std::span<const std::int32_t> receivers) {
  if (!receivers.empty() && receivers.size() != grid_.size())
    throw InputError("forced receivers: " + std::to_string(receivers.size()) +
                     " values, the grid has " + std::to_string(grid_.size()) + " cells");
  std::vector<std::pair<std::int32_t, std::uint8_t>> forced;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    if (receivers[i] == -1 || direction_[i] == kBase) continue;
    int found = -1;
    for (int k = 0; k < 8; ++k)
      if (has_neighbor(std::int32_t(i), k) && std::int32_t(i) + offset_[k] == receivers[i])
        found = k;
    if (found < 0)
      throw InputError("forced receivers: " + place(grid_, i) + " flows to cell " +
                       std::to_string(receivers[i]) + ", which is none of its eight neighbours");
    forced.emplace_back(std::int32_t(i), std::uint8_t(found));
  }
  forced_ = std::move(forced);
}

void FlowGraph::set_randomness(double randomness, std::uint32_t seed) {
  if (!(randomness >= 0.0 && randomness <= 1.0))
    throw InputError("randomness: " + std::to_string(randomness) + " is not within 0 to 1");
  randomness_ = randomness;
  seed_ = seed;
}

void FlowGraph::route(const Raster<float>& elevation, const Context& context) {
  if (elevation.grid() != grid_)
    throw InputError("elevation: must lie on the grid of the flow graph");
  const float* z = elevation.data();
  find_receivers(z, context);
  find_pits();
  cross_flats(z);
  cut_rings(z);
  find_donors(context);
  join_basins(z, context);
  build_order(context);
}

void FlowGraph::find_receivers(const float* z, const Context& context) {
  for (std::int32_t cell : shore_)
    if (!std::isfinite(z[cell])) throw InputError("elevation: not finite at " + place(grid_, cell));
  const int nx = grid_.nx;
  parallel_chunks(context, land_runs_.size(), 8, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const FlowRun run = land_runs_[i];
      const float* middle = z + grid_.index(run.row, 0);
      if (!all_finite(middle, run.begin, run.end)) {
        int c = run.begin;
        while (std::isfinite(middle[c])) ++c;
        throw InputError("elevation: not finite at " + place(grid_, grid_.index(run.row, c)));
      }
      const float* outside = scratch_->outside_row.data();
      const Stencil stencil{run.row > 0 ? middle - nx : outside,
                            middle,
                            run.row + 1 < grid_.ny ? middle + nx : outside,
                            float(1.0 / grid_.cell_size),
                            float(randomness_),
                            row_key(seed_, run.row)};
      std::uint8_t* direction = direction_.data() + grid_.index(run.row, 0);
      const auto look = randomness_ > 0.0 ? steepest_random : steepest_even;
      const int begin = std::max(run.begin, 1), end = std::min(run.end, nx - 1);
      for (int c = begin; c < end; c += kPiece)
        look(stencil, c, std::min(end, c + kPiece), direction);
      const auto at_side = [&](int c) {  // the same, with the missing columns put in
        float rows[3][3];
        const float* source[3] = {stencil.south, middle, stencil.north};
        for (int r = 0; r < 3; ++r)
          for (int d = 0; d < 3; ++d)
            rows[r][d] = c + d - 1 >= 0 && c + d - 1 < nx ? source[r][c + d - 1] : outside[0];
        Stencil side{rows[0] + 1 - c,  rows[1] + 1 - c,    rows[2] + 1 - c,
                     stencil.straight, stencil.randomness, stencil.key};
        look(side, c, c + 1, direction);
      };
      if (run.begin == 0) at_side(0);
      if (run.end == nx && nx > 1) at_side(nx - 1);
    }
  });
}

void FlowGraph::find_pits() {
  for (const auto& [cell, k] : forced_) direction_[cell] = k;
  auto& pits = scratch_->pits;
  pits.clear();
  for (const FlowRun& run : land_runs_) {
    const std::uint8_t* begin = direction_.data() + grid_.index(run.row, run.begin);
    const std::uint8_t* end = begin + (run.end - run.begin);
    while (begin < end) {
      begin = static_cast<const std::uint8_t*>(std::memchr(begin, kPit, end - begin));
      if (!begin) break;
      pits.push_back(std::int32_t(begin - direction_.data()));
      ++begin;
    }
  }
}

void FlowGraph::find_donors(const Context& context) {
  const int nx = grid_.nx;
  parallel_chunks(context, donor_runs_.size(), 8, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const FlowRun run = donor_runs_[i];
      const std::uint8_t* middle = direction_.data() + grid_.index(run.row, 0);
      const std::uint8_t* outside = scratch_->outside_direction.data();
      const std::uint8_t* south = run.row > 0 ? middle - nx : outside;
      const std::uint8_t* north = run.row + 1 < grid_.ny ? middle + nx : outside;
      std::uint8_t* donors = donors_.data() + grid_.index(run.row, 0);
      const int begin = std::max(run.begin, 1), end = std::min(run.end, nx - 1);
      if (begin < end) donor_masks(south, middle, north, begin, end, donors);
      const auto at_side = [&](int c) {
        const std::int32_t cell = std::int32_t(grid_.index(run.row, c));
        donors[c] = 0;
        for (int k = 0; k < 8; ++k)
          if (has_neighbor(cell, k) && direction_[cell + offset_[k]] == (k ^ 4))
            donors[c] |= std::uint8_t(1 << k);
      };
      if (run.begin == 0) at_side(0);
      if (run.end == nx && nx > 1) at_side(nx - 1);
    }
  });
}

void FlowGraph::build_order(const Context& context) {
  Scratch& s = *scratch_;
  order_.resize(land_count_);
  parents_.resize(land_count_);
  blocks_.clear();
  round_begin_.assign(1, 0);
  s.heads.clear();
  for (std::int32_t cell : shore_)
    for (std::uint8_t mask = donors_[cell]; mask; mask &= std::uint8_t(mask - 1))
      s.heads.push_back(cell + offset_[std::countr_zero(mask)]);
  std::size_t placed = 0;
  while (!s.heads.empty()) build_round(s.heads, placed, context);
  if (placed != land_count_)
    throw std::logic_error("flow graph: a cell does not drain");  // never, by construction
}

void FlowGraph::build_round(std::vector<std::int32_t>& heads, std::size_t& placed,
                            const Context& context) {
  Scratch& s = *scratch_;
  constexpr std::size_t room = kBlockCells + 16;
  const std::size_t share =
      std::clamp(heads.size() / kBlocksWanted, kFewestHeads, kMostHeads);  // heads of a block
  const std::size_t count = (heads.size() + share - 1) / share;
  s.next_heads.clear();
  for (std::size_t start = 0; start < count; start += kBlocksAtOnce) {
    const std::size_t here = std::min(kBlocksAtOnce, count - start);
    if (s.queues.size() < here * room) {
      s.queues.resize(here * room);
      s.queue_parents.resize(here * room);
    }
    s.queue_placed.resize(here);
    s.queue_length.resize(here);
    const auto fill = [&](std::size_t b) {
      const std::size_t first = (start + b) * share;
      const std::size_t last = std::min(heads.size(), first + share);
      std::int32_t* queue = s.queues.data() + b * room;
      std::uint16_t* parents = s.queue_parents.data() + b * room;
      std::int32_t done = 0, length = std::int32_t(last - first);
      std::copy(heads.begin() + first, heads.begin() + last, queue);
      for (; done < length && length < kBlockCells; ++done) {
        std::fill_n(parents + length, 8, std::uint16_t(done));
        s.append_donors(queue[done], donors_[queue[done]], queue, length);
      }
      s.queue_placed[b] = done;
      s.queue_length[b] = length;
    };
    if (here == 1)
      fill(0);
    else
      parallel_chunks(context, here, 1, [&](std::size_t b, std::size_t) { fill(b); });
    const std::size_t first_block = blocks_.size();
    for (std::size_t b = 0; b < here; ++b) {
      const auto given = std::int32_t(std::min(share, heads.size() - (start + b) * share));
      const std::int32_t done = s.queue_placed[b], begin = std::int32_t(placed);
      const std::int32_t* queue = s.queues.data() + b * room;
      if (placed + done > land_count_)
        throw std::logic_error("flow graph: a cell drains twice");  // never, by construction
      s.next_heads.insert(s.next_heads.end(), queue + done, queue + s.queue_length[b]);
      blocks_.push_back({begin, begin + std::min(given, done), begin + done});
      placed += done;
    }
    detail::for_blocks(context, std::span(blocks_).subspan(first_block), [&](std::size_t b) {
      const FlowBlock& block = blocks_[first_block + b];
      const std::size_t size = block.end - block.begin;
      std::copy_n(s.queues.data() + b * room, size, order_.data() + block.begin);
      std::copy_n(s.queue_parents.data() + b * room, size, parents_.data() + block.begin);
    });
  }
  round_begin_.push_back(std::int32_t(blocks_.size()));
  heads.swap(s.next_heads);
}

Raster<std::int32_t> FlowGraph::receivers(const Context& context) const {
  Raster<std::int32_t> result(grid_);
  parallel_chunks(context, result.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = receiver(std::int32_t(i));
  });
  return result;
}

}  // namespace orogen
