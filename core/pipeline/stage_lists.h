// The registry's parts, one a file, and what they share.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "foundation/parameters.h"
#include "pipeline/stages.h"

namespace orogen {

/// Product of the stage `land`: its field as a mask.
struct LandMask {
  Raster<std::uint8_t> land;  // 1 on land, 0 at sea
};

/// Says where land is: as the product and as the field `land`.
void set_land(PipelineState& state, Raster<std::uint8_t> land, const Context& context);

/// How freely a drawn river's bed meanders within the map's own precision.
struct RiverBedParameters {
  double river_wander = 35.0;
  double wander_wavelength = 2500.0;
};

constexpr auto parameter_table(const RiverBedParameters*) {
  using P = RiverBedParameters;
  return std::tuple{
      real("river_wander", &P::river_wander, 0.0, 5e3, "m",
           "How far a drawn river's bed may meander sideways."),
      real("wander_wavelength", &P::wander_wavelength, 200.0, 100e3, "m",
           "Wavelength of the widest meanders of drawn rivers."),
  };
}

void add_land_stages(std::vector<Stage>& list);
void add_tectonics_stages(std::vector<Stage>& list);
void add_relief_stages(std::vector<Stage>& list);
void add_erosion_stages(std::vector<Stage>& list);
void add_law_stages(std::vector<Stage>& list);
void add_collision_stages(std::vector<Stage>& list);
void add_layered_folds_stage(std::vector<Stage>& list);
void add_mountain_stages(std::vector<Stage>& list);
void add_given_stages(std::vector<Stage>& list);
void add_island_stages(std::vector<Stage>& list);
void add_climate_stages(std::vector<Stage>& list);
void add_vegetation_stages(std::vector<Stage>& list);

}  // namespace orogen
