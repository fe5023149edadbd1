// Flats, rings of forced receivers, and the joining of basins: what makes every cell drain.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "foundation/simd.h"
#include "hydrology/flow_graph_scratch.h"

namespace orogen {

namespace {

constexpr std::size_t kPitsPerTask = 128;
constexpr std::size_t kRunsPerTask = 8;
constexpr std::size_t kPairsKept = 2048;
constexpr std::uint8_t kFlatRoot = 10;

std::uint64_t pass_key(float height, std::int32_t a, std::int32_t b) {
  const std::uint32_t tie =
      hash_place(std::uint32_t(std::min(a, b)) * 0x27d4eb2fu, std::uint32_t(std::max(a, b)));
  return std::uint64_t(rising_bits(height)) << 32 | tie;
}

OROGEN_CLONES void compare_labels(const std::int32_t* own, const std::int32_t* other, int count,
                                  std::uint8_t bit, std::uint8_t* mask) {
  for (int c = 0; c < count; ++c) mask[c] |= own[c] != other[c] ? bit : std::uint8_t(0);
}

/// Bit k of each mask in [begin, end): the neighbour in direction k (0 to 3) has another label.
void find_borders(const std::int32_t* labels, const std::int32_t* north, int nx, int begin, int end,
                  std::uint8_t* masks) {
  std::fill(masks + begin, masks + end, std::uint8_t(0));
  const int before_last = std::min(end, nx - 1), after_first = std::max(begin, 1);
  compare_labels(labels + begin, labels + begin + 1, before_last - begin, 1, masks + begin);
  if (!north) return;
  compare_labels(labels + begin, north + begin + 1, before_last - begin, 2, masks + begin);
  compare_labels(labels + begin, north + begin, end - begin, 4, masks + begin);
  compare_labels(labels + after_first, north + after_first - 1, end - after_first, 8,
                 masks + after_first);
}

/// Cells of a flat in order of their way to its outlets: Dijkstra in buckets of one length unit.
/// Steps are 20 (28 on diagonals) and up to 11 more by chance, so that no direction stands out.
class FlatFront {
 public:
  void push(std::int32_t cell, std::uint8_t direction) {
    const std::uint32_t chance = hash_place(std::uint32_t(cell), direction) % 12;
    buckets_[(now_ + (direction % 2 ? 28 : 20) + chance) % kBuckets].push_back({cell, direction});
    ++waiting_;
  }
  bool pop(std::int32_t& cell, std::uint8_t& direction) {
    if (waiting_ == 0) return false;
    while (buckets_[now_ % kBuckets].empty()) ++now_;
    const Step step = buckets_[now_ % kBuckets].back();
    buckets_[now_ % kBuckets].pop_back();
    --waiting_;
    cell = step.cell;
    direction = step.direction;
    return true;
  }

 private:
  static constexpr std::size_t kBuckets = 64;
  struct Step {
    std::int32_t cell;
    std::uint8_t direction;
  };
  std::vector<Step> buckets_[kBuckets];
  std::size_t now_ = 0, waiting_ = 0;
};

}  // namespace

void FlowGraph::cross_flats(const float* z) {
  auto& pits = scratch_->pits;
  FlatFront front;
  std::vector<std::int32_t> flat;
  for (std::int32_t cell : pits) {
    bool is_flat = false;
    for (int k = 0; k < 8; ++k) {
      if (!has_neighbor(cell, k) || z[cell + offset_[k]] != z[cell]) continue;
      is_flat = true;
      if (direction_[cell + offset_[k]] != kPit) front.push(cell, std::uint8_t(k));
    }
    if (is_flat) flat.push_back(cell);
  }
  if (flat.empty()) return;
  const auto push_around = [&](std::int32_t cell) {
    for (int d = 0; d < 8; ++d) {
      const std::int32_t next = cell + offset_[d];
      if (has_neighbor(cell, d) && direction_[next] == kPit && z[next] == z[cell])
        front.push(next, std::uint8_t(d ^ 4));
    }
  };
  const auto spread = [&] {
    std::int32_t cell;
    std::uint8_t k;
    while (front.pop(cell, k)) {
      if (direction_[cell] != kPit) continue;
      direction_[cell] = k;
      push_around(cell);
    }
  };
  spread();
  for (std::int32_t cell : flat) {  // what is left is closed: one cell of each flat is its pit
    if (direction_[cell] != kPit) continue;
    direction_[cell] = kFlatRoot;
    push_around(cell);
    spread();
  }
  for (std::int32_t cell : flat)
    if (direction_[cell] == kFlatRoot) direction_[cell] = kPit;
  std::erase_if(pits, [&](std::int32_t cell) { return direction_[cell] != kPit; });
}

void FlowGraph::cut_rings(const float* z) {
  cut_ring_count_ = 0;
  if (forced_.empty()) return;
  auto& labels = scratch_->labels;
  labels.resize(grid_.size());
  const auto is_forced = [&](std::int32_t cell) {
    const auto at = std::lower_bound(forced_.begin(), forced_.end(),
                                     std::pair<std::int32_t, std::uint8_t>(cell, 0));
    return at != forced_.end() && at->first == cell;
  };
  std::vector<std::int32_t> touched;
  std::int32_t walk = 0;
  for (const auto& [start, k] : forced_) {
    ++walk;
    std::int32_t cell = start;
    while (direction_[cell] < kPit && labels[cell] == 0) {
      labels[cell] = walk;
      touched.push_back(cell);
      cell = receiver(cell);
    }
    if (direction_[cell] >= kPit || labels[cell] != walk) continue;
    std::int32_t cut = cell, at = cell;
    do {
      const bool better = is_forced(at) == is_forced(cut) ? z[at] < z[cut] : !is_forced(at);
      if (better) cut = at;
      at = receiver(at);
    } while (at != cell);
    direction_[cut] = kPit;
    scratch_->pits.push_back(cut);
    ++cut_ring_count_;
  }
  for (std::int32_t cell : touched) labels[cell] = 0;
}

/// Makes the way from a pit to `from` run back, and on from there in direction k.
void FlowGraph::turn_path(std::int32_t from, int k) {
  while (true) {
    const std::uint8_t before = direction_[from];
    direction_[from] = std::uint8_t(k);
    donors_[from + offset_[k]] |= std::uint8_t(1 << (k ^ 4));
    if (before == kPit) return;
    from += offset_[before];
    donors_[from] &= std::uint8_t(~(1 << (before ^ 4)));
    k = before ^ 4;
  }
}

void FlowGraph::join_basins(const float* z, const Context& context) {
  Scratch& s = *scratch_;
  pit_count_ = s.pits.size();
  if (s.pits.empty()) return;
  s.labels.resize(grid_.size());
  label_basins(context);
  find_passes(z, context);
  for (const BasinOutlet& outlet : s.basins.join(pit_count_ + 1, s.labels))
    for (int k = 0; k < 8; ++k)
      if (has_neighbor(outlet.from, k) && outlet.from + offset_[k] == outlet.to) {
        turn_path(outlet.from, k);
        break;
      }
  parallel_chunks(context, land_runs_.size(), 8, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const FlowRun& run = land_runs_[i];
      std::fill_n(s.labels.begin() + grid_.index(run.row, run.begin), run.end - run.begin, 0);
    }
  });
}

