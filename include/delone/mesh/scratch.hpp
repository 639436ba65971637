// Working memory of an insertion, kept from one to the next so that nothing is allocated after warm-up.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/territory.hpp"

namespace delone {

/// In 3D: the vertices of a cavity by numbers, in the order in which the search came to them. One that it came to again
/// got another number, which then counts.
struct CavityNumbers {
  Buffer<Index> number;  ///< per vertex + 1, the ghost at 0; means something for vertices of the cavity

  Index& of(VertexId v) { return number.data()[static_cast<Index>(raw(v) + 1)]; }
  /// Numbers 0 to 2: vertices 1 to 3 of the cell that the search starts from.
  void begin(const std::array<VertexId, 4>& start) {
    for (std::size_t i = 1; i < 4; ++i) of(start[i]) = static_cast<Index>(i - 1);
  }
  /// Each cell, the first one too, adds one vertex: opposite the facet by which the search entered it.
  void add(VertexId v, std::size_t cells_before) { of(v) = static_cast<Index>(cells_before + 3); }
};

/// In 3D: the facets of a new star by the directed edges of the cavity's boundary.
struct EdgeTable {
  static constexpr std::size_t kNumbers = 64;  ///< larger stars are linked by turning

  std::array<FacetId, kNumbers * kNumbers> facets;
  std::array<std::array<Index, 3>, 2 * kNumbers> twin_places;  ///< per new cell, of its three inner facets

  static Index place(Index from, Index to) { return from * Index{kNumbers} + to; }
};

/// What a removal plans: the hole, and the cells that will fill it.
struct Hole {
  Buffer<CellId> gone;                      ///< the star, and so the hole
  Buffer<FacetId> outside;                  ///< per cell of it the facet beyond the one opposite the vertex
  Buffer<VertexId> link;                    ///< finite vertices of the star
  Buffer<VertexId> asked;                   ///< hidden sites of the star, by ascending row
  Buffer<VertexId> revived;                 ///< those of them that will be vertices
  Buffer<std::array<VertexId, 2>> repeats;  ///< those that will repeat another one, and which
  Buffer<CellId> made;                      ///< the cells that will fill the hole
  Buffer<Index> cells;                      ///< per cell of these its vertices, then its twins
  Buffer<Index> closed;                     ///< per facet of `outside` its new twin
  Buffer<Index> star;                       ///< what the cells that go hold, in the same form, if they may come back
  Buffer<Index> open;                       ///< facets on which no new cell stands yet
  Buffer<Index> table;                      ///< of a FacetTable

  void clear() {
    for (auto* buffer : {&link, &asked, &revived}) buffer->clear();
    repeats.clear();
    made.clear();
    for (auto* buffer : {&cells, &star, &open}) buffer->clear();
  }
  std::size_t memory_bytes() const {
    return (gone.capacity() + made.capacity()) * sizeof(CellId) + outside.capacity() * sizeof(FacetId) +
           (link.capacity() + asked.capacity() + revived.capacity() + 2 * repeats.capacity()) * sizeof(VertexId) +
           (cells.capacity() + closed.capacity() + star.capacity() + open.capacity() + table.capacity()) *
               sizeof(Index);
  }
};

/// In the plane, an edge that a search has still to cross, seen from beyond, with what the query sees of its ends.
struct Front {
  FacetId outside;
  Ray left, right;
  double turn;  ///< from left to right
};

/// Above 3D: how the hyperplanes of the cells at a facet of the cavity's boundary see the new vertex.
struct FacetSights {
  Sight inside, outside;
};

/// Above 3D: the facets of a new star by the ridges of the cavity's boundary, each of which two of them share.
struct RidgeTable {
  static constexpr std::size_t kWidth = 4;
  struct Bucket {
    std::array<std::uint32_t, kWidth> keys;  ///< 0 behind the last one
    std::array<FacetId, kWidth> facets;      ///< the last ones met
  };
  Buffer<Bucket> buckets;  ///< a power of two of them

