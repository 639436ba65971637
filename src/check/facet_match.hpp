// Which simplices share which facets.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "delone/base/ids.hpp"

namespace delone::check_detail {

/// Facet f = simplex * corners + i is the facet opposite corner i.
struct FacetMatch {
  std::vector<Index> twin;                  ///< the same facet seen from the one other simplex, else kNone
  std::vector<std::vector<Index>> crowded;  ///< facets that three or more simplices share
};

/// @param simplices  rows, `corners` >= 1 of them per simplex, ascending within each
/// @param rows       all rows are below it
FacetMatch match_facets(std::span<const Index> simplices, int corners, std::size_t rows, int threads);

}  // namespace delone::check_detail
