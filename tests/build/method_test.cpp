#include "delone/build/method.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "delone/base/errors.hpp"
#include "delone/build/build.hpp"
#include "delone/mesh/export.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;

bool serves(const MethodInfo& method, const PointSet& points) {
  return points.dimension >= method.least_dimension && points.dimension <= method.most_dimension &&
         (method.weights || points.weights.empty());
}

/// What can tell two triangulations of the same rows apart.
struct Face {
  std::uint64_t hash;
  std::size_t hull_facets;
  std::vector<RowStatus> status;
  bool operator==(const Face&) const = default;
};

Face face(const AnyTriangulation& t) {
  Face face{canonical_hash(t), t.hull_facet_count(), {}};
  for (std::size_t row = 0; row < t.row_count(); ++row) face.status.push_back(t.status(static_cast<Index>(row)));
  return face;
}

void expect_face(const PointSet& points, const BuildOptions& options, const Face& usual) {
  SCOPED_TRACE(info(options.method).name);
  const AnyTriangulation t = build(points.view(), options);
  ASSERT_EQ(broken_invariant(t), "") << points;
  ASSERT_TRUE(face(t) == usual) << points;
}

void expect_all_methods_agree(const PointSet& points, std::uint64_t seed) {
  const Face usual = face(build(points.view()));
  for (const MethodInfo& method : methods()) {
    if (serves(method, points)) expect_face(points, {.method = method.method, .seed = seed}, usual);
  }
}

TEST(Method, all_methods_agree_on_every_family) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const std::size_t n : {1, 2, 3, 4, 5, 6, 8, 11, 15}) {
      for (const PointSet& points : families(dimension, n, n)) expect_all_methods_agree(points, n);
    }
  }
}

TEST(MethodSlow, all_methods_agree_on_larger_sets) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : families(dimension, dimension < 3 ? 120 : dimension < 4 ? 60 : 25, 7)) {
      expect_all_methods_agree(points, 3);
    }
  }
}

TEST(Method, all_methods_agree_in_high_dimensions) {
  for (int dimension = 5; dimension <= 7; ++dimension) expect_all_methods_agree(uniform(dimension, 14, 7), 3);
  expect_all_methods_agree(lattice(5, 14, 3, 1), 1);
  expect_all_methods_agree(with_random_weights(lattice(5, 14, 3, 1), 2), 1);
}

TEST(Method, every_order_leads_to_the_same) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const PointSet& points : families(dimension, 25, 5)) {
      const Face usual = face(build(points.view()));
      for (const OrderInfo& order : orders()) {
        SCOPED_TRACE(order.name);
        for (const Method method : {Method::cavity, Method::flip})
          expect_face(points, {.method = method, .order = order.order, .seed = 9}, usual);
      }
    }
  }
}

TEST(Method, divide_and_conquer_of_strips) {
  for (const std::size_t n : {3, 4, 5, 8, 20, 60, 300}) {
    for (const PointSet& points : unweighted_families(2, n, n)) {
      expect_face(points, {.method = Method::divide_conquer, .order = Order::lexicographic},
                  face(build(points.view())));
    }
  }
}

TEST(Method, what_a_method_does_not_serve_is_refused_naming_those_that_serve) {
  const PointSet points = uniform(3, 10, 1);
  try {
    build(points.view(), {.method = Method::sweep});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("the method sweep does not serve points of dimension 3; these do: "
                                                  "automatic, cavity, flip, "));
  }
  EXPECT_THROW(build(with_random_weights(uniform(2, 10, 1), 1).view(), {.method = Method::lawson}), InputError);
  EXPECT_THROW(build(points.view(), {.method = Method::gift_wrap, .order = Order::random}), InputError);
}

TEST(Method, a_caller_may_cancel_every_method) {
  for (const PointSet& points : {uniform(2, 600, 1), uniform(3, 600, 1), uniform(5, 40, 1)}) {
    for (const MethodInfo& method : methods()) {
      if (!serves(method, points)) continue;
      EXPECT_THROW(build(points.view(), {.progress = [](double) { return false; }, .method = method.method}), Cancelled)
          << method.name;
    }
  }
}

TEST(Method, names_lead_back_to_methods) {
  for (const MethodInfo& method : methods()) EXPECT_EQ(method_named(method.name), method.method);
  for (const OrderInfo& order : orders()) EXPECT_EQ(order_named(order.name), order.order);
  EXPECT_THROW(method_named("magic"), InputError);
  EXPECT_THROW(order_named("magic"), InputError);
}

}  // namespace
}  // namespace delone
