#include "vegetation/tree_skeleton.h"

#include <algorithm>
#include <cmath>

#include "foundation/random.h"
#include "foundation/units.h"
#include "vegetation/stem_growth.h"

namespace orogen {

namespace {

/// The part of a stem's random numbers that its children's places take, and that of its leaves.
constexpr std::uint64_t kPlaces = 1, kLeaves = 2;

class Grower {
 public:
  Grower(const TreeParameters& parameters, std::uint64_t seed) : seed_(seed) {
    tree_.parameters = parameters;
  }

  TreeSkeleton grow(const Context& context) {
    grow_trunk();
    std::size_t first = 0;
    for (int level = 1; level < tree_.parameters.levels; ++level) {
      const std::size_t end = tree_.stems.size();
      for (std::size_t stem = first; stem < end; stem = family_end(stem)) {
        context.check();
        grow_children(stem);
      }
      first = end;
    }
    for (std::size_t stem = first; stem < tree_.stems.size(); stem = family_end(stem))
      grow_leaves(stem);
    stretch();
    return std::move(tree_);
  }

 private:
  void grow_trunk() {
    const TreeParameters& p = tree_.parameters;
    StemDraws draws(seed_, 0);
    tree_.scale = draws.around(p.scale, p.scale_variation);
    z_scale_ = draws.around(p.z_scale, p.z_scale_variation);
    Stem trunk;
    trunk.length = draws.around(p.stems[0].length, p.stems[0].length_variation) * tree_.scale;
    trunk.radius = trunk.length * p.ratio * draws.around(p.trunk_scale, p.trunk_scale_variation);
    const Frame upright = Frame{}.about_z(radians(360.0 * draws.uniform()));
    grow_stem(tree_, trunk, {{0.0, 0.0, 0.0}, upright}, draws);
    keys_.assign(tree_.stems.size(), mix64(0));
  }

  std::size_t family_end(std::size_t stem) const {
    while (++stem < tree_.stems.size() && tree_.stems[stem].forked_from >= 0) {
    }
    return stem;
  }

  double bare(const Stem& stem) const {
    return stem.level == 0 ? tree_.parameters.base_size * tree_.scale : 0.0;
  }

  /// How many children, or leaves, a stem bears.
  int child_count(const Stem& stem, bool leaves) const {
    const TreeParameters& p = tree_.parameters;
    const double most = leaves ? std::abs(p.leaves) : p.stems[stem.level + 1].branches;
    if (stem.level == 0) return int(most);
    const Stem& parent = tree_.stems[stem.parent];
    const double along = stem.offset / parent.length;
    double share = 1.0 - 0.5 * along;
    if (leaves)
      share = shape_ratio(p, CrownShape::TaperedCylindrical, along);
    else if (stem.level == 1)
      share = 0.2 + 0.8 * stem.length / (parent.length * std::max(p.stems[1].length, 1e-9));
    return int(std::floor(most * std::min(1.0, share) + 0.5));
  }

  /// One of the forks, by turns, that reach `offset` along the family of stems [first, end).
  std::size_t bearer(std::size_t first, std::size_t end, double offset, std::size_t turn) const {
    std::size_t reaching = 0;
    for (std::size_t s = first; s < end; ++s) reaching += tree_.stems[s].start <= offset;
    std::size_t wanted = turn % reaching;
    for (std::size_t s = first; s < end; ++s)
      if (tree_.stems[s].start <= offset && wanted-- == 0) return s;
    return first;
  }

  double down_angle(const StemParameters& shape, const Stem& parent, double offset,
                    StemDraws& draws) const {
    if (shape.down_angle_variation_deg >= 0.0)
      return radians(draws.around(shape.down_angle_deg, shape.down_angle_variation_deg));
    const double ratio = (parent.length - offset) / (parent.length - bare(parent));
    const double conical = shape_ratio(tree_.parameters, CrownShape::Conical, ratio);
    return radians(shape.down_angle_deg + shape.down_angle_variation_deg * (1.0 - 2.0 * conical));
  }

