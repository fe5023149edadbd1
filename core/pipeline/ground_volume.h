// The ground as a closed solid: a narrow-band level set in an OpenVDB file, in metres.
//
// The solid lies below the terrain's elevation, down to a flat bottom, within the cells' centres:
//
//   phi(x, y, z) < 0 inside, > 0 outside, |phi| the distance to the surface, up to 3 voxels
//
// Voxels are as wide as a cell, so that one column of voxels stands on each cell's centre; index
// (0, 0, 0) maps to the centre of cell (0, 0) at height 0, and the file's transform to metres east,
// north and up in the map's projection. Grid class "level set", half floats off, compressed by
// Blosc where OpenVDB has it. Limits: overhangs cannot be; relief finer than a voxel is lost.
#pragma once

#include <filesystem>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

struct GroundVolumeOptions {
  double below_lowest = 0.0;  // m, from the lowest ground down to the bottom; 0: 4 voxels
  const char* name = "ground";
};

/// InputError if the file cannot be written or the grid has less than 2 x 2 cells.
void write_ground_volume(const std::filesystem::path& file, const Raster<float>& elevation,
                         const GroundVolumeOptions& options, const Context& context);

}  // namespace orogen
