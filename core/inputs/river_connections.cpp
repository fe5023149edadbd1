#include "inputs/river_connections.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "inputs/arborescence.h"
#include "inputs/ring_arrangement.h"
#include "inputs/river_clip.h"
#include "inputs/river_routing.h"

namespace orogen {
namespace {

/// The nearest thing that ends a river, from a place.
struct Goal {
  RiverEnd kind;
  int lake;
  glm::dvec2 point;
  double distance;
};

std::optional<Goal> nearest_goal(const LandRegion& land, glm::dvec2 p, double frame_handicap) {
  std::optional<Goal> best;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const SegmentTree& tree, RiverEnd kind, double handicap) {
    const auto hit = tree.nearest(p);
    if (!hit || hit->distance + handicap >= least) return;
    least = hit->distance + handicap;
    best = Goal{kind, kind == RiverEnd::Lake ? tree.segments()[hit->segment].line : -1, hit->point,
                hit->distance};
  };
  offer(land.coast(), RiverEnd::Sea, 0.0);
  offer(land.lakes(), RiverEnd::Lake, 0.0);
  offer(land.frame(), RiverEnd::Frame, frame_handicap);
  return best;
}

/// A way to carry a part on: from one of its ends to a goal or to another part's line.
struct Connection {
  int end;  // vertex
  int to;   // part; -1: a goal
  glm::dvec2 point;
  double distance;
  RiverEnd kind;
  int target_river = -1;
};

class Connector {
 public:
  Connector(const RiverGraph& graph, const std::vector<Outlet>& outlets, const RiverScene& scene)
      : graph_(graph),
        outlets_(outlets),
        scene_(scene),
        part_(connected_parts(graph)),
        parts_(part_.empty() ? 0 : *std::max_element(part_.begin(), part_.end()) + 1),
        drains_(parts_, 0) {
    std::vector<Segment> segments, peaks;
    for (std::size_t c = 0; c < graph.chains.size(); ++c) {
      const Chain& chain = graph.chains[c];
      for (std::size_t i = 0; i + 1 < chain.vertices.size(); ++i)
        segments.push_back(
            {graph.points[chain.vertices[i]], graph.points[chain.vertices[i + 1]], int(c), int(i)});
      for (const int v : {chain.first(), chain.last()})
        if (outlets[v].here && outlets[v].kind != RiverEnd::Lake) drains_[part_[c]] = 1;
    }
    lines_ = SegmentTree(std::move(segments));
    for (const Peak& peak : scene.map.peaks) peaks.push_back({peak.position, peak.position, 0, 0});
    peaks_ = SegmentTree(std::move(peaks));
  }

  std::vector<Connection> choose() {
    std::vector<Connection> chosen = extra_mouths();
    std::vector<std::vector<int>> ends(parts_);
    for (std::size_t c = 0; c < graph_.chains.size(); ++c)
      for (const int v : {graph_.chains[c].first(), graph_.chains[c].last()})
        if (graph_.is_end(v) && !drains_[part_[c]]) ends[part_[c]].push_back(v);
    std::vector<Hanging> hangings;
    std::vector<Connection> ways;
    for (int p = 0; p < parts_; ++p) {
      double lowest = 1.0;
      for (const int v : ends[p]) lowest = std::fmin(lowest, height(graph_.points[v]));
      for (const int v : ends[p]) add_ways(p, v, lowest, ways, hangings);
    }
    // Parts that drain, and those that cannot be carried on, are one with the root.
    const int root = parts_;
    for (Hanging& h : hangings)
      if (h.parent < root && (drains_[h.parent] || ends[h.parent].empty())) h.parent = root;
    for (const int h : cheapest_arborescence(parts_ + 1, root, hangings))
      if (h >= 0 && ways[h].distance > 0.0) chosen.push_back(ways[h]);
    return chosen;
  }

 private:
  /// 0 at the coast, 1 at a peak: a guess of how high a place lies.
  double height(glm::dvec2 p) const {
    const auto peak = peaks_.nearest(p);
    const auto sea = scene_.land.coast().segments().empty() ? scene_.land.frame().nearest(p)
                                                            : scene_.land.coast().nearest(p);
    if (!peak || !sea) return 0.0;
    return sea->distance / (sea->distance + peak->distance + 1.0);
  }

  const RiverHint& hint(int v) const { return scene_.hints[graph_.chains[graph_.at[v][0]].river]; }
  bool drawn_first(int v) const {
    const Chain& chain = graph_.chains[graph_.at[v][0]];
    return (chain.first() == v) == chain.drawn_onward;
  }
  double contrary(int v, RiverEnd kind) const {
    const double much = 2.0 * scene_.snap;
    return (hint(v).source_first && drawn_first(v) ? much : 0.0) +
           (hint(v).end && *hint(v).end != kind ? much : 0.0);
  }
  double frame_handicap(int v) const {
    return hint(v).end == RiverEnd::Frame ? 0.0 : 0.2 * scene_.snap;
  }

