#include "vegetation/tree_species.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "foundation/errors.h"

namespace orogen {
namespace {

TEST(TreeSpecies, EachIsNamedOnceAndMayBeGrown) {
  std::set<std::string_view> names;
  for (const TreeSpecies& species : tree_species()) {
    EXPECT_TRUE(names.insert(species.name).second) << species.name;
    EXPECT_EQ(species.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), species.name.npos);
    EXPECT_NO_THROW(check_tree(species.parameters)) << species.name;
    EXPECT_EQ(&find_tree_species(species.name), &species);
  }
  EXPECT_GE(names.size(), 10u);
  EXPECT_THROW(find_tree_species("oak"), InputError);
}

std::string refusal(const TreeParameters& parameters) {
  try {
    check_tree(parameters, "tree");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TreeParameters, WhatCannotBeGrownIsRefusedByName) {
  const TreeParameters oak = find_tree_species("black_oak").parameters;
  EXPECT_EQ(refusal(oak), "");
  TreeParameters bad = oak;
  bad.base_size = 1.0;
  EXPECT_NE(refusal(bad).find("tree.base_size: 1 "), std::string::npos) << refusal(bad);
  bad = oak;
  bad.scale_variation = 10.0;
  EXPECT_NE(refusal(bad).find("tree.scale_variation: 10 "), std::string::npos) << refusal(bad);
  bad = oak;
  bad.stems[2].curve_resolution = 0;
  EXPECT_NE(refusal(bad).find("tree.stems[2].curve_resolution: 0 "), std::string::npos)
      << refusal(bad);
  bad = oak;
  bad.stems[1].taper = std::nan("");
  EXPECT_NE(refusal(bad).find("tree.stems[1].taper"), std::string::npos) << refusal(bad);
  bad = oak;
  bad.stems[1].branches = bad.stems[2].branches = 2000;
  EXPECT_NE(refusal(bad).find("10 million at most"), std::string::npos) << refusal(bad);
}

TEST(TreeParameters, CrownsAreAsThePaperPrintsThem) {
  const TreeParameters p{.prune_width_peak = 0.6, .prune_power_low = 1.0, .prune_power_high = 2.0};
  // Tables of ShapeRatio, worked out by hand, at the top, a fifth, half and the whole way down.
  const double expected[9][4] = {{0.2, 0.36, 0.6, 1.0},
                                 {0.2, 0.6702282018339785, 1.0, 0.2},
                                 {0.2, 0.4472135954999579, 0.7656854249492380, 1.0},
                                 {1.0, 1.0, 1.0, 1.0},
                                 {0.5, 0.6, 0.75, 1.0},
                                 {0.0, 0.2857142857142857, 0.7142857142857143, 0.0},
                                 {1.0, 0.84, 0.6, 0.2},
                                 {0.5, 0.6428571428571429, 0.8571428571428571, 0.5},
                                 {0.0, 0.25, 0.8333333333333333, 0.0}};
  const double at[4] = {0.0, 0.2, 0.5, 1.0};
  for (int shape = 0; shape < 9; ++shape)
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(shape_ratio(p, CrownShape(shape), at[i]), expected[shape][i], 1e-12)
          << kCrownShapes[shape] << " at " << at[i];
}

}  // namespace
}  // namespace orogen
