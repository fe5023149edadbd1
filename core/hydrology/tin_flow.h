// Where water goes on a TIN: from each vertex to one of its neighbours, down to base level.
//
//   receiver(i) = argmax over the neighbours j of i of (z_i - z_j) / |ij|,  if that is above 0
//
// Of equal slopes the neighbour with the lowest number is taken; flats are crossed by the fewest
// edges. Closed basins are joined to base level over their lowest passes (basin_graph.h): the flow
// from a minimum to its pass runs back along the path that led from the pass down to it. After
// `route` every vertex drains to a base-level vertex, without cycles, and a path crosses no higher
// pass than it must.
//
// Order: trees of receivers that end in base-level vertices beside each other make up a part of the
// whole (`FlowTrees`), in which a vertex comes after its receiver. Parts do not depend on each
// other, so that they are solved in parallel, and a part is laid out so that memory streams.
// Results do not depend on the number of threads. One outlet for all leaves one part.
//
// Cost: O(vertices), about half of a whole step of erosion, without closed basins; O(p log b) for b
// of them with p passes. About 50 bytes a vertex, kept between calls. The TIN is not owned and must
// stay.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "foundation/context.h"
#include "foundation/parallel.h"
#include "foundation/tin.h"
#include "foundation/vertex_values.h"
#include "hydrology/basin_graph.h"

namespace orogen {

/// Whole trees of the flow: first `roots` base-level vertices, then all that drains to them.
struct FlowTrees {
  std::span<const std::int32_t> vertices;
  std::span<const std::int32_t> parents;  // place of the receiver in `vertices`; a root's own
  std::int32_t roots;
};

class TinFlow {
 public:
  /// `base_level`: not 0 at vertices where water leaves. InputError if it is 0 everywhere.
  TinFlow(const Tin& tin, std::span<const std::uint8_t> base_level);

  /// Other vertices where water leaves, for the next route. InputError as above.
  void set_base_level(std::span<const std::uint8_t> base_level);

  /// Finds receivers and order. InputError for a height (m) that is not finite.
  void route(std::span<const double> elevation, const Context& context);

  const Tin& tin() const { return *tin_; }
  bool is_base(std::int32_t vertex) const { return base_[vertex]; }
  /// A base-level vertex's is itself.
  std::span<const std::int32_t> receivers() const { return receivers_; }
  /// To the receiver (m); 0 at base level.
  std::span<const float> distances() const { return distances_; }
  std::size_t pit_count() const { return pits_.size(); }  // closed basins of the last route

  std::size_t part_count() const { return parts_.size(); }
  FlowTrees part(std::size_t p) const {
    const Part& part = parts_[p];
    return {{part.vertices.data(), std::size_t(part.count)},
            {part.parents.data(), std::size_t(part.count)},
            part.roots_end - part.roots_begin};
  }
  /// body(part, its number), in parallel.
  template <class Body>
  void visit(const Context& context, Body&& body) const {
    if (tin_->size() < kFewVertices) {
      for (std::size_t p = 0; p < parts_.size(); ++p) body(part(p), p);
    } else {
      parallel_chunks(context, parts_.size(), 1,
                      [&](std::size_t p, std::size_t) { body(part(p), p); });
    }
  }
  /// All vertices that are not base level, each after its receiver.
  std::vector<std::int32_t> order() const;

 private:
  struct Part {
    std::int32_t roots_begin, roots_end;  // in shore_
    std::int32_t count = 0;
    std::vector<std::int32_t> vertices{}, parents{};  // longer than `count`
  };

  void find_receivers(const double* z, const Context& context);
  void cross_flats(const double* z);
  void join_basins(const double* z, const Context& context);
  void label_basins(const Context& context);
  void find_passes(const double* z, const Context& context);
  void turn_path(std::int32_t from, std::int32_t to);
  void grow(Part& part) const;
  float distance_between(std::int32_t from, std::int32_t to) const;

  static constexpr std::size_t kFewVertices = 2048;  // one thread is sooner done with

  const Tin* tin_;
  std::vector<std::uint8_t> base_;
  std::vector<float> per_length_;    // of each edge (1/m)
  std::vector<std::int32_t> shore_;  // base-level vertices beside others
  std::vector<std::int32_t> receivers_;
  std::vector<float> distances_;
  std::vector<Part> parts_;
  std::size_t land_count_ = 0;
  std::vector<std::int32_t> pits_, labels_;  // label: 1 + number of the pit; 0 between calls
  std::vector<std::vector<std::int32_t>> chunk_pits_, basin_vertices_;  // by task
  std::vector<std::vector<BasinPass>> task_passes_;
  BasinGraph basins_;
};

/// For one part: drainage area (m², weighted by rain) in the part's order, of roots what reaches
/// them.
void sum_drainage_area(const Tin& tin, const FlowTrees& part, const VertexValues& rain_weight,
                       std::span<double> area);

/// Drainage area of each vertex (m²): its cell's, times the rain's weight, and its donors'. Of base
/// level what reaches it.
std::vector<double> drainage_area(const TinFlow& flow, const Context& context,
                                  const VertexValues& rain_weight = 1.0);

}  // namespace orogen
