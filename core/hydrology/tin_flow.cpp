#include "hydrology/tin_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr std::size_t kChunk = 4096;
constexpr std::size_t kParts = 64;

}  // namespace

TinFlow::TinFlow(const Tin& tin, std::span<const std::uint8_t> base_level)
    : tin_(&tin),
      per_length_(tin.edge_lengths.size()),
      receivers_(tin.size()),
      distances_(tin.size()) {
  for (std::size_t e = 0; e < per_length_.size(); ++e) per_length_[e] = 1.0f / tin.edge_lengths[e];
  set_base_level(base_level);
}

void TinFlow::set_base_level(std::span<const std::uint8_t> base_level) {
  const Tin& tin = *tin_;
  if (base_level.size() != tin.size())
    throw InputError("base_level: " + std::to_string(base_level.size()) + " values, the TIN has " +
                     std::to_string(tin.size()) + " vertices");
  if (std::ranges::equal(base_level, base_)) return;
  base_.assign(base_level.begin(), base_level.end());
  land_count_ = 0;
  shore_.clear();
  for (std::int32_t v = 0; v < std::int32_t(tin.size()); ++v) {
    receivers_[v] = v;
    distances_[v] = 0.0f;
    const auto neighbors = tin.neighbors_of(v);
    land_count_ += !base_[v];
    if (base_[v] && !std::ranges::all_of(neighbors, [&](std::int32_t n) { return base_[n]; }))
      shore_.push_back(v);
  }
  if (land_count_ == tin.size())
    throw InputError("base_level: no vertex is base level; water needs at least one");
  const std::size_t parts = std::min(kParts, shore_.size());
  parts_.clear();
  for (std::size_t p = 0; p < parts; ++p)
    parts_.push_back({.roots_begin = std::int32_t(shore_.size() * p / parts),
                      .roots_end = std::int32_t(shore_.size() * (p + 1) / parts)});
}

void TinFlow::route(std::span<const double> elevation, const Context& context) {
  if (elevation.size() != tin_->size())
    throw InputError("elevation: " + std::to_string(elevation.size()) + " values, the TIN has " +
                     std::to_string(tin_->size()) + " vertices");
  find_receivers(elevation.data(), context);
  if (!pits_.empty()) cross_flats(elevation.data());
  if (!pits_.empty()) join_basins(elevation.data(), context);
  const auto grow_parts = [&](std::size_t p, std::size_t) { grow(parts_[p]); };
  if (tin_->size() < kFewVertices)
    for (std::size_t p = 0; p < parts_.size(); ++p) grow_parts(p, p + 1);
  else
    parallel_chunks(context, parts_.size(), 1, grow_parts);
  std::size_t placed = 0;
  for (const Part& part : parts_) placed += part.count - (part.roots_end - part.roots_begin);
  if (placed != land_count_)
    throw std::logic_error("TIN flow: a vertex does not drain");  // never, by construction
}

void TinFlow::find_receivers(const double* z, const Context& context) {
  const std::int32_t* first_edge = tin_->first_edge.data();
  const std::int32_t* neighbors = tin_->neighbors.data();
  chunk_pits_.resize((tin_->size() + kChunk - 1) / kChunk);
  parallel_chunks(context, chunk_pits_.size(), 1, [&](std::size_t chunk, std::size_t) {
    auto& pits = chunk_pits_[chunk];
    pits.clear();
    const std::size_t last = std::min(tin_->size(), (chunk + 1) * kChunk);
    for (std::size_t v = chunk * kChunk; v < last; ++v) {
      const double height = z[v];
      if (!(std::fabs(height) <= std::numeric_limits<double>::max()))
        throw InputError("elevation: not finite at vertex " + std::to_string(v));
      if (base_[v]) continue;
      double steepest = 0.0;
      std::int32_t found = -1;
      for (std::int32_t e = first_edge[v]; e < first_edge[v + 1]; ++e) {
        const double slope = (height - z[neighbors[e]]) * per_length_[e];
        found = slope > steepest ? e : found;
        steepest = slope > steepest ? slope : steepest;
      }
      if (found < 0) {
        receivers_[v] = std::int32_t(v);
        pits.push_back(std::int32_t(v));
      } else {
        receivers_[v] = neighbors[found];
        distances_[v] = tin_->edge_lengths[found];
      }
    }
  });
  pits_.clear();
  for (const auto& pits : chunk_pits_) pits_.insert(pits_.end(), pits.begin(), pits.end());
}