  /// Turn of the next child about its parent.
  static double next_turn(const StemParameters& shape, double turn, int child, StemDraws& draws) {
    const double step =
        radians(draws.around(std::abs(shape.rotate_deg), shape.rotate_variation_deg));
    if (shape.rotate_deg >= 0.0) return turn + step;
    return child % 2 == 0 ? -0.5 * step : 0.5 * step;
  }

  void grow_children(std::size_t first) {
    const std::size_t end = family_end(first);
    const Stem whole = tree_.stems[first];
    const StemParameters& shape = tree_.parameters.stems[whole.level + 1];
    StemDraws places(seed_, keys_[first] + kPlaces);
    const int count = child_count(whole, false);
    double turn = radians(360.0 * places.uniform());
    for (int child = 0; child < count; ++child) {
      const double foot = bare(whole);
      const double offset = foot + (child + 0.5) / count * (whole.length - foot);
      const std::size_t parent = bearer(first, end, offset, child);
      turn = next_turn(shape, turn, child, places);
      const double down = down_angle(shape, whole, offset, places);
      grow_child(parent, offset, turn, down, mix64(keys_[first] ^ mix64(std::uint64_t(child) + 3)));
    }
  }

  void grow_child(std::size_t parent_index, double offset, double turn, double down,
                  std::uint64_t key) {
    const Stem parent = tree_.stems[parent_index];
    const TreeParameters& p = tree_.parameters;
    const StemParameters& shape = p.stems[parent.level + 1];
    StemDraws draws(seed_, key);
    const double share = std::max(0.0, draws.around(shape.length, shape.length_variation));
    Stem stem;
    stem.level = parent.level + 1;
    stem.parent = std::int32_t(parent_index);
    stem.offset = offset;
    if (parent.level == 0) {
      const double ratio = (parent.length - offset) / (parent.length - bare(parent));
      stem.length = parent.length * share * shape_ratio(p, p.shape, ratio);
    } else {
      stem.length = share * (parent.length - 0.6 * offset);
    }
    if (stem.length <= 0.0) return;
    stem.radius = std::min(parent.radius * std::pow(stem.length / parent.length, p.ratio_power),
                           stem_radius(tree_, parent, offset));
    StemNode foot = stem_place(tree_, parent, offset);
    foot.frame = foot.frame.about_z(turn).about_x(down);
    grow_stem(tree_, stem, foot, draws);
    keys_.resize(tree_.stems.size(), key);
  }

  void grow_leaves(std::size_t first) {
    const std::size_t end = family_end(first);
    const TreeParameters& p = tree_.parameters;
    const Stem& whole = tree_.stems[first];
    const StemParameters& shape = p.stems[leaf_level(p)];
    StemDraws draws(seed_, keys_[first] + kLeaves);
    const int count = child_count(whole, true);
    double turn = radians(360.0 * draws.uniform());
    for (int leaf = 0; leaf < count; ++leaf) {
      const bool fan = p.leaves < 0;
      const double offset =
          fan ? whole.length : bare(whole) + (leaf + 0.5) / count * (whole.length - bare(whole));
      const std::size_t stem = bearer(first, end, offset, leaf);
      StemNode place = stem_place(tree_, tree_.stems[stem], offset);
      const double down = down_angle(shape, whole, offset, draws);
      if (fan) {
        const double spread = count > 1 ? (leaf + 0.5) / count - 0.5 : 0.0;
        place.frame =
            place.frame.about_y(radians(spread * std::abs(shape.rotate_deg))).about_x(down);
      } else {
        turn = next_turn(shape, turn, leaf, draws);
        place.frame = place.frame.about_z(turn).about_x(down);
      }
      const Frame frame = bent_to_light(place);
      tree_.leaves.push_back({std::int32_t(stem), place.position, frame.z, frame.x});
    }
  }

  /// A leaf's frame, turned about its own length so that its face looks outwards and up.
  Frame bent_to_light(const StemNode& leaf) const {
    const double bend = tree_.parameters.leaf_bend;
    if (bend == 0.0) return leaf.frame;
    const double across = std::hypot(leaf.position.x, leaf.position.y);
    const double inverse = across > 1e-9 ? 1.0 / across : 0.0;
    const glm::dvec3 light(leaf.position.x * inverse, leaf.position.y * inverse, 1.0);
    const double angle =
        std::atan2(-glm::dot(light, leaf.frame.x), glm::dot(light, leaf.frame.y()));
    return leaf.frame.about_z(bend * angle);
  }

