// Why these checks prove that the cells are the regular triangulation of the points.
//
// Every cell has volume; a facet is in at most two cells, and two lie on opposite sides of it.
// (a) The boundary, the facets in one cell only, is that of a convex polytope. The point o is the barycentre of a cell,
//     strictly inside of each boundary facet, so each maps one to one onto a spherical simplex about o. Each ridge of
//     the boundary is in exactly two of them, f and g. They are the ends of a chain of cells that turns one way about
//     the ridge, so that the cells have f on their right and g on their left, say; so has o; hence f and g lie on
//     opposite sides of the hyperplane through o and the ridge, and a direction that crosses the image of a ridge
//     leaves one facet and enters another. So the number of facets that a direction meets is the same for all generic
//     directions (a sphere without parts of codimension two is connected). One ray meets exactly one facet: so do all,
//     the boundary is star-shaped. It is reflex at no ridge: it is convex.
// (b) The cells cover the polytope exactly once. How many cells lie over a generic point changes at the boundary only,
// by
//     one; it is zero far away, hence zero outside and one inside.
// (c) Heights over the cells are a function on a convex set, linear on each cell and convex across each facet: a convex
//     function, the lower hull of the lifted vertices. Every other row must lie at a vertex, or above that hull.
//
// Source: Mehlhorn, Naeher, Schilz, Schirra, Seel, Seidel, Uhrig, "Checking geometric programs or verification of
// geometric structures" (1999), section 2, which checks hulls by their ridges and one ray.
// Departure: the boundary need not be known to be a closed surface; the cells inside of it see to that.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "check/chunks.hpp"
#include "check/complex_check.hpp"
#include "check/exact_kernel.hpp"
#include "check/facet_match.hpp"

namespace delone::check_detail {

template <int K>
class ComplexCheck {
 public:
  ComplexCheck(const ComplexInput& input, Violations& violations)
      : input_(input), kernel_(input.points, input.hull, input.furthest), violations_(violations) {}

  std::size_t run() {
    check_volumes();
    match();
    check_sides();
    const bool sound = violations_.none();
    check_regularity();
    collect_boundary();
    if (!sound) return boundary_.size();  // what follows is about a complex without folds and flat cells
    check_boundary();
    if (violations_.none()) check_strays();
    return boundary_.size();
  }

 private:
  using Kernel = ExactKernel<K>;
  using Cell = typename Kernel::Cell;
  using Facet = typename Kernel::Facet;
  static constexpr std::size_t kCorners = static_cast<std::size_t>(K) + 1;

  std::size_t cell_count() const { return input_.cells.size() / kCorners; }
  Cell cell(std::size_t c) const {
    Cell corners;
    std::copy_n(input_.cells.data() + c * kCorners, kCorners, corners.begin());
    return corners;
  }
  Facet facet(std::size_t f) const { return without(cell(f / kCorners), f % kCorners); }
  Index apex(std::size_t f) const { return input_.cells[f]; }

  static Facet without(const Cell& cell, std::size_t corner) {
    Facet facet;
    for (std::size_t i = 0, j = 0; i < kCorners; ++i) {
      if (i != corner) facet[j++] = cell[i];
    }
    return facet;
  }
  /// The sign of the permutation that moves position i to the front.
  static int parity(std::size_t i) { return i % 2 == 0 ? 1 : -1; }

  /// The orientation of the simplex (apex of f, facet f): on which side of the facet its cell lies.
  int side(std::size_t f) const { return orientation_[f / kCorners] * parity(f % kCorners); }

  std::string beyond_sphere() const {
    return input_.furthest ? " is outside the orthosphere of " : " is inside the orthosphere of ";
  }
  static std::string cell_in_words(std::size_t c) { return "cell " + std::to_string(c); }
  std::string facet_in_words(std::size_t f) const { return "facet (" + in_words(facet(f)) + ")"; }

  void check_volumes() {
    orientation_.resize(cell_count());
    check_each(cell_count(), input_.threads, violations_, [this](std::size_t c, Violations& found) {
      orientation_[c] = static_cast<std::int8_t>(kernel_.orient(cell(c)));
      if (orientation_[c] == 0) {
        found.add([&] { return cell_in_words(c) + " (" + in_words(cell(c)) + ") is flat"; });
      }
    });
  }

  void match() {
    FacetMatch found = match_facets(input_.cells, K + 1, input_.points.size(), input_.threads);
    twin_ = std::move(found.twin);
    for (const auto& group : found.crowded) {
      violations_.add([&] {
        std::string words = facet_in_words(group.front()) + " is in " + std::to_string(group.size()) + " cells:";
        for (const Index f : group) words += ' ' + std::to_string(f / kCorners);
        return words;
      });
    }
  }