/// Breadth first from where water leaves a flat; in a closed flat, from one of its vertices.
void TinFlow::cross_flats(const double* z) {
  std::vector<std::int32_t> front;
  const auto is_pit = [&](std::int32_t v) { return !base_[v] && receivers_[v] == v; };
  const auto spread = [&](std::int32_t root) {
    for (std::size_t done = 0; done < front.size(); ++done)
      for (std::int32_t n : tin_->neighbors_of(front[done]))
        if (n != root && z[n] == z[front[done]] && is_pit(n)) {
          receivers_[n] = front[done];
          distances_[n] = distance_between(n, front[done]);
          front.push_back(n);
        }
    front.clear();
  };
  for (std::int32_t v : pits_)
    for (std::int32_t n : tin_->neighbors_of(v))
      if (z[n] == z[v] && !is_pit(n)) front.push_back(n);
  spread(-1);
  for (std::int32_t v : pits_) {
    if (!is_pit(v)) continue;
    front.push_back(v);
    spread(v);
  }
  std::erase_if(pits_, [&](std::int32_t v) { return !is_pit(v); });
}

void TinFlow::join_basins(const double* z, const Context& context) {
  labels_.resize(tin_->size());
  label_basins(context);
  find_passes(z, context);
  for (const BasinOutlet& outlet : basins_.join(pits_.size() + 1, labels_))
    turn_path(outlet.from, outlet.to);
  parallel_chunks(context, basin_vertices_.size(), 1, [&](std::size_t task, std::size_t) {
    for (std::int32_t v : basin_vertices_[task]) labels_[v] = 0;
  });
}

void TinFlow::label_basins(const Context& context) {
  constexpr std::size_t kPitsPerTask = 128;
  basin_vertices_.resize((pits_.size() + kPitsPerTask - 1) / kPitsPerTask);
  parallel_chunks(context, basin_vertices_.size(), 1, [&](std::size_t task, std::size_t) {
    auto& found = basin_vertices_[task];
    found.clear();
    const std::size_t last = std::min(pits_.size(), (task + 1) * kPitsPerTask);
    for (std::size_t p = task * kPitsPerTask; p < last; ++p) {
      std::size_t done = found.size();
      found.push_back(pits_[p]);
      for (; done < found.size(); ++done) {
        const std::int32_t v = found[done];
        labels_[v] = std::int32_t(p + 1);
        for (std::int32_t n : tin_->neighbors_of(v))
          if (receivers_[n] == v && n != v) found.push_back(n);
      }
    }
  });
}

/// The lowest passes between neighbouring basins; of a pair there may be a few.
void TinFlow::find_passes(const double* z, const Context& context) {
  task_passes_.resize(basin_vertices_.size());
  parallel_chunks(context, task_passes_.size(), 1, [&](std::size_t task, std::size_t) {
    auto& passes = task_passes_[task];
    passes.clear();
    std::uint32_t seen[256] = {};  // where a pair's pass may be found
    for (std::int32_t v : basin_vertices_[task]) {
      const std::int32_t own = labels_[v];
      for (std::int32_t n : tin_->neighbors_of(v)) {
        const std::int32_t other = labels_[n];
        if (other >= own) continue;  // the other basin's task sees the pair too
        const std::uint64_t key = rising_bits(std::max(z[v], z[n]));
        std::uint32_t& at = seen[std::uint32_t(other) % 256];
        if (at < passes.size() && passes[at].basins[0] == own && passes[at].basins[1] == other) {
          if (key < passes[at].key) passes[at] = {key, {own, other}, {v, n}};
        } else {
          at = std::uint32_t(passes.size());
          passes.push_back({key, {own, other}, {v, n}});
        }
      }
    }
  });
  basins_.passes.clear();
  for (const auto& passes : task_passes_)
    basins_.passes.insert(basins_.passes.end(), passes.begin(), passes.end());
}

