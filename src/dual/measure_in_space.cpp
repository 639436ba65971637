// Each facet between two cells is read once, around its edge of the triangulation, cut by the sides of the region that
// it reaches over, and measured once, for both. All is done on a copy of the finite cells of the triangulation in the
// order of a curve: they are visited 40 times per site, each time from a neighbour.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "base/chunks.hpp"
#include "base/part_of.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/order/hilbert.hpp"
#include "dual/centres.hpp"
#include "dual/clipper.hpp"
#include "dual/measure.hpp"
#include "dual/measure_directly.hpp"
#include "dual/polytope.hpp"

namespace delone::dual_detail {
namespace {

constexpr std::size_t kAhead = 8;  // so many cells or facets ahead memory is asked for

/// A finite cell of the triangulation.
struct Tetrahedron {
  std::array<VertexId, 4> vertex;
  std::array<Index, 4> twin;  ///< 4 * number + slot, kNone outside
  Centre centre;
};

/// The edges of a tetrahedron and its other two corners: even permutations. An edge and the one opposite have numbers
/// that sum to 5.
constexpr std::array<std::array<std::size_t, 4>, 6> kEdges{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};
constexpr std::uint8_t kAllEdges = (1U << 6) - 1;
/// The bit of the edge opposite to that between two corners.
constexpr std::array<std::array<std::uint8_t, 4>, 4> kOpposite{{{0, 1U << 5, 1U << 4, 1U << 3},
                                                                {1U << 5, 0, 1U << 2, 1U << 1},
                                                                {1U << 4, 1U << 2, 0, 1},
                                                                {1U << 3, 1U << 1, 1, 0}}};

/// A convex polygon, seen from one of its corners.
struct FaceMeasures {
  Point3 corner;
  Point3 area;  ///< its normal, as long as it is large
  double size;
  Point3 centroid;
  double square;  ///< the mean of |x|^2
};

/// Triangles count by their areas along a normal, so that none which rounding has turned around leads the centroid out
/// of the polygon.
FaceMeasures measured(std::span<const Point3> polygon, const Point3& normal) {
  const Point3& origin = polygon[0];
  Point3 area{}, first{};
  double weight = 0, second = 0;
  Point3 b = polygon[1] - origin;
  double b_squared = dot(b, b);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Point3 c = polygon[i] - origin;
    const double c_squared = dot(c, c);
    const Point3 triangle = cross(b, c);
    const Point3 sum = b + c;
    const double share = std::max(0.0, dot(triangle, normal));
    area = area + triangle;
    first = first + share * sum;
    second += share * (b_squared + c_squared + dot(sum, sum));
    weight += share;
    b = c;
    b_squared = c_squared;
  }
  const double scale = weight >= std::numeric_limits<double>::min() ? 1 / weight : 0;
  area = 0.5 * area;
  return {origin, area, length(area), scale / 3 * first, scale / 12 * second};
}

/// What the cells of two sites have in common within the region.
struct SharedFacet {
  std::array<VertexId, 2> sites;  ///< its normal leads from the first to the second
  FaceMeasures face;
  std::uint64_t crossed;  ///< sides of the region that it reaches over
  bool on_side;           ///< up to rounding
};

/// Sums over the faces of a cell.
struct Sums {
  bool begun = false;
  std::uint64_t crossed = 0;
  Point3 corner{};
  Moments<3> moments;

  void add(const FaceMeasures& face, const Point3& outward) {
    if (!begun) corner = face.corner;
    begun = true;
    const Point3 shift = face.corner - corner;
    moments.add_cone(outward, shift + face.centroid, dot(shift, shift + 2.0 * face.centroid) + face.square);
  }
};

/// The finite cells in an order in which neighbours are mostly near each other: along Hilbert's curve, each where its
/// first corner is.
std::vector<CellId> cells_along_curve(const AnyTriangulation& t, const Frame& frame) {
  const ConstComplexView<3> complex(t.complex());
  constexpr double kCellsPerBox = 4;
  const int bits =
      std::clamp(static_cast<int>(std::log2(static_cast<double>(t.cell_count()) / kCellsPerBox) / 3), 1, 8);
  const double boxes = std::ldexp(1.0, bits);
  std::vector<std::uint32_t> box(t.sites().size());  // of a site
  for (std::size_t s = 0; s < box.size(); ++s) {
    std::array<std::uint32_t, 3> x;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = frame.seen(t.sites().at(VertexId{static_cast<Index>(s)})[axis], axis) - frame.low[axis];
      x[axis] =
          static_cast<std::uint32_t>(std::clamp(at / (frame.high[axis] - frame.low[axis]) * boxes, 0.0, boxes - 1));
    }
    box[s] = static_cast<std::uint32_t>(HilbertCurve<3>::distance(x, bits));
  }
  const auto for_finite = [&](const auto& f) {
    for (std::size_t i = 0; i < complex.slot_count(); ++i) {
      const CellId c{static_cast<Index>(i)};
      if (complex.is_live(c) && !complex.is_ghost(c)) f(c, box[raw(complex.vertex(c, 0))]);
    }
  };
  std::vector<std::size_t> place((std::size_t{1} << 3 * bits) + 1);
  for_finite([&](CellId, std::uint32_t b) { ++place[b + 1]; });
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<CellId> order(place.back());
  for_finite([&](CellId c, std::uint32_t b) { order[place[b]++] = c; });
  return order;
}

