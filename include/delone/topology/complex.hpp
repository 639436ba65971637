// A closed simplicial complex as integer arrays: cells as half-facets, one ghost vertex that closes the hull, no
// numbers.
//
// The facet of `cell` opposite its i-th vertex is f = cell * 2^b + i, where b bits hold every i; vertex(f) is that
// vertex, twin(f) the same facet seen from the neighbouring cell. In 2D it is the half-edge, in 3D the half-face;
// above, nothing changes. A cell is 2 (K + 1) ids in a row, vertices before twins: 24 bytes a triangle, 32 bytes a
// tetrahedron. The complex stores its own dimension; algorithms see it through ComplexView<K>, where the dimension is
// constant. Invariants I1 to I4, I8 and I10: INVARIANTS.md.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "delone/base/assert.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"

namespace delone {

/// A part of a complex has drawn all that it may (see Complex::part).
struct NoMoreSlots {};

class Complex {
 public:
  /// An empty complex of dimension -1 (no cell can exist) to 8.
  explicit Complex(int dimension = -1) : dimension_(dimension) {}

  int dimension() const { return dimension_; }
  int corners() const { return dimension_ + 1; }

  /// Slots of cells, dead ones included: every CellId lies below.
  std::size_t slot_count() const { return dimension_ < 0 ? 0 : ids_.size() / stride(); }
  /// The same when `cells` more have been created.
  std::size_t slot_count_with(std::size_t cells) const { return slot_count() + (supply_.step == 0 ? cells : 0); }
  /// Every FacetId lies below.
  std::size_t facet_slots() const { return slot_count() << slot_bits(corners()); }
  /// How many slots the ids can name.
  std::size_t nameable_slots() const { return kDead >> slot_bits(corners()); }
  std::size_t live_count() const { return live_; }
  std::size_t ghost_count() const { return ghosts_; }
  std::size_t vertex_slots() const { return incident_.size(); }

  bool is_live(CellId c) const { return ids_[raw(c) * stride()] != kDead; }
  VertexId vertex(CellId c, int i) const { return VertexId{ids_[raw(c) * stride() + static_cast<std::size_t>(i)]}; }
  FacetId twin(CellId c, int i) const {
    return FacetId{ids_[raw(c) * stride() + static_cast<std::size_t>(corners() + i)]};
  }
  bool is_ghost(CellId c) const {
    for (int i = 0; i < corners(); ++i) {
      if (vertex(c, i) == kGhost) return true;
    }
    return false;
  }
  CellId cell(FacetId f) const { return CellId{raw(f) >> slot_bits(corners())}; }
  int slot(FacetId f) const { return static_cast<int>(raw(f) & ((Index{1} << slot_bits(corners())) - 1)); }

  /// A live cell that has `v`, or kNoCell when `v` is not in the complex. The ghost has one too.
  CellId incident_cell(VertexId v) const { return v == kGhost ? ghost_cell_ : CellId{incident_[raw(v)]}; }

  /// Asks memory for a cell at v, if there is one.
  void prefetch_cell_at(VertexId v) const {
    if (incident_[raw(v)] != kNone) __builtin_prefetch(ids_.data() + incident_[raw(v)] * stride());
  }

  std::size_t memory_bytes() const { return (ids_.capacity() + incident_.capacity()) * sizeof(Index); }

  /// Room for `cells` more live cells and vertices below `vertex_slots`; on std::bad_alloc nothing has changed.
  void reserve_more(std::size_t cells, std::size_t vertex_slots);
  /// Room for slots below `slots`, or a little more. @throws as above
  void reserve_slots(std::size_t slots) { ids_.reserve(slots * stride()); }
  /// Vertices below `count` may be used; new ones are in no cell. Requires reserved room.
  void grow_vertices(std::size_t count) { incident_.resize(count, kNone); }
  /// One of `count` parts: a complex over the same cells, to be changed by a thread of its own. What it creates comes
  /// from slots below `end`, for which there is room, rows of so many in turn; where they end reserve_more() throws
  /// NoMoreSlots. Its counts are of its own changes, and its ghost has no cell before it creates one. Good until this
  /// one changes.
  Complex part(std::size_t which, std::size_t count, std::size_t row, std::size_t end);
  /// Ends the parts: what they did counts here, and the last cells move to slots that are dead, so that none is left.
  /// Returns these, from where and where to, in the order in which they moved.
  std::vector<std::array<CellId, 2>> end_parts(std::span<Complex* const> parts);
  /// Gives back what growth left over.
  void shrink();
  /// Refills the incident cell of every vertex from the cells.
  void rebuild_incidence();

