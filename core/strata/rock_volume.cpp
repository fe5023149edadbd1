#include "strata/rock_volume.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/Prune.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr int kBrick = 128;  // columns along a side, of the tree's lowest tiles but one
constexpr double kMostVoxels = 2e9;

using IndexGrid = openvdb::Int32Grid;
using Brick = openvdb::tools::Dense<std::int32_t, openvdb::tools::LayoutZYX>;

struct Voxels {
  int nx, ny, nz;
  double across, up, base;
  glm::dvec2 first;  // centre of the first voxel

  glm::dvec2 center(int i, int j) const { return first + glm::dvec2(i, j) * across; }
  double height(int k) const { return base + (k + 0.5) * up; }
};

Voxels voxels_of(const RockBody& body, const RockVolumeOptions& options) {
  const Grid& grid = body.elevation.grid();
  const auto ground = body.elevation.values();
  const double highest = *std::max_element(ground.begin(), ground.end());
  Voxels f{};
  f.across = options.voxel_size > 0.0 ? options.voxel_size : grid.cell_size;
  f.up = options.voxel_height;
  f.base = options.base;
  if (!(f.up > 0.0)) throw InputError("voxel_height: must be above 0 m");
  if (!(highest > f.base))
    throw InputError("base: " + detail::format_number(f.base) + " m lies above all ground");
  const double nx = std::max(1.0, std::round(grid.width() / f.across));
  const double ny = std::max(1.0, std::round(grid.height() / f.across));
  const double nz = std::ceil((highest - f.base) / f.up);
  if (!(nx * ny * nz <= kMostVoxels))
    throw InputError("voxel_height: " + detail::format_number(nx * ny * nz) +
                     " voxels are too many; at most 2e9");
  f.nx = int(nx);
  f.ny = int(ny);
  f.nz = int(nz);
  f.first = grid.origin + glm::dvec2(0.5 * f.across);
  return f;
}

/// 1 + number of each layer's lowest sub-layer.
std::vector<int> first_numbers(const RockTable& rocks) {
  std::vector<int> first{1};
  for (int k = 0; k <= rocks.layers(); ++k) first.push_back(first.back() + rocks.sub_layers(k));
  return first;
}

void name_rocks(IndexGrid& volume, const StratigraphicColumn& column, const RockTable& rocks) {
  int number = 1;
  for (int k = 0; k <= rocks.layers() + 1; ++k)
    for (int s = 0; s < rocks.sub_layers(k); ++s, ++number) {
      const std::string layer = k == 0               ? column.basement.name
                                : k > rocks.layers() ? std::string("loose sediment")
                                                     : column.layers[k - 1].name;
      const std::string_view lithology = lithology_info(rocks.lithology({k, s, 0.0f})).name;
      volume.insertMeta("rock_" + std::to_string(number),
                        openvdb::StringMetadata(layer + "/" + std::string(lithology)));
    }
}

void fill_brick(Brick& brick, const RockBody& body, const Voxels& f, const std::vector<int>& first,
                const Context& context) {
  const openvdb::CoordBBox box = brick.bbox();
  const int rows = box.max().y() - box.min().y() + 1;
  parallel_chunks(context, std::size_t(rows), 4, [&](std::size_t begin, std::size_t end) {
    std::vector<float> h(body.horizons.heights.size());
    for (int j = box.min().y() + int(begin); j < box.min().y() + int(end); ++j)
      for (int i = box.min().x(); i <= box.max().x(); ++i) {
        const glm::dvec2 place = f.center(i, j);
        body.horizons.at(place, h.data());
        const double ground = body.ground_at(place);
        const float rock_top = body.rock_top_at(place, float(ground));
        for (int k = 0; k < f.nz && f.height(k) <= ground; ++k) {
          const Rock rock = body.rock_at(h.data(), float(f.height(k)), rock_top);
          brick.setValue(openvdb::Coord(i, j, k), first[rock.layer] + rock.sub_layer);
        }
      }
  });
}

}  // namespace

void write_rock_volume(const std::filesystem::path& file, const RockBody& body,
                       const StratigraphicColumn& column, const RockVolumeOptions& options,
                       const Context& context) {
  const Voxels f = voxels_of(body, options);
  const std::vector<int> first = first_numbers(body.rocks);
  const auto volume = IndexGrid::create(0);
  for (int j = 0; j < f.ny; j += kBrick)
    for (int i = 0; i < f.nx; i += kBrick) {
      const openvdb::Coord low(i, j, 0);
      const openvdb::Coord high(std::min(i + kBrick, f.nx) - 1, std::min(j + kBrick, f.ny) - 1,
                                f.nz - 1);
      const openvdb::CoordBBox box(low, high);
      Brick brick(box, 0);
      fill_brick(brick, body, f, first, context);
      const auto piece = IndexGrid::create(0);
      openvdb::tools::copyFromDense(brick, *piece, 0, false);
      openvdb::tools::prune(piece->tree());
      volume->tree().merge(piece->tree(), openvdb::MERGE_ACTIVE_STATES);
    }
  auto transform = openvdb::math::Transform::createLinearTransform(1.0);
  transform->preScale(openvdb::Vec3d(f.across, f.across, f.up));
  transform->postTranslate(openvdb::Vec3d(f.first.x, f.first.y, f.height(0)));
  volume->setTransform(transform);
  volume->setName("rock");
  volume->insertMeta("unit", openvdb::StringMetadata("1"));
  name_rocks(*volume, column, body.rocks);
  try {
    openvdb::io::File(file.string()).write(openvdb::GridCPtrVec{volume});
  } catch (const openvdb::IoError& error) {
    throw InputError(file.string() + ": cannot be written (" + error.what() + ")");
  }
}

}  // namespace orogen
