#include "tectonics/peak_chains.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace orogen {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kStraightness = 0.75;  // chord over arc of a chain, over any five peaks in a row

double length(glm::dvec2 v) {
  return std::hypot(v.x, v.y);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double squared = along.x * along.x + along.y * along.y;
  const double t = squared > 0.0 ? ((p.x - a.x) * along.x + (p.y - a.y) * along.y) / squared : 0.0;
  return length(p - a - std::clamp(t, 0.0, 1.0) * along);
}

// Numbers of the first peak at each place.
std::vector<int> distinct(std::span<const glm::dvec2> peaks) {
  std::vector<int> order(peaks.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) { return std::pair(peaks[i].x, peaks[i].y); };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  order.erase(
      std::unique(order.begin(), order.end(), [&](int a, int b) { return key(a) == key(b); }),
      order.end());
  std::sort(order.begin(), order.end());
  return order;
}

using Tree = std::vector<std::vector<std::pair<int, double>>>;  // neighbours and distances

// Prim's algorithm, O(n²).
Tree spanning_tree(const std::vector<glm::dvec2>& p) {
  const int n = int(p.size());
  Tree tree(n);
  std::vector<double> distance(n, kInfinity);
  std::vector<int> parent(n, -1);
  std::vector<char> in(n, 0);
  for (int step = 0, at = 0; step + 1 < n; ++step) {
    in[at] = 1;
    int next = -1;
    for (int i = 0; i < n; ++i) {
      if (in[i]) continue;
      const double d = length(p[i] - p[at]);
      if (d < distance[i]) distance[i] = d, parent[i] = at;
      if (next < 0 || distance[i] < distance[next]) next = i;
    }
    tree[next].push_back({parent[next], distance[next]});
    tree[parent[next]].push_back({next, distance[next]});
    at = next;
  }
  return tree;
}

// Members of the tree's part around `start`, and the way to the farthest of them.
std::pair<std::vector<int>, std::vector<int>> walk(const Tree& tree, int start) {
  std::vector<int> members{start}, parent(tree.size(), -1);
  std::vector<double> way(tree.size(), 0.0);
  int farthest = start;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const int at = members[i];
    if (way[at] > way[farthest]) farthest = at;
    for (auto [next, d] : tree[at]) {
      if (next == parent[at]) continue;
      parent[next] = at;
      way[next] = way[at] + d;
      members.push_back(next);
    }
  }
  std::vector<int> path;
  for (int at = farthest; at != -1; at = parent[at]) path.push_back(at);
  return {members, path};
}

bool is_line(const std::vector<glm::dvec2>& p, const std::vector<int>& members,
             const std::vector<int>& path, double width_factor) {
  double arc = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) arc += length(p[path[i]] - p[path[i - 1]]);
  const double spacing = arc / std::max<std::size_t>(path.size() - 1, 1);
  for (int m : members) {
    double nearest = kInfinity;
    for (std::size_t i = 1; i < path.size(); ++i)
      nearest = std::min(nearest, distance_to_segment(p[m], p[path[i - 1]], p[path[i]]));
    if (nearest > width_factor * spacing) return false;
  }
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::size_t last = std::min(i + 4, path.size() - 1);
    double part = 0.0;
    for (std::size_t j = i + 1; j <= last; ++j) part += length(p[path[j]] - p[path[j - 1]]);
    if (length(p[path[last]] - p[path[i]]) < kStraightness * part) return false;
  }
  return true;
}

}  // namespace

PeakPattern find_peak_pattern(std::span<const glm::dvec2> peaks,
                              const ChainParameters& parameters) {
  PeakPattern pattern;
  pattern.isolated.assign(peaks.size(), 0);
  const std::vector<int> ids = distinct(peaks);
  const int n = int(ids.size());
  if (n == 1) pattern.isolated.assign(peaks.size(), 1);
  if (n < 2) return pattern;
  std::vector<glm::dvec2> p;
  for (int id : ids) p.push_back(peaks[id]);

  Tree tree = spanning_tree(p);
  std::vector<double> edges, nearest(n, kInfinity);
  for (int i = 0; i < n; ++i)
    for (auto [j, d] : tree[i]) {
      nearest[i] = std::min(nearest[i], d);  // a point's nearest neighbour is joined to it
      if (i < j) edges.push_back(d);
    }
  const double usual = median(nearest), link = parameters.linking_factor * median(edges);
  for (int i = 0; i < n; ++i) {
    pattern.isolated[ids[i]] = n > 2 && nearest[i] > parameters.isolation_factor * usual;
    std::erase_if(tree[i], [&](const auto& edge) { return edge.second > link; });
  }
  std::vector<char> seen(n, 0);
  for (int i = 0; i < n; ++i) {
    if (seen[i]) continue;
    const auto [members, there] = walk(tree, i);
    for (int m : members) seen[m] = 1;
    if (int(members.size()) < parameters.minimum_peaks) continue;
    const auto path = walk(tree, there.front()).second;
    if (!is_line(p, members, path, parameters.width_factor)) continue;
    std::vector<int> chain;
    for (int m : path) chain.push_back(ids[m]);
    pattern.chains.push_back(std::move(chain));
  }
  return pattern;
}

}  // namespace orogen
