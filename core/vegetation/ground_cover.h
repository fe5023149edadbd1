// Tufts of grass, ferns and flowers (paper B, VII-B).
//
// A tuft is a number of blades that rise from a small disc, lean outwards and droop towards their
// tips: strips that taper to a point, or, with `pinnae`, fronds that bear pairs of leaflets. Stalks
// among them, if there are any, each end in a flower.
//
// As crossed quads (Fig. 10a) a tuft is two upright rectangles at right angles through its middle,
// for a picture with transparency; they have the tuft's height and width.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>

#include "foundation/parameters.h"
#include "vegetation/plant_mesh.h"

namespace orogen {

struct GroundCoverParameters {
  int blades = 30;
  double height = 0.3;
  double height_variation = 0.1;
  double spread = 0.05;
  double lean_deg = 20.0;
  double lean_variation_deg = 15.0;
  double droop_deg = 50.0;
  double blade_width = 0.005;
  int blade_segments = 4;
  int pinnae = 0;
  int stalks = 0;
  double stalk_height = 0.5;
  int petals = 0;
  double petal_length = 0.03;
  double petal_width = 0.5;
  double petal_lift_deg = 10.0;
};

constexpr auto parameter_table(const GroundCoverParameters*) {
  using P = GroundCoverParameters;
  return std::tuple{
      integer("blades", &P::blades, 0, 1000, "", "Blades, or fronds, of a tuft."),
      real("height", &P::height, 0.01, 10.0, "m", "Length of a blade."),
      real("height_variation", &P::height_variation, 0.0, 0.9, "1",
           "Its variation, and that of stalks, beside it."),
      real("spread", &P::spread, 0.0, 5.0, "m", "Radius of the disc that blades rise from."),
      real("lean_deg", &P::lean_deg, 0.0, 90.0, "deg", "Angle from upright at a blade's foot."),
      real("lean_variation_deg", &P::lean_variation_deg, 0.0, 90.0, "deg", "Its variation."),
      real("droop_deg", &P::droop_deg, -90.0, 180.0, "deg",
           "How much further a blade leans at its tip."),
      real("blade_width", &P::blade_width, 0.0005, 1.0, "m",
           "Width of a blade at its foot, of a frond at its widest."),
      integer("blade_segments", &P::blade_segments, 1, 40, "", "Pieces of a blade."),
      integer("pinnae", &P::pinnae, 0, 100, "", "Pairs of leaflets of a frond; 0: a blade."),
      integer("stalks", &P::stalks, 0, 200, "", "Stalks with flowers."),
      real("stalk_height", &P::stalk_height, 0.01, 10.0, "m", "Length of a stalk."),
      integer("petals", &P::petals, 0, 60, "", "Petals of a flower; 0: an ear of seeds."),
      real("petal_length", &P::petal_length, 0.001, 1.0, "m", "Length of a petal, or of the ear."),
      real("petal_width", &P::petal_width, 0.02, 2.0, "1", "Its width beside its length."),
      real("petal_lift_deg", &P::petal_lift_deg, -60.0, 90.0, "deg",
           "Angle by which petals rise: 0 flat, 90 closed."),
  };
}

/// Colours are sRGB, 0xRRGGBB. Leaves vary between two.
struct GroundCover {
  std::string_view name;        // snake_case, stable
  std::string_view scientific;  // as botanists call it
  std::uint32_t stem_color, leaf_color, other_leaf_color, petal_color, centre_color;
  GroundCoverParameters parameters;
};

std::span<const GroundCover> ground_cover();

/// InputError naming the known ones if there is no such species.
const GroundCover& find_ground_cover(std::string_view name);

/// InputError if a parameter is out of range.
PlantMesh make_ground_cover(const GroundCoverParameters& parameters, std::uint64_t seed,
                            bool crossed_quads);

}  // namespace orogen
