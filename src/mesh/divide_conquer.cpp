// Source: [For92] 4.6 and [GS85] section 9 (two triangulations with a line between them are knit together from their
// lower common tangent upwards); [Dwyer87] (cuts across alternating axes, so that parts stay square and seams short).
// Departures: cells instead of edges, with ghost cells along the hull as everywhere here: a ghost cell of the seam
// becomes the cell that is knit, an edge is deleted by a flip that makes two ghost cells, and a merge creates two
// cells. The boxes are those that Hilbert's curve goes through, not halves of equal number: they come with the order.
//
// Heights are perturbed by coordinates alone, so each part is the canonical triangulation of its sites.
#include "mesh/divide_conquer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/chunks.hpp"
#include "delone/base/buffer.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/inserter.hpp"
#include "delone/order/brio.hpp"
#include "delone/topology/complex.hpp"

namespace delone {
namespace {

/// A triangulation of some sites, known by its outermost vertices: by x and then y, and by y and then x. Each site that
/// repeats no other one comes with two cells of the complex; those of the last site of a part stay unused.
struct Part {
  VertexId left, right, bottom, top;
  CellId last;  ///< the first of these two
};

/// Knits parts together. The sides of a seam are called left and right whatever the axis of the cut: nothing but the
/// choice of the first two vertices knows of axes.
class Knitter {
  using View = ComplexView<2>;
  using Triangle = Kernel<2>::Cell;

 public:
  /// @param hull  per site, see hull_
  Knitter(Mesh& mesh, Buffer<FacetId>& hull) : complex_(mesh.complex), kernel_(mesh.sites), hull_(hull.data()) {}

  /// One part from two that a line across an axis separates; the sites of b follow those of a.
  Part merge(const Part& a, const Part& b) {
    spare_ = a.last;
    if (x(a.right) < x(b.left)) return beside(a, b, b.last);
    if (x(b.right) < x(a.left)) return beside(b, a, b.last);
    return y(a.top) < y(b.bottom) ? above(a, b, b.last) : above(b, a, b.last);
  }

  void add_to(BuildStatistics& statistics) const {
    statistics.predicates += kernel_.stats();
    statistics.cells_created += cells_made_;
  }

  /// Counts the ghost cells of the hull, which v is on, and turns each so that the ghost stands last (I4).
  void settle_hull(VertexId v) {
    const CellId first = View::cell(hull_[raw(v)]);
    CellId c = first;
    do {
      const int next = View::turned(complex_.slot_of(c, kGhost), 1);
      const int last = View::turned(next, 1);
      const Triangle vertices{complex_.vertex(c, next), complex_.vertex(c, last), kGhost};
      const std::array<FacetId, 3> twins{complex_.twin(c, next), complex_.twin(c, last),
                                         complex_.twin(c, View::turned(last, 1))};
      complex_.set_vertices(c, vertices);
      for (int i = 0; i < 3; ++i) complex_.link(View::facet(c, i), twins[static_cast<std::size_t>(i)]);
      complex_.count_ghost(c);
      c = View::cell(twins[0]);
    } while (c != first);
  }

 private:
  /// A facet as its cell and slot.
  struct Half {
    CellId cell;
    int slot;

    explicit Half(FacetId f) : cell(View::cell(f)), slot(View::slot(f)) {}
    Half(CellId c, int i) : cell(c), slot(i) {}
    Half turned(int by) const { return {cell, View::turned(slot, by)}; }
    FacetId facet() const { return View::facet(cell, slot); }
  };

  /// One side of a seam. Its next hull edge upwards leads from `end` to the candidate for the third corner of the next
  /// cell. The ghost cell on that edge has the candidate in one slot and, turning on by kEnd and by kGhostEnd, the
  /// other two corners.
  template <bool Left>
  struct Bank {
    static constexpr int kEnd = Left ? 1 : 2;
    static constexpr int kGhostEnd = Left ? 2 : 1;

    VertexId end;
    bool alone;                     ///< `end` is the whole part: there is no ghost cell
    Half open;                      ///< of that ghost cell the facet opposite the candidate
    Half inner;                     ///< the facet below the ghost, from the other side
    VertexId candidate;             ///< this and what follows is known once look() and see() were called
    VertexId beyond;                ///< the corner that would be the candidate if the edge to this one went
    Ray candidate_ray, beyond_ray;  ///< as the left end sees them
    double turn;                    ///< from the right end to the candidate

