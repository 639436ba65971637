// Polygons are measured site by site: one turn about a site, with the centres around it at hand, is cheaper than to
// remember what its neighbours found.
#include <algorithm>
#include <array>
#include <cstddef>

#include "base/chunks.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/buffer.hpp"
#include "dual/centres.hpp"
#include "dual/measure.hpp"
#include "dual/measure_directly.hpp"
#include "dual/polytope.hpp"

namespace delone::dual_detail {
namespace {

constexpr std::size_t kAhead = 8;  // so many sites ahead memory is asked for

using Place = std::array<double, 2>;

class PlanarCells {
 public:
  PlanarCells(const AnyTriangulation& t, const Frame& frame)
      : frame_(frame), complex_(t.complex()), centres_(t, frame) {}

  /// Returns whether the cell of a site lies in the region; else nothing is measured.
  bool measure(VertexId v, MeasureTable& table) {
    if (!turn_about(v)) return false;
    MeasureTable::Line& line = table[v];
    const Place first = edges_[0].begin;
    Moments<2> moments;
    Place a{};
    double a_squared = 0;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Place& end = edges_[i + 1 == edges_.size() ? 0 : i + 1].begin;
      const Place edge = end - edges_[i].begin;  // as long from both sides
      const Place b = end - first;
      const double b_squared = dot(b, b);
      moments.add_simplex(a[0] * edge[1] - a[1] * edge[0], a + b, a_squared + b_squared);
      table.add_neighbour(line, edges_[i].neighbour, frame_.enlarged(length(edge), 1));
      a = b;
      a_squared = b_squared;
    }
    table.put(v, moments, first, frame_);
    return true;
  }

 private:
  struct Edge {
    Place begin;
    VertexId neighbour;
  };

  /// Reads the edges of a cell, counter-clockwise, as StarReader does; returns false where it does not lie in the
  /// region.
  bool turn_about(VertexId v) {
    edges_.clear();
    const CellId start = complex_.incident_cell(v);
    if (start == kNoCell || complex_.is_ghost(start)) return false;
    CellId c = start;
    Centre centre = centres_[c];
    do {
      const int slot = complex_.slot_of(c, v);
      const FacetId across = complex_.twin(c, complex_.turned(slot, 1));
      const CellId next = complex_.cell(across);
      if (complex_.is_ghost(next) || !centre.within) return false;
      const Centre next_centre = centres_[next];
      if (!centres_.coincide(centre, next_centre, c, complex_.vertex(across)))
        edges_.push_back({{centre.at[0], centre.at[1]}, complex_.vertex(c, complex_.turned(slot, 2))});
      c = next;
      centre = next_centre;
    } while (c != start);
    return true;
  }

  const Frame& frame_;
  ConstComplexView<2> complex_;
  Centres<2> centres_;
  Buffer<Edge> edges_;
};

}  // namespace

std::vector<VertexId> measure_in_plane(const AnyTriangulation& t, const Frame& frame, const ClipOptions& options,
                                       MeasureTable& table) {
  // So many at once that what is remembered of centres pays, and so few that all threads have work.
  const auto share = t.sites().size() / (4 * static_cast<std::size_t>(std::max(options.threads, 1)));
  const std::size_t at_once = std::clamp(share, kChunk, 8 * kChunk);
  std::vector<std::vector<VertexId>> others((t.sites().size() + at_once - 1) / at_once);
  const auto work = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    const ExactEnvironment environment;
    PlanarCells cells(t, frame);
    for (std::size_t s = begin; s < end; ++s) {
      const VertexId v{static_cast<Index>(s)};
      table.prefetch(VertexId{static_cast<Index>(std::min(s + kAhead, end - 1))});
      if (!t.sites().is_empty(v) && !cells.measure(v, table)) others[chunk].push_back(v);
    }
  };
  for_chunks(t.sites().size(), options.threads, work, options.progress, at_once);
  std::vector<VertexId> all;
  for (const auto& some : others) all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace delone::dual_detail