  /// Calls work(f, found) for each facet of two cells, once.
  template <class Work>
  void check_interior_facets(const Work& work) {
    check_each(cell_count(), input_.threads, violations_, [&](std::size_t c, Violations& found) {
      for (std::size_t f = c * kCorners; f < (c + 1) * kCorners; ++f) {
        if (twin_[f] != kNone && f < twin_[f]) work(f, found);
      }
    });
  }

  void check_sides() {
    check_interior_facets([this](std::size_t f, Violations& found) {
      if (side(f) * side(twin_[f]) > 0) {
        found.add([&] {
          return "cells " + std::to_string(f / kCorners) + " and " + std::to_string(twin_[f] / kCorners) +
                 " lie on the same side of their " + facet_in_words(f);
        });
      }
    });
  }

  void check_regularity() {
    check_interior_facets([this](std::size_t f, Violations& found) {
      const std::size_t c = f / kCorners;
      const Index q = apex(twin_[f]);
      if (side(f) * side(twin_[f]) >= 0) return;
      const int inside = kernel_.inside_orthosphere(cell(c), orientation_[c], q);
      if (inside > 0) {
        found.add([&] {
          return in_words({&q, 1}) + beyond_sphere() + cell_in_words(c) + " (" + in_words(cell(c)) + ")";
        });
      } else if (inside == 0 && input_.canonical && kernel_.wins_tie(cell(c), orientation_[c], q)) {
        found.add([&] {
          return cell_in_words(c) + " (" + in_words(cell(c)) + ") is not canonical: in the tie with " +
                 in_words({&q, 1}) + " it must give way";
        });
      }
    });
  }

  void collect_boundary() {
    for (std::size_t f = 0; f < twin_.size(); ++f) {
      if (twin_[f] == kNone) boundary_.push_back(f);
    }
  }

  void check_boundary() {
    const std::size_t before = violations_.count();
    const Cell centre = cell(0);
    std::vector<std::int8_t> about(boundary_.size());
    check_each(boundary_.size(), input_.threads, violations_, [&](std::size_t b, Violations& found) {
      const std::size_t f = boundary_[b];
      about[b] = static_cast<std::int8_t>(kernel_.orient_about(centre, facet(f)));
      if (about[b] != side(f)) {
        found.add([&] {
          return "boundary " + facet_in_words(f) + " of " + cell_in_words(f / kCorners) +
                 " does not have the inside of cell 0 on its inner side: the boundary is not convex";
        });
      }
    });
    check_ridges();
    if (violations_.count() == before) check_ray(about);
  }

  void check_ridges() {
    constexpr std::size_t kRidges = static_cast<std::size_t>(K);  // of a facet
    std::vector<Index> rows;
    rows.reserve(boundary_.size() * kRidges);
    for (const std::size_t f : boundary_) {
      const Facet corners = facet(f);
      rows.insert(rows.end(), corners.begin(), corners.end());
    }
    const FacetMatch ridges = match_facets(rows, K, input_.points.size(), input_.threads);
    check_each(rows.size(), input_.threads, violations_, [&](std::size_t r, Violations& found) {
      const std::size_t b = r / kRidges;
      const std::size_t f = boundary_[b];
      const std::size_t other = ridges.twin[r];
      if (other == kNone) {
        found.add([&] {
          return "boundary " + facet_in_words(f) + " of " + cell_in_words(f / kCorners) + " opposite " +
                 in_words({&rows[r], 1}) + " does not continue in exactly one other boundary facet";
        });
        return;
      }
      if (other < r) return;
      Cell beyond;  // the other facet's apex, seen from this facet
      beyond[0] = rows[other];
      std::copy_n(rows.data() + b * kRidges, kRidges, beyond.begin() + 1);
      if (kernel_.orient(beyond) * side(f) < 0) {
        found.add([&] {
          return in_words({&rows[other], 1}) + " is outside of boundary " + facet_in_words(f) + " of " +
                 cell_in_words(f / kCorners) + ": the boundary is not convex";
        });
      }
    });
  }

  /// The ray through the barycentre of the first boundary facet must meet no other.
  void check_ray(const std::vector<std::int8_t>& about) {
    if (boundary_.empty()) {
      violations_.add([] { return std::string("the cells have no boundary"); });
      return;
    }
    const Cell centre = cell(0);
    const Facet target = facet(boundary_.front());
    check_each(boundary_.size() - 1, input_.threads, violations_, [&](std::size_t i, Violations& found) {
      const std::size_t b = i + 1;
      const Facet corners = facet(boundary_[b]);
      for (std::size_t j = 0; j < static_cast<std::size_t>(K); ++j) {
        if (kernel_.orient_about(centre, corners, j, target) * about[b] < 0) return;
      }
      found.add([&] {
        return "boundary " + facet_in_words(boundary_[b]) + " and boundary " + facet_in_words(boundary_.front()) +
               " lie behind each other: the boundary winds around more than once";
      });
    });
  }

