#include "folding/fold_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "folding/compression_fields.h"
#include "folding/fold_layers.h"
#include "folding/fold_lines.h"

namespace orogen {
namespace {

const Grid kGrid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 100);
constexpr glm::dvec2 kFrom(30e3, 35e3), kTo(72e3, 61e3);  // a line across most folds

// Share of the line with a crest within `distance`.
double share_with_crest(const FoldSkeleton& skeleton, const Segment& line, double distance) {
  int near = 0;
  for (int k = 0; k <= 500; ++k) {
    const glm::dvec2 p = line.a + (k / 500.0) * (line.b - line.a);
    near += std::any_of(skeleton.top.begin(), skeleton.top.end(),
                        [&](const Segment& s) { return distance_to(s, p) <= distance; });
  }
  return near / 501.0;
}

// Number of crests along the line, by the rule of the header.
int crests_along(const FoldSkeleton& skeleton, const Segment& line, double lambda) {
  int count = 0;
  for (const Segment& s : skeleton.top) {
    const glm::dvec2 d = s.b - s.a, way = line.b - line.a;
    count += distance_to(line, 0.5 * (s.a + s.b)) <= 0.5 * lambda &&
             std::fabs(glm::dot(d, way)) >= std::sqrt(0.5) * glm::length(d) * glm::length(way);
  }
  return count;
}

void expect_open_faces(const FoldSkeleton& skeleton) {
  for (const auto& face : skeleton.mesh.faces)
    EXPECT_LT(std::count_if(face.edges.begin(), face.edges.end(),
                            [&](int e) { return skeleton.choice[e] != FoldChoice::None; }),
              3);
}

TEST(FoldEdits, ADrawnFoldIsACrestWhateverWavelengthSeedAndField) {
  const Context context;
  const FoldEdit edits[] = {{FoldEditKind::Add, kFrom, kTo}};
  for (int seed = 0; seed < 100; ++seed) {
    const double lambda = 2e3 + 50.0 * seed;
    const auto field =
        seed % 2 ? test::random_field(kGrid, seed) : test::uniform_field(kGrid, 0.1 * seed);
    const auto skeleton = fold_skeleton(field, FoldWavelength(lambda), edits, seed, context);
    EXPECT_TRUE(skeleton.edits_without_effect.empty());
    EXPECT_EQ(share_with_crest(skeleton, {kFrom, kTo}, 0.75 * lambda), 1.0);
    expect_open_faces(skeleton);
    // The crests by hand make one path: two ends, all else passed through.
    std::vector<int> degree(skeleton.mesh.points.size(), 0);
    for (std::size_t e = 0; e < skeleton.choice.size(); ++e)
      if (skeleton.choice[e] == FoldChoice::ByHand) {
        ++degree[skeleton.mesh.edges[e].a];
        ++degree[skeleton.mesh.edges[e].b];
      }
    EXPECT_EQ(std::count(degree.begin(), degree.end(), 1), 2);
    EXPECT_EQ(std::count_if(degree.begin(), degree.end(), [](int d) { return d > 2; }), 0);
  }
}

TEST(FoldEdits, ADrawnFoldStandsAloneButJoinsOthersAtItsEnds) {
  const Context context;
  const double lambda = 4e3;
  int joined = 0;
  for (int seed = 0; seed < 50; ++seed) {
    const auto field = test::uniform_field(kGrid, 0.3);
    const auto plain = fold_skeleton(field, FoldWavelength(lambda), {}, seed, context);
    // From the end of a fold near the middle, across the others.
    glm::dvec2 from(0.0);
    for (const FoldLine& line : fold_lines(plain.top))
      if (glm::distance(line.points.front(), glm::dvec2(50e3)) <
          glm::distance(from, glm::dvec2(50e3)))
        from = line.points.front();
    const FoldEdit edits[] = {{FoldEditKind::Add, from, from + glm::dvec2(18e3, 6e3)}};
    const auto skeleton = fold_skeleton(field, FoldWavelength(lambda), edits, seed, context);
    std::vector<Segment> drawn, others;
    for (std::size_t e = 0; e < skeleton.choice.size(); ++e) {
      const auto& edge = skeleton.mesh.edges[e];
      const Segment s{skeleton.mesh.points[edge.a], skeleton.mesh.points[edge.b]};
      if (skeleton.choice[e] == FoldChoice::ByHand) drawn.push_back(s);
      if (skeleton.choice[e] == FoldChoice::ByEnergy) others.push_back(s);
    }
    for (const Segment& s : others) {
      const glm::dvec2 middle = 0.5 * (s.a + s.b);
      double d = std::numeric_limits<double>::infinity();
      for (const Segment& t : drawn) d = std::min(d, distance_to(t, middle));
      const double to_end = std::min(glm::distance(middle, from),
                                     glm::distance(middle, from + glm::dvec2(18e3, 6e3)));
      EXPECT_TRUE(d >= 0.75 * lambda || to_end < 1.5 * lambda);
      joined += s.a == from || s.b == from;
    }
  }
  EXPECT_GT(joined, 25);
}

TEST(FoldEdits, WhatIsRemovedIsGoneAndTheRestStays) {
  const Context context;
  for (int seed = 0; seed < 100; ++seed) {
    const double lambda = 3e3 + 40.0 * seed;
    const auto field = test::uniform_field(kGrid, 2.1);  // folds run along the line
    const FoldEdit edits[] = {{FoldEditKind::Remove, kFrom, kTo}};
    const auto before = fold_skeleton(field, FoldWavelength(lambda), {}, seed, context);
    const auto after = fold_skeleton(field, FoldWavelength(lambda), edits, seed, context);
    EXPECT_GT(crests_along(before, {kFrom, kTo}, lambda), 0);
    EXPECT_EQ(crests_along(after, {kFrom, kTo}, lambda), 0);
    const auto far = [&](const FoldSkeleton& skeleton) {
      std::vector<Segment> result;
      for (const Segment& s : skeleton.top)
        if (distance_to({kFrom, kTo}, 0.5 * (s.a + s.b)) > 2.0 * lambda) result.push_back(s);
      return result;
    };
    EXPECT_EQ(far(before), far(after));
    expect_open_faces(after);
  }
}

TEST(FoldEdits, LaterEditsWin) {
  const Context context;
  const auto field = test::uniform_field(kGrid, 0.0);
  const FoldWavelength lambda(4e3);
  const FoldEdit add{FoldEditKind::Add, kFrom, kTo}, remove{FoldEditKind::Remove, kFrom, kTo};
  const auto none = fold_skeleton(field, lambda, std::vector{add, remove}, 1, context);
  EXPECT_EQ(crests_along(none, {kFrom, kTo}, 4e3), 0);
  const auto drawn = fold_skeleton(field, lambda, std::vector{remove, add}, 1, context);
  EXPECT_EQ(share_with_crest(drawn, {kFrom, kTo}, 3e3), 1.0);
}

TEST(FoldEdits, CrossingAndCoincidingFoldsLeaveNoFaceClosed) {
  const Context context;
  for (int seed = 0; seed < 100; ++seed) {
    std::vector<FoldEdit> edits;
    for (int i = 0; i < 30; ++i) {
      const auto place = [&](int k) {
        return 20e3 * glm::dvec2(random_uniform(seed, i, k), random_uniform(seed, i, k + 1));
      };
      edits.push_back({i % 5 == 4 ? FoldEditKind::Remove : FoldEditKind::Add, place(0), place(2)});
    }
    const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(20e3), 20);
    const auto field = test::random_field(grid, seed);
    expect_open_faces(fold_skeleton(field, FoldWavelength(4e3), edits, seed, context));
  }
}

