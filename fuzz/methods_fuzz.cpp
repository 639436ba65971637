// Small point sets, triangulated by every method in every order: all must agree. Furthest sites and hulls must pass the
// exact check, and agree about corners. Input bytes: dimension and weights, how coordinates are coded, a seed, then the
// coordinates.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

#include "delone/apps/furthest.hpp"
#include "delone/apps/hull.hpp"
#include "delone/build/build.hpp"
#include "delone/check/delaunay.hpp"
#include "delone/mesh/export.hpp"
#include "fuzz/bytes.hpp"

namespace {

using delone::Index;
using delone::fuzz::Bytes;
using delone::fuzz::number;

[[noreturn]] void fail(const char* how, const char* what) {
  std::fprintf(stderr, "methods_fuzz: %s: %s\n", how, what);
  std::abort();
}

void expect_same(const delone::AnyTriangulation& t, const delone::AnyTriangulation& usual, const char* how) {
  if (delone::canonical_hash(t) != delone::canonical_hash(usual)) fail(how, "another hash");
  if (t.hull_facet_count() != usual.hull_facet_count()) fail(how, "another number of hull facets");
  for (std::size_t row = 0; row < t.row_count(); ++row) {
    if (t.status(static_cast<Index>(row)) != usual.status(static_cast<Index>(row)))
      fail(how, "another status of a row");
  }
}

void expect_furthest_and_hull(delone::PointsView points) {
  const auto furthest = delone::furthest_delaunay(points);
  if (!delone::check(points, furthest.cells, {.canonical = true, .furthest = true}).passed())
    fail("furthest", "the exact check fails");
  std::vector<Index> corners;
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (furthest.status[row].status == delone::Status::vertex) corners.push_back(static_cast<Index>(row));
  }
  if (delone::convex_hull(points).corners != corners) fail("hull", "other corners than furthest sites");
}

constexpr std::size_t kMostPoints[] = {0, 24, 20, 16, 12};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(std::span(data, size));
  const std::uint8_t shape = bytes.next();
  const int dimension = 1 + shape % 4;
  const bool weighted = (shape & 16) != 0;
  const int coding = bytes.next() % 8;
  const int weight_coding = bytes.next() % 8;
  const std::uint64_t seed = bytes.next();

  std::vector<double> coordinates, weights;
  for (std::size_t n = 0; n < kMostPoints[dimension] && !bytes.empty(); ++n) {
    for (int axis = 0; axis < dimension; ++axis) coordinates.push_back(number(bytes, coding));
    if (weighted) weights.push_back(number(bytes, weight_coding));
  }
  if (coordinates.empty()) return 0;
  const delone::PointsView points(coordinates, dimension, weights);
  const auto usual = delone::build(points);
  for (const delone::MethodInfo& method : delone::methods()) {
    const bool serves = dimension >= method.least_dimension && dimension <= method.most_dimension;
    if (!serves || (weighted && !method.weights)) continue;
    expect_same(delone::build(points, {.method = method.method, .seed = seed}), usual, method.name);
  }
  for (const delone::OrderInfo& order : delone::orders())
    expect_same(delone::build(points, {.order = order.order, .seed = seed}), usual, order.name);
  if (!weighted) expect_furthest_and_hull(points);
  return 0;
}
