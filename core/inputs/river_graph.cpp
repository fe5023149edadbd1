#include "inputs/river_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_map>

#include "foundation/errors.h"
#include "inputs/ring_arrangement.h"
#include "inputs/segment_tree.h"

namespace orogen {
namespace {

constexpr double kNear = 0.5;  // m, a vertex this near takes the place of a crossing
constexpr std::size_t kMostPairs = 50'000'000;  // compared in one pass
constexpr std::size_t kMostCrossings = 100'000;

/// A vertex to be put into a segment.
struct Split {
  int line, index;
  double t;
  glm::dvec2 point;
};

/// Points by squares of kNear, so that crossings close to each other become one.
class Vertices {
 public:
  void add(glm::dvec2 p) {
    const auto [x, y] = square(p);
    squares_[key(x, y)].push_back(p);
  }

  /// The nearest point known within kNear; else p, known from now on.
  glm::dvec2 settle(glm::dvec2 p) {
    const auto [x, y] = square(p);
    double least = kNear;
    glm::dvec2 nearest = p;
    for (long dx = -1; dx <= 1; ++dx)
      for (long dy = -1; dy <= 1; ++dy) {
        const auto found = squares_.find(key(x + dx, y + dy));
        if (found == squares_.end()) continue;
        for (const glm::dvec2 q : found->second)
          if (glm::length(q - p) < least) least = glm::length(q - p), nearest = q;
      }
    if (least == kNear) squares_[key(x, y)].push_back(p);
    return nearest;
  }

  /// Is p a vertex more than once?
  bool shared(glm::dvec2 p) const {
    const auto [x, y] = square(p);
    const auto found = squares_.find(key(x, y));
    return found != squares_.end() && std::count(found->second.begin(), found->second.end(), p) > 1;
  }

 private:
  static std::pair<long, long> square(glm::dvec2 p) {
    return {std::lround(p.x / kNear), std::lround(p.y / kNear)};
  }
  static std::uint64_t key(long x, long y) {  // distinct: |x|, |y| < 2^31
    return (std::uint64_t(std::uint32_t(x)) << 32) | std::uint32_t(y);
  }
  std::unordered_map<std::uint64_t, std::vector<glm::dvec2>> squares_;  // looked up only
};

class Noder {
 public:
  explicit Noder(std::vector<RiverLine>& lines) : lines_(lines) {}

  /// One pass; false if nothing had to be split.
  bool pass() {
    std::vector<Segment> segments;
    for (std::size_t k = 0; k < lines_.size(); ++k)
      append_segments(segments, lines_[k].points, false, int(k));
    const SegmentTree tree(std::move(segments));
    splits_.clear();
    moves_.clear();
    pairs_ = 0;
    vertices_ = {};
    for (const RiverLine& line : lines_)
      for (const glm::dvec2 p : line.points) vertices_.add(p);
    for (std::size_t i = 0; i < tree.segments().size(); ++i) {
      const Segment& s = tree.segments()[i];
      Box box;
      box.add(glm::min(s.a, s.b) - kTouch);
      box.add(glm::max(s.a, s.b) + kTouch);
      tree.visit(box, [&](std::size_t j) {
        if (++pairs_ > kMostPairs) refuse(s.a);
        if (j > i) compare(s, tree.segments()[j]);
      });
    }
    insert();
    move_ends();
    return !splits_.empty() || !moves_.empty();
  }

 private:
  [[noreturn]] static void refuse(glm::dvec2 p) {
    throw InputError("features: the rivers are too tangled to be told apart, near (" +
                     std::to_string(std::llround(p.x)) + " m, " +
                     std::to_string(std::llround(p.y)) + " m)");
  }
  bool line_end(const Segment& s, bool second) const {
    return second ? s.index + 2 == int(lines_[s.line].points.size()) : s.index == 0;
  }

  void compare(const Segment& s, const Segment& t) {
    if (s.line == t.line && std::abs(s.index - t.index) == 1) return;
    const bool touched =
        touch(s, false, t) | touch(s, true, t) | touch(t, false, s) | touch(t, true, s);
    if (touched || s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) return;
    const glm::dvec2 u = s.b - s.a, v = t.b - t.a, w = t.a - s.a;
    const double cross = u.x * v.y - u.y * v.x;
    if (cross == 0.0) return;
    const double p = (w.x * v.y - w.y * v.x) / cross, q = (w.x * u.y - w.y * u.x) / cross;
    if (!(p > 0.0 && p < 1.0 && q > 0.0 && q < 1.0)) return;
    const glm::dvec2 x = vertices_.settle(on_lattice(s.a + p * u));
    split(s, p, x);
    split(t, q, x);
  }

