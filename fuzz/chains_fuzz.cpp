// Points of the plane as a piece of divide and conquer that looks for chains, as it does of many points on curves: they
// must be triangulated as by insertion. Input bytes: how x is coded, how much a curve bends, how far points may lie
// beside it; then of each point x, and how far beside the curve it lies.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/geometry/affine.hpp"
#include "delone/mesh/export.hpp"
#include "delone/order/brio.hpp"
#include "fuzz/bytes.hpp"
#include "mesh/triangulate.hpp"
#include "support/expectations.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using delone::fuzz::number;
  delone::fuzz::Bytes bytes(std::span(data, size));
  const int coding = bytes.next() % 8;
  const double bend = number(bytes, 1) / 16.0;
  const double width = std::ldexp(1.0, -static_cast<int>(bytes.next()));
  std::vector<double> coordinates;
  for (std::size_t n = 0; n < 200 && !bytes.empty(); ++n) {
    const double x = number(bytes, coding);
    const double y = bend * x * (x / 16.0) + width * number(bytes, 1);
    for (const double at : {x, y}) coordinates.push_back(std::isfinite(at) ? at : 0.0);
  }
  if (coordinates.empty()) return 0;
  const delone::PointsView points(coordinates, 2);
  const delone::AffineHull hull = delone::affine_hull(points);
  if (hull.flat.dimension != 2) return 0;
  const delone::CutPlan plan{delone::curve_cuts(points, std::span(hull.flat.axes).first(2)), true};
  const delone::AnyTriangulation t(delone::triangulate_plane(points, hull.flat, plan, 1, {}));
  const delone::AnyTriangulation usual = delone::build(points, {.method = delone::Method::cavity});
  if (delone::canonical_hash(t) != delone::canonical_hash(usual) || delone::test::broken_invariant(t) != "") {
    std::fprintf(stderr, "chains_fuzz: not as by insertion\n");
    std::abort();
  }
  return 0;
}