    Bank(VertexId v, FacetId hull) : end(v), alone(hull == kNoFacet), open(hull), inner(hull) {}
  };

  double x(VertexId v) const { return kernel_.at(v)[0]; }
  double y(VertexId v) const { return kernel_.at(v)[1]; }
  // Without branches: which of two vertices comes first nobody can predict.
  bool x_before(VertexId a, VertexId b) const {
    return static_cast<int>(x(a) < x(b)) | (static_cast<int>(x(a) == x(b)) & static_cast<int>(y(a) < y(b)));
  }
  bool y_before(VertexId a, VertexId b) const {
    return static_cast<int>(y(a) < y(b)) | (static_cast<int>(y(a) == y(b)) & static_cast<int>(x(a) < x(b)));
  }

  Part beside(const Part& left, const Part& right, CellId last) {
    knit(left.right, right.left);
    return {left.left, right.right, y_before(left.bottom, right.bottom) ? left.bottom : right.bottom,
            y_before(left.top, right.top) ? right.top : left.top, last};
  }
  Part above(const Part& lower, const Part& upper, CellId last) {
    knit(lower.top, upper.bottom);
    return {x_before(lower.left, upper.left) ? lower.left : upper.left,
            x_before(lower.right, upper.right) ? upper.right : lower.right, lower.bottom, upper.top, last};
  }

  FacetId twin(Half h) const { return complex_.twin(h.cell, h.slot); }
  VertexId vertex(Half h) const { return complex_.vertex(h.cell, h.slot); }
  /// Two halves of one facet.
  void link(Half a, Half b) {
    complex_.set_twin(a.cell, a.slot, b.facet());
    complex_.set_twin(b.cell, b.slot, a.facet());
  }

  /// Knits two parts, from vertices that face each other across the line between them.
  void knit(VertexId left_start, VertexId right_start) {
    Bank<true> left(left_start, hull_[raw(left_start)]);
    Bank<false> right(right_start, hull_[raw(right_start)]);
    if (!right.alone) right.open = Half(twin(right.open));
    while (descend(left, left.end, right.end) || descend(right, left.end, right.end)) {
    }

    const CellId bottom = spare_;
    complex_.set_vertices(bottom, {right.end, left.end, kGhost});
    close(left, {bottom, 0});
    close(right, {bottom, 1});
    hull_[raw(left.end)] = View::facet(bottom, 0);
    Half base(bottom, 2);
    look(left);
    look(right);
    see(left, left.end);
    see(right, left.end);
    for (;;) {
      base_ = kernel_.ray(right.end, left.end);
      const bool left_on = choose(left, left.end, right.end);
      const bool right_on = choose(right, left.end, right.end);
      if (!left_on && !right_on) break;
      if (left_on &&
          !(right_on && inside(left.end, right.end, left, right.candidate, right.candidate_ray, right.turn))) {
        base = attach(left, right.end, base);
        see(left, left.end);
      } else {
        base = attach(right, left.end, base);
      }
      see(right, left.end);
    }
    const CellId top{raw(spare_) + 1};
    complex_.set_vertices(top, {left.end, right.end, kGhost});
    link({top, 0}, right.open);
    link({top, 1}, left.open);
    link({top, 2}, base);
    hull_[raw(left.end)] = left.open.facet();
    hull_[raw(right.end)] = View::facet(top, 0);
    cells_made_ += 2;
  }

  /// Moves the end of a bank down its hull if the next vertex lies below the line through both ends.
  template <bool Left>
  bool descend(Bank<Left>& bank, VertexId left, VertexId right) {
    if (bank.alone) return false;
    const Half below(twin(bank.open));
    const VertexId next = vertex(below);
    if (kernel_.orient({left, right, next}) >= 0) return false;
    bank.end = next;
    bank.open = below.turned(Bank<Left>::kGhostEnd);
    return true;
  }

  /// Links the ghost cell below the seam to the hull of one side; a vertex alone has no hull and stays open upwards.
  template <bool Left>
  void close(Bank<Left>& bank, Half f) {
    if (bank.alone) {
      bank.open = f;
    } else {
      link(f, Half(twin(bank.open)));
    }
  }

