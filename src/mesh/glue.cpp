// Why it works. Call a cell of one part safe when no site of the other part is in conflict with it. Safe cells are
// cells of the whole triangulation, ghost cells too. What they leave open is filled by cells that have sites of both
// parts or whose own part was right about them: all have only sites of cells that are not safe, since at each of their
// sites some cell gave way. So they are cells of the triangulation of these few sites, the seam: nothing is nearer in
// it, and heights are perturbed alike. The facets between safe cells and others are facets of the seam, too, so its
// cells on the other side of them are exactly the filling. The same holds if some safe cells are taken for unsafe ones.
//
// Departure from the usual merge of divide and conquer, which knits along the border and is known in the plane only:
// the seam is triangulated by any method at all.
#include "mesh/glue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "base/both.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/mesh/facet_table.hpp"
#include "delone/mesh/walk.hpp"
#include "mesh/triangulate.hpp"

namespace delone {
namespace {

/// What is known of all sites of a part.
template <int K>
struct Box {
  std::array<double, K> low, high;  // on the leading axes
  double heaviest;

  explicit Box(const Sites& sites) {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    const double* x = sites.leading();
    for (std::size_t i = 0; i < sites.size(); ++i) {
      for (std::size_t j = 0; j < K; ++j, ++x) {
        low[j] = std::min(low[j], *x);
        high[j] = std::max(high[j], *x);
      }
    }
    heaviest = sites.weighted() ? *std::max_element(sites.weights(), sites.weights() + sites.size()) : 0.0;
  }
};

/// The cells of a part that a site in a box beside it may be in conflict with.
template <int K>
class Reach {
 public:
  Reach(const Mesh& mesh, const Box<K>& box, const NumberRange& range)
      : sites_(&mesh.sites), complex_(mesh.complex), kernel_(mesh.sites, range), box_(box) {
    tested_.resize(complex_.slot_count(), false);
    WalkStats walked;  // the corner of the box lies outside the hull
    add(walk(complex_, kernel_, box.low.data(), complex_.incident_cell(kGhost), walked));
    for (std::size_t next = 0; next < cells_.size(); ++next) {  // for all places in the box they hang together
      for (int i = 0; i <= K; ++i) {
        const CellId c = complex_.cell(complex_.twin(cells_[next], i));
        if (!tested_[raw(c)] && reaches(c)) add(c);
        tested_[raw(c)] = true;
      }
    }
  }

  const std::vector<CellId>& cells() const { return cells_; }

 private:
  void add(CellId c) {
    cells_.push_back(c);
    tested_[raw(c)] = true;
  }
  /// Whether normal . d + height * l <= 0 for some d in the box, as far as doubles can tell: a sum over the axes, each
  /// of which has its least value at one place. Coordinates beyond the leading ones only raise l.
  bool reaches(CellId c) const {
    constexpr double kRoundings = 0x1p-40;  // far more than the sums below round
    const Hyperplane<K> plane = kernel_.hyperplane(complex_.vertices(c));
    if (plane.tilt_error == 0.0) return true;  // nothing is known
    const auto height = static_cast<double>(plane.height);
    double value = height * (sites_->weight(plane.origin) - box_.heaviest);
    double size = std::abs(value);
    for (std::size_t j = 0; j < K; ++j) {
      const double normal = plane.normal[j];
      const double low = box_.low[j] - kernel_.at(plane.origin)[j];
      const double high = box_.high[j] - kernel_.at(plane.origin)[j];
      const double downhill = normal > 0.0 ? low : high;
      const double least = height > 0.0 ? std::clamp(-0.5 * normal, low, high) : downhill;
      const double farthest = std::max(std::abs(low), std::abs(high));
      value += (normal + height * least) * least - plane.tilt_error * farthest;
      size += (std::abs(normal) + height * farthest) * farthest;
    }
    return !(value > kRoundings * size);
  }

  const Sites* sites_;
  ConstComplexView<K> complex_;
  Kernel<K> kernel_;
  Box<K> box_;
  std::vector<bool> tested_;
  std::vector<CellId> cells_;
};

/// The cells of a part that are not safe, as far as is known, and their sites, ascending.
struct Border {
  std::vector<CellId> cells;
  std::vector<VertexId> sites;

