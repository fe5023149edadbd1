// The parts of checking a map; finish_map runs them in order.
#pragma once

#include <cstdint>
#include <vector>

#include "inputs/land_region.h"
#include "inputs/map_draft.h"

namespace orogen {

inline constexpr double kHighestPeak = 12000.0;  // m

/// Puts points onto the lattice and drops repeated ones (with a warning); a closed line's last
/// point too if it repeats the first. `drawn` gets the numbers of the points that stay. InputError
/// for what is not finite or too far.
void clean_points(std::vector<glm::dvec2>& points, bool closed, const std::string& words,
                  MapReport& report, std::vector<std::uint32_t>* drawn = nullptr);

/// Closes, cleans and orients the rings of coasts and lakes, and refuses those that cross, touch or
/// lie where they cannot.
void check_rings(MapDraft& draft, MapReport& report);

/// Carries what is clipped on past the frame by an eighth of its longer side.
void carry_clipped_coasts(VectorMap& map, MapReport& report);

/// Peaks onto the lattice, heights in range.
void clean_peaks(VectorMap& map, MapReport& report);

/// Peaks on land and in the frame, none twice.
void check_peaks(VectorMap& map, const LandRegion& land, MapReport& report);

}  // namespace orogen
