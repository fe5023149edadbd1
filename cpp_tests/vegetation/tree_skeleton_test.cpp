#include "vegetation/tree_skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "random_trees.h"
#include "vegetation/tree_species.h"
#include "vegetation/tree_statistics.h"

namespace orogen {
namespace {

const Context kContext;

TreeSkeleton grown(std::string_view species, std::uint64_t seed) {
  return grow_tree(find_tree_species(species).parameters, seed, kContext);
}

std::vector<Stem> of_level(const TreeSkeleton& tree, int level) {
  std::vector<Stem> stems;
  for (const Stem& stem : tree.stems)
    if (stem.level == level && stem.forked_from < 0) stems.push_back(stem);
  return stems;
}

// The paper's appendix and formulas, worked out again without the code that is tested.

double tend_flame(double ratio) {
  return ratio <= 0.7 ? 0.5 + 0.5 * ratio / 0.7 : 0.5 + 0.5 * (1.0 - ratio) / 0.3;
}

TEST(TreeSkeleton, QuakingAspenHasThePublishedLevels) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const TreeSkeleton tree = grown("quaking_aspen", seed);
    const Stem trunk = tree.stems[0];
    EXPECT_EQ(trunk.length, tree.scale);  // 0Length 1
    EXPECT_TRUE(trunk.length >= 10.0 && trunk.length <= 16.0) << trunk.length;
    EXPECT_NEAR(trunk.radius, 0.015 * trunk.length, 1e-12);
    const auto branches = of_level(tree, 1), twigs = of_level(tree, 2);
    ASSERT_EQ(branches.size(), 50u);
    std::size_t expected_twigs = 0, expected_leaves = 0;
    for (int i = 0; i < 50; ++i) {
      const double share = (i + 0.5) / 50;  // along the crown, from its foot
      EXPECT_NEAR(branches[i].offset, trunk.length * (0.4 + 0.6 * share), 1e-9);
      const double length = 0.3 * trunk.length * tend_flame(1.0 - share);
      EXPECT_NEAR(branches[i].length, length, 1e-9);
      EXPECT_NEAR(branches[i].radius,
                  std::min(trunk.radius * std::pow(length / trunk.length, 1.2),
                           trunk.radius * (1.0 - branches[i].offset / trunk.length)),
                  1e-9);
      const int count = int(std::floor(30 * (0.2 + 0.8 * tend_flame(1.0 - share)) + 0.5));
      for (int k = 0; k < count; ++k) {
        const double offset = length * (k + 0.5) / count;
        ASSERT_LT(expected_twigs, twigs.size());
        EXPECT_NEAR(twigs[expected_twigs].offset, offset, 1e-9);
        EXPECT_NEAR(twigs[expected_twigs].length, 0.6 * (length - 0.6 * offset), 1e-9);
        ++expected_twigs;
        expected_leaves += std::size_t(25 * (0.5 + 0.5 * offset / length) + 0.5);
      }
    }
    EXPECT_EQ(twigs.size(), expected_twigs);
    EXPECT_EQ(twigs.size(), 1200u);  // 50 · 30 (0.2 + 0.8 · 3/4): the mean of the shape's ratio
    EXPECT_EQ(tree.leaves.size(), expected_leaves);
    EXPECT_NEAR(double(tree.leaves.size()), 1200 * 25 * 0.75, 100.0);
    EXPECT_EQ(tree.stems.size(), 1u + 50u + 1200u) << "an aspen forked";
  }
}

TEST(TreeSkeleton, BlackTupeloHasThePublishedLevels) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const TreeSkeleton tree = grown("black_tupelo", seed);
    const Stem trunk = tree.stems[0];
    EXPECT_TRUE(trunk.length >= 18.0 && trunk.length <= 28.0) << trunk.length;
    const auto branches = of_level(tree, 1), twigs = of_level(tree, 2), shoots = of_level(tree, 3);
    ASSERT_EQ(branches.size(), 50u);
    std::size_t expected_twigs = 0, expected_shoots = 0;
    for (int i = 0; i < 50; ++i) {
      const double ratio = 1.0 - (i + 0.5) / 50, shape = 0.5 + 0.5 * ratio;  // shape 4
      EXPECT_GE(branches[i].length, 0.25 * trunk.length * shape - 1e-9);
      EXPECT_LE(branches[i].length, 0.35 * trunk.length * shape + 1e-9);
      expected_twigs += std::size_t(
          25 * std::min(1.0, 0.2 + 0.8 * branches[i].length / trunk.length / 0.3) + 0.5);
    }
    EXPECT_EQ(twigs.size(), expected_twigs);
    for (const Stem& twig : twigs) {
      const Stem& branch = tree.stems[twig.parent];
      const double longest = branch.length - 0.6 * twig.offset;
      EXPECT_TRUE(twig.length >= 0.5 * longest - 1e-9 && twig.length <= 0.7 * longest + 1e-9);
      expected_shoots += std::size_t(12 * (1.0 - 0.5 * twig.offset / branch.length) + 0.5);
    }
    EXPECT_EQ(shoots.size(), expected_shoots);
    for (const Stem& shoot : shoots)
      EXPECT_NEAR(shoot.length, 0.4 * (tree.stems[shoot.parent].length - 0.6 * shoot.offset), 1e-9);
  }
}

