// Buckets in a quaternary tree, 2^D-ary in dimension D: every node knows one vertex below it, so a query goes down as
// far as there are vertices and takes what the last node knows. Source: [OIM84], as told in [For92] 4.3: a hierarchy of
// grids keeps a start for the walk near wherever points are. Departure from [OIM84]: the points are not known before,
// so the tree is not of one depth: a bucket that holds more than `capacity` vertices is divided. The order of insertion
// is the caller's; [OIM84] also takes it from the tree.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delone/locate/locator.hpp"

namespace delone {

/// Survives inserts and removes, follows clusters. A hint and an edit cost the depth of the tree, at most 32, which is
/// about log2(n) / D for evenly spread points. Memory: three ids a vertex, and the nodes.
class QuadBuckets {
 public:
  std::size_t capacity =
      8;  ///< vertices of a bucket; at least 2^(D-1) are taken, so that nodes stay fewer than vertices

  CellId hint(const AnyTriangulation& t, std::span<const double> q);
  void update(const AnyTriangulation& t, const Edit& e) noexcept;

  std::size_t node_count() const { return nodes_.size(); }
  const LocateCounts& counts() const { return counts_; }
  std::size_t memory_bytes() const;

 private:
  /// Fractions of the root's side in units of 2^-32: bit 31 - l chooses the side on level l.
  using Key = std::array<std::uint32_t, kMaxDimension>;

  struct Node {
    Index children = kNone;  ///< the first of 2^D in a row; kNone for a bucket
    Index parent = kNone;
    VertexId label = kGhost;  ///< a vertex below; of a bucket the first of its list
    Index size = 0;           ///< vertices of a bucket
    int level = 0;
  };

  void rehash(const AnyTriangulation& t);
  Key key_of(std::span<const double> q) const;
  bool outside(std::span<const double> q) const;
  Index child_towards(Index node, const Key& key) const;
  void enter(const AnyTriangulation& t, VertexId v);
  void push(Index node, VertexId v);
  void divide(const AnyTriangulation& t, Index node);
  void leave(VertexId v);
  void forget();
  std::size_t fan() const { return std::size_t{1} << dimension_; }

  std::size_t dimension_ = 0;
  std::array<double, kMaxDimension> low_{};  // of the root, halved
  double side_ = 0.0;                        // of the root, halved
  std::vector<Node> nodes_;                  // the root first
  std::vector<VertexId> next_, previous_;    // of each vertex in the list of its bucket
  std::vector<Index> node_of_;               // of each vertex, kNone when it is in none
  std::size_t size_ = 0, size_at_rehash_ = 0, outside_ = 0;
  LocateCounts counts_;
};

}  // namespace delone
