#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "delone/base/assert.hpp"
#include "delone/base/buffer.hpp"
#include "delone/exact/determinant.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/inserter.hpp"
#include "delone/topology/complex.hpp"
#include "geometry/sixteen_in_space.hpp"
#include "mesh/wrap_few.hpp"

namespace delone {

#ifdef DELONE_SIXTEENS

namespace {

/// Three corners of a facet as seen from outside, and the apex of the cell beyond.
using Corners = std::array<Index, 4>;

constexpr Index kNobody = sixteen::kNobody;

/// The facets of which one side is done, in no order. Whether a new cell meets one of them is a coin toss, so nothing
/// branches on that.
class OpenFacets {
 public:
  struct Facet {
    std::uint64_t entry;

    FacetId facet() const { return FacetId{static_cast<Index>(entry >> kFacetShift)}; }
    /// The apex is to come.
    Corners corners() const {
      const auto corner = [&](int i) { return static_cast<Index>(entry >> (8 * i) & 0xFF); };
      return {corner(0), corner(1), corner(2)};
    }
  };

  /// @param slots  a power of two, at most 2^16, larger than the number of facets that are ever met
  explicit OpenFacets(std::size_t slots)
      : hash_shift_(64 - std::countr_zero(slots)), last_slot_(slots - 1), table_(slots), list_(slots) {
    DELONE_ASSERT(last_slot_ <= kSlot, "entries hold slots");
    std::ranges::fill(table_, 0);
  }

  bool empty() const { return size_ == 0; }
  /// One of them; another one for another number, if there are so many.
  Facet operator[](std::size_t i) const { return {list_[i < size_ ? size_ - 1 - i : 0]}; }
  /// Removes a facet if it is still open.
  bool take(Facet f) {
    const std::uint64_t place = table_[f.entry >> kSlotShift & kSlot] >> kPlaceShift;
    if (place >= size_ || list_[place] != f.entry) return false;
    put(place, list_[--size_]);
    return true;
  }
  /// Meets a facet for the first time, and keeps it open and returns it; or from the other side, and returns that.
  [[gnu::always_inline]] inline FacetId meet(FacetId f, const Corners& corners) {
    const auto [a, b, c, none] = corners;
    const std::uint64_t key = key_of(a, b, c);
    std::uint64_t slot = (key * 0x9E3779B97F4A7C15U) >> hash_shift_;
    // Neither factor is zero where another facet stands.
    while ((table_[slot] & kKey) * ((table_[slot] & kKey) ^ key) != 0) [[unlikely]] slot = (slot + 1) & last_slot_;
    const std::uint64_t known = (table_[slot] & kKey) != 0 ? 1 : 0;
    const auto choose = [mask = 0 - known](std::uint64_t if_known, std::uint64_t if_new) {
      return (if_known & mask) | (if_new & ~mask);
    };
    const std::uint64_t entry = std::uint64_t{raw(f)} << kFacetShift | slot << kSlotShift | c << 16 | b << 8 | a;
    const std::uint64_t place = choose(table_[slot] >> kPlaceShift, size_);
    const std::uint64_t other = choose(list_[place], entry);
    const std::uint64_t moved = choose(list_[size_ - known], entry);  // the last takes the place of one that goes
    table_[slot] = key;
    put(place, moved);
    size_ += 1 - 2 * known;
    return FacetId{static_cast<Index>(other >> kFacetShift)};
  }

 private:
  void put(std::uint64_t place, std::uint64_t entry) {
    list_[place] = entry;
    std::uint64_t& its = table_[entry >> kSlotShift & kSlot];
    its = (its & kKey) | place << kPlaceShift;
  }

  // In the list: the corners, the slot in the table, the facet. In the table: the corners sorted, the place in the
  // list.
  static constexpr std::uint64_t kKey = 0xFFFFFF;
  static constexpr std::uint64_t kSlot = 0xFFFF;
  static constexpr int kSlotShift = 24;
  static constexpr int kPlaceShift = 32;
  static constexpr int kFacetShift = 40;

  /// Not 0, since the corners differ.
  static std::uint64_t key_of(Index a, Index b, Index c) {
    const Index least = std::min(std::min(a, b), c);
    const Index most = std::max(std::max(a, b), c);
    return std::uint64_t{least} << 16 | std::uint64_t{a + b + c - least - most} << 8 | most;
  }

