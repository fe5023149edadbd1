// Where water goes: from each cell of a grid to one of its eight neighbours, down to base level.
//
//   receiver(i) = argmax over the neighbours j of i of (z_i - z_j) / |ij|      (O'Callaghan and
//                 Mark 1984, D8 with true distances), if that is above 0
//
// Ties are broken, and flats are crossed, by a hash of the cell's place, so that no direction of
// the grid is favoured. Local minima are joined to their surroundings over a minimum spanning tree
// of the basin graph (Cordonnier, Bovy and Braun 2019, doi:10.5194/esurf-7-549-2019), and the flow
// from a minimum to its pass runs back along the path that led from the pass down to it
// ("depression carving"). After `route` every cell drains to a base-level cell, without cycles,
// and a path crosses no higher pass than it must.
//
// Forced receivers (drawn rivers) replace the steepest neighbour, uphill too. Where they would
// close a ring, the ring is cut at its lowest cell that is not forced (or its lowest), and counted.
//
// Order: `order()` lists the cells that are not base level so that a cell comes after its receiver.
// It is cut into blocks of some thousand cells that lie near each other, and blocks into rounds:
// the blocks of a round depend on earlier rounds only. `sweep_upstream` and `sweep_downstream` run
// the blocks of a round in parallel; results do not depend on the number of threads. The fastest
// kernels (`visit_...`) copy a block's values together first: within a block `parents()` say which
// place of the block a cell flows to, and parents rise with the cells, so that memory streams.
//
// Cost: O(cells that are not base level), and O(p log b) for b local minima with p passes. About 20
// bytes a cell, kept between calls. Limits: at most 2^31 - 1 cells; the height of a base-level cell
// is the height water falls to: give the sea its level, not its floor.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "foundation/context.h"
#include "foundation/parallel.h"
#include "foundation/raster.h"

namespace orogen {

struct FlowBlock {
  std::int32_t begin, heads_end, end;  // in order(); heads: cells whose receiver is in no block of
                                       // this round
};

struct FlowRun {
  std::int32_t row, begin, end;  // columns [begin, end) of a row, none of them base level
};

class FlowGraph {
 public:
  /// `base_level`: not 0 where water leaves. InputError if it is 0 everywhere.
  explicit FlowGraph(const Raster<std::uint8_t>& base_level);

  /// For each cell -1, or the cell its water must flow to: one of its eight neighbours (InputError
  /// otherwise). Ignored in base-level cells. An empty list takes all away.
  void force_receivers(std::span<const std::int32_t> receivers);

  /// Diagonal steps are judged by a random length between 1 and 2 cells instead of sqrt(2): 0 D8,
  /// 1 Rho8 (Fairfield and Leymarie 1991), which breaks up straight parallel flow on even slopes.
  void set_randomness(double randomness, std::uint32_t seed = 0);

  /// Finds receivers and order. InputError for a height that is not finite.
  void route(const Raster<float>& elevation, const Context& context);

  const Grid& grid() const { return grid_; }
  bool is_base(std::int32_t cell) const { return direction_[cell] == kBase; }
  std::int32_t receiver(std::int32_t cell) const { return cell + offset_[direction_[cell]]; }
  /// Distance to the receiver (m); 0 in a base-level cell.
  float distance(std::int32_t cell) const { return length_[direction_[cell]]; }
  /// 0..7: east, north-east, north, ... south-east; 8 and above: none (base level).
  std::uint8_t direction(std::int32_t cell) const { return direction_[cell]; }
  /// Bit k: the neighbour in direction k flows here.
  std::uint8_t donors(std::int32_t cell) const { return donors_[cell]; }
  std::int32_t neighbor(std::int32_t cell, int direction) const {
    return cell + offset_[direction];
  }
  const std::uint8_t* directions() const { return direction_.data(); }  // of all cells
  Raster<std::int32_t> receivers(const Context& context) const;  // a base-level cell's is itself

  /// All cells that are not base level, each after its receiver.
  std::span<const std::int32_t> order() const { return {order_.data(), land_count_}; }
  std::span<const FlowBlock> blocks() const { return blocks_; }
  std::size_t rounds() const { return round_begin_.size() - 1; }
  std::span<const FlowBlock> round(std::size_t r) const {
    return std::span(blocks_).subspan(round_begin_[r], round_begin_[r + 1] - round_begin_[r]);
  }
  /// For each cell of order() that is no head: the place of its receiver in the block, from 0.
  std::span<const std::uint16_t> parents() const { return {parents_.data(), land_count_}; }
  /// The same cells as row pieces, for loops that need no order.
  std::span<const FlowRun> runs() const { return land_runs_; }
  /// Base-level cells beside others, where water may leave.
  std::span<const std::int32_t> shore() const { return shore_; }

  std::size_t pit_count() const { return pit_count_; }            // local minima of the last route
  std::size_t cut_ring_count() const { return cut_ring_count_; }  // rings of forced receivers cut

  /// body(cell) for each cell after its receiver. It may write to the cell only.
  template <class Body>
  void sweep_upstream(const Context& context, Body&& body) const;
  /// body(cell) for each cell after all its donors. It may write to the cell and its receiver.
  template <class Body>
  void sweep_downstream(const Context& context, Body&& body) const;

  /// body(block, its number) for each block after those it flows to.
  template <class Body>
  void visit_upstream(const Context& context, Body&& body) const;
  /// body(block, its number) for each block before those it flows to; then, one by one, join(place
  /// in order()) for its heads, which may share receivers with other blocks' heads.
  template <class Body, class Join>
  void visit_downstream(const Context& context, Body&& body, Join&& join) const;

  static constexpr std::int32_t kBlockCells = 8192;  // no block has more
  static constexpr std::uint8_t kPit = 8, kBase = 9;

 private:
  struct Scratch;
  struct ScratchDeleter {
    void operator()(Scratch*) const;
  };

  void find_receivers(const float* z, const Context& context);
  void find_pits();
  void cross_flats(const float* z);
  void cut_rings(const float* z);
  void find_donors(const Context& context);
  void join_basins(const float* z, const Context& context);
  void label_basins(const Context& context);
  void find_passes(const float* z, const Context& context);
  void turn_path(std::int32_t from, int k);
  void build_order(const Context& context);
  void build_round(std::vector<std::int32_t>& heads, std::size_t& placed, const Context& context);
  bool has_neighbor(std::int32_t cell, int k) const;

  Grid grid_;
  std::array<std::int32_t, 10> offset_{};
  std::array<float, 10> length_{};
  std::vector<std::uint8_t> direction_;  // to the receiver
  std::vector<std::uint8_t> donors_;     // bit k: the neighbour in direction k flows here
  std::vector<std::int32_t> order_;
  std::vector<std::uint16_t> parents_;
  std::vector<FlowBlock> blocks_;
  std::vector<std::int32_t> round_begin_;
  std::vector<FlowRun> land_runs_, donor_runs_;
  std::vector<std::int32_t> shore_;
  std::vector<std::pair<std::int32_t, std::uint8_t>> forced_;  // cell, direction
  std::size_t land_count_ = 0, pit_count_ = 0, cut_ring_count_ = 0;
  double randomness_ = 0.0;
  std::uint32_t seed_ = 0;
  std::unique_ptr<Scratch, ScratchDeleter> scratch_;
};

}  // namespace orogen

#include "hydrology/flow_graph_sweeps.h"
