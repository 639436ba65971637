// What an insertion removes, seen from outside through its Edit: all cells in conflict, and no other.
#include "delone/mesh/cavity.hpp"

#include <gtest/gtest.h>

#include <set>

#include "delone/base/dispatch.hpp"
#include "delone/build/insert.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

/// Conflict by definition, one cell at a time: a ghost cell when q is beyond its facet, or in line with it and in
/// conflict with the cell behind.
template <int K>
bool conflicts(const Complex& complex, Kernel<K>& kernel, CellId c, VertexId q) {
  typename Kernel<K>::Cell v;
  int ghost = -1;
  for (int i = 0; i <= K; ++i) {
    v[static_cast<std::size_t>(i)] = complex.vertex(c, i);
    if (complex.vertex(c, i) == kGhost) ghost = i;
  }
  if (ghost < 0) {
    const SlowSign sign = kernel.slow_conflict_sign(v, q);
    return sign.sign != 0 ? sign.sign > 0 : kernel.conflict(v, q);
  }
  v[static_cast<std::size_t>(ghost)] = q;
  if (const int side = kernel.exact_orient(v); side != 0) return side > 0;
  return conflicts(complex, kernel, complex.cell(complex.twin(c, ghost)), q);
}

TEST(Cavity, is_every_cell_in_conflict_and_no_other) {
  for (int dimension = 1; dimension <= 5; ++dimension) {
    const std::size_t n = dimension < 4 ? 40 : 14;
    for (const PointSet& points : {uniform(dimension, n, 1), lattice(dimension, n, 3, 2), cospherical(dimension, n, 3),
                                   with_random_weights(lattice(dimension, n, 4, 4), 5)}) {
      AnyTriangulation t = built(rows(points, 0, n / 2));
      for (std::size_t row = n / 2; row < n; ++row) {
        AnyTriangulation before = t;
        std::set<Index> removed;
        const auto listen = [&](const Edit& edit) {
          if (edit.rebuilt) before = AnyTriangulation(dimension);
          for (const CellId c : edit.removed) removed.insert(raw(c));
        };
        const Inserted inserted = insert(t, points.view()[row], points.view().weight(row), {.on_edit = listen});
        if (before.affine_dimension() < 1 || inserted.outcome != Outcome::inserted) continue;
        with_dimension<1>(before.affine_dimension(), [&](auto k) {
          Kernel<k> kernel(t.sites());
          const VertexId q = t.vertex(inserted.row);
          for (std::size_t s = 0; s < before.complex().slot_count(); ++s) {
            const CellId c{static_cast<Index>(s)};
            if (!before.complex().is_live(c)) continue;
            ASSERT_EQ(conflicts<k>(before.complex(), kernel, c, q), removed.contains(raw(c))) << points.name;
          }
        });
      }
    }
  }
}

TEST(Cavity, in_the_plane_its_boundary_is_listed_as_a_cycle) {
  for (const PointSet& points :
       {uniform(2, 60, 1), lattice(2, 60, 5, 2), cospherical(2, 60, 3), with_random_weights(lattice(2, 80, 6, 4), 5)}) {
    AnyTriangulation t(2, !points.weights.empty());
    const auto expect_cycle = [&](const Edit& edit) {
      // Each cell of the star shares the edge from the new vertex to where its part of the boundary ends with the next.
      for (std::size_t b = 0; b < edit.created.size(); ++b) {
        const CellId c = edit.created[b];
        int slot = 0;
        while (t.complex().vertex(c, slot) != edit.came.front()) ++slot;
        const FacetId along_end = t.complex().twin(c, (slot + 1) % 3);
        ASSERT_EQ(t.complex().cell(along_end), edit.created[(b + 1) % edit.created.size()]) << points.name;
      }
    };
    for (std::size_t row = 0; row < points.size(); ++row) {
      insert(t, points.view()[row], points.view().weight(row), {.on_edit = [&](const Edit& edit) {
               if (!edit.rebuilt && t.affine_dimension() == 2) expect_cycle(edit);
             }});
    }
  }
}

}  // namespace
}  // namespace delone
