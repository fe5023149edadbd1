#include "inputs/river_network.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "inputs/ring_arrangement.h"
#include "inputs/river_clip.h"
#include "inputs/river_connections.h"

namespace orogen {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Directs the chains of a graph to its outlets and joins them up to rivers.
class Drainage {
 public:
  Drainage(const RiverGraph& graph, const std::vector<Outlet>& outlets, const RiverScene& scene)
      : graph_(graph), outlets_(outlets), scene_(scene) {}

  std::vector<River> rivers() {
    measure();
    direct();
    choose_stems();
    return assemble();
  }

 private:
  /// A chain with its direction.
  struct Reach {
    int up = -1, down = -1;  // vertices; -1: left out
    bool stem = false;       // the way out of `up`; else a fork, begun afresh below it
    double upstream = 0.0;   // m, longest way from a source to its lower end
    int feeder = -1;         // the reach that it carries on
  };

  int other_end(int c, int v) const {
    const Chain& chain = graph_.chains[c];
    return chain.first() == v ? chain.last() : chain.first();
  }

  /// Least way along the graph from an outlet to each node, and the chain by which it leaves there.
  void measure() {
    distance_.assign(graph_.points.size(), kFar);
    way_out_.assign(graph_.points.size(), -1);
    struct Entry {
      double distance;
      int vertex;
      bool operator<(const Entry& b) const {
        return distance != b.distance ? distance > b.distance : vertex > b.vertex;
      }
    };
    std::priority_queue<Entry> queue;
    for (std::size_t v = 0; v < outlets_.size(); ++v)
      if (outlets_[v].here) {
        distance_[v] = outlets_[v].handicap;
        queue.push({distance_[v], int(v)});
      }
    while (!queue.empty()) {
      const Entry e = queue.top();
      queue.pop();
      if (e.distance > distance_[e.vertex]) continue;
      for (const int c : graph_.at[e.vertex]) {
        const int w = other_end(c, e.vertex);
        const double d = e.distance + graph_.chains[c].length;
        if (d >= distance_[w]) continue;
        distance_[w] = d;
        way_out_[w] = c;
        queue.push({d, w});
      }
    }
  }

  void direct() {
    reaches_.resize(graph_.chains.size());
    for (std::size_t c = 0; c < reaches_.size(); ++c) {
      const Chain& chain = graph_.chains[c];
      const int a = chain.first(), b = chain.last();
      if (a == b || distance_[a] == kFar) {
        scene_.report.warn(scene_.words(chain.river) + ": a loop of " +
                           distance_words(chain.length) + " at " +
                           scene_.report.place(graph_.points[a]) + " cut off");
        continue;
      }
      const bool onward = way_out_[a] == int(c)          ? true
                          : way_out_[b] == int(c)        ? false
                          : distance_[a] != distance_[b] ? distance_[a] > distance_[b]
                                                         : chain.drawn_onward;
      Reach& reach = reaches_[c];
      reach.up = onward ? a : b;
      reach.down = onward ? b : a;
      reach.stem = way_out_[reach.up] == int(c);
      if (!reach.stem && graph_.at[reach.up].size() > 1) check_fork(int(c), reach);
    }
  }

  /// A reach that leaves a node beside the stem goes if it rejoins the stem soon.
  void check_fork(int c, Reach& reach) {
    const Chain& chain = graph_.chains[c];
    bool rejoins = false;
    for (int v = reach.up; way_out_[v] >= 0 && !rejoins;) {
      v = other_end(way_out_[v], v);
      rejoins = v == reach.down;
    }
    const std::string at = scene_.report.place(graph_.points[reach.up]);
    if (chain.length < (rejoins ? 1.0 : 0.2) * scene_.snap) {
      scene_.report.warn(scene_.words(chain.river) + ": a side branch of " +
                         distance_words(chain.length) + " from " + at + " left out");
      reach = {};
      return;
    }
    scene_.report.warn(scene_.words(chain.river) + ": crosses or forks at " + at +
                       "; joined there, the lesser branch begins afresh below");
  }

