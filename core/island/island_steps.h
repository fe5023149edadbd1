// The steps of make_island, in order; see island.h.
#pragma once

#include <span>

#include "island/island.h"

namespace orogen {

/// Marks centers and coast by what corners say: water, ocean.
void mark_water(Island& island, double water_share, bool sea_at_sides);

/// Heights of corners, from -1 to 1, by steps from the coast.
void raise_from_coast(Island& island);

/// Gives all corners of a lake the height of its lowest.
void level_lakes(Island& island);

/// Which way water runs from each corner of land; corners from the sea upwards.
std::vector<std::int32_t> drain(Island& island);

/// Rivers and what they carry. `upwards`: from `drain`.
void start_rivers(Island& island, const IslandParameters& parameters, std::uint32_t seed,
                  std::span<const std::int32_t> upwards);

/// Moisture of corners.
void spread_moisture(Island& island, const IslandParameters& parameters);

/// Whether water that is no ocean lies at an edge.
inline bool at_lake(const Island& island, std::int32_t edge) {
  for (const std::int32_t center : island.map.edge_centers[edge])
    if (center >= 0 && island.centers.water[center] && !island.centers.ocean[center]) return true;
  return false;
}

}  // namespace orogen
