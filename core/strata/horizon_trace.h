// Traces: the lines along which a horizon comes to light, h_k(x, y) = z(x, y).
//
// A fold seen on a cliff is such a line; beside the horizon itself it shows what the ground tells
// of the rock below. Lines follow tectonics/iso_lines.h between cell centres and lie on the ground;
// on their left the horizon lies above it, gone. A closed line repeats its first point. Where the
// highest horizon is the ground itself there is no trace.
// Limits: those of iso lines; what turns within a cell is lost.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "foundation/context.h"
#include "strata/rock_body.h"

namespace orogen {

/// A line on the ground, in metres, less the grid's origin (z is the height itself).
using Trace = std::vector<glm::vec3>;

/// InputError for a horizon that is none, or a grid of less than 2 × 2 cells.
std::vector<Trace> horizon_traces(const RockBody& body, int horizon, const Context& context);

}  // namespace orogen