  void check_strays() {
    const std::vector<Index> order = along_a_curve();
    std::vector<Violations> found((order.size() + kChunk - 1) / kChunk, Violations(violations_.limit()));
    for_chunks(order.size(), input_.threads, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      std::size_t hint = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const Index q = order[i];
        const std::optional<std::size_t> c = locate(q, hint);
        if (c) hint = *c;
        check_stray(q, c, found[chunk]);
      }
    });
    for (Violations& some : found) violations_.append(std::move(some));
  }

  void check_stray(Index q, std::optional<std::size_t> c, Violations& found) const {
    if (!c) {
      found.add([&] { return in_words({&q, 1}) + " is outside of all cells"; });
      return;
    }
    const int inside = kernel_.inside_orthosphere(cell(*c), orientation_[*c], q);
    if (inside > 0) {
      found.add([&] {
        return in_words({&q, 1}) + " is no vertex, but" + beyond_sphere().substr(3) + cell_in_words(*c) + " (" +
               in_words(cell(*c)) + ") that contains it";
      });
    } else if (inside == 0 && input_.canonical && kernel_.wins_tie(cell(*c), orientation_[*c], q)) {
      found.add([&] {
        return in_words({&q, 1}) + " is no vertex, but in the canonical triangulation it wins its tie with " +
               cell_in_words(*c) + " (" + in_words(cell(*c)) + ")";
      });
    }
  }

  /// The stray rows sorted along a Z curve; any order is correct, a local one is fast.
  std::vector<Index> along_a_curve() const {
    constexpr int kBits = std::min(63 / K, 21);
    std::array<double, static_cast<std::size_t>(K)> low;
    std::array<double, static_cast<std::size_t>(K)> span;
    for (std::size_t j = 0; j < low.size(); ++j) {
      const auto axis = static_cast<std::size_t>(input_.hull.axes[j]);
      low[j] = input_.points[0][axis];
      double high = low[j];
      for (std::size_t row = 1; row < input_.points.size(); ++row) {
        low[j] = std::min(low[j], input_.points[row][axis]);
        high = std::max(high, input_.points[row][axis]);
      }
      span[j] = high / 2 - low[j] / 2;  // halves do not overflow
    }
    std::vector<std::pair<std::uint64_t, Index>> keys;
    for (const Index row : input_.strays) {
      std::uint64_t key = 0;
      for (std::size_t j = 0; j < low.size(); ++j) {
        const double x = input_.points[row][static_cast<std::size_t>(input_.hull.axes[j])];
        const double share = span[j] > 0 ? (x / 2 - low[j] / 2) / span[j] : 0.0;
        const auto step = static_cast<std::uint64_t>(std::clamp(share, 0.0, 1.0) * ((1 << kBits) - 1));
        for (int bit = 0; bit < kBits; ++bit) key |= ((step >> bit) & 1) << (bit * K + static_cast<int>(j));
      }
      keys.emplace_back(key, row);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<Index> order;
    for (const auto& [key, row] : keys) order.push_back(row);
    return order;
  }

  /// A closed cell that contains q, by a visibility walk from `start`; none when q is outside of the hull. Among cells
  /// of one orthosphere the walk may turn in circles: then every cell is tried.
  std::optional<std::size_t> locate(Index q, std::size_t start) const {
    std::size_t c = start;
    for (std::size_t steps = 0; steps <= cell_count(); ++steps) {
      const std::optional<std::size_t> f = separating_facet(c, q, steps);
      if (!f) return c;
      if (twin_[*f] == kNone) return std::nullopt;  // outside of a facet of the hull, which is convex
      c = twin_[*f] / kCorners;
    }
    for (c = 0; c < cell_count(); ++c) {
      if (!separating_facet(c, q, 0)) return c;
    }
    return std::nullopt;
  }

  /// A facet of cell c that has q strictly on its outer side, trying corners from `first` on.
  std::optional<std::size_t> separating_facet(std::size_t c, Index q, std::size_t first) const {
    const Cell corners = cell(c);
    for (std::size_t i = 0; i < kCorners; ++i) {
      const std::size_t corner = (first + i) % kCorners;
      Cell replaced = corners;
      replaced[corner] = q;
      if (kernel_.orient(replaced) * orientation_[c] < 0) return c * kCorners + corner;
    }
    return std::nullopt;
  }

  const ComplexInput& input_;
  Kernel kernel_;
  Violations& violations_;
  std::vector<std::int8_t> orientation_;  // per cell
  std::vector<Index> twin_;               // per facet
  std::vector<std::size_t> boundary_;     // facets
};

template <int K>
std::size_t check_complex(const ComplexInput& input, Violations& violations) {
  return ComplexCheck<K>(input, violations).run();
}

}  // namespace delone::check_detail
