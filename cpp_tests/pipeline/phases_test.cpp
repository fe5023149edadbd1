// Two phases of motion at right angles leave both sets of folds, the older bent by the younger.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "foundation/bilinear.h"
#include "pipeline/collision_products.h"
#include "pipeline/pipeline.h"

namespace orogen {
namespace {

constexpr double kWavelength = 6e3;  // m

/// Two plates that meet from north and south or from west and east; `drag` (m) moves the first
/// sideways, too.
std::string plates(bool north_south, double drag = 0.0) {
  const auto plate = [&](double low, double high, double push, double aside) {
    const auto place = [&](double across, double along) {
      const double x = north_south ? along : across, y = north_south ? across : along;
      return "[" + std::to_string(x) + ", " + std::to_string(y) + "]";
    };
    const auto arrow = place(push, aside);
    return "{\"points\": [" + place(low, -60e3) + ", " + place(high, -60e3) + ", " +
           place(high, 140e3) + ", " + place(low, 140e3) + "], \"arrows\": [" + arrow + ", " +
           arrow + ", " + arrow + ", " + arrow + "]}";
  };
  return "{\"years\": 3e6, \"plates\": [" + plate(-60e3, 5e3, 5e3, drag) + ", " +
         plate(75e3, 140e3, -5e3, 0.0) + "]}";
}

/// A column of one layer that folds, over a basement.
std::string document(const std::string& phases, bool carry, const std::string& edits) {
  return R"({"orogen": 1, "resolution": 160, "extent": {"origin": [0, 0], "size": [80000, 80000]},
    "column": {"basement": {"sub_layers": [{"lithology": "gneiss"}]}, "layers": [{
      "fold_wavelength": 6000, "fold_share": 0.3, "sub_layers": [{"lithology": "limestone"}]}]},
    "stages": [{"stage": "collision", "parameters": {"fault": false, "carry_older_phases": )" +
         std::string(carry ? "true" : "false") + R"(}}, {"stage": "fold_layers"}],
    "phases": [)" +
         phases + R"(], "fold_edits": [)" + edits + "]}";
}

Generated run(const std::string& recipe) {
  Context context;
  return generate(read_recipe(recipe), {}, context);
}

struct Folded {
  Generated made;
  const FoldedPhases& folds;
  const CollisionPhases& collision;
  Raster<float> height;  // of the layer's folds, m

  explicit Folded(const std::string& phases, bool carry = true, const std::string& edits = "")
      : made(run(document(phases, carry, edits))),
        folds(made.products.get<FoldedPhases>()),
        collision(made.products.get<CollisionPhases>()),
        height(made.terrain.grid()) {
    for (std::size_t p = 0; p < folds.phases.size(); ++p)
      for (std::size_t i = 0; i < height.size(); ++i)
        height[i] += float(folds.phases[p][0].speed[i] * collision.phases[p].years);
  }
};

/// Power at wavelengths of 0.7 to 1.5 of the folds' in the middle of the map: folds that run north
/// and south, and folds that run east and west.
struct Power {
  double north_south = 0.0, east_west = 0.0;
};

Power power_of(const Raster<float>& height) {
  const Grid& grid = height.grid();
  const int n = grid.nx / 2, first = grid.nx / 4;
  const double length = n * grid.cell_size;
  std::vector<double> window(n);
  for (int i = 0; i < n; ++i)
    window[i] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (i + 0.5) / n);
  double mean = 0.0;
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) mean += height(first + r, first + c) / (double(n) * n);
  Power power;
  const int most = int(length / (0.7 * kWavelength)) + 1;
  for (int kx = -most; kx <= most; ++kx)
    for (int ky = 0; ky <= most; ++ky) {
      const double k = std::hypot(kx, ky), wavelength = length / k;
      if (!(wavelength > 0.7 * kWavelength && wavelength < 1.5 * kWavelength)) continue;
      double re = 0.0, im = 0.0;
      for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
          const double phase = 2.0 * std::numbers::pi * (kx * c + ky * r) / n;
          const double value = window[r] * window[c] * (height(first + r, first + c) - mean);
          re += value * std::cos(phase);
          im += value * std::sin(phase);
        }
      const double angle = std::atan2(std::abs(ky), std::abs(kx));  // of the way across the folds
      if (angle < std::numbers::pi / 6) power.north_south += re * re + im * im;
      if (angle > std::numbers::pi / 3) power.east_west += re * re + im * im;
    }
  return power;
}

TEST(Phases, BothSetsOfFoldsAreLeft) {
  const Power older = power_of(Folded(plates(false)).height);
  const Power younger = power_of(Folded(plates(true)).height);
  EXPECT_GT(older.north_south, 10.0 * older.east_west);
  EXPECT_GT(younger.east_west, 10.0 * younger.north_south);
  for (const bool carry : {false, true}) {
    const Power both = power_of(Folded(plates(false) + ", " + plates(true), carry).height);
    EXPECT_NEAR(both.north_south / older.north_south, 1.0, 0.3) << carry;
    EXPECT_NEAR(both.east_west / younger.east_west, 1.0, 0.3) << carry;
  }
}

/// Mean, deviation, and correlation with another field at the middles of a phase's crests.
struct AlongCrests {
  double mean = 0.0, deviation = 0.0, correlation = 0.0;
};

AlongCrests along_crests(const FoldSkeleton& skeleton, const GroundShift& shift,
                         const Raster<float>& height, const Raster<float>& other) {
  std::vector<double> a, b;
  for (const Segment& s : skeleton.top) {
    const glm::dvec2 was = 0.5 * (s.a + s.b);
    glm::dvec2 place = was;  // to which it was carried
    for (int i = 0; i < 20; ++i) place += was - place_before(place, shift);
    if (std::min(place.x, place.y) < 20e3 || std::max(place.x, place.y) > 60e3) continue;
    const Bilinear at = bilinear_at(height.grid(), place);
    a.push_back(at(height));
    b.push_back(at(other));
  }
  AlongCrests result;
  double other_mean = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  const double n = double(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    result.mean += a[i] / n;
    other_mean += b[i] / n;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - result.mean) * (a[i] - result.mean);
    bb += (b[i] - other_mean) * (b[i] - other_mean);
    ab += (a[i] - result.mean) * (b[i] - other_mean);
  }
  result.deviation = std::sqrt(aa / n);
  result.correlation = ab / std::sqrt(aa * bb);
  return result;
}

