// A vector map: coasts, rivers, peaks and lakes, checked and in order.
//
// Positions are metres, east and north, in the map's projection; `frame.origin` is the lower-left
// corner of the mapped rectangle. A VectorMap made by `read_geojson` (or passed through
// `check_map`) keeps these promises: finite coordinates inside the frame (grown by its own size);
// rings closed in meaning (last point differs from the first), simple and apart from each other,
// outer rings anticlockwise, holes clockwise; rivers run from source to mouth and form trees (a
// river that joins another ends on a vertex of it); peaks on land, with heights in (0, 12000] m;
// positions are multiples of 1/1024 m. A clipped coast is carried on past the frame's sides, so
// that land reaches them on any grid; `shorelines` gives what is truly coast.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

namespace orogen {

using Polyline = std::vector<glm::dvec2>;  // m
using Ring = std::vector<glm::dvec2>;      // m, first point not repeated

struct Frame {
  glm::dvec2 origin{0.0, 0.0};  // m, lower-left corner in the projection
  glm::dvec2 size{0.0, 0.0};    // m
  std::string proj4;            // empty: a plane without a place on Earth
};

struct Coast {
  Ring outer;
  std::vector<Ring> holes;  // inland seas
  bool clipped = false;     // cut off at the frame: its stretch on the frame's side is no coast
  std::string name;
  int feature = -1;  // number of the feature in the file; -1: none
};

struct Lake {
  Ring outer;
  std::vector<Ring> islands;
  std::optional<double> level_m;
  std::string name;
  int feature = -1;
};

enum class RiverEnd { Sea, River, Lake, Frame };

struct River {
  Polyline points;  // from source to mouth
  RiverEnd end = RiverEnd::Sea;
  int joins = -1;                      // index of the river or lake it flows into; -1: sea or frame
  std::optional<double> end_height_m;  // of the bed where it leaves the frame
  int rank = 0;                        // 1: largest; 0: not said
  std::string name;
  int feature = -1;
};

struct Peak {
  glm::dvec2 position{0.0, 0.0};
  std::optional<double> height_m;
  std::string name;
  int feature = -1;
  std::optional<bool> volcano;  // not said: the stages decide
};

struct VectorMap {
  std::string name;
  Frame frame;
  std::vector<Coast> coasts;  // without any, everything is land and the frame's sides are open
  std::vector<River> rivers;
  std::vector<Peak> peaks;
  std::vector<Lake> lakes;
  std::vector<std::string> warnings;  // what was mended, and where
};

/// The same map; warnings and feature numbers are not compared.
bool operator==(const VectorMap& a, const VectorMap& b);

}  // namespace orogen
