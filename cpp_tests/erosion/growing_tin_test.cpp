#include "erosion/growing_tin.h"

#include <gtest/gtest.h>

#include <cmath>

#include "erosion/range.h"

namespace orogen {
namespace {

TEST(GrowingTin, CreepEndsAtTheNewShore) {
  // Where the south sinks below the sea, what land loses goes out through the shore as it is then.
  Range range;
  range.strength.soft_erodibility = range.strength.hard_erodibility = 1e-12;
  range.rocks = RockTable(range.column, range.strength, StrataPalette::Map);
  range.parameters.landslide_rate = 0.0;
  range.parameters.diffusivity = 20.0;
  for (int r = 0; r < range.grid.ny; ++r)
    for (int c = 0; c < range.grid.nx; ++c) range.crust(r, c) = r < 40 ? -1e-3f : 5e-4f;
  range.input.phases[0].folds[1] = nullptr;
  const TinDomain domain{range.grid.origin, {range.grid.width(), range.grid.height()}};
  const auto tin = std::make_shared<const Tin>(jittered_tin(domain, 500.0, 1, range.context));
  GrowingTin mesh(tin, range.input, range.parameters);
  mesh.begin(1, range.context);
  mesh.set_phase(range.input.phases[0], range.context);
  for (int i = 0; i < 5; ++i) mesh.step(1e5, range.context);
  const std::vector<double> before = mesh.elevation();
  const MassBalance b = mesh.step(1e5, range.context);
  double gained = 0.0;
  int sunk = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] < 0.0)
      ++sunk;
    else if (!mesh.tin().sides[i])
      gained += (mesh.elevation()[i] - before[i]) * mesh.tin().cell_areas[i];
  }
  EXPECT_GT(sunk, 500);
  EXPECT_GT(b.exported_m3, 0.0);
  EXPECT_NEAR(gained, b.supplied_m3 - b.exported_m3, 1e-9 * b.supplied_m3);
}

}  // namespace
}  // namespace orogen