  /// Finds the two vertices of a bank that may come next.
  template <bool Left>
  void look(Bank<Left>& bank) {
    if (bank.alone) return;
    bank.candidate = vertex(bank.open);
    bank.inner = Half(twin(bank.open.turned(Bank<Left>::kGhostEnd)));
    bank.beyond = vertex(bank.inner);
  }
  /// How the left end sees them.
  template <bool Left>
  void see(Bank<Left>& bank, VertexId left) {
    if (bank.alone) return;
    bank.candidate_ray = kernel_.ray(bank.candidate, left);
    if (bank.beyond != kGhost) bank.beyond_ray = kernel_.ray(bank.beyond, left);
  }

  /// Makes the candidate of a bank the corner of the cell on the base that no vertex of its side is in conflict with:
  /// edges in its way are deleted. False when nothing of this side is above the base.
  template <bool Left>
  bool choose(Bank<Left>& bank, VertexId left, VertexId right) {
    constexpr int kEnd = Bank<Left>::kEnd;
    constexpr int kGhostEnd = Bank<Left>::kGhostEnd;
    if (bank.alone) return false;
    bank.turn = base_.turn(bank.candidate_ray);
    if (kernel_.orient_seen(base_, bank.candidate_ray, bank.turn, [&] {
          return Triangle{left, right, bank.candidate};
        }) <= 0)
      return false;
    while (bank.beyond != kGhost) {
      const double turn = base_.turn(bank.beyond_ray);
      if (!inside(left, right, bank, bank.beyond, bank.beyond_ray, turn)) return true;
      // The edge between end and candidate goes; the cell behind it becomes the ghost cell on its upper edge.
      const Half lower(twin(bank.inner.turned(kGhostEnd)));
      link(bank.inner, Half(twin(bank.open.turned(kEnd))));
      link(bank.open.turned(kEnd), bank.inner.turned(kGhostEnd));
      link(bank.open.turned(kGhostEnd), lower);
      complex_.set_vertex(bank.inner.cell, bank.inner.turned(kEnd).slot, kGhost);
      complex_.set_vertex(bank.open.cell, bank.open.slot, bank.beyond);
      cells_made_ += 2;
      bank.candidate = bank.beyond;
      bank.candidate_ray = bank.beyond_ray;
      bank.turn = turn;
      bank.inner = lower;
      bank.beyond = vertex(lower);
      if (bank.beyond != kGhost) bank.beyond_ray = kernel_.ray(bank.beyond, left);
    }
    return true;
  }

  /// Whether q lies in the circle through the ends and the candidate of a bank.
  template <bool Left>
  bool inside(VertexId left, VertexId right, const Bank<Left>& bank, VertexId q, const Ray& ray, double turn) {
    return kernel_.conflict_seen(base_, bank.candidate_ray, ray, bank.turn, bank.candidate_ray.turn(ray), turn, q, [&] {
      return Triangle{left, right, bank.candidate};
    });
  }

  /// The ghost cell of a bank becomes the cell on the base. Returns the new base.
  template <bool Left>
  Half attach(Bank<Left>& bank, VertexId other_end, Half base) {
    const Half next_base = bank.open.turned(Bank<Left>::kEnd);
    const Half above(twin(next_base));
    complex_.set_vertex(bank.open.cell, bank.open.turned(Bank<Left>::kGhostEnd).slot, other_end);
    link(bank.open, base);
    bank.end = bank.candidate;
    bank.open = above;
    look(bank);
    ++cells_made_;
    return next_base;
  }

  View complex_;
  Kernel<2> kernel_;
  FacetId* hull_;   ///< per hull vertex, of the ghost cell on the edge that leaves it counter-clockwise, the facet
                    ///< between it and the ghost; kNoFacet for a vertex alone
  CellId spare_{};  ///< two cells that the next merge may use
  Ray base_{};      ///< the right end as the left one sees it
  std::uint64_t cells_made_ = 0;
};

constexpr std::size_t kPiece = 1 << 13;  ///< sites that one thread triangulates by itself

/// Merges parts that come one after the other in the order of the curve, each with the cut before it: of two cuts the
/// deeper one is mended first.
class Mender {
 public:
  explicit Mender(Knitter& knitter) : knitter_(&knitter) {}

