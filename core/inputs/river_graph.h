// Lines as a graph: common vertices where they cross or touch, and chains between its nodes.
#pragma once

#include <vector>

#include "inputs/vector_map.h"

namespace orogen {

/// Part of a drawn river, in the drawn direction.
struct RiverLine {
  Polyline points;
  int river;  // number of the drawn river
};

inline constexpr double kTouch = 1.0;  // m, closer ends count as touching

/// Gives lines that cross, touch or end on each other a common vertex there. InputError if they are
/// tangled beyond reason.
void node_lines(std::vector<RiverLine>& lines);

/// A stretch between two nodes: ends, forks, and places where one river's line follows another's.
struct Chain {
  std::vector<int> vertices;
  int river;
  double length;      // m
  bool drawn_onward;  // vertices are in the drawn direction
  int first() const { return vertices.front(); }
  int last() const { return vertices.back(); }
};

struct RiverGraph {
  std::vector<glm::dvec2> points;    // of the vertices
  std::vector<Chain> chains;         // stretches drawn twice appear once
  std::vector<std::vector<int>> at;  // chains that begin or end at each vertex (loops twice)
  bool is_end(int vertex) const { return at[vertex].size() == 1; }
};

RiverGraph make_graph(const std::vector<RiverLine>& noded);

}  // namespace orogen
