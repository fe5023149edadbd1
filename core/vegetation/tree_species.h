// The species of trees and shrubs that Orogen knows.
//
// Quaking aspen, black tupelo, weeping willow and black oak have the parameters that Weber and Penn
// (1995) print, but for what docs/theory/vegetation.md lists. The other sets are Orogen's own,
// drawn up from each species' habit: height, crown, angles of branches, arrangement of leaves.
//
// A species is known by its name; its number, the place in the list, may be stored together with a
// version of the program only.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "vegetation/tree_parameters.h"

namespace orogen {

/// Colours are sRGB, 0xRRGGBB. Leaves vary between two.
struct TreeSpecies {
  std::string_view name;        // snake_case, stable
  std::string_view scientific;  // as botanists call it
  std::uint32_t bark_color, leaf_color, other_leaf_color;
  TreeParameters parameters;
};

std::span<const TreeSpecies> tree_species();

/// InputError naming the known ones if there is no such species.
const TreeSpecies& find_tree_species(std::string_view name);

}  // namespace orogen
