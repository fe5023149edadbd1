#include "hydrology/basin_graph.h"

#include <limits>
#include <utility>

namespace orogen {

std::span<const BasinOutlet> BasinGraph::join(std::size_t basins,
                                              std::span<const std::int32_t> labels) {
  span_tree(basins);
  drain(basins, labels);
  return outlets_;
}

/// Boruvka's algorithm: each basin joins the neighbour over its lowest pass, until all are one.
void BasinGraph::span_tree(std::size_t basins) {
  tree_.clear();
  merged_.resize(basins);
  for (std::size_t b = 0; b < basins; ++b) merged_[b] = std::int32_t(b);
  while (true) {
    lowest_key_.assign(basins, std::numeric_limits<std::uint64_t>::max());
    lowest_.assign(basins, -1);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < passes.size(); ++i) {
      BasinPass pass = passes[i];
      pass.basins[0] = merged_[pass.basins[0]];
      pass.basins[1] = merged_[pass.basins[1]];
      if (pass.basins[0] == pass.basins[1]) continue;
      for (std::int32_t b : pass.basins)
        if (pass.key < lowest_key_[b]) {
          lowest_key_[b] = pass.key;
          lowest_[b] = std::int32_t(kept);
        }
      passes[kept++] = pass;
    }
    passes.resize(kept);
    if (kept == 0) return;
    // Each basin points at the one it joins; of two that chose each other the first stays.
    for (std::size_t b = 0; b < basins; ++b) {
      merged_[b] = std::int32_t(b);
      if (b == 0 || lowest_[b] < 0) continue;
      const BasinPass& pass = passes[lowest_[b]];
      const std::int32_t other = pass.basins[pass.basins[0] == std::int32_t(b)];
      if (other != 0 && lowest_[other] == lowest_[b] && std::int32_t(b) < other) continue;
      merged_[b] = other;
      tree_.push_back(pass);
    }
    for (std::size_t b = 0; b < basins; ++b) {
      std::int32_t root = std::int32_t(b);
      while (merged_[root] != root) root = merged_[root];
      for (std::int32_t at = std::int32_t(b); at != root;) at = std::exchange(merged_[at], root);
    }
  }
}

/// From basin 0 outward over the tree.
void BasinGraph::drain(std::size_t basins, std::span<const std::int32_t> labels) {
  edge_begin_.assign(basins + 1, 0);
  edges_.resize(2 * tree_.size());
  for (const BasinPass& pass : tree_)
    for (std::int32_t cell : pass.cells) ++edge_begin_[labels[cell] + 1];
  for (std::size_t b = 0; b < basins; ++b) edge_begin_[b + 1] += edge_begin_[b];
  merged_.assign(edge_begin_.begin(), edge_begin_.end());  // where the next edge goes
  for (std::size_t e = 0; e < tree_.size(); ++e)
    for (int side : {0, 1})
      edges_[merged_[labels[tree_[e].cells[side]]]++] = std::int32_t(2 * e + side);
  outlets_.clear();
  queue_.assign(1, 0);
  reached_.assign(basins, 0);
  reached_[0] = 1;
  for (std::size_t done = 0; done < queue_.size(); ++done) {
    const std::int32_t basin = queue_[done];
    for (std::int32_t i = edge_begin_[basin]; i < edge_begin_[basin + 1]; ++i) {
      const BasinPass& pass = tree_[edges_[i] / 2];
      const int side = edges_[i] % 2;
      const std::int32_t from = pass.cells[1 - side], next = labels[from];
      if (reached_[next]) continue;
      reached_[next] = 1;
      queue_.push_back(next);
      outlets_.push_back({from, pass.cells[side]});
    }
  }
}

}  // namespace orogen
