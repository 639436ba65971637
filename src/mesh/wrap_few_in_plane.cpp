// The cells come from searches in floats, so they are checked. They are the triangulation of all sites, proven, if
//   * facets are glued two by two, 2n - 2 cells are there, and each of the n sites has one: so the complex is a sphere,
//     by Euler's formula (no vertex has two stars: that would be one more vertex);
//   * triangles are positively oriented, and the hull is convex everywhere and goes round once: so cells cover the
//   plane
//     once;
//   * no cell is in conflict with the vertex across any of its facets [For92 2].
// Doubles decide nearly all of this, with a bound; what remains is left to the kernel.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "delone/base/buffer.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/cavity.hpp"
#include "delone/topology/complex.hpp"
#include "geometry/sixteen_in_plane.hpp"
#include "mesh/wrap_few.hpp"

namespace delone {

#ifdef DELONE_SIXTEENS

namespace {

using sixteen::InPlane;
using sixteen::kNobody;

constexpr std::size_t kMostCells = 2 * sixteen::kMostSites;

/// An edge as seen by the cell to come on its left, and the facet of the cell on its right.
class OpenEdge {
 public:
  OpenEdge() = default;
  OpenEdge(Index from, Index to, Index facet) : entry_(facet << 16 | to << 8 | from) {}

  Index from() const { return entry_ & 0xFF; }
  Index to() const { return entry_ >> 8 & 0xFF; }
  Index facet() const { return entry_ >> 16; }

 private:
  std::uint32_t entry_;  // in one word, which is written and read at once
};

/// Which edges cells have on their left, each direction for itself, and of which that cell is to come. Whether a new
/// cell meets one of these is a coin toss, so nothing branches on that.
class EdgeTable {
 public:
  /// Of vertices below `count`.
  explicit EdgeTable(std::size_t count) : shift_(static_cast<int>(std::bit_width(count - 1))), table_(count << shift_) {
    std::ranges::fill(table_, 0);
  }

  bool is_open(const OpenEdge& e) const { return table_[place(e.from(), e.to())] == e.facet() + 1; }
  void open(const OpenEdge& e) {
    table_[place(e.from(), e.to())] = static_cast<std::uint16_t>(e.facet() + 1);
    ++open_count_;
  }
  void close(const OpenEdge& e) {
    table_[place(e.from(), e.to())] = kTaken;
    --open_count_;
  }
  /// A cell takes the edge from a to b with its facet f. Returns the facet on the other side; f where that is to come.
  [[gnu::always_inline]] inline Index take(Index a, Index b, Index f) {
    std::uint16_t& here = table_[place(a, b)];
    const Index state = here;
    taken_twice_ |= state == kTaken;
    here = kTaken;
    if (state - 1 < kTaken - 1) {
      table_[place(b, a)] = kTaken;
      --open_count_;
      return state - 1;
    }
    table_[place(b, a)] = static_cast<std::uint16_t>(f + 1);
    ++open_count_;
    return f;
  }
  std::ptrdiff_t open_count() const { return open_count_; }
  bool taken_twice() const { return taken_twice_; }

 private:
  static constexpr Index kTaken = 0xFFFF;  // 0: not known; others: the facet on the right, plus 1

  std::size_t place(std::size_t a, std::size_t b) const { return a << shift_ | b; }

  int shift_;
  bool taken_twice_ = false;
  std::ptrdiff_t open_count_ = 0;
  Buffer<std::uint16_t> table_;
};

/// The cells in the order in which they are found. The ghost is the vertex after the last site.
struct FoundCells {
  explicit FoundCells(std::size_t sites) : ghost(static_cast<Index>(sites)) {}

  /// How many there must be.
  std::size_t due() const { return 2 * std::size_t{ghost} - 2; }
  void glue(Index f, Index g) {
    twins[f] = g;
    twins[g] = f;
  }
  Index across(Index facet) const { return corners[twins[facet] / 4][twins[facet] % 4]; }

