// Source: [For92] 4.6 and [GS85] section 9 (two triangulations with a line between them are knit together from their
// lower common tangent upwards); [Dwyer87] (cuts across alternating axes, so that parts stay square and seams short).
// Departures: cells instead of edges, with ghost cells along the hull as everywhere here: a ghost cell of the seam
// becomes the cell that is knit, an edge is deleted by a flip that makes two ghost cells, and a merge creates two
// cells. Cuts come with the order of the sites: those of the boxes that Hilbert's curve goes through, or of strips, not
// halves of equal number.
//
// Heights are perturbed by coordinates alone, so each part is the canonical triangulation of its sites.
#include "mesh/divide_conquer.hpp"

#include <algorithm>
#include <array>
#include <atomic>
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
  /// @param hull  per site, see hull_; set by single()
  Knitter(Mesh& mesh, Buffer<CellId>& hull) : complex_(mesh.complex), kernel_(mesh.sites), hull_(hull.data()) {}

  /// The part of one site, with its two cells.
  Part single(VertexId v, CellId last) {
    hull_[raw(v)] = kNoCell;
    return {v, v, v, v, last};
  }

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

 private:
  // The slots of a ghost cell on a hull edge, which leads counter-clockwise from its tail to its head: the ghost stands
  // last (I4). Opposite the head is the ghost cell on the edge before, opposite the tail that on the edge after.
  static constexpr int kHead = 0;
  static constexpr int kTail = 1;
  static constexpr int kGhostSlot = 2;

  /// One side of a seam. Its next hull edge upwards leads from `end` to the candidate for the third corner of the next
  /// cell.
  template <bool Left>
  struct Bank {
    static constexpr int kCandidate = Left ? kHead : kTail;  ///< slots of the ghost cell on that edge
    static constexpr int kEnd = Left ? kTail : kHead;
    /// The same vertices in the cell inside the edge: so many slots after its third one.
    static constexpr int kCandidateTurn = Left ? 2 : 1;
    static constexpr int kEndTurn = Left ? 1 : 2;

    VertexId end;
    bool alone;                     ///< `end` is the whole part: there is no such edge
    CellId open;                    ///< the ghost cell on it; opposite the candidate it is linked to what lies below
    FacetId inner;                  ///< the edge, seen from the cell inside
    VertexId candidate;             ///< this and what follows is known once look() and see() were called
    VertexId beyond;                ///< the corner that would be the candidate if the edge to this one went
    Ray candidate_ray, beyond_ray;  ///< as the left end sees them
    double turn;                    ///< from the right end to the candidate

    Bank(VertexId v, CellId hull) : end(v), alone(hull == kNoCell), open(hull) {}
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

  /// Knits two parts, from vertices that face each other across the line between them.
  void knit(VertexId left_start, VertexId right_start) {
    Bank<true> left(left_start, hull_[raw(left_start)]);
    Bank<false> right(right_start, hull_[raw(right_start)]);
    if (!right.alone) right.open = above(right);
    while (descend(left, left.end, right.end) || descend(right, left.end, right.end)) {
    }

    const CellId bottom = spare_;
    complex_.set_vertices(bottom, {right.end, left.end, kGhost});
    close(left, bottom);
    close(right, bottom);
    hull_[raw(left.end)] = bottom;
    FacetId base = View::facet(bottom, kGhostSlot);
    look(left);
    look(right);
    see(left, left.end);
    see(right, left.end);
    for (;;) {
      const Ray across = kernel_.ray(right.end, left.end);
      const bool left_on = choose(left, left.end, right.end, across);
      const bool right_on = choose(right, left.end, right.end, across);
      if (!left_on && !right_on) break;
      if (left_on &&
          !(right_on && inside(left.end, right.end, across, left, right.candidate, right.candidate_ray, right.turn))) {
        base = attach(left, right.end, base);
        see(left, left.end);
      } else {
        base = attach(right, left.end, base);
      }
      see(right, left.end);
    }
    const CellId top{raw(spare_) + 1};
    complex_.set_vertices(top, {left.end, right.end, kGhost});
    complex_.link(View::facet(top, kHead), View::facet(right.open, right.kCandidate));
    complex_.link(View::facet(top, kTail), View::facet(left.open, left.kCandidate));
    complex_.link(View::facet(top, kGhostSlot), base);
    hull_[raw(left.end)] = left.open;
    hull_[raw(right.end)] = top;
    cells_made_ += 2;
  }

  /// The ghost cells on the next edges down and up a hull.
  template <bool Left>
  CellId below(const Bank<Left>& bank) const {
    return View::cell(complex_.twin(bank.open, bank.kCandidate));
  }
  template <bool Left>
  CellId above(const Bank<Left>& bank) const {
    return View::cell(complex_.twin(bank.open, bank.kEnd));
  }

  /// Moves the end of a bank down its hull if the next vertex lies below the line through both ends.
  template <bool Left>
  bool descend(Bank<Left>& bank, VertexId left, VertexId right) {
    if (bank.alone) return false;
    const CellId next = below(bank);
    const VertexId v = complex_.vertex(next, bank.kEnd);
    if (kernel_.orient({left, right, v}) >= 0) return false;
    bank.end = v;
    bank.open = next;
    return true;
  }

  /// Links the ghost cell below the seam to the hull of one side; a vertex alone has no hull and stays open upwards.
  template <bool Left>
  void close(Bank<Left>& bank, CellId bottom) {
    if (bank.alone) {
      bank.open = bottom;
    } else {
      complex_.link(View::facet(bottom, bank.kCandidate), View::facet(below(bank), bank.kEnd));
    }
  }

  /// Finds the two vertices of a bank that may come next.
  template <bool Left>
  void look(Bank<Left>& bank) {
    if (bank.alone) return;
    bank.candidate = complex_.vertex(bank.open, bank.kCandidate);
    bank.inner = complex_.twin(bank.open, kGhostSlot);
    bank.beyond = complex_.vertex(bank.inner);
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
  bool choose(Bank<Left>& bank, VertexId left, VertexId right, const Ray& across) {
    if (bank.alone) return false;
    bank.turn = across.turn(bank.candidate_ray);
    if (kernel_.orient_seen(across, bank.candidate_ray, bank.turn, [&] {
          return Triangle{left, right, bank.candidate};
        }) <= 0)
      return false;
    while (bank.beyond != kGhost) {
      const double turn = across.turn(bank.beyond_ray);
      if (!inside(left, right, across, bank, bank.beyond, bank.beyond_ray, turn)) return true;
      delete_edge(bank);
      bank.candidate_ray = bank.beyond_ray;
      bank.turn = turn;
      if (bank.beyond != kGhost) bank.beyond_ray = kernel_.ray(bank.beyond, left);
    }
    return true;
  }

  /// The edge between end and candidate goes; the cell inside becomes the ghost cell on its upper edge.
  template <bool Left>
  void delete_edge(Bank<Left>& bank) {
    constexpr int kCandidate = Bank<Left>::kCandidate;
    constexpr int kEnd = Bank<Left>::kEnd;
    const CellId open = bank.open;
    const CellId upper = View::cell(bank.inner);
    const int slot = View::slot(bank.inner);
    const FacetId lower_edge = complex_.twin(upper, View::turned(slot, Bank<Left>::kCandidateTurn));
    const FacetId upper_edge = complex_.twin(upper, View::turned(slot, Bank<Left>::kEndTurn));
    const CellId next = above(bank);
    complex_.set_vertex(upper, kCandidate, bank.candidate);
    complex_.set_vertex(upper, kEnd, bank.beyond);
    complex_.set_vertex(upper, kGhostSlot, kGhost);
    complex_.set_vertex(open, kCandidate, bank.beyond);
    complex_.link(View::facet(upper, kEnd), View::facet(next, kCandidate));
    complex_.link(View::facet(upper, kCandidate), View::facet(open, kEnd));
    complex_.link(View::facet(upper, kGhostSlot), upper_edge);
    complex_.link(View::facet(open, kGhostSlot), lower_edge);
    cells_made_ += 2;
    bank.candidate = bank.beyond;
    bank.inner = lower_edge;
    bank.beyond = complex_.vertex(lower_edge);
  }

  /// Whether q lies in the circle through the ends and the candidate of a bank.
  template <bool Left>
  bool inside(VertexId left, VertexId right, const Ray& across, const Bank<Left>& bank, VertexId q, const Ray& ray,
              double turn) {
    return kernel_.conflict_seen(across, bank.candidate_ray, ray, bank.turn, bank.candidate_ray.turn(ray), turn, q,
                                 [&] {
                                   return Triangle{left, right, bank.candidate};
                                 });
  }

  /// The ghost cell of a bank becomes the cell on the base. Returns the new base.
  template <bool Left>
  FacetId attach(Bank<Left>& bank, VertexId other_end, FacetId base) {
    const CellId made = bank.open;
    complex_.set_vertex(made, kGhostSlot, other_end);
    complex_.link(View::facet(made, bank.kCandidate), base);
    bank.end = bank.candidate;
    bank.open = above(bank);
    look(bank);
    ++cells_made_;
    return View::facet(made, bank.kEnd);
  }

  View complex_;
  Kernel<2> kernel_;
  CellId* hull_;    ///< per hull vertex the ghost cell on the edge that leaves it; kNoCell for a vertex alone
  CellId spare_{};  ///< two cells that the next merge may use
  std::uint64_t cells_made_ = 0;
};

/// A part, and the depth of the cut before it: of two cuts the deeper one is mended first.
struct CutPart {
  Part part;
  std::uint16_t cut;
};

/// Merges parts that come one after the other in the order of the sites.
class Mender {
 public:
  explicit Mender(Knitter& knitter) : knitter_(&knitter) {}

  void add(const CutPart& next) {
    while (parts_.size() > 1 && parts_.back().cut > next.cut) merge_last();
    parts_.push_back(next);
  }
  /// All of them in one, with the cut before the first.
  CutPart finish() {
    while (parts_.size() > 1) merge_last();
    return std::exchange(parts_, {}).front();
  }

 private:
  void merge_last() {
    const Part last = parts_.back().part;
    parts_.pop_back();
    parts_.back().part = knitter_->merge(parts_.back().part, last);
  }

  Knitter* knitter_;
  std::vector<CutPart> parts_;
};

/// Sites that fill a box or a strip: [begin, end). The first is number `rank` of those that repeat none.
struct Piece {
  std::size_t begin, end, rank;
};

/// Boxes or strips of up to `most` sites, or of one place.
std::vector<Piece> pieces_of(std::span<const std::uint16_t> cut, std::size_t most) {
  std::vector<Piece> done;
  std::vector<Piece> open{{0, cut.size(), 0}};
  std::size_t rank = 0;
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    const auto inner = cut.subspan(piece.begin + 1, piece.end - piece.begin - 1);
    const std::uint16_t least_deep = inner.size() < most ? CurveCuts::kSamePlace : std::ranges::min(inner);
    if (least_deep == CurveCuts::kSamePlace) {
      done.push_back({piece.begin, piece.end, rank});
      rank += piece.end - piece.begin - static_cast<std::size_t>(std::ranges::count(inner, CurveCuts::kSamePlace));
    } else {
      const auto at = static_cast<std::size_t>(std::ranges::find(inner, least_deep) - inner.begin());
      const std::size_t middle = piece.begin + 1 + at;
      open.push_back({middle, piece.end, 0});
      open.push_back({piece.begin, middle, 0});
    }
  }
  return done;
}