TEST(Phases, YoungerFoldsCutTheCrestsOfTheOlder) {
  for (const bool carry : {false, true}) {
    const Folded alone(plates(false), carry);
    const Folded both(plates(false) + ", " + plates(true), carry);
    Raster<float> younger = both.folds.phases[1][0].speed;
    for (float& v : younger.values()) v *= float(both.collision.phases[1].years);
    const FoldSkeleton& older = both.folds.phases[0][0].skeleton;
    EXPECT_EQ(older.top, alone.folds.phases[0][0].skeleton.top);
    const auto flat = along_crests(older, {}, alone.height, alone.height);
    const auto cut = along_crests(older, both.collision.phases[0].shift, both.height, younger);
    EXPECT_LT(flat.deviation, 0.15 * flat.mean);  // alone their crests are nearly level
    EXPECT_GT(cut.deviation, 0.25 * flat.mean);   // now they dip under the younger troughs
    EXPECT_GT(cut.correlation, 0.9);
  }
}

TEST(Phases, OlderFoldsAreCarriedByTheYoungerMotion) {
  const Folded alone(plates(false));
  const std::string both = plates(false) + ", " + plates(true, 6e3);
  const Folded carried(both), left(both, false);
  EXPECT_EQ(left.folds.phases[0][0].speed, alone.folds.phases[0][0].speed);
  EXPECT_EQ(left.collision.phases[0].rise, alone.collision.phases[0].rise);

  std::vector<PlateGesture> gestures;
  for (const auto& [low, high, arrow] : {std::tuple{-60e3, 5e3, glm::dvec2(6e3, 5e3)},
                                         std::tuple{75e3, 140e3, glm::dvec2(0.0, -5e3)}})
    gestures.push_back({{{-60e3, low}, {-60e3, high}, {140e3, high}, {140e3, low}},
                        std::vector(4, arrow),
                        PlateCrust::Continental,
                        ""});
  const TransportField younger(rigid_plates(gestures));
  const Raster<float>& before = alone.folds.phases[0][0].speed;
  const Raster<float>& after = carried.folds.phases[0][0].speed;
  const Grid& grid = before.grid();
  const double most = *std::max_element(before.values().begin(), before.values().end());
  double least_aside = 1e9, most_aside = -1e9;
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) {
      const glm::dvec2 place = grid.center(r, c), origin = younger.inverse(place);
      const glm::dvec2 cells = grid.to_cells(origin) - 0.5;
      if (std::min(cells.x, cells.y) >= 0.0 && cells.x <= grid.nx - 1 && cells.y <= grid.ny - 1)
        ASSERT_NEAR(after(r, c), bilinear_at(grid, origin)(before), 1e-5 * most);
      if (c != grid.nx / 2) continue;
      least_aside = std::min(least_aside, place.x - origin.x);
      most_aside = std::max(most_aside, place.x - origin.x);
    }
  EXPECT_LT(least_aside, 500.0);  // a crest that ran north and south is bent
  EXPECT_GT(most_aside, 5500.0);
  EXPECT_EQ(carried.folds.phases[1][0].speed, left.folds.phases[1][0].speed);  // the last one stays
}

TEST(Phases, EditsAreMeantWhereTheirFoldsEndUp) {
  const std::string both = plates(false) + ", " + plates(true, 6e3);
  const std::string line =
      R"("layer": 1, "phase": 1, "from": [40000, 25000], "to": [40000, 55000])";
  const Folded made(
      both, true,
      R"({"edit": "add", )" + line + R"(}, {"edit": "set", "value": 2000, )" + line + "}");
  EXPECT_TRUE(made.made.warnings.empty());
  const Raster<float>& older = made.folds.phases[0][0].speed;
  double highest = 0.0;  // across the line's middle
  for (double x = 37.5e3; x <= 42.5e3; x += 100.0)
    highest = std::max(
        highest, bilinear_at(older.grid(), {x, 40e3})(older) * made.collision.phases[0].years);
  EXPECT_NEAR(highest, 2000.0, 300.0);
}

}  // namespace
}  // namespace orogen