TEST(TreeSkeleton, ForksOfABlackOakShareItsBranches) {
  int forks = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const TreeStatistics oak = tree_statistics(grown("black_oak", seed));
    EXPECT_EQ(oak.levels[1].stems, 60);
    forks += oak.levels[0].forks;
  }
  // Two at the first segment's end, then 0.4 at each of six: 3 · 1.4^6 = 22.6 ends of the trunk.
  EXPECT_NEAR(forks / 40.0 + 1.0, 3.0 * std::pow(1.4, 6), 1.5);
}

// Properties of any tree.

void expect_sound_stem(const TreeSkeleton& tree, const Stem& stem) {
  const StemParameters& shape = tree.parameters.stems[stem.level];
  const double segment = stem.length / shape.curve_resolution;
  ASSERT_EQ(stem.nodes - 1, int(std::lround((stem.length - stem.start) / segment)));
  for (int n = 0; n < stem.nodes; ++n) {
    const StemNode& node = tree.nodes[stem.first_node + n];
    ASSERT_TRUE(std::isfinite(glm::dot(node.position, node.position)));
    ASSERT_NEAR(glm::length(node.frame.z), 1.0, 1e-9);
    ASSERT_NEAR(glm::length(node.frame.x), 1.0, 1e-9);
    ASSERT_NEAR(glm::dot(node.frame.x, node.frame.z), 0.0, 1e-9);
    if (stem.level > 0) {
      ASSERT_GE(node.position.z, -1e-9) << "in the ground";
    }
    if (n > 0) {
      ASSERT_NEAR(glm::length(node.position - (&node)[-1].position), segment, 1e-9 * stem.length);
    }
    const double along = stem.start + n * segment;
    ASSERT_LT(glm::length(stem_place(tree, stem, along).position - node.position),
              1e-6 * stem.length);
  }
  double before = stem_radius(tree, stem, stem.start);
  ASSERT_GE(before, 0.0);
  for (int i = 1; i <= 50; ++i) {
    const double radius =
        stem_radius(tree, stem, stem.start + (stem.length - stem.start) * i / 50.0);
    ASSERT_LE(radius, before + 1e-12);
    before = radius;
  }
}

void expect_sound_foot(const TreeSkeleton& tree, const Stem& stem) {
  const glm::dvec3 foot = tree.nodes[stem.first_node].position;
  if (stem.forked_from >= 0) {
    const Stem& original = tree.stems[stem.forked_from];
    ASSERT_EQ(original.level, stem.level);
    ASSERT_EQ(original.length, stem.length);
    ASSERT_LT(glm::length(stem_place(tree, original, stem.start).position - foot),
              1e-6 * stem.length);
  } else if (stem.parent >= 0) {
    const Stem& parent = tree.stems[stem.parent];
    ASSERT_EQ(parent.level + 1, stem.level);
    ASSERT_GE(stem.offset, parent.start);
    ASSERT_LT(glm::length(stem_place(tree, parent, stem.offset).position - foot), 1e-9);
    ASSERT_LE(stem.radius, stem_radius(tree, parent, stem.offset) + 1e-12);
  }
}

TEST(TreeSkeleton, RandomTreesAreSound) {
  int grown = 0;
  for (std::uint64_t number = 0; number < 300; ++number) {
    SCOPED_TRACE(number);
    const TreeParameters p = random_tree(number);
    const TreeSkeleton tree = grow_tree(p, number, kContext);
    std::array<double, kStemLevels> longest{};
    for (const Stem& stem : tree.stems) {
      ASSERT_NO_FATAL_FAILURE(expect_sound_stem(tree, stem));
      ASSERT_NO_FATAL_FAILURE(expect_sound_foot(tree, stem));
      longest[stem.level] = std::max(longest[stem.level], stem.length);
    }
    double reach = 0.0;
    for (double length : longest) reach += length;
    ASSERT_LE(tree_statistics(tree).height, reach * (1.0 + 1e-12));
    ASSERT_LE(std::abs(tree.scale - p.scale), p.scale_variation);
    for (const TreeLeaf& leaf : tree.leaves) {
      ASSERT_NEAR(glm::dot(leaf.direction, leaf.side), 0.0f, 1e-5f);
      ASSERT_EQ(tree.stems[leaf.stem].level, p.levels - 1);
    }
    grown += int(tree.stems.size());
  }
  EXPECT_GT(grown, 10000);
}