  Index ghost;
  std::size_t count = 0, met_count = 0;
  std::array<std::array<Index, 4>, kMostCells> corners;  // three, and nothing
  std::array<Index, 4 * kMostCells> twins;               // by facet; of the last one of a cell, that of the cell before
  std::array<Index, 2 * kMostCells> met;                 // other facets that were there first when a cell was found
};

class Wrapper {
 public:
  Wrapper(const InPlane& sites, FoundCells& cells) : sites_(sites), cells_(cells), edges_(cells.ghost + 1) {}

  /// False where these are no closed complex of as many cells as are due.
  DELONE_BY_SIXTEENS bool wrap() {
    return add_first() && add_others() && cells_.count == cells_.due() && edges_.open_count() == 0 &&
           !edges_.taken_twice();
  }

 private:
  DELONE_BY_SIXTEENS bool add_first() {
    constexpr Index kBase = 2;  // its last facet
    Index a = 0, b = sites_.nearest(a);
    if (b == kNobody) return false;
    Index c = sites_.apex(a, b);
    if (c == kNobody) {
      std::swap(a, b);
      c = sites_.apex(a, b);
    }
    if (c == kNobody || sites_.has_tie(sites_.plane(a, b, c))) return false;  // of ties, one seldom comes alone
    edges_.open({a, b, kBase});
    add({a, b, kBase}, c);
    edges_.open({b, a, kBase});
    stack_[stack_size_++] = {b, a, kBase};
    return true;
  }
  /// A search begins before the cell is added that the last one has found: each step of it waits for the one before,
  /// but the processor need not.
  DELONE_BY_SIXTEENS bool add_others() {
    OpenEdge last{}, next{};
    Index apex = kNobody;
    bool found = false;
    while (true) {
      const bool more = take_open(next);
      const Index next_apex = more ? search(next) : kNobody;
      if (found && edges_.is_open(last)) {
        if (cells_.count == cells_.due() || edges_.taken_twice()) return false;
        add(last, apex);
      } else if (!more) {
        return true;
      }
      last = next;
      apex = next_apex;
      found = more;
    }
  }
  [[gnu::always_inline]] inline bool take_open(OpenEdge& edge) {
    while (stack_size_ > 0) {
      edge = stack_[--stack_size_];
      if (edges_.is_open(edge)) return true;
    }
    return false;
  }
  // Neither of these is inlined: together they would need more registers than there are.
  DELONE_BY_SIXTEENS [[gnu::noinline]] Index search(OpenEdge edge) const { return sites_.apex(edge.from(), edge.to()); }
  /// Adds the cell on the left of an open edge; without an apex it is a ghost cell.
  [[gnu::noinline]] void add(OpenEdge edge, Index apex) {
    const Index first_facet = 4 * static_cast<Index>(cells_.count);
    const bool finite = apex != kNobody;
    const Index end = finite ? apex : cells_.ghost;
    cells_.corners[cells_.count++] = {edge.from(), edge.to(), end};
    edges_.close(edge);
    cells_.glue(first_facet + 2, edge.facet());
    meet(first_facet, edge.to(), end, finite);
    meet(first_facet + 1, end, edge.from(), finite);
  }
  [[gnu::always_inline]] inline void meet(Index f, Index from, Index to, bool finite) {
    const Index other = edges_.take(from, to, f);
    cells_.glue(f, other);
    if (other != f) {
      cells_.met[cells_.met_count++] = f;
    } else if (finite) {
      stack_[stack_size_++] = {to, from, f};
    }
  }

  const InPlane& sites_;
  FoundCells& cells_;
  EdgeTable edges_;
  std::size_t stack_size_ = 0;
  std::array<OpenEdge, 2 * kMostCells> stack_;  // some of them have been met since
};

/// Fills the complex of a mesh.
class Prover {
 public:
  Prover(Mesh& mesh, const InPlane& sites, const FoundCells& cells)
      : mesh_(mesh), sites_(sites), cells_(cells), complex_(mesh.complex), kernel_(mesh.sites) {}
  ~Prover() { mesh_.statistics.predicates += kernel_.stats(); }
  Prover(const Prover&) = delete;
  Prover& operator=(const Prover&) = delete;