  int hash_shift_;
  std::uint64_t last_slot_;
  std::uint64_t size_ = 0;
  Buffer<std::uint64_t> table_, list_;
};

using Row = std::array<double, 4>;

/// Six times the volume of a cell with x for one of its corners.
double volume_with(const sixteen::InSpace& sites, const Corners& cell, std::size_t slot, const Row& x) {
  const auto corner = [&](std::size_t i) -> const Row& { return i == slot ? x : sites.row(cell[i]); };
  Matrix<3, double> edges;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) edges[i][j] = corner(i + 1)[j] - corner(0)[j];
  }
  return determinant<3>(edges);
}

/// Puts a site in the place of a corner, so that the cell still lies around x.
void exchange(const sixteen::InSpace& sites, Corners& cell, Index site, const Row& x) {
  std::size_t leaves = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    const double volume = volume_with(sites, cell, i, sites.row(site));
    const double share = volume_with(sites, cell, i, x) / volume;
    if (volume > 0.0 && share < least) {
      least = share;
      leaves = i;
    }
  }
  cell[leaves] = site;
}

/// The cell around the middle of the first four sites, found by exchanging corners as in mesh/first_cell.hpp, in
/// doubles; nothing where these do not tell it.
DELONE_BY_SIXTEENS std::optional<Corners> first_cell(const sixteen::InSpace& sites) {
  constexpr int kSteps = 100;
  Corners cell{0, 1, 2, 3};
  Row middle{};
  for (const Index v : cell) {
    for (std::size_t j = 0; j < 3; ++j) middle[j] += sites.row(v)[j] / 4;
  }
  if (volume_with(sites, cell, 0, sites.row(0)) < 0.0) std::swap(cell[0], cell[1]);
  for (int step = 0; step < kSteps; ++step) {
    const sixteen::InSpace::Plane plane = sites.plane(sites.facet(cell), cell[3]);
    const Index below = sites.lowest(plane);
    if (below == kNobody) {
      if (sites.is_positive(plane) && sites.count_doubts(plane) == 4) return cell;
      break;
    }
    exchange(sites, cell, below, middle);
  }
  return std::nullopt;
}

class FewWrapper {
 public:
  FewWrapper(Mesh& mesh, const sixteen::InSpace& sites)
      : mesh_(mesh),
        sites_(sites),
        complex_(mesh.complex),
        kernel_(mesh.sites),
        exact_tests_left_(kExactTests * mesh.sites.size()),
        most_cells_(kCells * mesh.sites.size()),
        open_(std::bit_ceil(4 * most_cells_)),
        hull_(std::bit_ceil(8 * mesh.sites.size())),
        planes_(most_cells_) {
    mesh.complex.reserve_more(most_cells_, mesh.sites.size());
    mesh.complex.grow_vertices(mesh.sites.size());
  }
  ~FewWrapper() { mesh_.statistics.predicates += kernel_.stats(); }
  FewWrapper(const FewWrapper&) = delete;
  FewWrapper& operator=(const FewWrapper&) = delete;

  /// False where it would take too many cells or exact tests.
  DELONE_BY_SIXTEENS bool wrap(const Corners& first) {
    add(first, through(sites_.facet(first), first[3]), kNoFacet, open_);
    while (!open_.empty()) {
      // Two searches step by step: each step waits for the one before, but the processor need not.
      std::array<Search, 2> searches;
      for (std::size_t i = 0; i < 2; ++i) {
        Search& s = searches[i];
        s.from = open_[i];
        s.cell = s.from.corners();
        s.facet = sites_.facet(s.cell);
      }
      for (Search& s : searches) s.cell[3] = sites_.apex(s.facet, planes_[raw(complex_.cell(s.from.facet()))]);
      for (Search& s : searches) s.plane = through(s.facet, s.cell[3]);
      for (Search& s : searches) s.doubtful = sites_.count_doubts(s.plane) != (s.cell[3] == kNobody ? 3 : 4);
      for (Search& s : searches) {
        if (!open_.take(s.from)) continue;
        if (s.doubtful && !settle(s)) return false;
        if (complex_.slot_count() == most_cells_) return false;
        add(s.cell, s.plane, s.from.facet(), s.cell[3] == kNobody ? hull_ : open_);
      }
    }
    mesh_.statistics.cells_created += complex_.slot_count();
    kernel_.count_filtered(complex_.slot_count() * mesh_.sites.size());
    for (Index v = 0; v < mesh_.sites.size(); ++v) mesh_.vertex_count += complex_.has_vertex(VertexId{v}) ? 1 : 0;
    return true;
  }

