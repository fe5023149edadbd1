// The rocks of a terrain as a volume: an OpenVDB index grid, one voxel a cell across and
// `voxel_height` tall.
//
// Grid `rock` (Int32): 1 + number of the sub-layer, counted from the basement's lowest upwards; 0,
// the background, in the air and below the base. A voxel has the rock at its centre, as
// RockTable::rock_at gives it. Metadata: `unit`, and `rock_N` = "layer/lithology" for each number.
// The transform puts index (0, 0, 0) at the centre of cell (0, 0), half a voxel above the base.
// Written in bricks of 128 × 128 columns, each pruned before the next, so that memory stays near
// what the file's own tree needs.
#pragma once

#include <filesystem>

#include "strata/rock_body.h"

namespace orogen {

struct RockVolumeOptions {
  double base = 0.0;            // m, height of the lower side
  double voxel_size = 0.0;      // m, across; 0: the cell size
  double voxel_height = 100.0;  // m
};

/// InputError if the file cannot be written, or the volume would have no or over 2·10⁹ voxels.
void write_rock_volume(const std::filesystem::path& file, const RockBody& body,
                       const StratigraphicColumn& column, const RockVolumeOptions& options,
                       const Context& context);

}  // namespace orogen
