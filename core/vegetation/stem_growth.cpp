#include "vegetation/stem_growth.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "foundation/units.h"

namespace orogen {

namespace {

constexpr int kPruneSteps = 32;

/// A stem or fork that is to grow from a segment on.
struct Bud {
  StemNode node;
  int segment = 0;
  std::int32_t forked_from = -1;
  double straighten = 0.0;  // radians a segment, back to where it grew before it forked
};

class Growth {
 public:
  Growth(TreeSkeleton& tree, const Stem& stem, StemDraws& draws)
      : tree_(tree),
        stem_(stem),
        draws_(draws),
        shape_(tree.parameters.stems[stem.level]),
        segment_length_(stem.length / shape_.curve_resolution),
        split_error_(draws.uniform() - 0.5) {}

  void run(const StemNode& foot) {
    axis_ = foot.frame.z;
    buds_.push_back({.node = foot});
    for (std::size_t b = 0; b < buds_.size(); ++b) grow(Bud(buds_[b]));
  }

 private:
  void grow(const Bud& bud) {
    Stem stem = stem_;
    stem.start = bud.segment * segment_length_;
    stem.forked_from = bud.forked_from;
    stem.first_node = std::int32_t(tree_.nodes.size());
    const auto index = std::int32_t(tree_.stems.size());
    tree_.stems.push_back(stem);
    StemNode node = bud.node;
    double straighten = bud.straighten;
    const int last = shape_.curve_resolution - 1;
    for (int segment = bud.segment; segment <= last; ++segment) {
      if (segment > bud.segment) straighten += split(node.frame, node.position, segment, index);
      if (segment > 0 || is_helix()) node.frame = bent(node.frame, segment, straighten);
      tree_.nodes.push_back(node);
      node.position += segment_length_ * node.frame.z;
    }
    tree_.nodes.push_back(node);
    tree_.stems[index].nodes = std::int32_t(tree_.nodes.size()) - stem.first_node;
  }

  bool is_helix() const { return shape_.curve_variation_deg < 0.0; }

  /// The frame of a segment from that of the one before.
  Frame bent(const Frame& before, int segment, double straighten) {
    const int count = shape_.curve_resolution;
    if (is_helix()) {
      if (segment == 0) return before.about_x(radians(-shape_.curve_variation_deg));
      return before.about(axis_, radians(360.0 / count)).about_x(-straighten);
    }
    double curve = shape_.curve_deg / count;
    if (shape_.curve_back_deg != 0.0)
      curve = 2.0 * (2 * segment < count ? shape_.curve_deg : shape_.curve_back_deg) / count;
    const double variation = shape_.curve_variation_deg / count;
    Frame frame = before.about_x(radians(draws_.around(curve, variation)) - straighten)
                      .about_y(radians(draws_.around(0.0, variation)));
    const double up = tree_.parameters.attraction_up;
    if (stem_.level >= 2 && up != 0.0) {
      const double lean = std::acos(std::fmin(1.0, std::fmax(-1.0, frame.z.z)));
      frame = frame.towards_sky(up * lean / count);
    }
    return frame;
  }

  /// Forks the stem before `segment`, if it is to, turning the frame that goes on. Returns by how
  /// much each later segment is to turn back.
  double split(Frame& frame, glm::dvec3 position, int segment, std::int32_t index) {
    const int forks = fork_count(segment);
    if (forks == 0) return 0.0;
    const double lean = std::acos(std::fmin(1.0, std::fmax(-1.0, frame.z.z)));
    const int left = shape_.curve_resolution - segment;
    const Frame before = frame;
    double back = 0.0;
    for (int fork = 0; fork <= forks; ++fork) {
      const double drawn = draws_.around(shape_.split_angle_deg, shape_.split_angle_variation_deg);
      const double angle =
          std::fmax(0.0, radians(drawn) - std::fmin(lean, std::numbers::pi - lean));
      const double straighten = angle / left;
      const Frame turned =
          before.about_x(angle).about({0.0, 0.0, 1.0}, azimuth(fork, forks, degrees(lean)));
      if (fork == 0) {
        frame = turned;
        back = straighten;
      } else {
        buds_.push_back({{position, turned}, segment, index, straighten});
      }
    }
    return back;
  }

  /// How many forks beside the stem itself; the error that rounding makes is carried on.
  int fork_count(int segment) {
    if (stem_.level == 0 && segment == 1 && tree_.parameters.base_splits > 0)
      return tree_.parameters.base_splits;
    const int forks = int(std::floor(shape_.segment_splits + split_error_ + 0.5));
    split_error_ += shape_.segment_splits - forks;
    return forks;
  }

  /// How far a fork is turned about the vertical, in radians.
  double azimuth(int fork, int forks, double lean_deg) {
    if (fork == 0) return 0.0;
    if (forks > 1) return radians(draws_.around(360.0 * fork / (forks + 1), 20.0));
    const double chance = draws_.uniform();
    const double spread = 20.0 + 0.75 * (30.0 + std::abs(lean_deg - 90.0)) * chance * chance;
    return radians(draws_.uniform() < 0.5 ? -spread : spread);
  }

  TreeSkeleton& tree_;
  const Stem& stem_;
  StemDraws& draws_;
  const StemParameters& shape_;
  double segment_length_;
  double split_error_;
  glm::dvec3 axis_{0.0, 0.0, 1.0};  // in which the whole stem set out
  std::vector<Bud> buds_;
};

/// The largest factor with which all nodes, drawn to the foot, are where `allowed` says.
template <class Allowed>
double fitting_factor(const TreeSkeleton& tree, std::size_t first_node, Allowed&& allowed) {
  const glm::dvec3 foot = tree.nodes[first_node].position;
  for (int step = kPruneSteps; step > 0; --step) {
    const double factor = double(step) / kPruneSteps;
    bool fits = true;
    for (std::size_t n = first_node; n < tree.nodes.size() && fits; ++n)
      fits = allowed(foot + factor * (tree.nodes[n].position - foot));
    if (fits) return factor;
  }
  return 0.0;
}

}  // namespace

void grow_stem(TreeSkeleton& tree, Stem stem, const StemNode& foot, StemDraws& draws) {
  const std::size_t first_stem = tree.stems.size(), first_node = tree.nodes.size();
  Growth(tree, stem, draws).run(foot);
  if (stem.level == 0) return;
  double factor = fitting_factor(tree, first_node, [](glm::dvec3 place) { return place.z >= 0.0; });
  if (const double prune = tree.parameters.prune_ratio; prune > 0.0) {
    const double within = fitting_factor(tree, first_node, [&](glm::dvec3 place) {
      return within_envelope(tree.parameters, tree.scale, place);
    });
    factor = std::fmin(factor, 1.0 - prune + prune * within);
  }
  if (factor == 1.0) return;
  if (factor == 0.0) {
    tree.stems.resize(first_stem);
    tree.nodes.resize(first_node);
    return;
  }
  for (std::size_t n = first_node; n < tree.nodes.size(); ++n)
    tree.nodes[n].position = foot.position + factor * (tree.nodes[n].position - foot.position);
  for (std::size_t s = first_stem; s < tree.stems.size(); ++s) {
    tree.stems[s].length *= factor;
    tree.stems[s].start *= factor;
    tree.stems[s].radius *= std::pow(factor, tree.parameters.ratio_power);
  }
}

}  // namespace orogen
