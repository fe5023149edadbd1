// Paper C: plates that collide, and the layers that they fold.
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "foundation/raster_sums.h"
#include "pipeline/collision_products.h"
#include "pipeline/make_stage.h"
#include "pipeline/stage_lists.h"
#include "tectonics/felt_compression.h"
#include "tectonics/map_motion.h"
#include "tectonics/plate_margins.h"

namespace orogen {

namespace {

const StageInfo& collision_stage() {
  static const StageInfo info{"collision",
                              "Squeezes the crust between moving plates, which lifts it.",
                              "Cordonnier et al. 2018, section 4, equations 1 and 2",
                              {},
                              {"influence", "compression", "fault", "crust_uplift_rate"},
                              {"phases"}};
  return info;
}

const StageInfo& fold_layers_stage() {
  static const StageInfo info{"fold_layers",
                              "Folds each layer of the column at its own wavelength.",
                              "Cordonnier et al. 2018, section 5, equations 3 and 4",
                              {"compression"},
                              {"fold_uplift_rate"},
                              {"column", "fold_edits"}};
  return info;
}

const StageInfo& map_collision_stage() {
  static const StageInfo info{
      "map_collision",
      "Squeezes the crust between the plates inferred from a map.",
      "Cordonnier et al. 2018, section 4; plates of Michel, Emilien and Cani 2015, section 4",
      {"plate"},
      {"influence", "compression", "fault", "crust_uplift_rate"}};
  return info;
}

struct CollisionOptions {
  const PhaseParameters& phases;
  const CollisionParameters& collision;
  const MarginParameters& margins;
  const IsostasyParameters& isostasy;
  const FaultDipParameters& dip;
};

CollisionPhase collide(const TransportField& transport, const Grid& grid,
                       const CollisionOptions& options, std::uint32_t seed,
                       const Context& context) {
  const double smoothing = options.collision.crust_smoothing;
  CompressionField field = compression_field(transport, grid, context);
  const Raster<float> meet = plate_convergence(transport, grid, smoothing, context);
  CollisionPhase made;
  made.uplift = collision_uplift(transport, field, meet, options.collision, context);
  made.rise = floating_uplift(made.uplift.uplift_rate, options.isostasy, context);
  if (options.margins.margins)
    add_weighted(made.rise,
                 plate_margins(transport, field, options.margins, seed, context).uplift_rate, 1.0);
  if (options.dip.dipping_fault)
    made.motion = fault_motion(made.uplift.uplift_rate, made.uplift.fault, options.dip, context);
  made.compression = felt_compression(transport, std::move(field), meet, smoothing, context);
  made.mean_compression = mean_compression(made.compression, made.uplift.uplift_rate, context);
  return made;
}

/// What later phases carry along.
void carry(CollisionPhase& phase, std::span<const TransportField> later, const Grid& grid,
           const Context& context) {
  phase.shift = ground_shift(later, grid, context);
  if (phase.shift.empty()) return;
  phase.rise = carried(std::move(phase.rise), phase.shift, context);
  if (!phase.motion) return;
  phase.motion->velocity_x = carried(std::move(phase.motion->velocity_x), phase.shift, context);
  phase.motion->velocity_y = carried(std::move(phase.motion->velocity_y), phase.shift, context);
}

/// |C| at its last place.
Raster<float> strength(const CollisionPhase& phase, const Context& context) {
  const CompressionField& field = phase.compression;
  Raster<float> length(field.compression_x.grid());
  for (std::size_t i = 0; i < length.size(); ++i)
    length[i] = std::hypot(field.compression_x[i], field.compression_y[i]);
  return carried(std::move(length), phase.shift, context);
}

/// Sets the fields and the product of a collision.
void collide_phases(PipelineState& state, std::span<const MotionPhase> phases,
                    const TransportParameters& transport, const CollisionOptions& options,
                    Context& context) {
  const Grid& grid = state.terrain.grid();
  CollisionPhases made{{}, options.collision.target_uplift_rate, options.isostasy};
  Raster<float> rise(grid), compression(grid);
  std::vector<TransportField> motions;
  for (std::size_t p = 0; p < phases.size(); ++p)
    motions.emplace_back(rigid_plates(phases[p].plates, "phases[" + std::to_string(p) + "].plates"),
                         transport);
  for (std::size_t p = 0; p < phases.size(); ++p) {
    MarginParameters margins = options.margins;
    margins.growth_time = phases[p].years;
    CollisionParameters own = options.collision;
    if (phases[p].stable_plate >= 0) own.stable_plate = phases[p].stable_plate;
    made.phases.push_back(collide(motions[p], grid,
                                  {options.phases, own, margins, options.isostasy, options.dip},
                                  stage_seed(state.seed, "collision") + std::uint32_t(p), context));
    made.phases.back().years = phases[p].years;
    if (options.phases.carry_older_phases)
      carry(made.phases.back(), std::span<const TransportField>(motions).subspan(p + 1), grid,
            context);
    context.report(double(p + 1) / double(phases.size()));
  }
  for (const CollisionPhase& one : made.phases) {
    add_weighted(rise, one.rise, one.years / made.years());
    const Raster<float> felt = strength(one, context);
    for (std::size_t i = 0; i < grid.size(); ++i)
      compression[i] = std::max(compression[i], felt[i]);
  }
  const auto kept = state.products.set(std::move(made));
  const CollisionPhase& last = kept->phases.back();
  state.terrain.set("influence", part_of(kept, last.compression.plate));
  state.terrain.set("fault", part_of(kept, last.uplift.fault));
  state.terrain.set("compression", std::move(compression));
  state.terrain.set("crust_uplift_rate", std::move(rise));
}

void run_collision(PipelineState& state, Context& context, const TransportParameters& transport,
                   const CollisionParameters& parameters, const MarginParameters& margins,
                   const IsostasyParameters& isostasy, const FaultDipParameters& dip,
                   const PhaseParameters& phases) {
  collide_phases(state, state.inputs.phases, transport,
                 {phases, parameters, margins, isostasy, dip}, context);
}

void run_map_collision(PipelineState& state, Context& context, const MapMotionParameters& motion,
                       const TransportParameters& transport,
                       const CollisionParameters& parameters) {
  const MotionPhase phase = motion_of(state.products.get<PlateMap>(), motion);
  collide_phases(state, {&phase, 1}, transport, {{}, parameters, {.margins = false}, {}, {}},
                 context);
}

/// Layers as they fold: where a layer's thickness varies, so does its wavelength (equation 3).
struct LayersToFold {
  std::vector<FoldLayer> layers;  // those that fold
  std::vector<int> numbers;       // of them in the column
  std::vector<Raster<float>> wavelengths;

