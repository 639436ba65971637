// The nearest site of any point of the plane, from a Voronoi diagram that keeps all its versions.
// Source: [GKS92] section 5.
//
// Sites are inserted in random order. Each Voronoi region is cut into triangles by segments from its site to its
// vertices, and every triangle that ever was is kept, with what became of it. A query follows the triangles that hold
// it from the first version to the last.
//
//   sector   a triangle of site i from the day it came: based on the bisector of i and a neighbour k, between the rays
//            from i through two Voronoi vertices
//   plane    the sectors of a site by angle, so that a query finds its own by binary search
//   beyond   the base of a sector lie the new triangles of k's region: across it a whole one, and towards the next and
//            the previous sector what remains of two others
//   fate     what became of a triangle: where a later site cut it off, that site's sector on the bisector of the two
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"
#include "delone/geometry/voronoi_predicates.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone {

/// What queries have cost.
struct RadialSteps {
  std::uint64_t triangles = 0;  ///< radial triangles visited, over all versions of the diagram
  std::uint64_t rays = 0;       ///< comparisons of the query with the ray from a site through a Voronoi vertex
  std::uint64_t bisectors = 0;  ///< comparisons with the bisector of two sites
  std::uint64_t passed = 0;     ///< sectors that a search one by one, from the bisector that led to a plane, would pass
};

/// A point-location structure beside a triangulation: it copies what it needs, so the triangulation may change or die.
/// It does not follow insertions and removals; build it anew.
///
/// Every decision is exact. Const calls may run from many threads at once. With n sites, over the random order alone:
/// expected size O(n) and expected query cost O(log^2 n) for every point of the plane, however the sites lie.
/// Sites on one line have no Voronoi vertices: they are kept in their order on it, and searched by binary search.
class RadialVoronoi {
 public:
  /// @param seed  decides the order of insertion, together with the rows of `t`; never an answer
  /// @throws InputError unless `t` is a triangulation of the plane without weights; std::bad_alloc
  /// Cost: O(n log^2 n) expected.
  explicit RadialVoronoi(const AnyTriangulation& t, std::uint64_t seed = 0);

  /// The row of a nearest site, of several the lowest; kNone without sites.
  /// @throws InputError unless `q` is two finite coordinates
  /// Cost: O(log^2 n) expected, and O(m) more where m > 1 sites are nearest.
  Index nearest(std::span<const double> q) const;
  /// Adds to `steps` what the query cost.
  Index nearest(std::span<const double> q, RadialSteps& steps) const;

  /// Distinct sites.
  std::size_t site_count() const { return mesh_.sites.size(); }
  /// Radial triangles that ever were; none on a line.
  std::size_t triangle_count() const { return triangle_count_; }
  std::size_t memory_bytes() const;

 private:
  /// What became of a radial triangle.
  class Fate {
   public:
    /// It is in the final diagram, and stands for the half-edge `f` of the triangulation, which starts at its site.
    static Fate alive(FacetId f) { return Fate(raw(f) | kAlive); }
    /// A later site destroyed it, whose sector on the bisector of the two sites this is.
    static Fate cut_by(Index sector) { return Fate(sector); }
    static constexpr Index kNames = kNone / 2;  ///< sectors and half-edges lie below

    Fate() = default;
    bool is_alive() const { return (bits_ & kAlive) != 0; }
    FacetId half_edge() const { return FacetId{bits_ & ~kAlive}; }
    Index sector() const { return bits_; }

   private:
    static constexpr Index kAlive = ~(kNone >> 1);
    explicit Fate(Index bits) : bits_(bits) {}
    Index bits_;
  };

  /// The radial triangles at the bisector of `site` and `neighbour` when `site` came.
  enum class Part : std::uint8_t { inside, towards_next, across, towards_previous };

  struct Sector {
    VertexId site, neighbour;   ///< the neighbour is the ghost between the two rays to infinity of a hull vertex
    std::array<Fate, 4> fates;  ///< by Part; only inside has one when the neighbour is the ghost
  };
  /// The sectors of a site from the first whose first ray leads up, or along the x axis, to the next plane's.
  struct Plane {
    Index first;
    Index lower;  ///< the first sector whose first ray leads down, or against the x axis
  };
  struct Triangle {
    Index sector;
    Part part;
  };
  class Builder;

  void keep_in_order(const AnyTriangulation& t);
  Index nearest_on_line(Point2 q, RadialSteps& steps) const;
  Index lowest_nearest(Triangle at, Point2 q, RadialSteps& steps) const;

  Point2 point(VertexId v) const;
  Fate fate(Triangle at) const { return sectors_[at.sector].fates[static_cast<std::size_t>(at.part)]; }
  Index next(Index sector) const;
  Index previous(Index sector) const;
  VertexId site(Triangle at) const;
  VertexId base(Triangle at) const;

  int side_of_ray(VertexId o, VertexId a, VertexId b, Heading d) const;
  Triangle first_triangle(Point2 q, RadialSteps& steps) const;
  Triangle last_triangle(Point2 q, RadialSteps& steps) const;
  Index sector_towards(VertexId o, Point2 q, RadialSteps& steps) const;
  Part part_beyond(Index sector, VertexId old_base, Point2 q, RadialSteps& steps) const;
  std::size_t distance(Index sector, Index other) const;

  Mesh mesh_;  // the sites in the order of insertion, and their Delaunay triangulation
  Buffer<Sector> sectors_;
  Buffer<Plane> planes_;  // by site, and one behind the last
  std::size_t triangle_count_ = 0;
};

}  // namespace delone
