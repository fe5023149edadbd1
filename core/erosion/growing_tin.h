// One mesh of the growing mountains: heights, horizons and rates of its vertices, and a step in
// time (see mountain_growth.h). Horizons lie vertex by vertex: those of one place are read
// together.
#pragma once

#include <cstdint>
#include <vector>

#include "erosion/mountain_growth.h"
#include "erosion/tin_stream_power.h"
#include "hydrology/tin_flow.h"

namespace orogen {

class GrowingTin {
 public:
  GrowingTin(Tin tin, const MountainGrowthInput& input, const MountainGrowthParameters& parameters);

  /// Flat ground with hollows, over the horizons before anything moved.
  void begin(std::uint32_t seed, const Context& context);
  /// The state of a coarser mesh.
  void take_over(const GrowingTin& coarse, const Context& context);
  /// The rates of rise of a phase.
  void set_phase(const UpliftPhase& phase, const Context& context);
  MassBalance step(double years, const Context& context);

  const Tin& tin() const { return tin_; }
  const std::vector<double>& elevation() const { return z_; }
  HorizonStack horizons_on(const Grid& grid, const Context& context) const;
  /// Fields of the last step, on a grid.
  Raster<float> on_grid(const std::vector<double>& values, const Grid& grid,
                        const Context& context) const;
  std::vector<double> uplift_rates(const Context& context);
  std::vector<double> drainage_areas() const;

 private:
  void look_at_rock(const Context& context);
  std::vector<double> horizon(int k) const;

  Tin tin_;
  const MountainGrowthInput& input_;
  MountainGrowthParameters parameters_;
  int count_;  // horizons
  std::vector<double> z_;
  std::vector<float> horizons_, rates_;  // count_ values a vertex
  std::vector<float> uplift_, erodibility_, talus_, rain_;
  TinFlow flow_;
  TinStreamPower rivers_;
};

}  // namespace orogen
