#include "pipeline/ground_volume.h"

#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "foundation/errors.h"

namespace orogen {
namespace {

openvdb::FloatGrid::Ptr write_and_read(const Raster<float>& elevation) {
  static const bool registered = [] {
    openvdb::FloatGrid::registerGrid();
    openvdb::math::MapRegistry::registerMap(openvdb::math::UniformScaleTranslateMap::mapType(),
                                            openvdb::math::UniformScaleTranslateMap::create);
    openvdb::StringMetadata::registerType();
    openvdb::BoolMetadata::registerType();
    openvdb::Int64Metadata::registerType();
    openvdb::Vec3IMetadata::registerType();
    return true;
  }();
  (void)registered;
  // Tests run side by side: each has a file of its own.
  const auto name = "orogen_" + std::to_string(getpid()) + ".vdb";
  const auto path = std::filesystem::temp_directory_path() / name;
  Context context;
  write_ground_volume(path, elevation, {}, context);
  openvdb::io::File file(path.string());
  file.open();
  auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("ground"));
  file.close();
  std::filesystem::remove(path);
  return grid;
}

TEST(GroundVolume, IsALevelSetInMetresUnderAPlane) {
  const Grid grid{40, 30, 50.0, {1000.0, -500.0}};
  Raster<float> elevation(grid);
  const double rise = 0.4;  // along x
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c)
      elevation(r, c) = float(rise * (grid.center(r, c).x - 1000.0));
  const auto volume = write_and_read(elevation);
  EXPECT_EQ(volume->getGridClass(), openvdb::GRID_LEVEL_SET);
  EXPECT_NEAR(volume->voxelSize()[0], 50.0, 1e-9);

  const openvdb::tools::GridSampler<openvdb::FloatGrid, openvdb::tools::BoxSampler> sample(*volume);
  for (int c = 8; c < grid.nx - 8; ++c)
    for (const double above : {-100.0, -40.0, 0.0, 30.0, 90.0}) {
      const glm::dvec2 p = grid.center(15, c);
      const double distance = above / std::sqrt(1.0 + rise * rise);
      EXPECT_NEAR(sample.wsSample({p.x, p.y, elevation(15, c) + above}), distance, 1.0);
    }
}

TEST(GroundVolume, IsSolidBelowAndEmptyBeside) {
  const Grid grid{20, 20, 10.0, {0.0, 0.0}};
  Raster<float> elevation(grid, 100.0f);
  elevation(10, 10) = 160.0f;
  const auto volume = write_and_read(elevation);
  const openvdb::tools::GridSampler<openvdb::FloatGrid, openvdb::tools::PointSampler> at(*volume);
  EXPECT_LT(at.wsSample({100.0, 100.0, 80.0}), 0.0f);
  EXPECT_GT(at.wsSample({100.0, 100.0, 50.0}), 0.0f);   // below the bottom
  EXPECT_GT(at.wsSample({100.0, 100.0, 180.0}), 0.0f);  // above the spike
  EXPECT_GT(at.wsSample({-20.0, 100.0, 90.0}), 0.0f);   // beside
  EXPECT_EQ(at.wsSample({100.0, 100.0, 1e4}), volume->background());
  EXPECT_EQ(volume->background(), 30.0f);
}

TEST(GroundVolume, RefusesWhatMakesNoVolume) {
  Context context;
  const auto nowhere = std::filesystem::path("/no/such/folder/x.vdb");
  EXPECT_THROW(write_ground_volume(nowhere, Raster<float>(Grid{1, 5, 1.0}), {}, context),
               InputError);
  EXPECT_THROW(write_ground_volume(nowhere, Raster<float>(Grid{5, 5, 1.0}), {}, context),
               InputError);
}

TEST(GroundVolume, StopsWhenCancelled) {
  Context context;
  context.cancel();
  EXPECT_THROW(write_ground_volume(std::filesystem::temp_directory_path() / "never.vdb",
                                   Raster<float>(Grid{50, 50, 1.0}), {}, context),
               Cancelled);
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::temp_directory_path() / "never.vdb"));
}

}  // namespace
}  // namespace orogen
