// A recipe's moving plates, its stratigraphic column and its rain, from JSON.
//
//   "phases": [{"years": 5e6,
//               "plates": [{"name": "south", "points": [[x, y], ...], "arrows": [[dx, dy], ...],
//                           "crust": "continental" or "oceanic", "stable": true}, ...]}, ...]
//   "column": {"preset": "jura"} or
//             {"basement": layer, "layers": [layer, ...]}        from the bottom up
//     layer: {"name": "Malm", "thickness": 700, "viscosity": 3e20, "fold_wavelength": 3000,
//             "fold_share": 0.1, "sub_layers": [{"lithology": "marl", "share": 1,
//             "resistance": 0.1}, ...], "thickness_map": [[...], ...]}
//
//   "rain": [[...], ...]      how much it rains where, in any unit: only ratios count
//
//   "fold_edits": [{"edit": "add", "layer": 2, "phase": 1, "from": [x, y], "to": [x, y],
//                   "value": 500}, ...]      edit: add, remove, scale or set
//                   (folding/fold_edits.h);
//                                            layer and phase count from 1
//
// Lengths in metres, in the terrain's own coordinates. Reading is strict.
#pragma once

#include <vector>

#include "inputs/plate_gesture.h"
#include "pipeline/stages.h"
#include "pipeline/strict_json.h"
#include "strata/column.h"

namespace orogen {

std::vector<MotionPhase> read_phases(const JsonValue& list);
std::vector<PlateGesture> read_plates(const JsonValue& list);
StratigraphicColumn read_column(const JsonValue& column);

std::vector<LayerFoldEdit> read_fold_edits(const JsonValue& list);
/// InputError for an edit of a layer or a phase that the recipe does not have. Without phases there
/// is one, that of a map's plates.
void check_fold_edit_places(const RecipeInputs& inputs);
/// The edits of one layer, without `layer` and `phase`.
std::vector<FoldEdit> read_layer_edits(const JsonValue& list);

/// InputError if it rains nowhere.
CornerMap read_rain(const JsonValue& rows);

/// What `read_column` reads, presets written out.
nlohmann::json write_column(const StratigraphicColumn& column);

}  // namespace orogen
