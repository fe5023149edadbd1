#include "strata/rock_volume.h"

#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "foundation/errors.h"
#include "foundation/noise.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

openvdb::Int32Grid::Ptr read_back(const std::filesystem::path& path) {
  static const bool registered = [] {
    using openvdb::math::MapRegistry;
    openvdb::Int32Grid::registerGrid();
    MapRegistry::registerMap(openvdb::math::ScaleTranslateMap::mapType(),
                             openvdb::math::ScaleTranslateMap::create);
    MapRegistry::registerMap(openvdb::math::UniformScaleTranslateMap::mapType(),
                             openvdb::math::UniformScaleTranslateMap::create);
    openvdb::StringMetadata::registerType();
    openvdb::BoolMetadata::registerType();
    openvdb::Int64Metadata::registerType();
    openvdb::Vec3IMetadata::registerType();
    return true;
  }();
  (void)registered;
  openvdb::io::File file(path.string());
  file.open();
  auto grid = openvdb::gridPtrCast<openvdb::Int32Grid>(file.readGrid("rock"));
  file.close();
  std::filesystem::remove(path);
  return grid;
}

std::filesystem::path own_file() {
  return std::filesystem::temp_directory_path() /
         ("orogen_rock_" + std::to_string(getpid()) + ".vdb");
}

TEST(RockVolume, AgreesWithRockAtVoxelByVoxel) {
  Context context;
  const auto column = test::three_layers();
  const RockTable rocks(column, {}, StrataPalette::Map);
  const Grid grid{150, 140, 100.0, {2000.0, 1000.0}};  // more than one brick each way
  const HorizonStack stack = test::folded(column, grid, 2500.0, 450.0, context);
  Raster<float> ground = fbm({.seed = 3, .wavelength = 2000.0}, grid, context);
  for (float& z : ground.values()) z = 500.0f + 300.0f * z;
  const RockBody body{stack, rocks, ground};
  write_rock_volume(own_file(), body, column, {.base = -1000.0, .voxel_height = 40.0}, context);
  const auto volume = read_back(own_file());
  EXPECT_NEAR(volume->voxelSize()[0], 100.0, 1e-9);
  EXPECT_NEAR(volume->voxelSize()[2], 40.0, 1e-9);
  auto access = volume->getConstAccessor();
  std::vector<float> h(4);
  std::set<int> met;
  for (int j = 0; j < grid.ny; j += 7)
    for (int i = 0; i < grid.nx; i += 3) {
      const glm::dvec2 place = grid.center(j, i);
      stack.at(place, h.data());
      for (double z = -1180.0; z < 2000.0; z += 40.0) {
        const auto index = volume->worldToIndex({place.x, place.y, z});
        const int found = access.getValue(openvdb::Coord::round(index));
        int expected = 0;
        if (z > -1000.0 && z <= ground(j, i)) {
          const Rock rock = rocks.rock_at(h.data(), float(z));
          expected = 1 + 2 * rock.layer + rock.sub_layer;
        }
        ASSERT_EQ(found, expected) << i << ' ' << j << ' ' << z;
        met.insert(found);
      }
    }
  EXPECT_GE(met.size(), 7u);
  EXPECT_EQ(volume->metaValue<std::string>("rock_6"), "middle/limestone");
  EXPECT_EQ(volume->metaValue<std::string>("rock_9"), "loose sediment/sediment");
}

TEST(RockVolume, RefusesWhatIsNoVolume) {
  Context context;
  const auto column = test::three_layers();
  const RockTable rocks(column, {}, StrataPalette::Map);
  const HorizonStack stack = initial_horizons(column, Grid{8, 8, 100.0, {}}, context);
  const Raster<float> ground(stack.grid(), -100.0f);
  const RockBody body{stack, rocks, ground};
  EXPECT_THROW(write_rock_volume(own_file(), body, column, {.base = 0.0}, context), InputError);
  EXPECT_THROW(
      write_rock_volume(own_file(), body, column, {.base = -1e3, .voxel_height = 0.0}, context),
      InputError);
  EXPECT_THROW(write_rock_volume(own_file(), body, column,
                                 {.base = -1e9, .voxel_size = 0.01, .voxel_height = 0.01}, context),
               InputError);
  EXPECT_THROW(write_rock_volume("/nowhere/at/all.vdb", body, column, {.base = -1e3}, context),
               InputError);
}

}  // namespace
}  // namespace orogen
