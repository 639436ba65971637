// Jump and walk: of a small random sample of the vertices the nearest one to the query.
// Source: [MSZ96], as described in [Dev97] 1 and 4.5: alpha * n^(1/3) vertices in the plane, each with a link to a
// cell. In dimension D the sample and the walk balance at n^(1/(D+1)). Departure from [MSZ96]: the sample is kept from
// query to query and follows edits, its coordinates beside each other; members are drawn with replacement.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delone/locate/locator.hpp"

namespace delone {

/// Survives inserts and removes. A hint costs alpha * n^(1/(D+1)) distances; an edit O(1), and the length of the sample
/// for each vertex that is gone.
class JumpAndWalk {
 public:
  double alpha = 1.0;      ///< 0.5 to 1 is best in the plane [Dev97] 4.5
  std::uint64_t seed = 1;  ///< the same seed and the same edits give the same hints

  CellId hint(const AnyTriangulation& t, std::span<const double> q);
  void update(const AnyTriangulation& t, const Edit& e) noexcept;

  /// The vertex of the sample that is nearest to q, the ghost when the sample is empty.
  VertexId nearest(std::span<const double> q);

  std::span<const VertexId> sample() const { return sample_; }
  /// How large the sample of n vertices shall be.
  std::size_t size_for(std::size_t n, int dimension) const;
  const LocateCounts& counts() const { return counts_; }
  std::size_t memory_bytes() const;

 private:
  std::uint64_t random();
  VertexId random_vertex(const AnyTriangulation& t);
  void add(const AnyTriangulation& t, VertexId v);
  void replace(const AnyTriangulation& t, std::size_t place, VertexId v);
  void drop(std::size_t place);
  void keep_size(const AnyTriangulation& t);
  void forget();

  std::size_t dimension_ = 0;
  std::vector<VertexId> sample_;
  std::vector<double> coordinates_;  // of the sample, row-major
  std::uint64_t drawn_ = 0;
  LocateCounts counts_;
};

}  // namespace delone