class SpatialCells {
 public:
  SpatialCells(const AnyTriangulation& t, const Frame& frame, int threads, const Progress& progress);

  std::size_t size() const { return cells_.size(); }
  Sums& operator[](VertexId v) { return sums_[raw(v)]; }
  void prefetch(VertexId v) const {
    __builtin_prefetch(&sums_[raw(v)], 1);
    __builtin_prefetch(&sums_[raw(v)].moments, 1);
  }
  /// Is the cell bounded, and are all its corners near the region? Then it is measured by its faces. (Of a site that
  /// has no cell, nothing is known to the contrary.)
  bool is_placed(VertexId v) const { return kind_[raw(v)] != 0; }
  /// Do all its corners lie in the region?
  bool is_inside(VertexId v) const { return kind_[raw(v)] == kInside; }
  void give_up(VertexId v) { kind_[raw(v)] = 0; }

  /// Every facet belongs to the first cell around it: appends those of the cells `begin` to `end` at placed cells of
  /// the diagram, in order. From several threads at once when their ranges do not overlap.
  void read_facets(std::size_t begin, std::size_t end, std::vector<SharedFacet>& facets);

 private:
  static constexpr std::uint8_t kPlaced = 1;
  static constexpr std::uint8_t kInside = 3;

  struct Ring {
    Buffer<Index> cells;
    Polygon3 corners;
    FaceCutter cutter;
  };

  void find_placed();
  bool go_around(Index first, std::size_t edge, std::size_t end, Ring& ring);
  bool has_extent(const Buffer<Index>& ring) const;
  SharedFacet within_region(VertexId from, VertexId to, Ring& ring) const;

  const AnyTriangulation& t_;
  const Frame& frame_;
  Centres<3> compute_;
  std::vector<CellId> order_;
  Buffer<Tetrahedron> cells_;
  Buffer<std::uint8_t> edges_read_;  ///< per cell, a bit for each
  Buffer<std::uint8_t> kind_;        ///< per site
  Buffer<Sums> sums_;                ///< per site
};

SpatialCells::SpatialCells(const AnyTriangulation& t, const Frame& frame, int threads, const Progress& progress)
    : t_(t), frame_(frame), compute_(t, frame), order_(cells_along_curve(t, frame)), cells_(order_.size()) {
  const ConstComplexView<3> complex(t.complex());
  Buffer<Index> number;
  number.resize(complex.slot_count(), kNone);
  for (std::size_t i = 0; i < order_.size(); ++i) number[raw(order_[i])] = static_cast<Index>(i);
  const auto copy = [&](std::size_t begin, std::size_t end, std::size_t) {
    const ExactEnvironment environment;
    for (std::size_t i = begin; i < end; ++i) {
      complex.prefetch(order_[std::min(i + kAhead, end - 1)]);
      const CellId c = order_[i];
      Tetrahedron& cell = cells_[i];
      cell.vertex = complex.vertices(c);
      for (std::size_t slot = 0; slot < 4; ++slot) {
        const FacetId twin = complex.twin(c, static_cast<int>(slot));
        const Index other = number[raw(complex.cell(twin))];
        cell.twin[slot] = other == kNone ? kNone : 4 * other + static_cast<Index>(complex.slot(twin));
      }
      cell.centre = compute_.compute(c);
    }
  };
  for_chunks(cells_.size(), threads, copy, progress);
  edges_read_.resize(cells_.size(), 0);
  sums_.resize(t.sites().size(), Sums{});
  kind_.resize(t.sites().size(), kInside);
  find_placed();
}