TEST(TreeSkeleton, PrunedTreesStayWithinTheirEnvelope) {
  int pruned = 0;
  for (std::uint64_t number = 0; number < 200; ++number) {
    TreeParameters p = random_tree(number);
    const TreeSkeleton free = grow_tree(p, number, kContext);
    p.prune_ratio = 1.0;
    const TreeSkeleton tree = grow_tree(p, number, kContext);
    for (const Stem& stem : tree.stems) {
      if (stem.level == 0) continue;
      for (int n = 0; n < stem.nodes; ++n) {
        const glm::dvec3 at = tree.nodes[stem.first_node + n].position;
        ASSERT_TRUE(within_envelope(p, tree.scale * (1.0 + 1e-9), at)) << number;
      }
    }
    pruned += tree.stems.size() != free.stems.size();
  }
  EXPECT_GT(pruned, 50);
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b, std::size_t count) {
  return a.size() >= count && b.size() >= count &&
         std::memcmp(a.data(), b.data(), count * sizeof(T)) == 0;
}

TEST(TreeSkeleton, ASeedIsATreeAndTwigsLeaveTheirBranchesAsTheyAre) {
  for (const TreeSpecies& species : tree_species()) {
    const TreeSkeleton tree = grow_tree(species.parameters, 5, kContext);
    const TreeSkeleton again = grow_tree(species.parameters, 5, kContext);
    const TreeSkeleton other = grow_tree(species.parameters, 6, kContext);
    EXPECT_EQ(tree.leaves.size(), again.leaves.size());
    EXPECT_TRUE(same_bytes(tree.nodes, again.nodes, tree.nodes.size())) << species.name;
    EXPECT_FALSE(same_bytes(tree.nodes, other.nodes, 5)) << species.name;
    TreeParameters bare = species.parameters;
    bare.levels = 2;
    const TreeSkeleton branches = grow_tree(bare, 5, kContext);
    EXPECT_TRUE(same_bytes(tree.nodes, branches.nodes, branches.nodes.size())) << species.name;
  }
}

TEST(TreeSkeleton, FullyBentLeavesFaceTheLightAsFarAsTheirDirectionLets) {
  TreeParameters p = find_tree_species("quaking_aspen").parameters;
  const auto away = [&](double bend) {  // the largest turn about its length that a leaf lacks
    p.leaf_bend = bend;
    const TreeSkeleton tree = grow_tree(p, 1, kContext);
    double most = 0.0;
    for (const TreeLeaf& leaf : tree.leaves) {
      const glm::dvec3 out = glm::normalize(glm::dvec3(leaf.position.x, leaf.position.y, 0.0));
      const glm::dvec3 light = out + glm::dvec3(0.0, 0.0, 1.0), side = leaf.side;
      const double facing = glm::dot(glm::cross(glm::dvec3(leaf.direction), side), light);
      most = std::max(most, std::atan2(std::abs(glm::dot(side, light)), facing));
    }
    return most;
  };
  EXPECT_GT(away(0.0), 3.1);
  EXPECT_NEAR(away(0.5), 0.5 * away(0.0), 1e-2);
  EXPECT_LT(away(1.0), 1e-3);
}

TEST(TreeSkeleton, ANegativeVariationOfTheCurveIsAHelix) {
  TreeParameters p;
  p.levels = 1, p.scale = 10.0;
  p.stems[0].curve_resolution = 12, p.stems[0].curve_variation_deg = -25.0;
  const TreeSkeleton tree = grow_tree(p, 1, kContext);
  for (const StemNode& node : tree.nodes)
    EXPECT_NEAR(node.frame.z.z, std::cos(25.0 * std::acos(-1.0) / 180.0), 1e-9);
  const glm::dvec3 tip = tree.nodes.back().position;  // one full turn: above its foot again
  EXPECT_NEAR(std::hypot(tip.x, tip.y), 0.0, 1e-9);
}

TEST(TreeSkeleton, ForksPart) {
  for (const std::string_view species : {"black_oak", "umbrella_acacia", "hazel_bush"}) {
    const TreeSkeleton tree = grown(species, 2);
    int forks = 0, together = 0;
    for (const Stem& fork : tree.stems) {
      if (fork.forked_from < 0) continue;
      const Stem& original = tree.stems[fork.forked_from];
      const glm::dvec3 tip = tree.nodes[fork.first_node + fork.nodes - 1].position;
      const glm::dvec3 other = tree.nodes[original.first_node + original.nodes - 1].position;
      ++forks;
      together += glm::length(tip - other) < 2.0 * stem_radius(tree, fork, fork.start);
    }
    EXPECT_GT(forks, 10);
    EXPECT_LE(together, forks / 20) << species;
  }
}

TEST(TreeSkeleton, ZScaleStretchesTheWholeTree) {
  TreeParameters p = find_tree_species("black_oak").parameters;
  const TreeStatistics plain = tree_statistics(grow_tree(p, 3, kContext));
  p.z_scale = 1.7;
  const TreeStatistics stretched = tree_statistics(grow_tree(p, 3, kContext));
  EXPECT_NEAR(stretched.height, 1.7 * plain.height, 1e-9);
  EXPECT_NEAR(stretched.crown_radius, plain.crown_radius, 1e-9);
}

}  // namespace
}  // namespace orogen
