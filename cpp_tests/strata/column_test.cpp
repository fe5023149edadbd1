#include "strata/column.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "foundation/errors.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

std::string refusal(const StratigraphicColumn& column) {
  try {
    check_column(column);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Column, PresetsAreSoundAndDiffer) {
  std::set<std::size_t> counts;
  for (const auto name : column_names()) {
    SCOPED_TRACE(name);
    const StratigraphicColumn column = preset_column(name);
    EXPECT_EQ(refusal(column), "");
    for (const double wavelength : fold_wavelengths(column)) {
      EXPECT_GE(wavelength, 500.0);  // Table 2
      EXPECT_LE(wavelength, 20e3);
    }
    for (const Layer& layer : column.layers) {
      EXPECT_FALSE(layer.name.empty());
      EXPECT_LE(layer.fold_share, 0.5);
    }
    counts.insert(column.layers.size());
  }
  EXPECT_GE(counts.size(), 3u);
  EXPECT_THROW(preset_column("cheese"), InputError);
}

TEST(Column, WavelengthsFollowThicknessAndViscosity) {
  StratigraphicColumn column = test::three_layers();
  const auto wavelengths = fold_wavelengths(column);
  const double expected =
      2.0 * std::numbers::pi * std::sqrt(600.0 * 300.0) / std::pow(6.0, 1.0 / 6.0);
  EXPECT_NEAR(wavelengths[1], expected, 1e-9 * expected);
  column.layers[1].thickness *= 4.0;
  EXPECT_NEAR(fold_wavelengths(column)[1], 2.0 * expected, 1e-9 * expected);
  column.layers[1].viscosity *= 64.0;
  EXPECT_NEAR(fold_wavelengths(column)[1], 4.0 * expected, 1e-9 * expected);
  column.layers[1].fold_wavelength = 5000.0;
  EXPECT_EQ(fold_wavelengths(column)[1], 5000.0);
}

TEST(Column, RefusalsNameThePlace) {
  StratigraphicColumn column = test::three_layers();
  column.layers[2].thickness = -1.0;
  EXPECT_EQ(refusal(column).find("column.layers[2].thickness: -1"), 0u) << refusal(column);
  column = test::three_layers();
  column.layers[1].sub_layers[1].resistance = 1.5;
  EXPECT_EQ(refusal(column).find("column.layers[1].sub_layers[1].resistance: 1.5"), 0u);
  column = test::three_layers();
  column.layers[0].sub_layers.clear();
  EXPECT_NE(refusal(column).find("1 to 10"), std::string::npos);
  column.layers.clear();
  EXPECT_NE(refusal(column), "");
  column = test::three_layers();
  column.layers[0].viscosity = std::nan("");
  EXPECT_NE(refusal(column), "");
  column = test::three_layers();
  column.layers[0].thickness_map = CornerMap{2, 2, {100.0, 100.0, -5.0, 100.0}};
  EXPECT_EQ(refusal(column).find("column.layers[0].thickness_map[1][0]: -5"), 0u)
      << refusal(column);
}

TEST(Column, HarderRockErodesLessAndStandsSteeper) {
  const RockStrengthParameters strength;
  EXPECT_DOUBLE_EQ(erodibility_of(0.0, strength), strength.soft_erodibility);
  EXPECT_NEAR(erodibility_of(1.0, strength), strength.hard_erodibility, 1e-18);
  EXPECT_NEAR(talus_slope_of(0.0, strength), std::tan(std::numbers::pi / 6.0), 1e-12);
  for (double r = 0.0; r < 1.0; r += 0.1) {
    EXPECT_GT(erodibility_of(r, strength), erodibility_of(r + 0.1, strength));
    EXPECT_LT(talus_slope_of(r, strength), talus_slope_of(r + 0.1, strength));
  }
}

}  // namespace
}  // namespace orogen
