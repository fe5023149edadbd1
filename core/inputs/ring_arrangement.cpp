#include "inputs/ring_arrangement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

namespace orogen {
namespace {

__extension__ typedef __int128 Wide;

struct LatticePoint {
  std::int64_t x, y;
  auto operator<=>(const LatticePoint&) const = default;
};

LatticePoint lattice_point(glm::dvec2 p) {
  return {std::llround(p.x * kLattice), std::llround(p.y * kLattice)};
}

/// 1: c lies left of a -> b, -1: right, 0: on the line.
int side(LatticePoint a, LatticePoint b, LatticePoint c) {
  const Wide cross = Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
  return cross > 0 ? 1 : cross < 0 ? -1 : 0;
}

struct Edge {
  LatticePoint left, right;  // by x, then y
  std::size_t ring, index;   // from vertex `index` of the ring to the next
  bool eastward;             // left is the first vertex
};

struct Event {
  LatticePoint point;
  bool start;
  std::size_t edge;
  std::size_t vertex;  // of the edge's ring
};

class Sweep {
 public:
  explicit Sweep(std::span<const Ring* const> rings) : rings_(rings), status_(Below{edges_}) {
    for (std::size_t r = 0; r < rings.size(); ++r) add_ring(r);
    std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
      if (a.point != b.point) return a.point < b.point;
      if (a.start != b.start) return b.start;
      return a.edge < b.edge;
    });
  }

  RingArrangement run() {
    RingArrangement result{shared_vertex(), std::vector<int>(rings_.size(), -1)};
    std::vector<char> met(rings_.size(), 0);
    std::vector<Status::iterator> place(edges_.size());
    for (const Event& event : events_) {
      if (result.contact) break;
      if (event.start) {
        const auto it = place[event.edge] = status_.insert(event.edge).first;
        const std::size_t ring = edges_[event.edge].ring;
        if (!met[ring]) result.parent[ring] = parent_above(it, result.parent);
        met[ring] = 1;
        if (it != status_.begin()) result.contact = contact(*std::prev(it), *it);
        if (!result.contact && std::next(it) != status_.end())
          result.contact = contact(*it, *std::next(it));
      } else {
        const auto it = place[event.edge];
        if (it != status_.begin() && std::next(it) != status_.end())
          result.contact = contact(*std::prev(it), *std::next(it));
        status_.erase(it);
      }
    }
    if (result.contact) result.parent.clear();
    return result;
  }

 private:
  /// Which of two edges lies below the other where the sweep meets both.
  struct Below {
    const std::vector<Edge>& edges;
    bool operator()(std::size_t i, std::size_t j) const {
      if (i == j) return false;
      const Edge &s = edges[i], &t = edges[j];
      int above = 0;  // 1: t above s
      if (s.left <= t.left) {
        above = side(s.left, s.right, t.left);
        if (above == 0) above = side(s.left, s.right, t.right);
      } else {
        above = -side(t.left, t.right, s.left);
        if (above == 0) above = -side(t.left, t.right, s.right);
      }
      return above != 0 ? above > 0 : i < j;
    }
  };
  using Status = std::set<std::size_t, Below>;

  void add_ring(std::size_t r) {
    const Ring& ring = *rings_[r];
    anticlockwise_.push_back(signed_area(ring) > 0.0);
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = i + 1 < n ? i + 1 : 0;
      const LatticePoint a = lattice_point(ring[i]), b = lattice_point(ring[next]);
      const bool eastward = a < b;
      const std::size_t edge = edges_.size();
      edges_.push_back({std::min(a, b), std::max(a, b), r, i, eastward});
      events_.push_back({a, eastward, edge, i});
      events_.push_back({b, !eastward, edge, next});
    }
  }

  /// Two different vertices at one point.
  std::optional<RingContact> shared_vertex() const {
    for (std::size_t i = 1; i < events_.size(); ++i) {
      const Event &a = events_[i - 1], &b = events_[i];
      const Edge &s = edges_[a.edge], &t = edges_[b.edge];
      if (a.point == b.point && (s.ring != t.ring || a.vertex != b.vertex))
        return RingContact{s.ring, s.index, t.ring, t.index, (*rings_[t.ring])[b.vertex]};
    }
    return {};
  }

  /// The ring around the first edge of a ring, from the edge below it.
  int parent_above(Status::const_iterator it, const std::vector<int>& parent) const {
    if (it == status_.begin()) return -1;
    const Edge& below = edges_[*std::prev(it)];
    return below.eastward == anticlockwise_[below.ring] ? int(below.ring) : parent[below.ring];
  }

  std::optional<RingContact> contact(std::size_t i, std::size_t j) const {
    const Edge &s = edges_[i], &t = edges_[j];
    const auto found = [&](glm::dvec2 place) {
      return RingContact{s.ring, s.index, t.ring, t.index, place};
    };
    const std::size_t n = rings_[s.ring]->size();
    if (s.ring == t.ring && ((s.index + 1) % n == t.index || (t.index + 1) % n == s.index)) {
      const std::size_t shared = (s.index + 1) % n == t.index ? t.index : s.index;
      const LatticePoint v = lattice_point((*rings_[s.ring])[shared]);
      const LatticePoint p = s.left == v ? s.right : s.left, q = t.left == v ? t.right : t.left;
      const Wide dot = Wide(p.x - v.x) * (q.x - v.x) + Wide(p.y - v.y) * (q.y - v.y);
      if (side(v, p, q) == 0 && dot > 0) return found((*rings_[s.ring])[shared]);
      return {};
    }
    const int a = side(s.left, s.right, t.left), b = side(s.left, s.right, t.right);
    const int c = side(t.left, t.right, s.left), d = side(t.left, t.right, s.right);
    if (a * b > 0 || c * d > 0) return {};
    if (a == 0 && b == 0 && (s.right < t.left || t.right < s.left)) return {};
    return found(crossing(s, t));
  }

  static glm::dvec2 crossing(const Edge& s, const Edge& t) {
    const auto metres = [](LatticePoint p) {
      return glm::dvec2{double(p.x), double(p.y)} / kLattice;
    };
    const glm::dvec2 a = metres(s.left), u = metres(s.right) - a;
    const glm::dvec2 b = metres(t.left), v = metres(t.right) - b;
    const double cross = u.x * v.y - u.y * v.x;
    if (cross == 0.0) return s.left < t.left ? b : a;
    const double at = ((b.x - a.x) * v.y - (b.y - a.y) * v.x) / cross;
    return a + std::clamp(at, 0.0, 1.0) * u;
  }

  std::span<const Ring* const> rings_;
  std::vector<bool> anticlockwise_;
  std::vector<Edge> edges_;
  std::vector<Event> events_;
  Status status_;
};

}  // namespace

glm::dvec2 on_lattice(glm::dvec2 p) {
  return {std::round(p.x * kLattice) / kLattice, std::round(p.y * kLattice) / kLattice};
}

double signed_area(const Ring& ring) {
  if (ring.empty()) return 0.0;
  double twice = 0.0;
  const glm::dvec2 o = ring.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec2 a = ring[i] - o, b = ring[i + 1 < ring.size() ? i + 1 : 0] - o;
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

RingArrangement arrange_rings(std::span<const Ring* const> rings) {
  return Sweep(rings).run();
}

}  // namespace orogen