 private:
  template <int K, class C>
  friend class ComplexView;

  static constexpr Index kDead = kNone - 1;  // stands in the first vertex of a dead cell

  /// Of a facet's id, those that tell its slot.
  static constexpr int slot_bits(int corners) {
    return corners > 0 ? static_cast<int>(std::bit_width(static_cast<unsigned>(corners - 1))) : 0;
  }
  /// Of a part: the fresh slots that it may still draw, a row at `next`, and at every `step` slots from there.
  struct Supply {
    std::size_t next = 0, step = 0, row = 0, end = 0;
    std::size_t drawn = 0;  ///< slots so far

    std::size_t drawn_end() const { return drawn == 0 ? 0 : next - step + row; }
  };

  /// The next row of a part becomes dead cells, the first of which is taken first.
  void add_dead_row();
  /// Moves the last live cells to dead slots of a list, as far as these are among the first live_count() ones.
  void fill_gaps(Index first, std::vector<std::array<CellId, 2>>& moves);
  std::size_t stride() const { return 2 * static_cast<std::size_t>(corners()); }

  int dimension_;
  Buffer<Index> ids_;
  Buffer<Index> incident_;
  CellId ghost_cell_ = kNoCell;
  Index free_ = kNone;    // first dead cell; the next one stands in its second id
  std::size_t live_ = 0;  // of a part: created less destroyed, which may be below 0 and wrap around; so ghosts_
  std::size_t ghosts_ = 0;
  Supply supply_;
};

/// The complex with its dimension known to the compiler; cheap to copy, valid as long as the complex.
/// A view of a const complex is for reading: its changes do not compile.
template <int K, class C = Complex>
class ComplexView {
  static constexpr Index kCorners = K + 1;
  static constexpr int kSlotBits = Complex::slot_bits(K + 1);
  using Id = std::conditional_t<std::is_const_v<C>, const Index, Index>;

 public:
  explicit ComplexView(C& complex) : complex_(&complex) {
    DELONE_ASSERT(complex.dimension() == K, "the view has the dimension of the complex");
  }

  static CellId cell(FacetId f) { return CellId{raw(f) >> kSlotBits}; }
  static int slot(FacetId f) { return static_cast<int>(raw(f) & ((Index{1} << kSlotBits) - 1)); }
  /// The slot `by` places after `slot`, 0 <= by <= K + 1, round and round. Without a branch, as in slot_of.
  static int turned(int slot, int by) {
    const int past = slot + by - (K + 1);
    return past + ((K + 1) & (past >> 31));
  }
  static constexpr FacetId facet(CellId c, int i) { return FacetId{raw(c) << kSlotBits | static_cast<Index>(i)}; }

  VertexId vertex(CellId c, int i) const { return VertexId{base(c)[i]}; }
  FacetId twin(CellId c, int i) const { return FacetId{base(c)[std::size_t{kCorners} + static_cast<std::size_t>(i)]}; }
  std::array<VertexId, kCorners> vertices(CellId c) const {
    std::array<VertexId, kCorners> copy;
    std::memcpy(copy.data(), base(c), sizeof copy);
    return copy;
  }
  std::array<FacetId, kCorners> twins(CellId c) const {
    std::array<FacetId, kCorners> copy;
    std::memcpy(copy.data(), base(c) + kCorners, sizeof copy);
    return copy;
  }
  VertexId vertex(FacetId f) const { return VertexId{complex_->ids_[place(f)]}; }
  FacetId twin(FacetId f) const { return FacetId{complex_->ids_[place(f) + kCorners]}; }
  bool has(CellId c, VertexId v) const {
    bool found = false;
    for (int i = 0; i <= K; ++i) found |= vertex(c, i) == v;
    return found;
  }
  /// The slot of a vertex that `c` has. Without a branch on where it stands, which nobody can predict.
  int slot_of(CellId c, VertexId v) const {
    int slot = 0;
    for (int i = 1; i <= K; ++i) slot = vertex(c, i) == v ? i : slot;
    DELONE_ASSERT(vertex(c, slot) == v, "the cell has the vertex");
    return slot;
  }

  /// Slot of the ghost, or -1 in a finite cell. Above dimension 1 the ghost always stands last (I4).
  int ghost_slot(CellId c) const {
    if constexpr (K == 1) {
      if (vertex(c, 0) == kGhost) return 0;
    }
    return vertex(c, K) == kGhost ? K : -1;
  }
  bool is_ghost(CellId c) const { return ghost_slot(c) >= 0; }
  bool is_live(CellId c) const { return *base(c) != Complex::kDead; }
  std::size_t slot_count() const { return complex_->ids_.size() / (2 * std::size_t{kCorners}); }
  std::size_t facet_slots() const { return slot_count() << kSlotBits; }
  CellId incident_cell(VertexId v) const { return complex_->incident_cell(v); }
  bool has_vertex(VertexId v) const { return incident_cell(v) != kNoCell; }

