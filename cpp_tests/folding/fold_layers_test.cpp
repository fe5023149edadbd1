#include "folding/fold_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "folding/compression_fields.h"
#include "folding/fold_relief.h"
#include "foundation/errors.h"

namespace orogen {
namespace {

const Grid kGrid = grid_over({0.0, 0.0}, glm::dvec2(60e3, 45e3), 150);

FoldLayer layer_of(double wavelength, double share) {
  FoldLayer layer;
  layer.fold_wavelength = wavelength;
  layer.speed_share = share;
  return layer;
}

float highest(const Raster<float>& raster) {
  return *std::max_element(raster.values().begin(), raster.values().end());
}

TEST(FoldLayers, EachLayerFoldsAtItsOwnWavelengthAndSpeed) {
  const Context context;
  const auto field = test::uniform_field(kGrid, 0.3, 0.4);
  const auto folded =
      fold_layers(field, std::vector{layer_of(9e3, 0.5), layer_of(3e3, 0.1)}, {}, 1, context);
  ASSERT_EQ(folded.size(), 2u);
  EXPECT_NEAR(highest(folded[0].speed), 0.5 * 5e-4 * 0.4, 1e-6);
  EXPECT_NEAR(highest(folded[1].speed), 0.1 * 5e-4 * 0.4, 1e-6);
  EXPECT_GT(folded[1].skeleton.top.size(), 5 * folded[0].skeleton.top.size());
}

TEST(FoldLayers, LayersOfOneWavelengthFoldAtDifferentPlaces) {
  const Context context;
  const auto field = test::uniform_field(kGrid, 0.3);
  const auto folded = fold_layers(field, std::vector<FoldLayer>(2), {}, 1, context);
  EXPECT_NE(folded[0].skeleton.mesh.points, folded[1].skeleton.mesh.points);
}

TEST(FoldLayers, APreviewLeavesSmallFoldsFlatAndOthersAsTheyAre) {
  const Context context;
  const auto field = test::belt_field(kGrid);
  const std::vector layers{layer_of(2e3, 0.1), layer_of(9e3, 0.5)};
  const auto full = fold_layers(field, layers, {}, 1, context);
  const auto preview = fold_layers(field, layers, {.shortest_wavelength = 5e3}, 1, context);
  ASSERT_EQ(preview.size(), 2u);
  EXPECT_EQ(preview[0].speed, Raster<float>(kGrid));
  EXPECT_TRUE(preview[0].skeleton.top.empty());
  EXPECT_EQ(preview[1].speed, full[1].speed);
}

TEST(FoldLayers, SameBytesForAnyNumberOfThreads) {
  const auto field = test::random_field(kGrid, 5);
  std::vector layers{layer_of(6e3, 0.3), layer_of(1200.0, 0.1)};
  layers[0].edits = {{FoldEditKind::Add, {5e3, 5e3}, {40e3, 30e3}},
                     {FoldEditKind::Set, {5e3, 5e3}, {40e3, 30e3}, 900.0}};
  std::vector<FoldedLayer> first;
  for (const int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      const auto result = fold_layers(field, layers, {}, 7, context);
      if (first.empty()) first = result;
      for (std::size_t i = 0; i < layers.size(); ++i) {
        EXPECT_EQ(result[i].speed, first[i].speed);
        EXPECT_EQ(result[i].skeleton.top, first[i].skeleton.top);
        EXPECT_EQ(result[i].skeleton.bottom, first[i].skeleton.bottom);
      }
    });
  }
}

TEST(FoldLayers, WavelengthFollowsTheMapOfALayer) {
  const Context context;
  const auto field = test::uniform_field(kGrid, 0.0);
  Raster<float> map(kGrid);
  for (int r = 0; r < kGrid.ny; ++r)
    for (int c = 0; c < kGrid.nx; ++c) map(r, c) = c < kGrid.nx / 2 ? 2e3f : 6e3f;
  FoldLayer layer;
  layer.wavelength_map = &map;
  const auto folded = fold_layers(field, std::vector{layer}, {}, 1, context);
  int west = 0, east = 0;
  for (const Segment& s : folded[0].skeleton.top) {
    west += s.a.x > 0.0 && s.a.x < 30e3;
    east += s.a.x > 30e3 && s.a.x < 60e3;
  }
  EXPECT_NEAR(double(west) / east, 9.0, 3.0);
}

TEST(FoldLayers, NoLayersAndTinyGrids) {
  const Context context;
  EXPECT_TRUE(fold_layers(test::uniform_field(kGrid, 0.0), {}, {}, 1, context).empty());
  for (const Grid grid :
       {Grid{1, 1, 10.0}, Grid{1, 37, 900.0}, Grid{41, 1, 900.0}, Grid{17, 19, 5.0}})
    for (int seed = 0; seed < 10; ++seed) {
      const auto folded = fold_layers(test::uniform_field(grid, 0.4, 0.3),
                                      std::vector<FoldLayer>(1), {}, seed, context);
      for (const float v : folded[0].speed.values()) {
        EXPECT_GE(v, 0.0f);
        EXPECT_LE(v, 0.25 * 5e-4 * 0.3 * 1.00001);
      }
    }
}

std::string refusal(const FoldLayer& layer) {
  const Context context;
  try {
    fold_layers(test::uniform_field(kGrid, 0.0), std::vector{FoldLayer{}, layer}, {}, 1, context);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FoldLayers, BadInputIsNamed) {
  FoldLayer layer;
  layer.speed_share = 0.7;
  EXPECT_NE(refusal(layer).find("fold_layers[1]"), std::string::npos);
  EXPECT_NE(refusal(layer).find("speed_share"), std::string::npos);
  layer = {};
  layer.edits = {{}, {FoldEditKind::Set, {0.0, 0.0}, {1e3, 0.0}, -5.0}};
  EXPECT_NE(refusal(layer).find("fold_layers[1].edits[1]: value"), std::string::npos);
  layer.edits = {{FoldEditKind::Add, {0.0, std::nan("")}, {1e3, 0.0}}};
  EXPECT_NE(refusal(layer).find("fold_layers[1].edits[0]"), std::string::npos);
  layer = {};
  const Raster<float> bad(Grid{3, 3, 10.0}, -1.0f);
  layer.wavelength_map = &bad;
  EXPECT_NE(refusal(layer).find("fold_layers[1].fold_wavelength"), std::string::npos);
  layer = {};
  EXPECT_EQ(refusal(layer), "");
}

}  // namespace
}  // namespace orogen
