// Hillslopes on a TIN: landslides and soil creep (hillslope.h has them on a grid).
//
//   landslide  dz/dt = -l (s - tan θ) where the slope s to the lowest neighbour exceeds tan θ
//              (paper C, section 6.1)
//   creep      A_i dz_i/dt = Σ_j w_ij (z_j - z_i),  w_ij = (D_L cot α + D_R cot β) / 2
//              α, β: the angles that face the edge ij in the triangles left and right of it
//              D_T = D / max(1 - (|grad z| / S_c)², f)   (Roering et al. 1999); D if S_c is 0
//
// z (m); θ talus angle; l landslide rate (m/yr); A cell area (m²); D diffusivity (m²/yr); S_c
// critical slope; t (yr). Weights are those of linear finite elements with lumped mass: planes are
// kept but for the limit below, volumes are those under the triangles. The domain's sides are
// closed; base level keeps its height and takes what comes.
//
// `landslide` keeps mass, in rounds. In a round every vertex that is too steep gives
//   V_i = e_i / (1/A_i + n_j/A_j)     e_i: height (m) above the talus slope towards j
// to its steepest neighbour j, at most; n_j vertices give to j. Then Σ A z² falls in every round,
// so that nothing swings. An infinite dt relaxes until no edge is steeper by more than some mm, or
// rounds are spent.
// `shed_landslides` is the paper's own step: implicit, in the order of the flow, O(n). It lowers
// only: what falls is taken away by the rivers, or given to them.
// Creep is solved backward in time by conjugate gradients to 1e-12 of the first flux; what heights
// and fluxes then differ by is spread evenly, so that mass is kept. With S_c in sub-steps of
// D dt / mean A below 1/2, diffusivity of the sub-step's start.
// Limits: a weight that would be negative is 0, and creep a little slower there: at sides of the
// domain that face an obtuse angle (the makers of tin.h make none), and where S_c makes one of two
// triangles far more diffusive.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "erosion/hillslope.h"
#include "foundation/context.h"
#include "foundation/mass_balance.h"
#include "foundation/vertex_values.h"
#include "hydrology/tin_flow.h"

namespace orogen {

/// `base_level`: not 0 where the height is held. `talus_slope`: tan(talus angle).
MassBalance landslide(const Tin& tin, std::span<double> elevation,
                      std::span<const std::uint8_t> base_level, const VertexValues& talus_slope,
                      const LandslideParameters& parameters, double dt_years,
                      const Context& context);

/// `flow` was routed over a surface with this drainage, such as the one before the step. All that
/// falls is eroded and exported; `debris`, if there is one, gets what falls on each vertex (m³)
/// added. `landslide_rate` in m/yr; dt may be infinite.
MassBalance shed_landslides(const TinFlow& flow, std::span<double> elevation,
                            const VertexValues& talus_slope, double landslide_rate, double dt_years,
                            const Context& context, std::span<double> debris = {});

/// What a change of heights is to the books (m³).
MassBalance balance_of(const Tin& tin, std::span<const double> start, std::span<const double> end,
                       double exported_m3);

/// The weights are kept between steps. The TIN is not owned and must stay.
class TinCreep {
 public:
  TinCreep(const Tin& tin, std::span<const std::uint8_t> base_level,
           const CreepParameters& parameters);

  /// Other vertices whose height is held, from the next step on. InputError for a wrong number.
  void set_base_level(std::span<const std::uint8_t> base_level);

  MassBalance step(std::span<double> elevation, double dt_years, const Context& context);

 private:
  void find_diffusivity(const std::vector<double>& z, const Context& context);
  void find_weights(const Context& context);
  double solve(std::vector<double>& z, double dt, const Context& context);  // m³ to base level
  double gain(const std::vector<double>& z, std::size_t vertex) const;      // m³/yr

  const Tin* tin_;
  std::vector<std::uint8_t> base_;
  CreepParameters parameters_;
  std::vector<std::array<std::int32_t, 2>> triangles_;  // left and right of each edge, or -1
  std::vector<std::array<float, 2>> cotangents_;        // of the angles that face the edge there
  std::vector<double> diffusivity_;                     // m²/yr, of each triangle
  std::vector<double> weight_, diagonal_;               // m²/yr, of each edge; their sum
};

}  // namespace orogen