  /// Does an end of s touch t? If at one of t's vertices, it moves onto it.
  bool touch(const Segment& s, bool second, const Segment& t) {
    const glm::dvec2 p = second ? s.b : s.a, u = t.b - t.a;
    if (p == t.a || p == t.b) return false;
    const bool end = line_end(s, second) && s.line != t.line;
    const double at = glm::dot(p - t.a, u) / glm::dot(u, u);
    if (!(at > 0.0 && at < 1.0)) {
      const bool far = at >= 1.0;  // end of t
      if (end && glm::length(p - (far ? t.b : t.a)) <= kTouch &&
          (!line_end(t, far) || t.line < s.line) && !vertices_.shared(p))
        moves_.push_back({s.line, s.index + int(second), 0.0, far ? t.b : t.a});
      return false;
    }
    if (glm::length(t.a + at * u - p) > (end ? kTouch : kNear)) return false;
    split(t, at, p);
    return true;
  }

  void split(const Segment& s, double t, glm::dvec2 point) {
    if (point == s.a || point == s.b) return;
    if (splits_.size() >= kMostCrossings) refuse(point);
    splits_.push_back({s.line, s.index, t, point});
  }

  void insert() {
    std::stable_sort(splits_.begin(), splits_.end(), [](const Split& a, const Split& b) {
      return std::tie(a.line, a.index, a.t) < std::tie(b.line, b.index, b.t);
    });
    for (std::size_t k = 0; k < splits_.size();) {
      const int line = splits_[k].line;
      Polyline points;
      const Polyline& old = lines_[line].points;
      for (std::size_t i = 0; i < old.size(); ++i) {
        if (points.empty() || points.back() != old[i]) points.push_back(old[i]);
        for (; k < splits_.size() && splits_[k].line == line && splits_[k].index == int(i); ++k)
          if (points.back() != splits_[k].point) points.push_back(splits_[k].point);
      }
      lines_[line].points = std::move(points);
    }
  }

  /// Moves are of first and last points, whatever was put between.
  void move_ends() {
    for (const Split& move : moves_) {
      Polyline& points = lines_[move.line].points;
      (move.index == 0 ? points.front() : points.back()) = move.point;
      points.erase(std::unique(points.begin(), points.end()), points.end());
    }
  }

  std::vector<RiverLine>& lines_;
  Vertices vertices_;
  std::vector<Split> splits_, moves_;
  std::size_t pairs_ = 0;
};

/// Single edges between vertices, each drawn once.
struct EdgeList {
  struct Edge {
    int a, b, river;
  };
  std::vector<Edge> edges;                  // in drawn order and direction
  std::vector<std::vector<int>> at_vertex;  // edges at each vertex
};

EdgeList list_edges(const std::vector<RiverLine>& lines, std::vector<glm::dvec2>& points) {
  std::vector<std::tuple<double, double>> sorted;
  for (const RiverLine& line : lines)
    for (const glm::dvec2 p : line.points) sorted.emplace_back(p.x, p.y);
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  for (const auto& [x, y] : sorted) points.emplace_back(x, y);
  const auto number = [&](glm::dvec2 p) {
    return int(std::lower_bound(sorted.begin(), sorted.end(), std::tuple(p.x, p.y)) -
               sorted.begin());
  };
  EdgeList list;
  list.at_vertex.resize(points.size());
  std::map<std::pair<int, int>, int> known;
  for (const RiverLine& line : lines)
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      const int a = number(line.points[i]), b = number(line.points[i + 1]);
      if (a == b || !known.emplace(std::minmax(a, b), 0).second) continue;
      list.at_vertex[a].push_back(int(list.edges.size()));
      list.at_vertex[b].push_back(int(list.edges.size()));
      list.edges.push_back({a, b, line.river});
    }
  return list;
}

}  // namespace

void node_lines(std::vector<RiverLine>& lines) {
  Noder noder(lines);
  for (int round = 0; round < 10 && noder.pass(); ++round) {
  }
}

RiverGraph make_graph(const std::vector<RiverLine>& noded) {
  RiverGraph graph;
  const EdgeList list = list_edges(noded, graph.points);
  graph.at.resize(graph.points.size());
  std::vector<char> used(list.edges.size(), 0);
  const auto is_node = [&](int v) {
    const auto& e = list.at_vertex[v];
    return e.size() != 2 || list.edges[e[0]].river != list.edges[e[1]].river;
  };
  const auto trace = [&](int start, int edge) {
    Chain chain{{start}, list.edges[edge].river, 0.0, list.edges[edge].a == start};
    for (int v = start;;) {
      used[edge] = 1;
      const int next = list.edges[edge].a == v ? list.edges[edge].b : list.edges[edge].a;
      chain.length += glm::length(graph.points[next] - graph.points[v]);
      chain.vertices.push_back(next);
      v = next;
      if (v == start || is_node(v)) break;
      const auto& e = list.at_vertex[v];
      edge = e[0] == edge ? e[1] : e[0];
    }
    graph.at[chain.first()].push_back(int(graph.chains.size()));
    graph.at[chain.last()].push_back(int(graph.chains.size()));
    graph.chains.push_back(std::move(chain));
  };
  for (const bool rings : {false, true})  // closed rings without a node come last
    for (std::size_t v = 0; v < graph.points.size(); ++v)
      if (rings || is_node(int(v)))
        for (const int edge : list.at_vertex[v])
          if (!used[edge]) trace(int(v), edge);
  return graph;
}

}  // namespace orogen