/// Which pit each cell drains to.
void FlowGraph::label_basins(const Context& context) {
  Scratch& s = *scratch_;
  s.basin_cells.resize((s.pits.size() + kPitsPerTask - 1) / kPitsPerTask);
  parallel_chunks(context, s.basin_cells.size(), 1, [&](std::size_t t, std::size_t) {
    auto& cells = s.basin_cells[t];
    if (cells.size() < 1024) cells.resize(1024);
    std::int32_t length = 0, done = 0;
    const std::size_t last = std::min(s.pits.size(), (t + 1) * kPitsPerTask);
    for (std::size_t p = t * kPitsPerTask; p < last; ++p) {
      cells[length++] = s.pits[p];
      for (; done < length; ++done) {
        if (cells.size() < std::size_t(length) + 16) cells.resize(2 * cells.size());
        const std::int32_t cell = cells[done];
        s.labels[cell] = std::int32_t(p + 1);
        s.append_donors(cell, donors_[cell], cells.data(), length);
      }
    }
    cells.resize(length);
  });
}

/// The lowest passes between neighbouring basins; of a pair there may be a few.
void FlowGraph::find_passes(const float* z, const Context& context) {
  Scratch& s = *scratch_;
  s.row_passes.resize((donor_runs_.size() + kRunsPerTask - 1) / kRunsPerTask);
  parallel_chunks(context, s.row_passes.size(), 1, [&](std::size_t t, std::size_t) {
    auto& passes = s.row_passes[t];
    passes.clear();
    std::vector<std::uint8_t> borders(grid_.nx + 8);
    std::array<std::uint32_t, kPairsKept> seen;  // where a pair's pass may be found
    seen.fill(0);
    const auto add = [&](std::int32_t cell, int k) {  // k: 0 to 3, the others are the neighbours'
      const std::int32_t other = cell + offset_[k];
      BasinPass pass{pass_key(std::max(z[cell], z[other]), cell, other),
                     {s.labels[cell], s.labels[other]},
                     {cell, other}};
      if (pass.basins[0] > pass.basins[1]) {
        std::swap(pass.basins[0], pass.basins[1]);
        std::swap(pass.cells[0], pass.cells[1]);
      }
      std::uint32_t& at =
          seen[(std::uint32_t(pass.basins[0]) * 31u + std::uint32_t(pass.basins[1])) % kPairsKept];
      if (at < passes.size() && std::ranges::equal(passes[at].basins, pass.basins)) {
        if (pass.key < passes[at].key) passes[at] = pass;
      } else {
        at = std::uint32_t(passes.size());
        passes.push_back(pass);
      }
    };
    const std::size_t last = std::min(donor_runs_.size(), (t + 1) * kRunsPerTask);
    for (std::size_t run = t * kRunsPerTask; run < last; ++run) {
      const auto [row, begin, end] = donor_runs_[run];
      const std::int32_t* labels = s.labels.data() + grid_.index(row, 0);
      const std::int32_t* north = row + 1 < grid_.ny ? labels + grid_.nx : nullptr;
      find_borders(labels, north, grid_.nx, begin, end, borders.data());
      std::fill_n(borders.begin() + end, 8, std::uint8_t(0));
      for (int c = begin; c < end; c += 8) {
        std::uint64_t eight;
        std::memcpy(&eight, borders.data() + c, 8);
        if (eight == 0) continue;
        for (int d = c; d < std::min(end, c + 8); ++d)
          for (unsigned mask = borders[d]; mask; mask &= mask - 1)
            add(std::int32_t(grid_.index(row, d)), std::countr_zero(mask));
      }
    }
  });
  s.basins.passes.clear();
  for (const auto& passes : s.row_passes)
    s.basins.passes.insert(s.basins.passes.end(), passes.begin(), passes.end());
}

}  // namespace orogen
