// Plates, their boundaries and velocities, and the folds that they raise.
#include "folding/warped_folds.h"
#include "pipeline/make_stage.h"
#include "pipeline/stage_lists.h"
#include "tectonics/boundaries.h"
#include "tectonics/sub_plates.h"
#include "tectonics/velocity_map.h"

namespace orogen {

namespace {

void run_plates(PipelineState& state, Context& context, const PlateParameters& parameters) {
  const auto plates =
      state.products.set(infer_plates(*state.inputs.map, state.terrain.grid(), parameters,
                                      stage_seed(state.seed, "plates"), context));
  state.terrain.set("plate", part_of(plates, plates->plate));
  state.terrain.set("peak_distance", part_of(plates, plates->peak_distance));
}

void run_boundaries(PipelineState& state, Context& context, const BoundaryParameters& parameters) {
  const auto made =
      state.products.set(plate_boundaries(state.products.get<PlateMap>(), parameters, context));
  state.terrain.set("boundary_distance", part_of(made, made->boundary_distance));
  state.terrain.set("convergence", part_of(made, made->convergence));
  state.terrain.set("boundary_kind", part_of(made, made->boundary_kind));
}

void run_velocity(PipelineState& state, Context& context, const VelocityParameters& parameters) {
  const auto made =
      state.products.set(velocity_map(state.products.get<PlateMap>(), parameters, context));
  state.terrain.set("velocity_x", part_of(made, made->velocity_x));
  state.terrain.set("velocity_y", part_of(made, made->velocity_y));
}

void run_folds(PipelineState& state, Context& context, const FoldParameters& parameters) {
  const Products& made = state.products;
  state.terrain.set(
      "fold_relief",
      warped_folds(*state.inputs.map, made.get<PlateMap>(), made.get<BoundaryMap>(),
                   made.get<VelocityMap>(), parameters, stage_seed(state.seed, "folds"), context));
}

}  // namespace

void add_tectonics_stages(std::vector<Stage>& list) {
  list.push_back(
      make_stage(plates_stage(), {.cost = 0.1, .working_bytes_per_cell = 10.0}, run_plates));
  list.push_back(make_stage(boundaries_stage(), {.cost = 0.15, .working_bytes_per_cell = 16.0},
                            run_boundaries));
  list.push_back(
      make_stage(velocity_stage(), {.cost = 0.05, .working_bytes_per_cell = 12.0}, run_velocity));
  list.push_back(
      make_stage(folds_stage(), {.cost = 0.07, .working_bytes_per_cell = 12.0}, run_folds));
}

}  // namespace orogen