FoldedLayer folded(const CompressionField& field, double lambda, std::vector<FoldEdit> edits,
                   int seed) {
  const Context context;
  FoldLayer layer;
  layer.fold_wavelength = lambda;
  layer.edits = std::move(edits);
  return fold_layers(field, std::vector{layer}, {}, seed, context)[0];
}

TEST(FoldEdits, HeightsSetByHandAreReachedOnTheCrestAndNowhereFar) {
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(100e3), 400);
  const double time = FoldLayersParameters{}.folding_time;
  for (int seed = 0; seed < 20; ++seed) {
    const double lambda = 8e3 + 200.0 * seed, wanted = 300.0 + 100.0 * seed;
    const auto field = test::belt_field(grid);  // the line leaves the compressed ground
    const FoldEdit add{FoldEditKind::Add, kFrom, kTo};
    const auto plain = folded(field, lambda, {add}, seed);
    const auto set = folded(field, lambda, {add, {FoldEditKind::Set, kFrom, kTo, wanted}}, seed);
    EXPECT_TRUE(set.edits_without_effect.empty());
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        const double height = set.speed(r, c) * time,
                     d = distance_to({kFrom, kTo}, grid.center(r, c));
        if (d > 3.0 * lambda) {
          ASSERT_EQ(set.speed(r, c), plain.speed(r, c));
        }
        ASSERT_GE(height, 0.0);
      }
    // Along the drawn crests the height is the one asked for, but for the distance to cell centres.
    const auto& mesh = set.skeleton.mesh;
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      if (set.skeleton.choice[e] != FoldChoice::ByHand) continue;
      const glm::dvec2 m = mesh.middle(int(e)), d = mesh.along(int(e)), way = kTo - kFrom;
      if (distance_to({kFrom, kTo}, m) > 0.5 * lambda ||
          std::fabs(glm::dot(d, way)) < std::sqrt(0.5) * glm::length(d) * glm::length(way))
        continue;
      const double height = set.speed(grid.row_of(m.y), grid.column_of(m.x)) * time;
      EXPECT_NEAR(height, wanted, 0.1 * wanted);
    }
  }
}