/// Makes the way from a pit to `from` run back, and on from there to `to`.
void TinFlow::turn_path(std::int32_t from, std::int32_t to) {
  float distance = distance_between(from, to);
  while (true) {
    const std::int32_t before = receivers_[from];
    receivers_[from] = to;
    std::swap(distances_[from], distance);
    if (before == from) return;
    to = from;
    from = before;
  }
}

float TinFlow::distance_between(std::int32_t from, std::int32_t to) const {
  const auto neighbors = tin_->neighbors_of(from);
  const auto at = std::lower_bound(neighbors.begin(), neighbors.end(), to) - neighbors.begin();
  return tin_->edge_lengths[tin_->first_edge[from] + at];
}

/// Breadth first from the part's roots.
void TinFlow::grow(Part& part) const {
  const std::int32_t* first_edge = tin_->first_edge.data();
  const std::int32_t* neighbors = tin_->neighbors.data();
  const std::int32_t* receivers = receivers_.data();
  std::int32_t count = part.roots_end - part.roots_begin;
  std::size_t room = part.vertices.size();
  const auto make_room = [&](std::size_t wanted) {
    if (room >= wanted) return;
    room = 2 * wanted;
    part.vertices.resize(room);
    part.parents.resize(room);
  };
  make_room(count);
  for (std::int32_t k = 0; k < count; ++k) {
    part.vertices[k] = shore_[part.roots_begin + k];
    part.parents[k] = k;
  }
  for (std::int32_t done = 0; done < count; ++done) {
    const std::int32_t v = part.vertices[done];
    const std::int32_t begin = first_edge[v], end = first_edge[v + 1];
    make_room(std::size_t(count) + (end - begin));
    std::int32_t* vertices = part.vertices.data();
    std::int32_t* parents = part.parents.data();
    for (std::int32_t e = begin; e < end; ++e) {
      const std::int32_t n = neighbors[e];
      vertices[count] = n;
      parents[count] = done;
      count += receivers[n] == v;
    }
  }
  part.count = count;
}

std::vector<std::int32_t> TinFlow::order() const {
  std::vector<std::int32_t> order;
  order.reserve(land_count_);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const FlowTrees trees = part(p);
    order.insert(order.end(), trees.vertices.begin() + trees.roots, trees.vertices.end());
  }
  return order;
}

void sum_drainage_area(const Tin& tin, const FlowTrees& part, const VertexValues& rain_weight,
                       std::span<double> area) {
  const std::size_t count = part.vertices.size(), roots = std::size_t(part.roots);
  std::fill_n(area.begin(), roots, 0.0);
  for (std::size_t k = roots; k < count; ++k) area[k] = tin.cell_areas[part.vertices[k]];
  if (!rain_weight.values.empty() || rain_weight.value != 1.0)
    for (std::size_t k = roots; k < count; ++k) area[k] *= rain_weight.at(part.vertices[k]);
  for (std::size_t k = count; k-- > roots;) area[part.parents[k]] += area[k];
}

std::vector<double> drainage_area(const TinFlow& flow, const Context& context,
                                  const VertexValues& rain_weight) {
  rain_weight.check(flow.tin().size(), "rain_weight");
  std::vector<double> area(flow.tin().size(), 0.0);
  flow.visit(context, [&](const FlowTrees& part, std::size_t) {
    std::vector<double> ordered(part.vertices.size());
    sum_drainage_area(flow.tin(), part, rain_weight, ordered);
    for (std::size_t k = 0; k < ordered.size(); ++k) area[part.vertices[k]] = ordered[k];
  });
  return area;
}

}  // namespace orogen