  /// Those of a part whose cells and sites are counted on from some number.
  void add(const Border& other, Index cells_before, Index sites_before) {
    for (const CellId c : other.cells) cells.push_back(CellId{raw(c) + cells_before});
    for (const VertexId v : other.sites) sites.push_back(VertexId{raw(v) + sites_before});
  }
};

template <int K>
Border border_of(const Mesh& mesh, const Box<K>& other, const NumberRange& range) {
  Border border{Reach<K>(mesh, other, range).cells(), {}};
  std::vector<bool> listed(mesh.complex.vertex_slots(), false);
  for (const CellId c : border.cells) {
    for (const VertexId v : ConstComplexView<K>(mesh.complex).vertices(c)) {
      if (v == kGhost || listed[raw(v)]) continue;
      listed[raw(v)] = true;
      border.sites.push_back(v);
    }
  }
  std::ranges::sort(border.sites);
  return border;
}

/// Of each of two meshes the cells that the other one's sites may be in conflict with.
template <int K>
std::array<Border, 2> borders(const Mesh& a, const Mesh& b, int threads) {
  NumberRange range = a.sites.range();
  range.include(b.sites.range());
  std::array<Border, 2> found;
  both(
      threads, [&] { found[0] = border_of<K>(a, Box<K>(b.sites), range); },
      [&] { found[1] = border_of<K>(b, Box<K>(a.sites), range); });
  return found;
}

/// Two parts side by side in one mesh, and what lies open between them.
template <int K>
class Gap {
 public:
  /// @param border  of both parts
  /// @param second  the first site of the second part
  Gap(Mesh& mesh, const Border& border, VertexId second)
      : mesh_(&mesh), complex_(mesh.complex), border_(&border), second_(second), rim_(words_, border.cells.size()) {
    std::vector<bool> is_open(complex_.slot_count(), false);
    for (const CellId c : border.cells) is_open[raw(c)] = true;
    for (const CellId c : border.cells) {
      for (int i = 0; i <= K; ++i) {
        const FacetId outside = complex_.twin(c, i);
        if (!is_open[raw(complex_.cell(outside))]) rim_[rim_.key(complex_.vertices(c), i)] = raw(outside);
      }
    }
  }

  Gap(const Gap&) = delete;  // rim_ stands in words_
  Gap& operator=(const Gap&) = delete;

  /// Fills the gap with cells of the seam: the triangulation of the border, whose row i is its site i.
  void fill(const Mesh& seam) {
    const ConstComplexView<K> cells(seam.complex);
    const std::vector<CellId> filling = cells_within(cells, seam.sites);

    mesh_->complex.reserve_more(filling.size(), mesh_->sites.size());
    // A site of the border is hidden in the whole just where it is in the seam; all others have a cell of the filling.
    mesh_->vertex_count -= border_->sites.size() - seam.vertex_count;
    for (const VertexId v : border_->sites) complex_.forget(v);
    for (const CellId c : border_->cells) complex_.destroy(c);
    std::vector<CellId> made(cells.slot_count(), kNoCell);
    for (const CellId c : filling) {
      const CellId m = made[raw(c)] = complex_.create();
      complex_.set_vertices(m, sites_of(cells.vertices(c), seam.sites));
      complex_.settle(m);
      complex_.count_ghost(m);
    }
    for (const CellId c : filling) {
      const CellId m = made[raw(c)];
      for (int i = 0; i <= K; ++i) {
        const FacetId twin = cells.twin(c, i);
        if (const CellId across = made[raw(cells.cell(twin))]; across != kNoCell) {
          complex_.set_twin(m, i, complex_.facet(across, cells.slot(twin)));
        } else {
          const Index outside = rim_.at(rim_.key(complex_.vertices(m), i));
          DELONE_ASSERT(outside != kNone, "the filling ends at the rim");
          complex_.link(complex_.facet(m, i), FacetId{outside});
        }
      }
    }
  }

 private:
  using Cell = typename Kernel<K>::Cell;

  Cell sites_of(Cell cell, const Sites& seam) const {
    for (VertexId& v : cell) v = v == kGhost ? kGhost : border_->sites[seam.row(v)];
    return cell;
  }