  LayersToFold(const StratigraphicColumn& column, const Grid& grid, const Context& context) {
    const std::vector<double> wavelength = fold_wavelengths(column);
    wavelengths.reserve(column.layers.size());
    for (std::size_t k = 0; k < column.layers.size(); ++k) {
      const Layer& layer = column.layers[k];
      if (layer.fold_share == 0.0) continue;
      FoldLayer& fold = layers.emplace_back();
      fold.fold_wavelength = wavelength[k];
      fold.speed_share = layer.fold_share;
      numbers.push_back(int(k));
      const Layer& below = k ? column.layers[k - 1] : column.basement;
      if (!layer.thickness_map && !below.thickness_map) continue;
      fold.wavelength_map =
          &wavelengths.emplace_back(local_wavelength(wavelength[k], layer, below, grid, context));
    }
  }

  /// Edits are drawn at last places; folds are made where their phase left them.
  void take_edits(const std::vector<LayerFoldEdit>& edits, int phase, const GroundShift& shift) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
      layers[i].edits.clear();
      for (const LayerFoldEdit& e : edits) {
        if (e.phase != phase || e.layer != numbers[i]) continue;
        FoldEdit& edit = layers[i].edits.emplace_back(e.edit);
        edit.a = place_before(edit.a, shift);
        edit.b = place_before(edit.b, shift);
      }
    }
  }

