// A uniform grid of buckets, about one vertex in each: the walk starts at a vertex in the nearest bucket that has one.
// Source: [For92] 4.3 ("subdivide space with a regular grid ... start at an already inserted site lying in the same or
// a nearby grid cell"). Departure from [For92] 4.3: the points are not known before, so the grid is made again when
// their number has doubled or too many lie outside its box; until then those count to the buckets at its border.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delone/locate/locator.hpp"

namespace delone {

/// Survives inserts and removes. A hint costs O(1) for evenly spread points, an edit O(1) on average. Memory: three ids
/// a vertex and one a bucket. Clustered points crowd into few buckets: see QuadBuckets.
class Grid {
 public:
  double per_bucket = 1.0;  ///< vertices
  std::size_t max_buckets = std::size_t{1} << 24;
  std::size_t max_visits = 1000;  ///< buckets that a hint looks at; then it takes the newest vertex
  std::size_t max_distances = 8;  ///< vertices of one bucket that a hint looks at

  CellId hint(const AnyTriangulation& t, std::span<const double> q);
  void update(const AnyTriangulation& t, const Edit& e) noexcept;

  std::size_t bucket_count() const { return first_.size(); }
  const LocateCounts& counts() const { return counts_; }
  std::size_t memory_bytes() const;

 private:
  using Place = std::array<std::int64_t, kMaxDimension>;

  void rehash(const AnyTriangulation& t);
  void choose_buckets(std::size_t vertices);
  Place place_of(std::span<const double> q) const;
  bool outside(std::span<const double> q) const;
  std::size_t bucket_at(const Place& place) const;
  VertexId search(const AnyTriangulation& t, std::span<const double> q);
  void enter(const AnyTriangulation& t, VertexId v);
  void leave(VertexId v);
  void forget();

  std::size_t dimension_ = 0;
  std::array<double, kMaxDimension> low_{}, high_{};  // halved, so that their difference is finite
  Place count_{};                                     // of buckets on each axis
  std::vector<VertexId> first_;                       // of each bucket's list
  std::vector<VertexId> next_, previous_;             // of each vertex
  std::vector<Index> bucket_;                         // of each vertex, kNone when it is in none
  VertexId newest_ = kGhost;
  std::size_t size_ = 0, size_at_rehash_ = 0, outside_ = 0;
  LocateCounts counts_;
};

}  // namespace delone
