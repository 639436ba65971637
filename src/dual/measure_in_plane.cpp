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
#include "dual/stars.hpp"

namespace delone::dual_detail {
namespace {

constexpr std::size_t kAhead = 8;  // so many sites ahead memory is asked for

using Place = std::array<double, 2>;

class PlanarCells {
 public:
  PlanarCells(const AnyTriangulation& t, const Frame& frame)
      : complex_(t.complex()), frame_(frame), centres_(t, frame), reader_(t, &centres_) {}

  /// Returns whether the cell of a site lies in the region; else nothing is measured.
  bool measure(VertexId v, MeasureTable& table) {
    if (complex_.incident_cell(v) == kNoCell) return false;
    edges_.clear();
    const auto add_edge = [&](const StarCell& c, VertexId neighbour, bool has_extent) {
      if (has_extent) edges_.push_back({{c.centre.at[0], c.centre.at[1]}, neighbour});
      return !c.ghost && c.centre.within;
    };
    if (!reader_.turn_in_plane(v, add_edge)) return false;
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

  const Complex& complex_;
  const Frame& frame_;
  Centres<2> centres_;
  StarReader<2> reader_;
  Buffer<Edge> edges_;  // counter-clockwise
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