 private:
  static constexpr std::size_t kCells = 8;       // a site, at most: where there are more, insertion is as good
  static constexpr std::size_t kExactTests = 4;  // a site, at most: more would cost what wrapping saves

  /// What lies beyond an open facet.
  struct Search {
    OpenFacets::Facet from;
    Corners cell;
    sixteen::InSpace::Facet facet;
    sixteen::InSpace::Plane plane;
    bool doubtful;
  };

  /// The plane of a cell or, without an apex, the wall on its facet.
  DELONE_INLINE_BY_SIXTEENS sixteen::InSpace::Plane through(const sixteen::InSpace::Facet& facet, Index apex) const {
    return apex == kNobody ? facet.wall : sites_.plane(facet, apex);
  }

  /// Finds the apex by exact tests of those sites of which floats do not tell that they are above the plane of the cell
  /// or, without an apex, inside. False when these tests have become too many.
  DELONE_BY_SIXTEENS [[gnu::noinline]] bool settle(Search& s) {
    const sixteen::InSpace::Set doubts = sites_.doubts(s.plane);
    Corners& cell = s.cell;
    for (Index v = 0; v < mesh_.sites.size(); ++v) {
      if (!sixteen::InSpace::has(doubts, v) || std::ranges::find(cell, v) != cell.end()) continue;
      if (exact_tests_left_-- == 0) return false;
      const bool better = cell[3] == kNobody ? kernel_.orient(vertices({cell[0], cell[1], cell[2], v})) > 0
                                             : kernel_.conflict(vertices(cell), VertexId{v});
      if (better) cell[3] = v;
    }
    s.plane = through(s.facet, cell[3]);
    return true;
  }

  /// Adds the cell beyond a facet, if there is one; without an apex it is a ghost cell.
  [[gnu::always_inline]] inline void add(const Corners& cell, const sixteen::InSpace::Plane& plane, FacetId from,
                                         OpenFacets& open) {
    const auto [a, b, c, d] = cell;
    const CellId id = complex_.create();
    planes_[raw(id)] = plane;
    complex_.set_vertices(id, vertices(cell));
    const auto meet = [&](int slot, const Corners& corners) {
      const FacetId f = complex_.facet(id, slot);
      complex_.link(f, open.meet(f, corners));
    };
    meet(0, {d, b, c});
    meet(1, {a, d, c});
    meet(2, {a, b, d});
    if (from == kNoFacet) {
      meet(3, {b, a, c});
    } else {
      complex_.link(complex_.facet(id, 3), from);
    }
    complex_.count_ghost(id);
    complex_.settle(id);
  }
  static std::array<VertexId, 4> vertices(const Corners& cell) {
    return {VertexId{cell[0]}, VertexId{cell[1]}, VertexId{cell[2]}, cell[3] == kNobody ? kGhost : VertexId{cell[3]}};
  }

  Mesh& mesh_;
  const sixteen::InSpace& sites_;
  ComplexView<3> complex_;
  Kernel<3> kernel_;
  std::size_t exact_tests_left_;
  std::size_t most_cells_;
  OpenFacets open_, hull_;
  Buffer<sixteen::InSpace::Plane> planes_;  // by cell; they tell where to look only
};

/// False where floats do not tell two sites from each other that are no duplicates.
DELONE_BY_SIXTEENS bool set_duplicates_aside(Mesh& mesh, sixteen::InSpace& sites) {
  for (Index i = 1; i < mesh.sites.size(); ++i) {
    const Index first = sites.first_alike(i);
    if (first == i) [[likely]]
      continue;
    if (!mesh.sites.same_place(VertexId{first}, VertexId{i})) return false;
    if (meet_at_same_place(mesh, VertexId{i}, VertexId{first}) != Outcome::duplicate) return false;
    sites.set_aside(i);
  }
  return true;
}

}  // namespace

bool wrap_few_in_space(Mesh& mesh) {
  sixteen::InSpace sites(mesh.sites);
  if (!set_duplicates_aside(mesh, sites)) return false;
  const std::optional<Corners> first = first_cell(sites);
  return first && FewWrapper(mesh, sites).wrap(*first);
}

#endif

}  // namespace delone