  void add(const Part& part, std::uint16_t cut) {
    while (parts_.size() > 1 && parts_.back().cut > cut) merge_last();
    parts_.push_back({part, cut});
  }
  /// All of them in one.
  Part finish() {
    while (parts_.size() > 1) merge_last();
    return std::exchange(parts_, {}).front().part;
  }

 private:
  struct CutPart {
    Part part;
    std::uint16_t cut;
  };

  void merge_last() {
    const Part last = parts_.back().part;
    parts_.pop_back();
    parts_.back().part = knitter_->merge(parts_.back().part, last);
  }

  Knitter* knitter_;
  std::vector<CutPart> parts_;
};

/// Sites that fill a box of the curve: [begin, end). The first is number `rank` of those that repeat none.
struct Piece {
  std::size_t begin, end, rank;
};

std::vector<Piece> pieces_of(std::span<const std::uint16_t> cut) {
  std::vector<Piece> done;
  std::vector<Piece> open{{0, cut.size(), 0}};
  std::size_t rank = 0;
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    const auto inner = cut.subspan(piece.begin + 1, piece.end - piece.begin - 1);
    const auto cut_most = std::ranges::min_element(inner);
    if (inner.size() < kPiece || *cut_most == CurveCuts::kSamePlace) {
      done.push_back({piece.begin, piece.end, rank});
      rank += piece.end - piece.begin - static_cast<std::size_t>(std::ranges::count(inner, CurveCuts::kSamePlace));
    } else {
      const std::size_t middle = piece.begin + 1 + static_cast<std::size_t>(cut_most - inner.begin());
      open.push_back({middle, piece.end, 0});
      open.push_back({piece.begin, middle, 0});
    }
  }
  return done;
}

/// Sites that stand at the place of the one before repeat it, or are repeated by it. Returns how many do not.
std::size_t set_duplicates_aside(Mesh& mesh, std::span<const std::uint16_t> cut) {
  std::size_t count = 1;
  VertexId last{0};
  for (std::size_t i = 1; i < cut.size(); ++i) {
    const VertexId v{static_cast<Index>(i)};
    if (cut[i] == CurveCuts::kSamePlace) {
      meet_at_same_place(mesh, v, last);
    } else {
      last = v;
      ++count;
    }
  }
  return count;
}

}  // namespace

void divide_and_conquer(Mesh& mesh, std::span<const std::uint16_t> cut, int threads, const Progress& progress) {
  const std::size_t n = mesh.sites.size();
  mesh.vertex_count = set_duplicates_aside(mesh, cut);
  mesh.complex.reserve_more(2 * mesh.vertex_count - 2, n);
  mesh.complex.grow_vertices(n);
  ComplexView<2> complex(mesh.complex);
  complex.create_row(2 * mesh.vertex_count - 2);
  Buffer<FacetId> hull;
  hull.resize(n, kNoFacet);

  const std::vector<Piece> pieces = pieces_of(cut);
  std::vector<Part> parts(pieces.size());
  std::vector<BuildStatistics> counts(pieces.size());
  const auto triangulate_piece = [&](std::size_t, std::size_t, std::size_t p) {
    Knitter knitter(mesh, hull);
    Mender mender(knitter);
    std::size_t rank = pieces[p].rank;
    for (std::size_t i = pieces[p].begin; i < pieces[p].end; ++i) {
      if (i > pieces[p].begin && cut[i] == CurveCuts::kSamePlace) continue;
      const VertexId v{static_cast<Index>(i)};
      mender.add({v, v, v, v, CellId{static_cast<Index>(2 * rank++)}}, cut[i]);
    }
    parts[p] = mender.finish();
    knitter.add_to(counts[p]);
  };
  for_chunks(pieces.size(), threads, triangulate_piece, progress, 1);

  Knitter knitter(mesh, hull);
  Mender mender(knitter);
  for (std::size_t p = 0; p < pieces.size(); ++p) mender.add(parts[p], cut[pieces[p].begin]);
  knitter.settle_hull(mender.finish().left);
  knitter.add_to(counts.front());
  for (const BuildStatistics& count : counts) mesh.statistics += count;
  for (std::size_t s = 0; s < complex.slot_count(); ++s) complex.settle(CellId{static_cast<Index>(s)});
}

}  // namespace delone