void SpatialCells::find_placed() {
  constexpr std::size_t kMostSides = 64;  // that SharedFacet::crossed can tell
  const bool may_cross = frame_.sides.size() <= kMostSides;
  for (const Tetrahedron& cell : cells_) {
    const std::uint8_t kind = cell.centre.within ? kInside : cell.centre.near && may_cross ? kPlaced : 0;
    for (std::size_t slot = 0; slot < 4; ++slot) {
      const auto at_ghost = [&](std::size_t other) { return other != slot && cell.twin[other] == kNone; };
      const bool bounded = !(at_ghost(0) || at_ghost(1) || at_ghost(2) || at_ghost(3));
      kind_[raw(cell.vertex[slot])] &= bounded ? kind : 0;
    }
  }
}

void SpatialCells::read_facets(std::size_t begin, std::size_t end, std::vector<SharedFacet>& facets) {
  Ring ring;
  for (std::size_t i = begin; i < end; ++i) {
    for (const Index twin : cells_[std::min(i + kAhead, end - 1)].twin) {
      if (twin != kNone) __builtin_prefetch(cells_.data() + twin / 4);
    }
    while (edges_read_[i] != kAllEdges) {
      const auto edge = static_cast<std::size_t>(std::countr_one(edges_read_[i]));
      edges_read_[i] |= static_cast<std::uint8_t>(1U << edge);
      const VertexId from = cells_[i].vertex[kEdges[edge][0]];
      const VertexId to = cells_[i].vertex[kEdges[edge][1]];
      if (!is_placed(from) && !is_placed(to)) continue;
      if (go_around(static_cast<Index>(i), edge, end, ring) && has_extent(ring.cells))
        facets.push_back(within_region(from, to, ring));
    }
  }
}

/// The cells around an edge, as seen from its second corner counter-clockwise. Returns false where `first` is not the
/// first of them.
bool SpatialCells::go_around(Index first, std::size_t edge, std::size_t end, Ring& ring) {
  ring.cells.clear();
  ring.corners.clear();
  std::size_t back = kEdges[edge][2];
  std::size_t ahead = kEdges[edge][3];
  Index c = first;
  do {
    const Tetrahedron& cell = cells_[c];
    ring.cells.push_back(c);
    ring.corners.push_back(cell.centre.at);
    if (c < end) edges_read_[c] |= kOpposite[back][ahead];
    const Index across = cell.twin[back];
    const VertexId kept = cell.vertex[ahead];
    c = across / 4;
    if (c < first) return false;
    const std::array<VertexId, 4>& vertex = cells_[c].vertex;
    back = (vertex[1] == kept ? 1U : 0U) + (vertex[2] == kept ? 2U : 0U) + (vertex[3] == kept ? 3U : 0U);
    ahead = across % 4;
  } while (c != first);
  return true;
}

/// At least three places that follow each other around the edge are not the same.
bool SpatialCells::has_extent(const Buffer<Index>& ring) const {
  int distinct = 0;
  for (std::size_t i = 0; i < ring.size() && distinct < 3; ++i) {
    const Tetrahedron& c = cells_[ring[i]];
    const Tetrahedron& d = cells_[ring[i + 1 == ring.size() ? 0 : i + 1]];
    bool same = !Centres<3>::differ(c.centre, d.centre);
    if (same) {
      const auto apex =
          std::ranges::find_if(d.vertex, [&](VertexId v) { return std::ranges::find(c.vertex, v) == c.vertex.end(); });
      same = compute_.coincide(c.centre, d.centre, order_[ring[i]], *apex);
    }
    distinct += same ? 0 : 1;
  }
  return distinct == 3;
}

SharedFacet SpatialCells::within_region(VertexId from, VertexId to, Ring& ring) const {
  const Point3 along = direction(t_.sites(), frame_, from, to);
  if (is_inside(from) && is_inside(to)) return {{from, to}, measured(ring.corners, along), 0, false};
  SharedFacet facet{{from, to}, {}, 0, false};
  ring.cutter.begin(ring.corners);
  for (std::size_t side = 0; side < frame_.sides.size(); ++side) {
    double least = std::numeric_limits<double>::infinity();
    double largest = -least;
    for (const Point3& x : ring.corners) {
      const double over = dot(frame_.sides[side].normal, x) - frame_.sides[side].offset;
      least = std::min(least, over);
      largest = std::max(largest, over);
    }
    facet.on_side = facet.on_side || std::max(-least, largest) < 0x1p-44 * frame_.radius;
    if (largest <= 0) continue;
    facet.crossed |= std::uint64_t{1} << side;
    ring.cutter.cut(frame_.sides[side]);
  }
  const Polygon3& corners = facet.crossed == 0 ? ring.corners : ring.cutter.end(kNarrow * frame_.radius);
  if (!corners.empty()) facet.face = measured(corners, along);
  return facet;
}

