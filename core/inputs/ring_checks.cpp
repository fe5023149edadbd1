#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "inputs/map_checks.h"
#include "inputs/ring_arrangement.h"

namespace orogen {
namespace {

class RingChecker {
 public:
  RingChecker(MapDraft& draft, MapReport& report)
      : draft_(draft), map_(draft.map), report_(report) {}

  void run() {
    close();
    for (std::size_t i = 0; i < map_.coasts.size(); ++i) {
      clean(map_.coasts[i].outer, {RingOwner::CoastOuter, i, 0});
      for (std::size_t h = 0; h < map_.coasts[i].holes.size(); ++h)
        clean(map_.coasts[i].holes[h], {RingOwner::CoastHole, i, h + 1});
    }
    for (std::size_t i = 0; i < map_.lakes.size(); ++i) {
      clean(map_.lakes[i].outer, {RingOwner::LakeOuter, i, 0});
      for (std::size_t h = 0; h < map_.lakes[i].islands.size(); ++h)
        clean(map_.lakes[i].islands[h], {RingOwner::LakeIsland, i, h + 1});
      const auto level = map_.lakes[i].level_m;
      if (level && !(*level >= -1000.0 && *level <= kHighestPeak))
        throw InputError(words("lake", map_.lakes[i], i) +
                         ": level_m must be from -1000 to 12000 m, not " + std::to_string(*level));
    }
    arrange();
  }

 private:
  struct RingOwner {
    enum Kind { CoastOuter, CoastHole, LakeOuter, LakeIsland } kind;
    std::size_t owner, number;  // ring number in the polygon
  };

  template <class Polygon>
  static std::string words(const char* kind, const Polygon& polygon, std::size_t i) {
    return feature_words(kind, polygon.feature, i, polygon.name);
  }
  std::string ring_words(const RingOwner& r) const {
    return (r.kind <= RingOwner::CoastHole ? words("coast", map_.coasts[r.owner], r.owner)
                                           : words("lake", map_.lakes[r.owner], r.owner)) +
           ", ring " + std::to_string(r.number);
  }
  std::string vertex_words(std::size_t ring, std::size_t edge) const {
    return ring_words(owners_[ring]) + ", vertex " + std::to_string(drawn_[ring][edge]);
  }

  double extent() const {
    Box box;
    for (const Coast& c : map_.coasts)
      for (const glm::dvec2 p : c.outer) box.add(p);
    for (const CoastPiece& c : draft_.pieces)
      for (const glm::dvec2 p : c.points) box.add(p);
    for (const Lake& l : map_.lakes)
      for (const glm::dvec2 p : l.outer) box.add(p);
    return box.low.x <= box.high.x ? glm::length(box.high - box.low) : 0.0;
  }

  /// Rings left open in the file, and coasts drawn as lines.
  void close() {
    const double tolerance = std::fmin(2000.0, 0.01 * extent());
    for (const OpenRing& open : draft_.open_rings) {
      const RingOwner owner{open.lake ? RingOwner::LakeOuter : RingOwner::CoastOuter, open.polygon,
                            open.ring};
      const Ring& outer =
          open.lake ? map_.lakes[open.polygon].outer : map_.coasts[open.polygon].outer;
      const auto& inner =
          open.lake ? map_.lakes[open.polygon].islands : map_.coasts[open.polygon].holes;
      const Ring& ring = open.ring == 0 ? outer : inner[open.ring - 1];
      const double gap = glm::length(ring.front() - ring.back());
      const std::string what = ring_words(owner) + ": stays open at " + report_.place(ring.back()) +
                               ", its beginning lies " + distance_words(gap) + " away";
      if (gap > tolerance)
        throw InputError(what + "; at most " + distance_words(tolerance) + " can be closed");
      report_.warn(what + "; closed");
    }
    first_drawn_as_line_ = map_.coasts.size();
    for (std::size_t i = 0; i < draft_.pieces.size(); ++i)
      clean_points(draft_.pieces[i].points, false, words("coast", draft_.pieces[i], i), report_);
    auto joined = join_coast_pieces(std::move(draft_.pieces), tolerance, report_);
    for (Coast& coast : joined) map_.coasts.push_back(std::move(coast));
  }

  void clean(Ring& ring, const RingOwner& owner) {
    const std::string what = ring_words(owner);
    std::vector<std::uint32_t> drawn;
    clean_points(ring, true, what, report_, &drawn);
    if (ring.size() < 3)
      throw InputError(what + ": a ring needs at least three different positions" +
                       (ring.empty() ? "" : ", at " + report_.place(ring.front())));
    const double area = signed_area(ring);
    if (area == 0.0)
      throw InputError(what + ": the ring encloses no area, at " + report_.place(ring.front()));
    const bool outer = owner.kind == RingOwner::CoastOuter || owner.kind == RingOwner::LakeOuter;
    if ((area > 0.0) != outer) {
      std::reverse(ring.begin(), ring.end());
      std::reverse(drawn.begin(), drawn.end());
    }
    rings_.push_back(&ring);
    owners_.push_back(owner);
    drawn_.push_back(std::move(drawn));
  }