  /// The cells of the seam that have sites of both parts, and those that hang together with them inside the rim.
  std::vector<CellId> cells_within(const ConstComplexView<K>& cells, const Sites& seam) {
    std::vector<CellId> found;
    std::vector<bool> is_found(cells.slot_count(), false);
    const auto add = [&](CellId c) {
      is_found[raw(c)] = true;
      found.push_back(c);
    };
    for (std::size_t s = 0; s < cells.slot_count(); ++s) {
      const CellId c{static_cast<Index>(s)};
      if (cells.is_live(c) && has_both(sites_of(cells.vertices(c), seam))) add(c);
    }
    for (std::size_t next = 0; next < found.size(); ++next) {
      const Cell cell = sites_of(cells.vertices(found[next]), seam);
      for (int i = 0; i <= K; ++i) {
        const CellId across = cells.cell(cells.twin(found[next], i));
        if (!is_found[raw(across)] && rim_.at(rim_.key(cell, i)) == kNone) add(across);
      }
    }
    return found;
  }
  bool has_both(const Cell& cell) const {
    const auto is_first = [this](VertexId v) { return v < second_; };
    const auto is_second = [this](VertexId v) { return v >= second_ && v != kGhost; };
    return std::ranges::any_of(cell, is_first) && std::ranges::any_of(cell, is_second);
  }

  Mesh* mesh_;
  ComplexView<K> complex_;
  const Border* border_;
  VertexId second_;
  Buffer<Index> words_;
  FacetTable<K> rim_;  ///< of each facet between an open and a safe cell the side of the safe one
};

/// Puts the sites and cells of b behind those of a.
void put_beside(Mesh& a, const Mesh& b, int threads) {
  const auto shift = static_cast<Index>(a.sites.size());
  a.sites.append(b.sites);
  a.complex.append(b.complex, threads);
  a.vertex_count += b.vertex_count;
  a.statistics += b.statistics;
  for (std::size_t i = 0; i < b.sites.size() && !b.duplicates.empty(); ++i) {
    const VertexId v{static_cast<Index>(i)};
    const VertexId repeated = b.duplicates.vertex_of(v);
    if (repeated != kGhost) a.duplicates.add(VertexId{raw(v) + shift}, VertexId{raw(repeated) + shift}, b.sites.row(v));
  }
}

template <int K>
std::optional<Mesh> glue_parts(Mesh a, const Mesh& b, int threads) {
  std::array<Border, 2> found = borders<K>(a, b, threads);
  Border& border = found[0];
  const Border& border_of_b = found[1];
  if (2 * (border.sites.size() + border_of_b.sites.size()) > a.sites.size() + b.sites.size()) return std::nullopt;
  PointCopies points;
  points.add(a.sites, border.sites);
  points.add(b.sites, border_of_b.sites);
  const int few = std::max(threads / 4, 1);  // copying takes less than the seam
  std::optional<Mesh> seam;
  std::optional<Gap<K>> gap;
  both(
      threads, [&] { seam = triangulate_points(points.view(), std::max(threads - few, 1), {}); },
      [&] {
        const VertexId second{static_cast<Index>(a.sites.size())};
        border.add(border_of_b, static_cast<Index>(a.complex.slot_count()), raw(second));
        a.scratch = {};  // it knows cells that will be others
        put_beside(a, b, few);
        gap.emplace(a, border, second);
      });
  points = {};
  if (seam->complex.dimension() != K) return std::nullopt;
  gap->fill(*seam);
  a.statistics += seam->statistics;
  return a;
}

template <int K>
double share_of_border(const Mesh& a, const Mesh& b) {
  const auto found = borders<K>(a, b, 1);
  return static_cast<double>(found[0].sites.size() + found[1].sites.size()) /
         static_cast<double>(a.sites.size() + b.sites.size());
}

}  // namespace

std::optional<Mesh> glue(Mesh a, const Mesh& b, int threads) {
  return with_dimension<2>(a.complex.dimension(),
                           [&](auto dimension) { return glue_parts<dimension>(std::move(a), b, threads); });
}

double border_share(const Mesh& a, const Mesh& b) {
  return with_dimension<2>(a.complex.dimension(), [&](auto dimension) { return share_of_border<dimension>(a, b); });
}

}  // namespace delone