  void stretch() {
    if (z_scale_ == 1.0) return;
    const auto stretched = [&](auto v) { return v.z *= z_scale_, v; };
    for (StemNode& node : tree_.nodes) {
      node.position = stretched(node.position);
      node.frame = frame_along(stretched(node.frame.z), node.frame.x);
    }
    for (TreeLeaf& leaf : tree_.leaves) leaf.position = stretched(leaf.position);
  }

  std::uint64_t seed_;
  double z_scale_ = 1.0;
  TreeSkeleton tree_;
  std::vector<std::uint64_t> keys_;  // of stems: the stream of their random numbers
};

}  // namespace

TreeSkeleton grow_tree(const TreeParameters& parameters, std::uint64_t seed,
                       const Context& context) {
  check_tree(parameters);
  return Grower(parameters, seed).grow(context);
}

StemNode stem_place(const TreeSkeleton& tree, const Stem& stem, double along) {
  const int segments = stem.nodes - 1;
  const double at = std::clamp((along - stem.start) / (stem.length - stem.start), 0.0, 1.0);
  const int segment = std::min(int(at * segments), segments - 1);
  const double t = at * segments - segment;
  const StemNode* node = &tree.nodes[stem.first_node + segment];
  const auto tangent = [&](int i) {  // of the i-th node: between its two segments
    const auto& here = node[i - segment].frame.z;
    return i == 0 || i == segments ? here : glm::normalize(here + node[i - segment - 1].frame.z);
  };
  const glm::dvec3 step = node[1].position - node[0].position;
  const double length = glm::length(step);
  const glm::dvec3 from = length * tangent(segment), to = length * tangent(segment + 1);
  const double s = 1.0 - t;
  const glm::dvec3 position =
      node[0].position + t * t * (3.0 - 2.0 * t) * step + t * s * s * from - t * t * s * to;
  const glm::dvec3 direction =
      6.0 * t * s * step + s * (1.0 - 3.0 * t) * from - t * (2.0 - 3.0 * t) * to;
  return {position, frame_along(direction, s * node[0].frame.x + t * node[1].frame.x)};
}

double stem_radius(const TreeSkeleton& tree, const Stem& stem, double along) {
  const TreeParameters& p = tree.parameters;
  const double taper = p.stems[stem.level].taper, z = std::clamp(along / stem.length, 0.0, 1.0);
  const double unit = taper < 1.0 ? taper : taper < 2.0 ? 2.0 - taper : 0.0;
  const double cone = stem.radius * (1.0 - unit * z);
  double radius = cone;
  if (taper >= 1.0 && cone > 0.0) {
    const double to_tip = (1.0 - z) * stem.length;
    const double depth = taper < 2.0 || to_tip < cone ? 1.0 : taper - 2.0;
    const double from_bead =
        taper < 2.0 ? to_tip
                    : std::abs(to_tip - 2.0 * cone * std::floor(0.5 * to_tip / cone + 0.5));
    if (taper >= 2.0 || from_bead < cone) {
      const double round =
          std::sqrt(std::max(0.0, cone * cone - (from_bead - cone) * (from_bead - cone)));
      radius = (1.0 - depth) * cone + depth * round;
    }
  }
  if (stem.level > 0 || p.flare == 0.0) return radius;
  const double foot = std::max(0.0, 1.0 - 8.0 * z);
  return radius * (1.0 + p.flare * (std::pow(100.0, foot) - 1.0) / 100.0);
}

bool within_envelope(const TreeParameters& p, double scale, glm::dvec3 place) {
  const double ratio = (scale - place.z) / (scale * (1.0 - p.base_size));
  return std::hypot(place.x, place.y) <=
         scale * p.prune_width * shape_ratio(p, CrownShape::Envelope, ratio);
}

}  // namespace orogen
