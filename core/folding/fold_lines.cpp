#include "folding/fold_lines.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <tuple>
#include <utility>

#include "foundation/random.h"

namespace orogen {

namespace {

bool before(glm::dvec2 p, glm::dvec2 q) {
  return std::tie(p.x, p.y) < std::tie(q.x, q.y);
}

// The segments as a graph: nodes by place, and the segments at each node in order.
class Graph {
 public:
  explicit Graph(std::span<const Segment> segments) : used_(segments.size(), false) {
    for (const Segment& s : segments) {
      nodes_.push_back(s.a);
      nodes_.push_back(s.b);
    }
    std::sort(nodes_.begin(), nodes_.end(), before);
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    const auto number = [&](glm::dvec2 p) {
      return int(std::lower_bound(nodes_.begin(), nodes_.end(), p, before) - nodes_.begin());
    };
    first_.assign(nodes_.size() + 1, 0);
    for (const Segment& s : segments) ends_.push_back({number(s.a), number(s.b)});
    for (const auto& [a, b] : ends_) {
      ++first_[a + 1];
      ++first_[b + 1];
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    at_.resize(2 * ends_.size());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (int s = 0; s < int(ends_.size()); ++s) {
      at_[next[ends_[s].first]++] = s;
      at_[next[ends_[s].second]++] = s;
    }
  }

  int nodes() const { return int(nodes_.size()); }
  int degree(int node) const { return first_[node + 1] - first_[node]; }

  // Lines that start at the node and have not been followed yet.
  void follow(int node, std::vector<FoldLine>& lines) {
    for (int i = first_[node]; i < first_[node + 1]; ++i)
      if (!used_[at_[i]]) lines.push_back(line(node, at_[i]));
  }

 private:
  FoldLine line(int start, int segment) {
    FoldLine result;
    result.points.push_back(nodes_[start]);
    int node = start;
    while (segment >= 0) {
      used_[segment] = true;
      node = ends_[segment].first == node ? ends_[segment].second : ends_[segment].first;
      result.closed = node == start;
      if (!result.closed) result.points.push_back(nodes_[node]);
      segment = result.closed ? -1 : onward(node);
    }
    if (!result.closed && before(result.points.back(), result.points.front()))
      std::reverse(result.points.begin(), result.points.end());
    for (const glm::dvec2 p : {result.points[0], result.points[1]}) {
      result.id = mix64(result.id + std::bit_cast<std::uint64_t>(p.x));
      result.id = mix64(result.id + std::bit_cast<std::uint64_t>(p.y));
    }
    return result;
  }

  int onward(int node) const {
    if (degree(node) != 2) return -1;
    const int s = at_[first_[node]];
    return used_[s] ? at_[first_[node] + 1] : s;
  }

  std::vector<glm::dvec2> nodes_;
  std::vector<std::pair<int, int>> ends_;
  std::vector<int> first_, at_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<FoldLine> fold_lines(std::span<const Segment> segments) {
  Graph graph(segments);
  std::vector<FoldLine> lines;
  for (int node = 0; node < graph.nodes(); ++node)
    if (graph.degree(node) != 2) graph.follow(node, lines);
  for (int node = 0; node < graph.nodes(); ++node) graph.follow(node, lines);  // rings
  std::stable_sort(lines.begin(), lines.end(), [](const FoldLine& a, const FoldLine& b) {
    return before(a.points.front(), b.points.front());
  });
  return lines;
}

}  // namespace orogen
