// One mesh of the growing mountains: heights, horizons and rates of its vertices, and a step in
// time (see mountain_growth.h). Horizons lie vertex by vertex: those of one place are read
// together.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "erosion/mountain_growth.h"
#include "erosion/tin_hillslope.h"
#include "erosion/tin_stream_power.h"
#include "foundation/tin_sampling.h"
#include "hydrology/tin_flow.h"

namespace orogen {

/// What a mesh holds, on a grid.
struct GroundSample {
  std::vector<Raster<float>> fields;  // those asked for
  HorizonStack horizons;
};

class GrowingTin {
 public:
  /// `input` is not owned and must stay.
  GrowingTin(std::shared_ptr<const Tin> tin, const MountainGrowthInput& input,
             const MountainGrowthParameters& parameters);

  /// Flat ground with hollows, over the horizons before anything moved.
  void begin(std::uint32_t seed, const Context& context);
  /// The state of a coarser mesh.
  void take_over(const GrowingTin& coarse, const Context& context);
  /// The motion of a phase.
  void set_phase(const UpliftPhase& phase, const Context& context);
  MassBalance step(double years, const Context& context);
  /// Carries rock sideways over the time since it was last carried.
  void carry(const Context& context);

  const Tin& tin() const { return tin_; }
  const std::vector<double>& elevation() const { return z_; }
  /// Depth of loose sediment (m) at each vertex; empty if rivers lay down none.
  std::vector<double> sediment_thickness() const;
  std::vector<double> uplift_rates(const Context& context);
  std::span<const double> drainage_area() const { return rivers_.drainage_area(); }
  GroundSample sample(const Grid& grid, std::vector<VertexField> fields,
                      const Context& context) const;

 private:
  void find_sea();
  void sample_inputs(const Context& context);
  void look_at_rock(const Context& context);
  TinForcing forcing() const;
  MassBalance wear(double years, const Context& context);
  MassBalance wear_and_lay_down(double years, const Context& context);
  void cut_bedrock();
  void rebound(const std::vector<double>& before, double years, const Context& context);
  void raise_horizons(double years, const Context& context);
  std::vector<double> horizon(int k) const;

  std::shared_ptr<const Tin> mesh_;
  const Tin& tin_;
  const MountainGrowthInput& input_;
  MountainGrowthParameters parameters_;
  int count_;  // horizons
  std::vector<double> z_;
  std::vector<double> bedrock_;          // m, below loose sediment; empty if rivers lay down none
  std::vector<double> debris_;           // m³/yr, of landslides, in this step
  std::vector<float> horizons_, rates_;  // count_ values a vertex
  std::vector<float> uplift_, erodibility_, talus_, rain_, uplift_factor_, erodibility_factor_;
  std::vector<std::uint8_t> outlets_, base_;     // open sides and drawn sea; those and the sea
  std::vector<double> velocity_x_, velocity_y_;  // m/yr; empty: rock stays in its place
  double fastest_ = 0.0, carried_years_ = 0.0;
  TinFlow flow_;
  TinStreamPower rivers_;
  std::optional<TinCreep> creep_;
};

}  // namespace orogen
