// A cross-section as an SVG document: a filled outline a band, the ground's profile, a scale in
// kilometres and metres, the vertical exaggeration, and a key of the layers. One unit of the
// picture is 1/1000 of its width.
#pragma once

#include <string>

#include "strata/section.h"

namespace orogen {

/// Heights are drawn `exaggeration` times as tall as lengths. InputError unless it is above 0.
std::string section_svg(const Section& section, const StratigraphicColumn& column,
                        double exaggeration);

}  // namespace orogen
