// A recipe's feature curves, from JSON.
//
//   "features": [{"name": "spur",
//                 "points": [{"position": [x, y, z], "elevation": true, "plateau": 50,
//                             "left": side, "right": side}, ...]}, ...]
//     side: {"slope_size": 300, "slope_angle_deg": 25, "envelope": 500}
//
// Lengths in metres, in the terrain's own coordinates; left and right as seen along the curve, and
// "sides" for both. An angle above 0 falls away from the curve. A position without z asks for no
// height. What is missing is 0, `elevation` true.
#pragma once

#include <vector>

#include "inputs/feature_curve.h"
#include "pipeline/strict_json.h"

namespace orogen {

std::vector<FeatureCurve> read_features(const JsonValue& list);

}  // namespace orogen