  void add_ways(int p, int v, double lowest, std::vector<Connection>& ways,
                std::vector<Hanging>& hangings) const {
    const glm::dvec2 at = graph_.points[v];
    const double uphill = 2.0 * scene_.snap * (height(at) - lowest);
    const auto add = [&](const Connection& way, double cost) {
      hangings.push_back({way.to < 0 ? parts_ : way.to, p, cost + uphill});
      ways.push_back(way);
    };
    // At a lake already: it may as well flow out of it.
    if (outlets_[v].here)
      add({v, -1, at, 0.0, RiverEnd::Lake}, 0.2 * scene_.snap + contrary(v, RiverEnd::Lake));
    else if (const auto goal = nearest_goal(scene_.land, at, frame_handicap(v)))
      add({v, -1, goal->point, goal->distance, goal->kind},
          goal->distance + contrary(v, goal->kind) +
              (goal->kind == RiverEnd::Frame ? frame_handicap(v) : 0.0));
    std::vector<int> met{p};
    for (int k = 0; k < 6; ++k) {
      const auto hit = lines_.nearest(at, scene_.snap, [&](const Segment& s) {
        return std::find(met.begin(), met.end(), part_[s.line]) == met.end();
      });
      if (!hit) break;
      const Segment& s = lines_.segments()[hit->segment];
      met.push_back(part_[s.line]);
      add({v, part_[s.line], hit->point, hit->distance, RiverEnd::River,
           graph_.chains[s.line].river},
          hit->distance + contrary(v, RiverEnd::River) + near_end(s.line, hit->point));
    }
  }

  /// Rivers seldom join another at its very source.
  double near_end(int c, glm::dvec2 p) const {
    const Chain& chain = graph_.chains[c];
    const double near = std::fmin(0.4 * scene_.snap, 0.2 * chain.length);
    for (const int v : {chain.first(), chain.last()})
      if (graph_.is_end(v) && !outlets_[v].here && glm::length(graph_.points[v] - p) < near)
        return 0.6 * scene_.snap;
    return 0.0;
  }

  /// Ends near the sea of rivers that cross or share an end with one that already reaches it.
  std::vector<Connection> extra_mouths() const {
    std::vector<Connection> found;
    for (std::size_t c = 0; c < graph_.chains.size(); ++c) {
      const Chain& chain = graph_.chains[c];
      if (!drains_[part_[c]] || chain.first() == chain.last()) continue;
      for (const int v : {chain.first(), chain.last()}) {
        if (!graph_.is_end(v) || outlets_[v].here) continue;
        const int w = v == chain.first() ? chain.last() : chain.first();
        const auto& met = graph_.at[w];
        const bool passes = met.size() >= 4 && std::count_if(met.begin(), met.end(), [&](int k) {
                                                 return graph_.chains[k].river == chain.river;
                                               }) > 1;
        if (met.size() != 2 && !passes) continue;
        if (hint(v).source_first && drawn_first(v)) continue;
        const auto goal = nearest_goal(scene_.land, graph_.points[v], frame_handicap(v));
        if (!goal || goal->distance > scene_.snap || !is_lower_end(chain, v, goal->distance))
          continue;
        if (hint(v).end && *hint(v).end != goal->kind) continue;
        found.push_back({v, -1, goal->point, goal->distance, goal->kind});
      }
    }
    return found;
  }
  /// Of the drawn river's ends, is v the nearest to a goal?
  bool is_lower_end(const Chain& chain, int v, double distance) const {
    for (const Chain& other : graph_.chains) {
      if (other.river != chain.river) continue;
      for (const int w : {other.first(), other.last()}) {
        const auto goal = nearest_goal(scene_.land, graph_.points[w], 0.0);
        if (w != v && goal && goal->distance < distance) return false;
      }
    }
    return true;
  }

  const RiverGraph& graph_;
  const std::vector<Outlet>& outlets_;
  const RiverScene& scene_;
  std::vector<int> part_;
  int parts_;
  std::vector<char> drains_;
  SegmentTree lines_, peaks_;
};

/// Adds points to the end of a line that lies at `from`.
void lengthen(std::vector<RiverLine>& lines, glm::dvec2 from, int river, const Polyline& way) {
  for (RiverLine& line : lines) {
    if (line.river != river) continue;
    if (line.points.back() == from) {
      line.points.insert(line.points.end(), way.begin(), way.end());
      return;
    }
    if (line.points.front() == from) {
      line.points.insert(line.points.begin(), way.rbegin(), way.rend());
      return;
    }
  }
}

}  // namespace

std::string RiverScene::words(int river) const {
  const River& r = map.rivers[river];
  return feature_words("river", r.feature, std::size_t(river), r.name);
}

std::vector<int> connected_parts(const RiverGraph& graph) {
  std::vector<int> part(graph.chains.size(), -1);
  int count = 0;
  std::vector<int> stack;
  for (std::size_t c = 0; c < graph.chains.size(); ++c) {
    if (part[c] >= 0) continue;
    part[c] = count;
    stack.push_back(int(c));
    while (!stack.empty()) {
      const Chain& chain = graph.chains[stack.back()];
      stack.pop_back();
      for (const int v : {chain.first(), chain.last()})
        for (const int k : graph.at[v])
          if (part[k] < 0) {
            part[k] = count;
            stack.push_back(k);
          }
    }
    ++count;
  }
  return part;
}