 private:
  static Raster<float> local_wavelength(double wavelength, const Layer& layer, const Layer& below,
                                        const Grid& grid, const Context& context) {
    Raster<float> map = thickness_raster(layer, grid, context);
    const Raster<float> under = thickness_raster(below, grid, context);
    for (std::size_t i = 0; i < map.size(); ++i) {
      const double ratio = double(map[i]) * under[i] / (layer.thickness * below.thickness);
      map[i] = float(wavelength * std::clamp(std::sqrt(ratio), 0.2, 5.0));
    }
    return map;
  }
};

void run_fold_layers(PipelineState& state, Context& context) {
  const Grid& grid = state.terrain.grid();
  const auto& collision = state.products.get<CollisionPhases>();
  const auto& phases = collision.phases;
  LayersToFold to_fold(*state.inputs.column, grid, context);
  FoldedPhases made;
  Raster<float> sum(grid);
  for (std::size_t p = 0; p < phases.size(); ++p) {
    FoldLayersParameters parameters;
    parameters.uplift_rate = collision.target_uplift_rate / collision.phases[p].mean_compression;
    parameters.folding_time = phases[p].years;
    to_fold.take_edits(state.inputs.fold_edits, int(p), phases[p].shift);
    auto folded = fold_layers(collision.phases[p].compression, to_fold.layers, parameters,
                              stage_seed(state.seed, "fold_layers") + std::uint32_t(p), context);
    auto& layers = made.phases.emplace_back(state.inputs.column->layers.size());
    for (std::size_t i = 0; i < folded.size(); ++i) {
      folded[i].speed = carried(std::move(folded[i].speed), phases[p].shift, context);
      add_weighted(sum, folded[i].speed, phases[p].years / collision.years());
      layers[to_fold.numbers[i]] = std::move(folded[i]);
    }
    context.report(double(p + 1) / phases.size());
  }
  state.products.set(std::move(made));
  state.terrain.set("fold_uplift_rate", std::move(sum));
}

}  // namespace

std::vector<std::string> fold_edit_warnings(const RecipeInputs& inputs, const FoldedPhases& folds) {
  std::vector<std::string> warnings;
  std::map<std::pair<int, int>, int> count;  // edits of each phase and layer so far
  for (std::size_t i = 0; i < inputs.fold_edits.size(); ++i) {
    const LayerFoldEdit& edit = inputs.fold_edits[i];
    const int number = count[{edit.phase, edit.layer}]++;
    const Layer& layer = inputs.column->layers.at(edit.layer);
    const auto& idle = folds.phases.at(edit.phase).at(edit.layer).edits_without_effect;
    const char* reason = nullptr;
    if (layer.fold_share == 0.0)
      reason = "does not fold";
    else if (std::find(idle.begin(), idle.end(), number) != idle.end())
      reason = edit.edit.kind == FoldEditKind::Add ? "has folds too wide for so short a line"
                                                   : "has no crest along the line";
    if (reason)
      warnings.push_back("fold_edits[" + std::to_string(i) + "]: changes nothing; layer " +
                         std::to_string(edit.layer + 1) +
                         (layer.name.empty() ? "" : " (" + layer.name + ")") + " " + reason);
  }
  return warnings;
}

void add_collision_stages(std::vector<Stage>& list) {
  const auto by_default = DefaultFor::Collisions;
  list.push_back(make_stage(collision_stage(),
                            {.by_default = by_default,
                             .cost = 0.1,
                             .working_bytes_per_cell = 28.0,
                             .product_bytes_per_cell = 20.0},
                            run_collision));
  list.push_back(make_stage(map_collision_stage(),
                            {.by_default = DefaultFor::None,
                             .cost = 0.1,
                             .working_bytes_per_cell = 28.0,
                             .product_bytes_per_cell = 20.0},
                            run_map_collision));
  list.push_back(make_stage(fold_layers_stage(),
                            {.by_default = by_default,
                             .cost = 0.3,
                             .working_bytes_per_cell = 24.0,
                             .product_bytes_per_cell = 16.0},
                            run_fold_layers));
}

}  // namespace orogen