/// What the sides of the region that a cell reaches over bound of it.
class SideFaces {
 public:
  SideFaces(const AnyTriangulation& t, const Frame& frame) : t_(t), frame_(frame) {}

  /// @param neighbours  rows, also those beyond facets that lie outside the region
  void add_to(Sums& sums, double& boundary, VertexId v, std::span<const Index> neighbours) {
    const Sites& sites = t_.sites();
    planes_.clear();
    sites.copy_point(v, at_);
    for (const Index row : neighbours) {
      const VertexId other = sites.vertex(row);
      sites.copy_point(other, other_at_);
      planes_.push_back(bisector(at_, sites.weight(v), other_at_, sites.weight(other), frame_, frame_.middle, row));
    }
    for (std::uint64_t crossed = sums.crossed; crossed != 0; crossed &= crossed - 1) {
      const auto side = static_cast<std::size_t>(std::countr_zero(crossed));
      cutter_.begin(frame_.faces[side]);
      for (const Plane& plane : planes_) cutter_.cut(plane);
      const Polygon3& corners = cutter_.end(kNarrow * frame_.radius);
      if (corners.empty()) continue;
      const FaceMeasures face = measured(corners, frame_.sides[side].normal);
      sums.add(face, face.area);
      boundary += frame_.enlarged(face.size, 2);
    }
  }

 private:
  const AnyTriangulation& t_;
  const Frame& frame_;
  std::array<double, 3> at_, other_at_;
  std::vector<Plane> planes_;
  FaceCutter cutter_;
};

}  // namespace

/// Facets are read side by side, and added one after the other, so that no sum depends on the number of threads.
std::vector<VertexId> measure_in_space(const AnyTriangulation& t, const Frame& frame, const ClipOptions& options,
                                       MeasureTable& table) {
  const Sites& sites = t.sites();
  SpatialCells cells(t, frame, options.threads, part_of(options.progress, 0, 0.5));
  const Progress progress = part_of(options.progress, 0.5, 1);
  const auto add_side = [&](const SharedFacet& facet, VertexId v, VertexId other, const Point3& outward) {
    if (facet.on_side && !cells.is_inside(v)) cells.give_up(v);
    if (!cells.is_placed(v)) return;
    Sums& sums = cells[v];
    sums.crossed |= facet.crossed;
    if (facet.face.size > 0) sums.add(facet.face, outward);
    table.add_neighbour(table[v], other, frame.enlarged(facet.face.size, 2));
  };
  const std::size_t at_once = options.threads > 1 ? 8 * static_cast<std::size_t>(options.threads) : 1;
  std::vector<std::vector<SharedFacet>> facets(at_once);
  for (std::size_t done = 0; done < cells.size(); done += at_once * kChunk) {
    tell(progress, done, cells.size());
    for_chunks(std::min(cells.size() - done, at_once * kChunk), options.threads,
               [&](std::size_t begin, std::size_t end, std::size_t i) {
                 const ExactEnvironment environment;
                 cells.read_facets(done + begin, done + end, facets[i]);
               });
    for (auto& some : facets) {
      for (std::size_t i = 0; i < some.size(); ++i) {
        for (const VertexId v : some[std::min(i + kAhead, some.size() - 1)].sites) {
          cells.prefetch(v);
          __builtin_prefetch(&table[v], 1);
        }
        const SharedFacet& facet = some[i];
        add_side(facet, facet.sites[0], facet.sites[1], facet.face.area);
        add_side(facet, facet.sites[1], facet.sites[0], -1.0 * facet.face.area);
      }
      some.clear();
    }
  }
  std::vector<VertexId> others;
  SideFaces side_faces(t, frame);
  for (std::size_t s = 0; s < sites.size(); ++s) {
    const VertexId v{static_cast<Index>(s)};
    if (sites.is_empty(v)) continue;
    Sums& sums = cells[v];
    MeasureTable::Line& line = table[v];
    if (!cells.is_placed(v) || t.complex().incident_cell(v) == kNoCell) {
      line.count = 0;
      others.push_back(v);
      continue;
    }
    if (sums.crossed != 0) side_faces.add_to(sums, line.boundary, v, table.neighbours(line));
    table.put(v, sums.moments, sums.corner, frame);
  }
  return others;
}

}  // namespace delone::dual_detail