  /// Whether the cells are the triangulation of all sites.
  DELONE_BY_SIXTEENS bool prove() {
    fill();
    mesh_.vertex_count = mesh_.sites.size();
    mesh_.statistics.cells_created += cells_.count;
    kernel_.count_filtered(3 * cells_.count / 2);
    return has_all_vertices() && summits_ == 1 && least_orientation_ > InPlane::kBound && no_conflict();
  }

 private:
  static constexpr double kFar = 1.0;

  DELONE_BY_SIXTEENS void fill() {
    mesh_.complex.reserve_more(cells_.due(), mesh_.sites.size());
    mesh_.complex.grow_vertices(mesh_.sites.size());
    complex_.create_row(cells_.due());
    for (Index i = 0; i < cells_.due(); ++i) {
      const CellId c{i};
      const auto& [a, b, end, none] = cells_.corners[i];
      const Index* const twins = &cells_.twins[std::size_t{4} * i];
      const bool ghost = end == cells_.ghost;
      const std::array<Index, 6> ids{a, b, ghost ? raw(kGhost) : end, twins[0], twins[1], twins[2]};
      complex_.set_ids(c, ids.data());
      if (ghost) {
        planes_[i] = sites_.wall(a, b);
        complex_.count_ghosts(1, c);
        if (rises(i) && !rises(twins[0] / 4)) ++summits_;
      } else {
        planes_[i] = sites_.plane(a, b, end);
        complex_.set_incident(VertexId{end}, c);
        least_orientation_ = std::min(least_orientation_, InPlane::orientation(planes_[i]));
      }
    }
    for (int i = 0; i < 2; ++i) complex_.set_incident(complex_.vertex(CellId{0}, i), CellId{0});
  }
  /// Whether an edge of the hull does.
  bool rises(Index ghost_cell) const {
    const auto& [a, b, end, none] = cells_.corners[ghost_cell];
    return kernel_.before(VertexId{a}, VertexId{b});
  }
  bool has_all_vertices() const {
    for (Index v = 0; v < cells_.ghost; ++v) {
      if (!complex_.has_vertex(VertexId{v})) return false;
    }
    return true;
  }
  /// Whether no cell is in conflict with the vertex across any of its facets.
  DELONE_BY_SIXTEENS bool no_conflict() {
    double least = kFar;  // one of two facets that are glued is enough
    for (Index c = 0; c < cells_.due(); ++c) least = std::min(least, height_across(4 * c + 2));
    for (std::size_t i = 0; i < cells_.met_count; ++i) least = std::min(least, height_across(cells_.met[i]));
    if (least > InPlane::kBound) return true;
    for (Index f = 0; f < 4 * cells_.due(); ++f) {
      if (f % 4 != 3 && height_across(f) <= InPlane::kBound && is_in_conflict(f)) return false;
    }
    return true;
  }
  DELONE_INLINE_BY_SIXTEENS double height_across(Index f) const {
    return sites_.height(planes_[f / 4], cells_.across(f));
  }
  /// The same, exactly.
  bool is_in_conflict(Index f) {
    const VertexId v{cells_.across(f)};
    const auto below = [&](CellId finite) { return kernel_.conflict(complex_.vertices(finite), v); };
    return in_conflict(complex_, kernel_, CellId{f / 4}, v, below);
  }

  Mesh& mesh_;
  const InPlane& sites_;
  const FoundCells& cells_;
  ComplexView<2> complex_;
  Kernel<2> kernel_;
  int summits_ = 0;  ///< edges of the hull that rise before one that falls
  double least_orientation_ = kFar;
  std::array<InPlane::Plane, kMostCells> planes_;  // by cell
};

}  // namespace

DELONE_BY_SIXTEENS bool wrap_few_in_plane(Mesh& mesh) {
  const InPlane sites(mesh.sites);
  FoundCells cells(mesh.sites.size());
  return sites.usable() && Wrapper(sites, cells).wrap() && Prover(mesh, sites, cells).prove();
}

#endif

}  // namespace delone
