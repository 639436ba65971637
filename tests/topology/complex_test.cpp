#include "delone/topology/complex.hpp"

#include <gtest/gtest.h>

#include "delone/base/errors.hpp"
#include "delone/build/insert.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

TEST(Complex, facets_are_numbered_by_cell_and_slot) {
  using View = ComplexView<3>;
  const FacetId f = View::facet(CellId{5}, 2);
  EXPECT_EQ(raw(f), 22U);
  EXPECT_EQ(View::cell(f), CellId{5});
  EXPECT_EQ(View::slot(f), 2);
  const Complex complex(3);
  EXPECT_EQ(complex.cell(f), CellId{5});
  EXPECT_EQ(complex.slot(f), 2);
  EXPECT_EQ(raw(ComplexView<2>::facet(CellId{5}, 2)), 22U);
  EXPECT_EQ(raw(ComplexView<4>::facet(CellId{5}, 4)), 44U);
  EXPECT_EQ(raw(ComplexView<0>::facet(CellId{5}, 0)), 5U);
  EXPECT_GT(Complex(2).nameable_slots(), std::size_t{1} << 29);
  EXPECT_EQ(Complex().facet_slots(), 0U);
  EXPECT_EQ(Complex().nameable_slots(), kNone - 1);
}

TEST(Complex, a_dead_slot_is_used_again_last_in_first_out) {
  Complex complex(2);
  complex.reserve_more(8, 4);
  complex.grow_vertices(4);
  ComplexView<2> view(complex);
  const auto make = [&] {
    const CellId c = view.create();
    for (int i = 0; i < 3; ++i) view.set_vertex(c, i, VertexId{static_cast<Index>(i)});
    return c;
  };
  const CellId a = make(), b = make(), c = make();
  EXPECT_EQ(complex.live_count(), 3U);
  view.destroy(a);
  view.destroy(c);
  EXPECT_FALSE(complex.is_live(a));
  EXPECT_TRUE(complex.is_live(b));
  EXPECT_EQ(complex.live_count(), 1U);
  EXPECT_EQ(make(), c);
  EXPECT_EQ(make(), a);
  EXPECT_EQ(complex.slot_count(), 3U);
}

TEST(Complex, links_run_both_ways) {
  Complex complex(1);
  complex.reserve_more(2, 2);
  ComplexView<1> view(complex);
  const CellId a = view.create(), b = view.create();
  view.link(view.facet(a, 0), view.facet(b, 1));
  EXPECT_EQ(view.twin(a, 0), view.facet(b, 1));
  EXPECT_EQ(view.twin(view.twin(view.facet(a, 0))), view.facet(a, 0));
}

TEST(Complex, more_cells_than_ids_are_refused_before_any_is_made) {
  Complex complex(3);
  EXPECT_THROW(complex.reserve_more((kNone - 1) / 4 + std::size_t{1}, 0), InputError);
  EXPECT_EQ(complex.memory_bytes(), 0U);
}

TEST(Complex, dimension_minus_one_has_no_cells) {
  const Complex complex;
  EXPECT_EQ(complex.dimension(), -1);
  EXPECT_EQ(complex.slot_count(), 0U);
}

TEST(Complex, incidence_can_be_refilled_from_the_cells) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    AnyTriangulation t = built(lattice(dimension, 20, 3, 1));
    t.mesh().complex.rebuild_incidence();
    EXPECT_EQ(broken_invariant(t), "");
  }
}

TEST(Complex, invariants_hold_for_every_family_and_after_every_insertion) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : {uniform(dimension, 20, 1), lattice(dimension, 30, 3, 2), flat(dimension, 2, 20, 3),
                                   with_random_weights(lattice(dimension, 30, 3, 4), 5)}) {
      AnyTriangulation t(dimension, !points.weights.empty());
      for (std::size_t row = 0; row < points.size(); ++row) {
        insert(t, points.view()[row], points.view().weight(row));
        ASSERT_EQ(broken_invariant(t), "") << points.name << " after row " << row;
      }
    }
  }
}

}  // namespace
}  // namespace delone
