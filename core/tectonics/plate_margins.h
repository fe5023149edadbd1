// Relief of plate margins beside collision: rifts where plates part, and subduction where oceanic
// crust dives under another plate. Beyond paper C, which leaves extension out.
//
// Along the border between two influence regions, with the unit normal n from plate i to plate j:
//
//   opening = (u_j − u_i) · n        u: how each plate moves the ground at the border (m a step)
//
// Plates part where opening > 0 and come together where it is < 0. Activity is the smoothed loss
// or gain of crust there (q − 1, collision_uplift.h) over the greatest on any border of that kind,
// carried to both sides and blurred by `margin_smoothing`. With the distance d to the border, over
// `growth_time`:
//
//   rift     rift_depth (v − 1) / (1 + v²),  v = 2.414 (d / rift_width)⁴: a flat floor between
//            shoulders a fifth as high
//   trench   −trench_depth e^(−d/a) (cos d/a + sin d/a), a = trench_width, on the plate that dives:
//            a bent elastic plate with a low swell before it; −trench_depth e^(−4 d²/a²) on the
//            other
//   arc      arc_height e^(−(d − arc_distance)² / 2 arc_width²) on the upper plate, with cones
//            volcano_height (1 − r / volcano_radius)^1.5 about `volcano_spacing` apart
//
// The oceanic one of two plates dives; of two oceanic ones the faster (then the later). Where none
// is oceanic nothing is added: that is collision.
//
// Limits: rates, so that erosion and growth together set the relief; oceanic plates that part make
// a rift too (no mid-ocean ridge); the nearest stretch of border alone counts, so that trenches and
// arcs may end in a step where three plates meet.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <tuple>
#include <vector>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "tectonics/compression.h"
#include "tectonics/transport_field.h"

namespace orogen {

struct MarginParameters {
  bool margins = true;
  double growth_time = 2e6;          // yr; that of the phase in recipes
  double margin_smoothing = 5000.0;  // m
  double rift_depth = 1500.0;        // m
  double rift_width = 12e3;          // m
  double trench_depth = 4000.0;      // m
  double trench_width = 25e3;        // m
  double arc_distance = 150e3;       // m
  double arc_height = 800.0;         // m
  double arc_width = 15e3;           // m
  double volcano_height = 2000.0;    // m
  double volcano_radius = 10e3;      // m
  double volcano_spacing = 35e3;     // m
};

constexpr auto parameter_table(const MarginParameters*) {
  using P = MarginParameters;
  return std::tuple{
      boolean("margins", &P::margins,
              "Whether plates that part leave rifts, and oceanic ones trenches and arcs."),
      real("margin_smoothing", &P::margin_smoothing, 0.0, 100e3, "m",
           "Standard deviation of the blur of the margins' activity."),
      real("rift_depth", &P::rift_depth, 0.0, 5e3, "m",
           "Depth of a rift where plates part fastest."),
      real("rift_width", &P::rift_width, 200.0, 200e3, "m",
           "Distance from a rift's middle to its shoulders."),
      real("trench_depth", &P::trench_depth, 0.0, 8e3, "m",
           "Depth of a trench where oceanic crust dives fastest."),
      real("trench_width", &P::trench_width, 200.0, 200e3, "m",
           "Length over which the diving plate bends down into the trench."),
      real("arc_distance", &P::arc_distance, 1e3, 500e3, "m",
           "Distance from the trench to its volcanic arc."),
      real("arc_height", &P::arc_height, 0.0, 5e3, "m", "Height of the arc between volcanoes."),
      real("arc_width", &P::arc_width, 100.0, 100e3, "m",
           "Standard deviation of the arc's cross-section."),
      real("volcano_height", &P::volcano_height, 0.0, 7e3, "m",
           "Height of the arc's volcanoes above it."),
      real("volcano_radius", &P::volcano_radius, 100.0, 50e3, "m",
           "Radius of the arc's volcanoes at their foot."),
      real("volcano_spacing", &P::volcano_spacing, 1e3, 500e3, "m",
           "Distance from one volcano of the arc to the next."),
  };
}

struct PlateMargins {
  Raster<float> uplift_rate;          // m/yr, to be added to u0; negative where the ground sinks
  std::vector<glm::dvec2> volcanoes;  // m
};

PlateMargins plate_margins(const TransportField& transport, const CompressionField& field,
                           const MarginParameters& parameters, std::uint32_t seed,
                           const Context& context);

}  // namespace orogen