  // Changes. Room must have been reserved; none of these fails.

  /// A cell whose ids are not yet set.
  CellId create() {
    ++complex_->live_;
    if (complex_->free_ != kNone) {
      const CellId c{complex_->free_};
      complex_->free_ = base(c)[1];
      return c;
    }
    const CellId c{static_cast<Index>(slot_count())};
    complex_->ids_.resize(complex_->ids_.size() + 2 * kCorners);
    return c;
  }
  /// `count` cells in a row, whose ids are not yet set, in a complex without dead ones; returns the first.
  CellId create_row(std::size_t count) {
    DELONE_ASSERT(complex_->free_ == kNone, "no dead cells");
    const CellId first{static_cast<Index>(slot_count())};
    complex_->ids_.resize(complex_->ids_.size() + 2 * kCorners * count);
    complex_->live_ += count;
    return first;
  }
  void destroy(CellId c) {
    discount_ghost(c);
    release(c);
  }
  /// The same for a cell that is no longer counted among the ghosts.
  void release(CellId c) {
    --complex_->live_;
    base(c)[0] = Complex::kDead;
    base(c)[1] = complex_->free_;
    complex_->free_ = raw(c);
  }
  /// What create() will return next; and, if nothing else happens, after it returned `last`, which may still be to
  /// come.
  CellId upcoming() const { return or_fresh(complex_->free_); }
  CellId upcoming_after(CellId last) const {
    return raw(last) < slot_count() ? or_fresh(base(last)[1]) : CellId{raw(last) + 1};
  }
  void set_vertex(CellId c, int i, VertexId v) { base(c)[i] = raw(v); }
  void set_vertices(CellId c, const std::array<VertexId, kCorners>& v) { std::memcpy(base(c), v.data(), sizeof v); }
  /// All ids of a cell at once: its vertices, then its twins.
  void set_ids(CellId c, const Index* ids) { std::memcpy(base(c), ids, 2 * kCorners * sizeof(Index)); }
  void copy_ids(CellId c, Index* to) const { std::memcpy(to, base(c), 2 * kCorners * sizeof(Index)); }
  void set_twin(CellId c, int i, FacetId f) { base(c)[std::size_t{kCorners} + static_cast<std::size_t>(i)] = raw(f); }
  void set_twin(FacetId f, FacetId g) { complex_->ids_[place(f) + kCorners] = raw(g); }
  void link(FacetId f, FacetId g) {
    set_twin(f, g);
    set_twin(g, f);
  }
  /// Counts `c`, whose vertices are set, if it is a ghost cell.
  void count_ghost(CellId c) {
    if (is_ghost(c)) count_ghosts(1, c);
  }
  /// Counts `count` ghost cells, of which c is one.
  void count_ghosts(std::size_t count, CellId c) {
    complex_->ghost_cell_ = c;
    complex_->ghosts_ += count;
  }
  /// Undoes the count; the ids of `c` may then be set anew.
  void discount_ghost(CellId c) { complex_->ghosts_ -= is_ghost(c) ? 1 : 0; }
  void set_incident(VertexId v, CellId c) {
    if (v == kGhost) {
      complex_->ghost_cell_ = c;
    } else {
      complex_->incident_[raw(v)] = raw(c);
    }
  }
  /// Makes `c` the incident cell of each of its vertices.
  void settle(CellId c) {
    for (int i = 0; i <= K; ++i) set_incident(vertex(c, i), c);
  }
  void forget(VertexId v) { complex_->incident_[raw(v)] = kNone; }

  void prefetch(CellId c) const { __builtin_prefetch(base(c)); }
  void prefetch(VertexId v) const { __builtin_prefetch(complex_->incident_.data() + raw(v), 1); }

 private:
  /// Where the vertex opposite f stands; its twin stands kCorners further.
  static std::size_t place(FacetId f) {
    return 2 * std::size_t{kCorners} * raw(cell(f)) + static_cast<std::size_t>(slot(f));
  }
  CellId or_fresh(Index free) const { return free != kNone ? CellId{free} : CellId{static_cast<Index>(slot_count())}; }
  Id* base(CellId c) const { return complex_->ids_.data() + raw(c) * (2 * std::size_t{kCorners}); }

  C* complex_;
};

template <int K>
using ConstComplexView = ComplexView<K, const Complex>;

}  // namespace delone
