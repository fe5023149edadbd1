// Carries rivers that end before they reach anything on to what they flow into.
#pragma once

#include <vector>

#include "inputs/land_region.h"
#include "inputs/map_draft.h"
#include "inputs/river_graph.h"

namespace orogen {

/// What a node of the graph drains into directly.
struct Outlet {
  bool here = false;
  RiverEnd kind = RiverEnd::Sea;
  int lake = -1;
  double handicap = 0.0;  // m, how unlikely it is that water leaves here
};

/// What the steps of the network share.
struct RiverScene {
  const VectorMap& map;
  const std::vector<RiverHint>& hints;
  const LandRegion& land;
  double snap;  // m
  MapReport& report;

  std::string words(int river) const;
};

/// Outlets by vertex: nodes that touch sea, frame or lake.
std::vector<Outlet> find_outlets(const RiverGraph& graph, const RiverScene& scene);

/// The connected part of the graph that each chain belongs to, numbered from 0.
std::vector<int> connected_parts(const RiverGraph& graph);

/// Cuts off ends that overshoot the river they cross by less than a fifth of the snap distance.
bool cut_overshoots(std::vector<RiverLine>& lines, const RiverGraph& graph,
                    const std::vector<Outlet>& outlets, const RiverScene& scene);

/// Lengthens lines so that more parts reach an outlet; false if there was nothing to do.
bool connect_parts(std::vector<RiverLine>& lines, const RiverGraph& graph,
                   const std::vector<Outlet>& outlets, const RiverScene& scene);

}  // namespace orogen
