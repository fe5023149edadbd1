// Parameter sets of trees by chance, small enough to try many.
#pragma once

#include "foundation/random.h"
#include "vegetation/tree_parameters.h"

namespace orogen {

inline TreeParameters random_tree(std::uint64_t number) {
  std::uint64_t counter = 0;
  const auto real = [&](double low, double high) {
    return low + (high - low) * random_uniform(7, number, counter++);
  };
  const auto whole = [&](int low, int high) { return low + int(real(0.0, high - low + 0.999)); };
  TreeParameters p;
  p.shape = CrownShape(whole(0, 8));
  p.base_size = real(0.0, 0.6);
  p.scale = real(0.5, 40.0), p.scale_variation = real(0.0, 0.4) * p.scale;
  p.levels = whole(1, 4);
  p.ratio = real(0.005, 0.05), p.ratio_power = real(0.5, 2.5);
  p.lobes = whole(0, 7), p.lobe_depth = real(0.0, 0.3), p.flare = real(0.0, 2.0);
  p.base_splits = whole(0, 2);
  p.leaves = whole(-8, 12);
  p.leaf_shape = LeafShape(whole(0, 5));
  p.leaf_scale_x = real(0.05, 1.5), p.leaf_bend = real(0.0, 1.0);
  p.attraction_up = real(-3.0, 3.0);
  p.prune_width = real(0.1, 0.8), p.prune_width_peak = real(0.1, 0.9);
  p.prune_power_low = real(0.0, 2.0), p.prune_power_high = real(0.0, 2.0);
  for (int level = 0; level < kStemLevels; ++level) {
    StemParameters& stem = p.stems[level];
    stem.down_angle_deg = real(0.0, 110.0), stem.down_angle_variation_deg = real(-50.0, 30.0);
    stem.rotate_deg = real(-180.0, 180.0), stem.rotate_variation_deg = real(0.0, 40.0);
    stem.branches = level ? whole(0, 9) : 0;
    stem.length = level ? real(0.0, 1.0) : real(0.7, 1.1);
    stem.length_variation = level ? real(0.0, 0.3) : 0.0;
    stem.taper = real(0.0, 2.0);
    stem.segment_splits = real(0.0, 0.4);
    stem.split_angle_deg = real(0.0, 40.0), stem.split_angle_variation_deg = real(0.0, 20.0);
    stem.curve_resolution = whole(1, 9);
    stem.curve_deg = real(-90.0, 90.0), stem.curve_back_deg = whole(0, 1) * real(-90.0, 90.0);
    stem.curve_variation_deg = real(-40.0, 120.0);
  }
  return p;
}

}  // namespace orogen
