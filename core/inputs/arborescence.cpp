#include "inputs/arborescence.h"

namespace orogen {
namespace {

struct Edge {
  int parent, child;
  double cost;
};

/// The cheapest edge into each vertex.
std::vector<int> cheapest_into(int n, int root, const std::vector<Edge>& edges) {
  std::vector<int> best(n, -1);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Edge& edge = edges[e];
    if (edge.child == root || edge.parent == edge.child) continue;
    if (best[edge.child] < 0 || edge.cost < edges[best[edge.child]].cost) best[edge.child] = int(e);
  }
  return best;
}

/// Numbers of vertices after each cycle of chosen edges is shrunk to one vertex; the count, or 0 if
/// there is no cycle.
int shrink_cycles(int n, int root, const std::vector<Edge>& edges, const std::vector<int>& best,
                  std::vector<int>& number) {
  number.assign(n, -1);
  std::vector<int> seen(n, -1);
  int count = 0;
  bool any = false;
  for (int v = 0; v < n; ++v) {
    int u = v;
    while (u != root && seen[u] < 0 && best[u] >= 0) {
      seen[u] = v;
      u = edges[best[u]].parent;
    }
    if (u == root || best[u] < 0 || seen[u] != v || number[u] >= 0) continue;
    any = true;
    for (int w = u; number[w] < 0; w = edges[best[w]].parent) number[w] = count;
    ++count;
  }
  for (int& k : number)
    if (k < 0) k = count++;
  return any ? count : 0;
}

}  // namespace

std::vector<int> cheapest_arborescence(int vertices, int root,
                                       const std::vector<Hanging>& hangings) {
  // Shrink cycles level by level, then open each again at the vertex by which it is entered.
  struct Level {
    int n, root;
    std::vector<Edge> edges;
    std::vector<int> below;  // edge of the level below
    std::vector<int> best, number;
  };
  std::vector<Level> levels(1);
  levels[0] = {vertices, root, {}, {}, {}, {}};
  for (const Hanging& h : hangings) levels[0].edges.push_back({h.parent, h.child, h.cost});
  for (;;) {
    Level& level = levels.back();
    level.best = cheapest_into(level.n, level.root, level.edges);
    const int n = shrink_cycles(level.n, level.root, level.edges, level.best, level.number);
    if (n == 0) break;
    Level next{n, level.number[level.root], {}, {}, {}, {}};
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
      const Edge& edge = level.edges[e];
      const int a = level.number[edge.parent], b = level.number[edge.child];
      if (a == b || edge.child == level.root) continue;
      next.edges.push_back({a, b, edge.cost - level.edges[level.best[edge.child]].cost});
      next.below.push_back(int(e));
    }
    levels.push_back(std::move(next));
  }
  std::vector<int> chosen = levels.back().best;
  for (std::size_t k = levels.size() - 1; k-- > 0;) {
    const Level &level = levels[k], &above = levels[k + 1];
    std::vector<int> opened = level.best;
    for (const int e : chosen)
      if (e >= 0) opened[level.edges[above.below[e]].child] = above.below[e];
    chosen = std::move(opened);
  }
  return chosen;
}

}  // namespace orogen
