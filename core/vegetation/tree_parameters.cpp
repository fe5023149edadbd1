#include "vegetation/tree_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace orogen {

namespace {

constexpr double kMostOfATree = 10e6;

void check_below(std::string_view place, std::string_view name, double value,
                 std::string_view other, double limit) {
  if (value >= limit)
    detail::refuse_value(place, name, detail::format_number(value),
                         "below `" + std::string(other) + "`, " + detail::format_number(limit));
}

void check_size(std::string_view place, std::string_view what, double count) {
  if (count > kMostOfATree)
    throw InputError(std::string(place) + (place.empty() ? "" : ": ") + "a tree of up to " +
                     detail::format_number(std::round(count)) + " " + std::string(what) +
                     " is not allowed; 10 million at most");
}

}  // namespace

TreeSize largest_size(const TreeParameters& p) {
  TreeSize size;
  double stems = 1.0;
  for (int level = 0; level < p.levels; ++level) {
    const StemParameters& stem = p.stems[level];
    if (level > 0) stems *= stem.branches;
    double forks = 1.0, nodes = 1.0;
    for (int s = 0; s < stem.curve_resolution; ++s) {
      if (s > 0) forks *= 1.0 + (level == 0 && s == 1 ? p.base_splits : stem.segment_splits);
      nodes += forks * 2.0;
    }
    size.stems += stems;
    size.nodes += stems * nodes;
  }
  size.leaves = stems * std::abs(p.leaves);
  return size;
}

void check_tree(const TreeParameters& p, std::string_view place) {
  check_parameters(p, place);
  for (int level = 0; level < kStemLevels; ++level)
    check_parameters(p.stems[level], std::string(place) + (place.empty() ? "" : ".") + "stems[" +
                                         std::to_string(level) + "]");
  check_below(place, "scale_variation", p.scale_variation, "scale", p.scale);
  check_below(place, "z_scale_variation", p.z_scale_variation, "z_scale", p.z_scale);
  check_below(place, "trunk_scale_variation", p.trunk_scale_variation, "trunk_scale",
              p.trunk_scale);
  check_below(place, "stems[0].length_variation", p.stems[0].length_variation, "stems[0].length",
              p.stems[0].length);
  check_below(place, "base_size", p.base_size, "the trunk's shortest length",
              p.stems[0].length - p.stems[0].length_variation);
  const TreeSize size = largest_size(p);
  check_size(place, "nodes", size.nodes);
  check_size(place, "leaves", size.leaves);
}

double shape_ratio(const TreeParameters& p, CrownShape shape, double ratio) {
  constexpr double kPi = std::numbers::pi;
  switch (shape) {
    case CrownShape::Conical:
      return 0.2 + 0.8 * ratio;
    case CrownShape::Spherical:
      return 0.2 + 0.8 * std::sin(kPi * ratio);
    case CrownShape::Hemispherical:
      return 0.2 + 0.8 * std::sin(0.5 * kPi * ratio);
    case CrownShape::Cylindrical:
      return 1.0;
    case CrownShape::TaperedCylindrical:
      return 0.5 + 0.5 * ratio;
    case CrownShape::Flame:
      return ratio <= 0.7 ? ratio / 0.7 : (1.0 - ratio) / 0.3;
    case CrownShape::InverseConical:
      return 1.0 - 0.8 * ratio;
    case CrownShape::TendFlame:
      return ratio <= 0.7 ? 0.5 + 0.5 * ratio / 0.7 : 0.5 + 0.5 * (1.0 - ratio) / 0.3;
    case CrownShape::Envelope:
      break;
  }
  // The paper divides both by 1 - PruneWidthPeak, which leaves a step where the two meet.
  if (ratio < 0.0 || ratio > 1.0) return 0.0;
  const double above = 1.0 - p.prune_width_peak;
  return ratio < above ? std::pow(ratio / above, p.prune_power_high)
                       : std::pow((1.0 - ratio) / p.prune_width_peak, p.prune_power_low);
}

}  // namespace orogen