  void arrange() {
    const RingArrangement found = arrange_rings(rings_);
    if (const auto& c = found.contact) {
      const std::string at = " at " + report_.place(c->place);
      if (c->ring_a == c->ring_b)
        throw InputError(vertex_words(c->ring_a, c->edge_a) + ": crosses or touches itself" + at +
                         " (vertex " + std::to_string(drawn_[c->ring_b][c->edge_b]) + ")");
      throw InputError(vertex_words(c->ring_a, c->edge_a) + ": crosses or touches " +
                       vertex_words(c->ring_b, c->edge_b) + at);
    }
    nest_lines(owners_, found.parent);
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const RingOwner* around = found.parent[r] < 0 ? nullptr : &owners_[found.parent[r]];
      check_nesting(owners_[r], around, (*rings_[r])[0]);
    }
    move_holes(owners_, found.parent);
  }

  /// Coasts drawn as lines that lie inside others become their holes (and islands in those).
  void nest_lines(std::vector<RingOwner>& owners, const std::vector<int>& parent) const {
    std::vector<char> known(owners.size(), 0);
    for (std::size_t r = 0; r < owners.size(); ++r) known[r] = !drawn_as_line(owners[r]);
    for (std::size_t r = 0; r < owners.size(); ++r) {
      std::vector<std::size_t> chain;
      for (int k = int(r); k >= 0 && !known[k]; k = parent[k]) chain.push_back(std::size_t(k));
      for (; !chain.empty(); chain.pop_back()) {
        RingOwner& ring = owners[chain.back()];
        const int around = parent[chain.back()];
        if (around >= 0 && owners[around].kind == RingOwner::CoastOuter)
          ring.kind = RingOwner::CoastHole;
        known[chain.back()] = 1;
      }
    }
  }
  bool drawn_as_line(const RingOwner& ring) const {
    return ring.kind <= RingOwner::CoastHole && ring.owner >= first_drawn_as_line_;
  }

  void check_nesting(const RingOwner& ring, const RingOwner* around, glm::dvec2 first) const {
    const std::string at = " at " + report_.place(first);
    const auto inside = [&] { return around ? ", inside " + ring_words(*around) + "," : ""; };
    switch (ring.kind) {
      case RingOwner::CoastOuter:
        if (around && around->kind != RingOwner::CoastHole)
          throw InputError(ring_words(ring) + ": a coast on land" + inside() + at +
                           "; an inland sea is a hole of its coast, a lake has kind 'lake'");
        break;
      case RingOwner::CoastHole:
        if (!drawn_as_line(ring) &&
            (!around || around->kind != RingOwner::CoastOuter || around->owner != ring.owner))
          throw InputError(ring_words(ring) + ": the hole lies outside its coast" + inside() + at);
        break;
      case RingOwner::LakeOuter:
        if (around ? around->kind != RingOwner::CoastOuter && around->kind != RingOwner::LakeIsland
                   : !map_.coasts.empty())
          throw InputError(
              ring_words(ring) + ": lies " +
              (!around || around->kind == RingOwner::CoastHole ? "in the sea" : "in another lake") +
              inside() + at);
        break;
      case RingOwner::LakeIsland:
        if (!around || around->kind != RingOwner::LakeOuter || around->owner != ring.owner)
          throw InputError(ring_words(ring) + ": the island lies outside its lake" + inside() + at);
    }
  }

  /// Rings drawn as lines that nest_lines found to be holes go to their coasts.
  void move_holes(const std::vector<RingOwner>& owners, const std::vector<int>& parent) {
    std::vector<char> moved(map_.coasts.size(), 0);
    for (std::size_t r = 0; r < owners.size(); ++r) {
      if (!drawn_as_line(owners[r]) || owners[r].kind != RingOwner::CoastHole) continue;
      Ring hole = std::move(map_.coasts[owners[r].owner].outer);
      std::reverse(hole.begin(), hole.end());
      map_.coasts[owners[parent[r]].owner].holes.push_back(std::move(hole));
      moved[owners[r].owner] = 1;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < moved.size(); ++i)
      if (!moved[i]) {
        if (kept != i) map_.coasts[kept] = std::move(map_.coasts[i]);
        ++kept;
      }
    map_.coasts.resize(kept);
  }

  MapDraft& draft_;
  VectorMap& map_;
  MapReport& report_;
  std::size_t first_drawn_as_line_ = 0;
  std::vector<const Ring*> rings_;
  std::vector<RingOwner> owners_;
  std::vector<std::vector<std::uint32_t>> drawn_;  // numbers of the vertices as drawn
};

}  // namespace

void check_rings(MapDraft& draft, MapReport& report) {
  RingChecker(draft, report).run();
}

}  // namespace orogen
