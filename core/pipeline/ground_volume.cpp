#include "pipeline/ground_volume.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetTracker.h>
#include <openvdb/tools/SignedFloodFill.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr double kHalfWidth = 3.0;  // voxels, OpenVDB's usual

/// A first signed distance, in voxels: to the tangent plane of the ground above or below a voxel,
/// and to the block that bounds the solid.
class GroundDistance {
 public:
  GroundDistance(const Raster<float>& elevation, double bottom)
      : elevation_(elevation), grid_(elevation.grid()), bottom_(bottom / grid_.cell_size) {}

  struct Column {
    double height, cosine;  // of the ground's slope
    double beside;          // distance to the nearest wall, positive outside
  };

  Column column(int i, int j) const {
    const int r = std::clamp(j, 0, grid_.ny - 1), c = std::clamp(i, 0, grid_.nx - 1);
    const int east = std::min(c + 1, grid_.nx - 1), west = std::max(c - 1, 0);
    const int north = std::min(r + 1, grid_.ny - 1), south = std::max(r - 1, 0);
    const double dx = (elevation_(r, east) - elevation_(r, west)) / (east - west);
    const double dy = (elevation_(north, c) - elevation_(south, c)) / (north - south);
    const double cell = grid_.cell_size;
    const double x = std::max(-i, i - grid_.nx + 1), y = std::max(-j, j - grid_.ny + 1);
    const double out = std::hypot(std::max(x, 0.0), std::max(y, 0.0));
    return {elevation_(r, c) / cell, 1.0 / std::sqrt(1.0 + (dx * dx + dy * dy) / (cell * cell)),
            out > 0.0 ? out : std::max(x, y)};
  }

  double at(const Column& column, int k) const {
    const double ground = (k - column.height) * column.cosine;
    const double below = bottom_ - k;
    const double corner = std::hypot(std::max(below, 0.0), std::max(column.beside, 0.0));
    return std::max(ground, corner > 0.0 ? corner : std::max(below, column.beside));
  }

  /// Calls body(k) for the voxels of a column that may lie in the narrow band.
  template <class Body>
  void for_band(const Column& column, Body&& body) const {
    const int reach = int(std::ceil(kHalfWidth / column.cosine));
    const int top = int(std::ceil(column.height)) + reach;
    const int low = int(std::floor(bottom_ - kHalfWidth));
    const bool wall = column.beside > -kHalfWidth;
    const int floor_end = wall ? top : std::min(top, int(std::ceil(bottom_ + kHalfWidth)));
    for (int k = low; k <= floor_end; ++k) body(k);
    for (int k = std::max(floor_end + 1, int(std::floor(column.height)) - reach); k <= top; ++k)
      body(k);
  }

 private:
  const Raster<float>& elevation_;
  Grid grid_;
  double bottom_;
};

/// Stops OpenVDB's work on cancellation.
struct Interrupter {
  const Context& context;
  void start(const char* = nullptr) {}
  void end() {}
  bool wasInterrupted(int = -1) { return context.cancelled(); }
};

/// Values in metres, active in the narrow band.
openvdb::FloatGrid::Ptr fill_band(const Grid& grid, const GroundDistance& distance,
                                  const Context& context) {
  const double background = kHalfWidth * grid.cell_size;
  auto volume = openvdb::FloatGrid::create(float(background));
  auto access = volume->getAccessor();
  const int beyond = int(kHalfWidth);
  for (int j = -beyond; j < grid.ny + beyond; ++j) {
    context.check();
    for (int i = -beyond; i < grid.nx + beyond; ++i) {
      const auto column = distance.column(i, j);
      distance.for_band(column, [&](int k) {
        const double value = distance.at(column, k) * grid.cell_size;
        if (std::abs(value) < background) access.setValue({i, j, k}, float(value));
      });
    }
  }
  openvdb::tools::signedFloodFill(volume->tree());
  return volume;
}

/// Brings |grad phi| to 1, so that values are distances also where the ground bends.
void make_distances(openvdb::FloatGrid& volume, const Context& context) {
  Interrupter interrupter{context};
  openvdb::tools::LevelSetTracker<openvdb::FloatGrid, Interrupter> tracker(volume, &interrupter);
  tracker.setSpatialScheme(openvdb::math::FIRST_BIAS);
  tracker.setTemporalScheme(openvdb::math::TVD_RK1);
  tracker.setNormCount(4);
  tracker.normalize();
}

openvdb::math::Transform::Ptr transform_of(const Grid& grid) {
  auto transform = openvdb::math::Transform::createLinearTransform(grid.cell_size);
  const glm::dvec2 first = grid.center(0, 0);
  transform->postTranslate({first.x, first.y, 0.0});
  return transform;
}

}  // namespace

void write_ground_volume(const std::filesystem::path& file, const Raster<float>& elevation,
                         const GroundVolumeOptions& options, const Context& context) {
  const Grid& grid = elevation.grid();
  if (grid.nx < 2 || grid.ny < 2)
    throw InputError("elevation: " + std::to_string(grid.ny) + " x " + std::to_string(grid.nx) +
                     " cells make no volume; at least 2 x 2 are wanted");
  const auto values = elevation.values();
  const double lowest = *std::min_element(values.begin(), values.end());
  const double depth = options.below_lowest > 0.0 ? options.below_lowest : 4.0 * grid.cell_size;
  const auto volume = fill_band(grid, GroundDistance(elevation, lowest - depth), context);
  volume->setTransform(transform_of(grid));
  volume->setGridClass(openvdb::GRID_LEVEL_SET);
  make_distances(*volume, context);
  context.check();
  volume->setName(options.name);
  volume->insertMeta("unit", openvdb::StringMetadata("m"));
  try {
    openvdb::io::File(file.string()).write(openvdb::GridCPtrVec{volume});
  } catch (const openvdb::IoError& error) {
    throw InputError(file.string() + ": cannot be written (" + error.what() + ")");
  }
}

}  // namespace orogen
