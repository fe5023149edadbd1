// A map as it was read, before it is checked: what the file said beyond a VectorMap.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "inputs/check_map.h"
#include "inputs/map_report.h"
#include "inputs/vector_map.h"

namespace orogen {

/// What a map says about a river's course.
struct RiverHint {
  std::optional<RiverEnd> end;
  bool source_first = false;  // the file says that it is drawn from source to mouth
};

/// A coast drawn as an open line.
struct CoastPiece {
  Polyline points;
  bool clipped = false;
  std::string name;
  int feature = -1;
};

/// A polygon's ring that does not end where it began.
struct OpenRing {
  bool lake;
  std::size_t polygon, ring;  // number of the coast or lake, of its ring
};

struct MapDraft {
  VectorMap map;
  std::vector<OpenRing> open_rings;
  std::vector<RiverHint> hints;  // one a river
  std::vector<CoastPiece> pieces;
};

VectorMap finish_map(MapDraft draft, const ReadOptions& options, MapReport report);

/// Joins pieces at their ends (within `tolerance`, with a warning) into rings. InputError for what
/// stays open.
std::vector<Coast> join_coast_pieces(std::vector<CoastPiece> pieces, double tolerance,
                                     MapReport& report);

}  // namespace orogen
