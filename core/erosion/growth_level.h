// One resolution of the growth of a relief (relief_growth.h): its ground, beds and solver.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "erosion/relief_growth.h"
#include "erosion/stream_power.h"
#include "foundation/context.h"
#include "foundation/raster.h"
#include "foundation/resample.h"
#include "hydrology/base_level.h"
#include "hydrology/flow_graph.h"
#include "hydrology/river_beds.h"
#include "inputs/vector_map.h"
#include "sculpting/summits.h"

namespace orogen {

class GrowthLevel {
 public:
  /// `aim`: heights that the land has at large (m); `folds`: crests above 0, troughs below, of
  /// variance 1; both on the level's grid. `land`: 1 on land.
  GrowthLevel(const VectorMap& map, Raster<std::uint8_t> land, RiverBeds beds,
              const Raster<float>& aim, const Raster<float>& folds,
              const ReliefGrowthParameters& parameters, std::uint32_t seed, Context& context);

  /// Makes rock weaker or stronger by place, before anything else; nullptr changes nothing.
  void multiply_erodibility(const Raster<float>* factor) {
    multiply(erodibility_, factor, context_);
  }

  /// First heights and uplift of the coarsest level.
  void start(std::uint32_t seed);
  /// Heights, uplift and hillslope area of a coarser level.
  void start_from(const GrowthLevel& coarser);

  /// Lets the land within `width` (m) of a bed drain towards it.
  void add_river_belts(double width);

  /// One steady-state step; `fit` then corrects the uplift.
  void step(bool fit);

  const Raster<float>& elevation() const { return elevation_; }
  const Raster<std::uint8_t>& base_cells() const { return base_.cells; }
  Raster<float> uplift_rate() const;
  const Raster<float>& erodibility() const { return erodibility_; }
  const std::vector<double>& drainage_area() const { return area_; }

 private:
  void hold_base_level();
  void vary_rock(const Raster<float>& folds, std::uint32_t seed);
  void set_aim(const Raster<float>& aim);
  void set_hillslope_area();
  void set_most_uplift();
  void set_channel_area();
  void lower_perched_beds();
  Raster<float> carry_beds();
  Raster<float> smooth(const Raster<float>& field, double sigma);
  void fit_to_aim();
  void fit_to_peaks();
  void fit_to_bounds();

  const ReliefGrowthParameters& parameters_;
  Context& context_;
  Grid grid_;
  Raster<std::uint8_t> land_;
  RiverBeds beds_;
  BaseLevel base_;
  std::optional<FlowGraph> flow_;
  StreamPower power_;
  Raster<float> elevation_, uplift_, uplift_noise_, erodibility_, hillslope_area_, aim_, forcing_,
      talus_slope_, most_uplift_;
  std::vector<double> area_, channel_area_;
  std::map<double, Raster<float>> land_shares_;  // of land around, by the width that is smoothed
  std::vector<float> bed_share_;                 // of Hack's area that each bed cell counts
  double slack_ = 1.0;                           // ε, m
  std::vector<Summit> summits_;
  Raster<float> pyramids_, cap_;  // what the summits ask of the ground around, m
  Raster<std::int32_t> nearest_summit_;
};

}  // namespace orogen