/// Finds an incident cell for every vertex: the last that has it of the cells with the numbers of its own piece; where
/// seams have left it none of these, the first of all. Returns how many cells are ghosts.
std::size_t find_incident_cells(ComplexView<2> complex, std::span<const std::uint16_t> cut,
                                std::span<const Piece> pieces, int threads) {
  std::atomic<bool> all_found{true};
  std::atomic<std::size_t> ghosts{0};
  for_chunks(
      pieces.size(), threads,
      [&](std::size_t, std::size_t, std::size_t p) {
        const auto [begin, end, rank] = pieces[p];
        const std::size_t last = p + 1 < pieces.size() ? 2 * pieces[p + 1].rank : complex.slot_count();
        std::size_t ghosts_here = 0;
        for (std::size_t c = 2 * rank; c < last; ++c) {
          const CellId cell{static_cast<Index>(c)};
          for (const VertexId v : complex.vertices(cell)) {
            if (raw(v) >= begin && raw(v) < end) complex.set_incident(v, cell);
          }
          ghosts_here += complex.is_ghost(cell) ? 1 : 0;
        }
        ghosts += ghosts_here;
        for (std::size_t v = begin; v < end; ++v) {
          const bool repeats = v > begin && cut[v] == CurveCuts::kSamePlace;
          if (!repeats && !complex.has_vertex(VertexId{static_cast<Index>(v)})) all_found = false;
        }
      },
      {}, 1);
  if (all_found) return ghosts;
  for (std::size_t c = 0; c < complex.slot_count(); ++c) {
    for (const VertexId v : complex.vertices(CellId{static_cast<Index>(c)})) {
      if (v != kGhost && !complex.has_vertex(v)) complex.set_incident(v, CellId{static_cast<Index>(c)});
    }
  }
  return ghosts;
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

void divide_and_conquer(Mesh& mesh, std::span<const std::uint16_t> cut, int threads, const Progress& progress,
                        std::size_t piece) {
  const std::size_t n = mesh.sites.size();
  mesh.vertex_count = set_duplicates_aside(mesh, cut);
  mesh.complex.reserve_more(2 * mesh.vertex_count - 2, n);
  mesh.complex.grow_vertices(n);
  ComplexView<2> complex(mesh.complex);
  complex.create_row(2 * mesh.vertex_count - 2);
  Buffer<CellId> hull;
  hull.resize(n);

  const std::vector<Piece> pieces = pieces_of(cut, piece);
  std::vector<CutPart> parts(pieces.size());
  std::vector<BuildStatistics> counts(pieces.size());
  const auto triangulate_piece = [&](std::size_t, std::size_t, std::size_t p) {
    Knitter knitter(mesh, hull);
    Mender mender(knitter);
    std::size_t rank = pieces[p].rank;
    for (std::size_t i = pieces[p].begin; i < pieces[p].end; ++i) {
      if (i > pieces[p].begin && cut[i] == CurveCuts::kSamePlace) continue;
      const VertexId v{static_cast<Index>(i)};
      mender.add({knitter.single(v, CellId{static_cast<Index>(2 * rank++)}), cut[i]});
    }
    parts[p] = mender.finish();
    knitter.add_to(counts[p]);
  };
  for_chunks(pieces.size(), threads, triangulate_piece, progress, 1);

  // Cuts of one depth are mended side by side: between two of them lies one that is less deep, so no part is at both.
  while (parts.size() > 1) {
    const std::uint16_t depth = std::ranges::max(std::span(parts).subspan(1), {}, &CutPart::cut).cut;
    std::vector<CutPart> rest{parts.front()};
    std::vector<std::pair<std::size_t, Part>> seconds;  // what goes to which of the rest
    for (const CutPart& part : std::span(parts).subspan(1)) {
      if (part.cut == depth) {
        seconds.emplace_back(rest.size() - 1, part.part);
      } else {
        rest.push_back(part);
      }
    }
    const auto mend = [&](std::size_t, std::size_t, std::size_t m) {
      Knitter knitter(mesh, hull);
      Part& first = rest[seconds[m].first].part;
      first = knitter.merge(first, seconds[m].second);
      knitter.add_to(counts[m]);
    };
    for_chunks(seconds.size(), threads, mend, {}, 1);
    parts = std::move(rest);
  }
  for (const BuildStatistics& count : counts) mesh.statistics += count;
  complex.count_ghosts(find_incident_cells(complex, cut, pieces, threads), hull[raw(parts.front().part.left)]);
}

}  // namespace delone