  /// For as many facets; no more than half of the places will be taken.
  void reserve(std::size_t facets) { buckets.resize(std::bit_ceil(facets) / kWidth); }
  std::size_t memory_bytes() const { return buckets.capacity() * sizeof(Bucket); }
};

struct Scratch {
  // A type of its own, not a character type: a store of one may change no other number, and the compiler knows.
  enum class Mark : std::uint8_t { none, conflicting };

  Territory territory;         ///< what an insertion may change
  Buffer<Mark> marks;          ///< per cell slot; all `none` between insertions
  Buffer<FacetId> cavity;      ///< of every cell in conflict a facet: the one that the search entered it by
  Buffer<Front> fronts;        ///< of a search in depth
  Buffer<FacetId> boundary;    ///< facets between the cavity and what stays, seen from inside
  Buffer<CellId> created;      ///< the star, in the order of `boundary`
  Buffer<VertexId> swallowed;  ///< vertices whose whole star lay in the cavity, with weights
  Buffer<VertexId> displaced;  ///< hidden sites of cells that go, where they are known
  Buffer<CellId> removed;      ///< the cells of the cavity, when somebody asked for them
  CavityNumbers numbers;
  Buffer<EdgeTable> edges;  ///< one in 3D, else none: it is large, and a mesh is moved
  RidgeTable ridges;
  Hole hole;
  Buffer<std::byte> planes;     ///< above 3D, per cell slot a Hyperplane; zero where it is not known
  Buffer<Sight> inside_sights;  ///< above 3D, how those of the cavity see the new vertex
  Buffer<FacetSights> sights;   ///< and those of the two cells at each facet of `boundary`

  /// Of the hyperplane of a cell of dimension k; none are kept where a test from coordinates is as fast.
  static constexpr std::size_t plane_size(int k) {
    return k <= 3 ? 0 : (static_cast<std::size_t>(k) + (sizeof(VertexId) <= 4 ? 2 : 3)) * sizeof(double);
  }
  template <int K>
  Hyperplane<K>& plane(CellId c) {
    static_assert(sizeof(Hyperplane<K>) == plane_size(K));
    return *reinterpret_cast<Hyperplane<K>*>(planes.data() + raw(c) * plane_size(K));
  }
  /// Marks and hyperplanes for cells below `slots`.
  void reserve_cells(int k, std::size_t slots) {
    if (slots <= marks.size()) return;
    marks.reserve_more(slots - marks.size());
    slots = std::min(with_spare(slots), marks.capacity());
    planes.reserve_more((slots - marks.size()) * plane_size(k));
    planes.resize(slots * plane_size(k), std::byte{0});
    marks.resize(slots, Mark::none);
  }
  /// Room for what reserve_cells() will make for as many.
  void expect_cells(int k, std::size_t slots) {
    marks.reserve(with_spare(slots));
    planes.reserve(with_spare(slots) * plane_size(k));
  }
  /// Some more, but few: fresh memory takes its time when it is first written.
  static constexpr std::size_t with_spare(std::size_t slots) { return slots + slots / 16; }
  /// For searches among vertices below `vertices`.
  void reserve_vertices(int k, std::size_t vertices) {
    if (k != 3) return;
    edges.resize(1);
    if (numbers.number.size() <= vertices) numbers.number.resize(vertices + vertices / 2 + 1);
  }
  /// Room for a star beside the cavity just found, all in cells below `slots`, and for telling of both.
  void prepare_star(int dimension, std::size_t slots) {
    created.resize(boundary.size());
    removed.reserve(cavity.size());
    if (dimension > 3) ridges.reserve(boundary.size() * static_cast<std::size_t>(dimension));
    reserve_cells(dimension, slots);
  }
  std::size_t memory_bytes() const {
    return hole.memory_bytes() + marks.capacity() + numbers.number.capacity() * sizeof(Index) +
           edges.capacity() * sizeof(EdgeTable) + planes.capacity() + inside_sights.capacity() * sizeof(Sight) +
           sights.capacity() * sizeof(FacetSights) + ridges.memory_bytes() + fronts.capacity() * sizeof(Front) +
           (cavity.capacity() + boundary.capacity()) * sizeof(FacetId) +
           (swallowed.capacity() + displaced.capacity()) * sizeof(VertexId) +
           (created.capacity() + removed.capacity()) * sizeof(CellId);
  }
};

}  // namespace delone