TEST(FoldEdits, HeightsAreScaledSmoothly) {
  const auto field = test::uniform_field(kGrid, 2.1);
  for (int seed = 0; seed < 20; ++seed) {
    const double lambda = 8e3;
    const auto plain = folded(field, lambda, {}, seed);
    const auto scaled = folded(field, lambda, {{FoldEditKind::Scale, kFrom, kTo, 3.0}}, seed);
    EXPECT_TRUE(scaled.edits_without_effect.empty());
    float most = 0.0f, last = 1.0f;
    for (int r = 0; r < kGrid.ny; ++r)
      for (int c = 0; c < kGrid.nx; ++c) {
        if (plain.speed(r, c) < 1e-9f) continue;
        const float factor = scaled.speed(r, c) / plain.speed(r, c);
        ASSERT_GE(factor, 1.0f - 1e-4f);
        ASSERT_LE(factor, 3.0f + 1e-4f);
        // w falls by at most 1.54 / λ.
        if (c > 0 && plain.speed(r, c - 1) >= 1e-9f) {
          ASSERT_LE(std::fabs(factor - last), 2.0 * 1.6 * kGrid.cell_size / lambda);
        }
        last = factor;
        most = std::max(most, factor);
      }
    EXPECT_GT(most, 2.9f);
    const auto level = folded(field, lambda, {{FoldEditKind::Scale, kFrom, kTo, 1.0}}, seed);
    EXPECT_EQ(level.speed, plain.speed);
  }
}

TEST(FoldEdits, ThoseWithoutEffectAreNamed) {
  const auto field = test::uniform_field(kGrid, 0.0, 0.0);
  const glm::dvec2 near = kFrom + glm::dvec2(1.0);
  const auto result = folded(field, 9e3,
                             {{FoldEditKind::Scale, kFrom, kTo, 2.0},
                              {FoldEditKind::Add, kFrom, near},
                              {FoldEditKind::Remove, kFrom, kTo},
                              {FoldEditKind::Set, kFrom, kTo, 5.0}},
                             1);
  EXPECT_EQ(result.edits_without_effect, (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(result.speed, Raster<float>(kGrid));
}

TEST(FoldEdits, WhereNothingIsCompressedADrawnFoldRisesOnceItsHeightIsSet) {
  const auto field = test::uniform_field(kGrid, 0.0, 0.0);
  const FoldEdit add{FoldEditKind::Add, kFrom, kTo};
  EXPECT_EQ(folded(field, 9e3, {add}, 1).speed, Raster<float>(kGrid));
  const auto risen = folded(field, 9e3, {add, {FoldEditKind::Set, kFrom, kTo, 800.0}}, 1).speed;
  const float most = *std::max_element(risen.values().begin(), risen.values().end());
  EXPECT_NEAR(most * FoldLayersParameters{}.folding_time, 800.0, 10.0);
}

}  // namespace
}  // namespace orogen
