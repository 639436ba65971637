// Small point sets, triangulated by the engine and by trying every subset: cells and the status of every row must
// agree, and the exact check must pass. Input bytes: dimension and weights, how coordinates are coded, then the
// coordinates. Most codes give few distinct values, since ties are where the engine can be wrong; the others reach
// every double.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/check/delaunay.hpp"
#include "delone/mesh/export.hpp"
#include "fuzz/bytes.hpp"
#include "support/brute_force.hpp"

namespace {

using delone::Index;
using delone::fuzz::Bytes;
using delone::fuzz::number;

[[noreturn]] void fail(const char* how, const char* what) {
  std::fprintf(stderr, "insert_fuzz: %s: %s\n", how, what);
  std::abort();
}

void expect_truth(const delone::AnyTriangulation& t, const delone::test::Truth& truth, const char* how) {
  if (t.affine_dimension() != truth.affine_dimension) fail(how, "another affine dimension than brute force");
  const auto table = delone::cells(t);
  std::vector<std::vector<Index>> cells;
  for (std::size_t c = 0; c < table.size(); ++c) {
    cells.emplace_back(table[c].begin(), table[c].end());
    std::ranges::sort(cells.back());
  }
  std::ranges::sort(cells);
  if (cells != truth.cells) fail(how, "other cells than brute force");
  for (std::size_t row = 0; row < t.row_count(); ++row) {
    const auto status = t.status(static_cast<Index>(row));
    if (static_cast<int>(status.status) != truth.status[row]) fail(how, "another status of a row than brute force");
    if (status.status == delone::Status::duplicate && status.of != truth.of[row])
      fail(how, "a duplicate of another row");
  }
}

/// The subsets that brute force tries stay below a few hundred.
constexpr std::size_t kMostPoints[] = {0, 10, 9, 8, 8};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(std::span(data, size));
  const std::uint8_t shape = bytes.next();
  const int dimension = 1 + shape % 4;
  const bool weighted = (shape & 16) != 0;
  const int coding = bytes.next() % 8;
  const int weight_coding = bytes.next() % 8;

  std::vector<double> coordinates, weights;
  for (std::size_t n = 0; n < kMostPoints[dimension] && !bytes.empty(); ++n) {
    for (int axis = 0; axis < dimension; ++axis) coordinates.push_back(number(bytes, coding));
    if (weighted) weights.push_back(number(bytes, weight_coding));
  }
  if (coordinates.empty()) return 0;
  const delone::PointsView points(coordinates, dimension, weights);

  const auto truth = delone::test::brute_force(points);
  const auto built = delone::build(points);
  expect_truth(built, truth, "built");

  // The same points, one after the other: from nothing, through every dimension that the first ones span.
  delone::AnyTriangulation grown(dimension, weighted);
  for (std::size_t row = 0; row < points.size(); ++row) delone::insert(grown, points[row], points.weight(row));
  expect_truth(grown, truth, "grown");
  if (delone::canonical_hash(grown) != delone::canonical_hash(built)) fail("grown", "another hash than built");

  // And the second half as a batch.
  const std::size_t half = points.size() / 2, axes = static_cast<std::size_t>(dimension);
  const auto part = [&](std::size_t from, std::size_t to) {
    const std::span<const double> w =
        weighted ? std::span<const double>(weights).subspan(from, to - from) : std::span<const double>();
    return delone::PointsView(std::span<const double>(coordinates).subspan(from * axes, (to - from) * axes), dimension,
                              w);
  };
  if (half > 0) {
    auto batched = delone::build(part(0, half));
    delone::insert(batched, part(half, points.size()));
    expect_truth(batched, truth, "batched");
  }
  if (!delone::check(points, delone::cells(built), {.canonical = true}).passed())
    fail("built", "the exact check fails");
  return 0;
}