  /// Which of the reaches that meet goes on: the same river, the same name; the longest of those.
  void choose_stems() {
    std::vector<int> order;
    std::vector<std::vector<int>> into(graph_.points.size());
    for (std::size_t c = 0; c < reaches_.size(); ++c)
      if (reaches_[c].up >= 0) {
        order.push_back(int(c));
        into[reaches_[c].down].push_back(int(c));
      }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return distance_[reaches_[a].up] > distance_[reaches_[b].up];
    });
    for (const int c : order) {
      Reach& reach = reaches_[c];
      const int river = graph_.chains[c].river;
      int best = -1, best_rank = 0;
      if (reach.stem)
        for (const int k : into[reach.up]) {
          const int other = graph_.chains[k].river;
          const int rank = other == river                                                   ? 2
                           : scene_.map.rivers[other].name == scene_.map.rivers[river].name ? 1
                                                                                            : 0;
          if (rank == 0 || rank < best_rank) continue;
          if (rank == best_rank && reaches_[k].upstream <= reaches_[best].upstream) continue;
          best = k;
          best_rank = rank;
        }
      reach.feeder = best;
      double longest = 0.0;
      if (reach.stem)
        for (const int k : into[reach.up]) longest = std::fmax(longest, reaches_[k].upstream);
      reach.upstream = graph_.chains[c].length + longest;
    }
  }

  Polyline points_of(int c) const {
    const Chain& chain = graph_.chains[c];
    Polyline points;
    for (const int v : chain.vertices) points.push_back(graph_.points[v]);
    if (reaches_[c].up != chain.first()) std::reverse(points.begin(), points.end());
    if (!reaches_[c].stem) begin_later(points, std::fmin(0.2 * scene_.snap, 0.3 * chain.length));
    return points;
  }
  static void begin_later(Polyline& points, double skip) {
    std::size_t k = 0;
    while (k + 2 < points.size()) {
      const double step = glm::length(points[k + 1] - points[k]);
      if (skip < step) break;
      skip -= step;
      ++k;
    }
    points.erase(points.begin(), points.begin() + std::ptrdiff_t(k));
    const double step = glm::length(points[1] - points[0]);
    points[0] = on_lattice(points[0] + std::fmin(skip / step, 0.5) * (points[1] - points[0]));
  }

  std::vector<River> assemble() {
    std::vector<char> goes_on(reaches_.size(), 0);
    for (const Reach& reach : reaches_)
      if (reach.up >= 0 && reach.feeder >= 0) goes_on[reach.feeder] = 1;
    std::vector<int> lowest;  // the last reach of each river
    for (std::size_t c = 0; c < reaches_.size(); ++c)
      if (reaches_[c].up >= 0 && !goes_on[c]) lowest.push_back(int(c));
    std::stable_sort(lowest.begin(), lowest.end(),
                     [&](int a, int b) { return graph_.chains[a].river < graph_.chains[b].river; });
    std::vector<int> number(reaches_.size(), -1);
    std::vector<River> rivers;
    for (const int last : lowest) {
      std::vector<int> course;
      for (int c = last; c >= 0; c = reaches_[c].feeder) {
        number[c] = int(rivers.size());
        course.push_back(c);
      }
      const River& drawn = scene_.map.rivers[graph_.chains[last].river];
      River river{{}, RiverEnd::Sea, -1, {}, drawn.rank, drawn.name, drawn.feature};
      for (; !course.empty(); course.pop_back()) {
        const Polyline points = points_of(course.back());
        river.points.insert(river.points.end(), points.begin() + (river.points.empty() ? 0 : 1),
                            points.end());
      }
      rivers.push_back(std::move(river));
    }
    for (std::size_t i = 0; i < lowest.size(); ++i) set_end(rivers[i], lowest[i], number);
    return rivers;
  }

  void set_end(River& river, int last, const std::vector<int>& number) const {
    const int mouth = reaches_[last].down;
    if (way_out_[mouth] >= 0) {
      river.end = RiverEnd::River;
      river.joins = number[way_out_[mouth]];
      return;
    }
    river.end = outlets_[mouth].kind;
    river.joins = outlets_[mouth].lake;
    if (river.end == RiverEnd::Frame)
      river.end_height_m = scene_.map.rivers[graph_.chains[last].river].end_height_m;
  }

  const RiverGraph& graph_;
  const std::vector<Outlet>& outlets_;
  const RiverScene& scene_;
  std::vector<double> distance_;
  std::vector<int> way_out_;
  std::vector<Reach> reaches_;
};

}  // namespace

void connect_rivers(VectorMap& map, const std::vector<RiverHint>& hints, const LandRegion& land,
                    const ReadOptions& options, MapReport& report) {
  const double longer = std::fmax(map.frame.size.x, map.frame.size.y);
  const RiverScene scene{map, hints, land, std::fmin(options.snap_distance, 0.05 * longer), report};
  std::vector<RiverLine> lines = clip_rivers(map.rivers, land, report);
  RiverGraph graph;
  std::vector<Outlet> outlets;
  for (int round = 0; round < 10; ++round) {
    node_lines(lines);
    graph = make_graph(lines);
    outlets = find_outlets(graph, scene);
    if (round == 0 && cut_overshoots(lines, graph, outlets, scene)) continue;
    if (!connect_parts(lines, graph, outlets, scene)) break;
  }
  map.rivers = Drainage(graph, outlets, scene).rivers();
}

}  // namespace orogen
