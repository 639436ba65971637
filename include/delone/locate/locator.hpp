// What a locator is: a value that stands beside a triangulation and gives a cell near a point, from which a walk
// starts. It hears of every edit, and is named in nobody's type.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>

#include "delone/base/ids.hpp"
#include "delone/build/insert.hpp"
#include "delone/mesh/edit.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// hint(t, q)    a live cell of t, kNoCell when there is none; any is correct, a near one is fast. q has t.dimension()
///               finite coordinates in the user's axes; whether it is a site, inside or outside does not matter.
///               @throws InputError when it has not
/// update(t, e)  after every change of t; never throws. A locator that runs out of memory forgets what it knows, and
/// its
///               hints stay correct.
template <class L>
concept Locator = requires(L l, const AnyTriangulation& t, std::span<const double> q, const Edit& e) {
  { l.hint(t, q) } -> std::same_as<CellId>;
  {l.update(t, e)};
};

/// What finding hints has cost so far, in operations: these do not depend on the machine.
struct LocateCounts {
  std::uint64_t hints = 0;
  std::uint64_t levels = 0;       ///< marches: one a level of a hierarchy
  std::uint64_t turned = 0;       ///< cells passed on the way round a vertex, to the one towards q
  std::uint64_t crossed = 0;      ///< cells walked through
  std::uint64_t visited = 0;      ///< buckets, nodes of a tree, or vertices whose neighbours were looked at
  std::uint64_t line_tests = 0;   ///< orientation tests of a vertex against the line from another one to q
  std::uint64_t facet_tests = 0;  ///< orientation tests of q against a facet; all facets of a cell at once count as one
  std::uint64_t distances = 0;    ///< squared distances to q, each compared with the least so far

  bool operator==(const LocateCounts&) const = default;
};

/// Tells `locator` of a triangulation that was there before it.
template <Locator L>
void attach(L& locator, const AnyTriangulation& t) {
  locator.update(t, Edit{.rebuilt = true});
}

/// Inserts one point where `locator` sends the walk, and lets it know. Errors and cost are those of insert() and the
/// hint.
template <Locator L>
Inserted insert(AnyTriangulation& t, std::span<const double> point, double weight, L& locator) {
  const CellId near = locator.hint(t, point);
  return insert(t, point, weight, {.near = near, .on_edit = [&](const Edit& e) { locator.update(t, e); }});
}

}  // namespace delone
