// A geological cross-section: the ground cut open along a line.
//
// Along a line on the map, points stand at even spacing (the line's own corners too). Between the
// surface and a base height lie bands, one for each sub-layer that is met: band b fills
// bottom_b(s) < z <= top_b(s), with nothing where the two are equal. Bands fill the section without
// gaps, and the rock of every point is the one that RockTable::rock_at gives there: picture, SVG,
// mesh, block diagram and volume are made from the same horizons.
// Horizons and ground are interpolated bilinearly between cells. Limits as for horizons.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "inputs/vector_map.h"
#include "strata/rock_body.h"

namespace orogen {

struct SectionBand {
  int layer = 0, sub_layer = 0;
  std::uint32_t color = 0;         // sRGB, 0xRRGGBB
  std::vector<float> bottom, top;  // m, at each point
};

struct Section {
  std::vector<glm::dvec2> points;  // m, on the map
  std::vector<double> distance;    // m, along the line
  std::vector<float> surface;      // m, height of the ground
  double base = 0.0;               // m, height of the lower edge
  std::vector<SectionBand> bands;  // from the bottom up
};

/// InputError for fewer than 2 points, a point outside the grid, a line without length, a spacing
/// not above 0 or more than 10⁶ points.
Section cut_section(const RockBody& body, const Polyline& line, double spacing, double base,
                    const Context& context);

/// A picture of `width` × `height` pixels, row 0 at the top, 0xAARRGGBB, transparent above ground;
/// from the section's base up to `top` metres.
struct SectionPicture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
};
SectionPicture draw_section(const RockBody& body, const Section& section, int width, int height,
                            double top);

}  // namespace orogen