std::vector<Outlet> find_outlets(const RiverGraph& graph, const RiverScene& scene) {
  std::vector<Outlet> outlets(graph.points.size());
  for (std::size_t v = 0; v < graph.points.size(); ++v) {
    if (graph.at[v].empty()) continue;
    const auto near = [&](const SegmentTree& tree) {
      return tree.nearest(graph.points[v], kTouch * 1.01, [](const Segment&) { return true; });
    };
    Outlet& o = outlets[v];
    if (near(scene.land.coast())) {
      o = {true, RiverEnd::Sea, -1, 0.0};
    } else if (near(scene.land.frame())) {
      o = {true, RiverEnd::Frame, -1, 1e6};
    } else if (const auto lake = near(scene.land.lakes())) {
      o = {true, RiverEnd::Lake, scene.land.lakes().segments()[lake->segment].line, 1e7};
    }
    if (!o.here || !graph.is_end(int(v))) continue;
    const Chain& chain = graph.chains[graph.at[v][0]];
    const RiverHint& hint = scene.hints[chain.river];
    if (hint.end == o.kind) o.handicap = 0.0;
    if (hint.end && *hint.end != o.kind) o.handicap += 1e8;
    if (hint.source_first && (chain.first() == int(v)) == chain.drawn_onward) o.handicap += 1e8;
  }
  return outlets;
}

bool cut_overshoots(std::vector<RiverLine>& lines, const RiverGraph& graph,
                    const std::vector<Outlet>& outlets, const RiverScene& scene) {
  bool any = false;
  for (const Chain& chain : graph.chains) {
    if (chain.length > 0.2 * scene.snap || chain.first() == chain.last()) continue;
    for (const bool back : {false, true}) {
      const int end = back ? chain.last() : chain.first(),
                fork = back ? chain.first() : chain.last();
      if (!graph.is_end(end) || outlets[end].here || graph.at[fork].size() < 4) continue;
      int own = 0, other = 0;
      for (const int c : graph.at[fork]) {
        own += graph.chains[c].river == chain.river;
        int same = 0;
        for (const int k : graph.at[fork]) same += graph.chains[k].river == graph.chains[c].river;
        other += graph.chains[c].river != chain.river && same >= 2;
      }
      if (own < 2 || other < 2) continue;
      for (RiverLine& line : lines) {
        if (line.river != chain.river) continue;
        const std::size_t stub = chain.vertices.size() - 1;
        if (line.points.size() <= stub + 1) continue;
        if (line.points.back() == graph.points[end])
          line.points.resize(line.points.size() - stub);
        else if (line.points.front() == graph.points[end])
          line.points.erase(line.points.begin(), line.points.begin() + std::ptrdiff_t(stub));
        else
          continue;
        scene.report.warn(scene.words(chain.river) + ": overshoots another river at " +
                          scene.report.place(graph.points[fork]) + " by " +
                          distance_words(chain.length) + "; cut off");
        any = true;
        break;
      }
    }
  }
  return any;
}

bool connect_parts(std::vector<RiverLine>& lines, const RiverGraph& graph,
                   const std::vector<Outlet>& outlets, const RiverScene& scene) {
  const std::vector<Connection> chosen = Connector(graph, outlets, scene).choose();
  std::optional<RiverRouting> routing;
  for (const Connection& c : chosen) {
    const glm::dvec2 from = graph.points[c.end];
    const int river = graph.chains[graph.at[c.end][0]].river;
    const std::string words = scene.words(river), at = scene.report.place(from);
    static constexpr const char* kGoals[] = {"the coast", "a river", "a lake", "the frame's side"};
    std::string goal = kGoals[int(c.kind)];
    if (c.kind == RiverEnd::River) goal = scene.words(c.target_river);
    Polyline way{c.point};
    if (c.distance > scene.snap) {
      if (!routing) routing.emplace(scene.map, scene.land, graph, outlets);
      way = routing->way_from(from, c.point);
      scene.report.warn(words + ": ends inland at " + at + ", " + distance_words(c.distance) +
                        " from " + goal + "; carried on over land for " +
                        distance_words(length_of(way) + glm::length(way.front() - from)));
    } else {
      scene.report.warn(words + ": ends " + distance_words(c.distance) + " short of " + goal +
                        " at " + at + "; carried on to it");
    }
    glm::dvec2 last = from;
    for (std::size_t i = 0; i < way.size(); ++i) {
      for (const SegmentTree* tree : {&scene.land.rings(), &scene.land.frame()})
        if (const auto x = first_crossing(*tree, last, way[i])) {
          way[i] = *x;
          way.resize(i + 1);
        }
      last = way[i];
    }
    for (glm::dvec2& p : way) p = on_lattice(p);
    lengthen(lines, from, river, way);
  }
  return !chosen.empty();
}

}  // namespace orogen
