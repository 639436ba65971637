// Source: [For92] 4.6 and [GS85] section 9; [Dwyer87] (cuts across alternating axes, so that parts stay square and
// seams short). Departures: cuts come with the order of the sites: those of the boxes that Hilbert's curve goes
// through, or of strips, not halves of equal number. Boxes may hold chains, which are knit from one end to the other.
//
// Heights are perturbed by coordinates alone, so each part is the canonical triangulation of its sites.
#include "mesh/divide_conquer.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/chunks.hpp"
#include "delone/order/brio.hpp"
#include "mesh/chain.hpp"
#include "mesh/knitter.hpp"

namespace delone {
namespace {

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

/// Where the least deep cut of a piece of two sites or more is; its end when it is one place.
std::size_t middle_of(std::span<const std::uint16_t> cut, const Piece& piece) {
  const auto inner = cut.subspan(piece.begin + 1, piece.end - piece.begin - 1);
  const std::uint16_t least_deep = std::ranges::min(inner);
  if (least_deep == CurveCuts::kSamePlace) return piece.end;
  return piece.begin + 1 + static_cast<std::size_t>(std::ranges::find(inner, least_deep) - inner.begin());
}

/// Boxes or strips of up to `most` sites, or of one place.
std::vector<Piece> pieces_of(std::span<const std::uint16_t> cut, std::size_t most) {
  std::vector<Piece> done;
  std::vector<Piece> open{{0, cut.size(), 0}};
  std::size_t rank = 0;
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    const std::size_t middle = piece.end - piece.begin <= most ? piece.end : middle_of(cut, piece);
    if (middle == piece.end) {
      const auto inner = cut.subspan(piece.begin + 1, piece.end - piece.begin - 1);
      done.push_back({piece.begin, piece.end, rank});
      rank += piece.end - piece.begin - static_cast<std::size_t>(std::ranges::count(inner, CurveCuts::kSamePlace));
    } else {
      open.push_back({middle, piece.end, 0});
      open.push_back({piece.begin, middle, 0});
    }
  }
  return done;
}

/// Knits the sites of a sorted chain. A piece of a curve, triangulated alone, is a fan but for details: all see the end
/// where it bends most. Of two halves of it one is triangulated in vain. So the chain is knit from that end to the
/// other, site by site. Where this makes many cells another chain begins; chains are merged two by two, then.
Part knit_chain(Knitter& knitter, std::span<VertexId> chain, CellId first) {
  constexpr std::uint64_t kMany = 8;  // for each site; 3 to 6 are usual
  constexpr std::uint64_t kSlack = 64;
  if (!knitter.bends_most_in_front(chain)) std::ranges::reverse(chain);
  const auto single = [&](std::size_t i) {
    return knitter.single(chain[i], CellId{raw(first) + static_cast<Index>(2 * i)});
  };
  Mender mender(knitter);
  std::size_t end = 0;
  for (std::size_t number = 0; end < chain.size(); ++number) {
    const std::size_t begin = end;
    const std::uint64_t made = knitter.cells_made();
    Part part = single(end++);
    while (end < chain.size() && knitter.cells_made() - made < kMany * (end - begin) + kSlack) {
      part = knitter.merge(part, single(end++));
    }
    mender.add({part, static_cast<std::uint16_t>(64 - std::countr_zero(number))});  // as deep as in a balanced tree
  }
  return mender.finish().part;
}

/// Triangulates a piece.
class PieceWork {
 public:
  PieceWork(Mesh& mesh, Buffer<CellId>& hull, std::span<const std::uint16_t> cut, const Piece& piece)
      : sites_(mesh.sites), cut_(cut), piece_(piece), rank_(piece.rank), knitter_(mesh, hull), mender_(knitter_) {}

  CutPart knit(bool in_chains) {
    if (in_chains) {
      add_chains(piece_);
    } else {
      add_sites(piece_);
    }
    return mender_.finish();
  }
  void add_to(BuildStatistics& statistics) const { knitter_.add_to(statistics); }

 private:
  /// Whether site i of a box stands where the one before it does.
  bool repeats(std::size_t i, const Piece& box) const { return i > box.begin && cut_[i] == CurveCuts::kSamePlace; }
  /// The first cell of the next site.
  CellId next_cells() const { return CellId{static_cast<Index>(2 * rank_)}; }
  /// The same, and those of the next `count` are taken.
  CellId take_cells(std::size_t count) {
    const CellId first = next_cells();
    rank_ += count;
    return first;
  }
  /// Those of a box of two or three at once, the others one by one.
  void add_sites(const Piece& box) {
    for (std::size_t i = box.begin; i < box.end;) {
      if (add_few<3>(i, box.end)) {
        i += 3;
      } else if (add_few<2>(i, box.end)) {
        i += 2;
      } else {
        if (!repeats(i, box)) mender_.add({knitter_.single(VertexId{static_cast<Index>(i)}, take_cells(1)), cut_[i]});
        ++i;
      }
    }
  }
  /// False, and nothing is done, unless the N sites from i on are those of a box, and on no line when there are three.
  template <std::size_t N>
  bool add_few(std::size_t i, std::size_t end) {
    if (end - i < N || !is_box(i, i + N)) return false;
    std::array<VertexId, N> sites{};
    for (std::size_t k = 0; k < N; ++k) sites[k] = VertexId{static_cast<Index>(i + k)};
    const std::optional<Part> part = knitter_.few(sites, next_cells());
    if (!part) return false;
    take_cells(N);
    mender_.add({*part, cut_[i]});
    return true;
  }
  /// Whether none of these sites repeats another one, and each cut between them is deeper than those around.
  bool is_box(std::size_t begin, std::size_t end) const {
    const auto [least, deepest] = std::ranges::minmax(cut_.subspan(begin + 1, end - begin - 1));
    return deepest != CurveCuts::kSamePlace && (begin == 0 || least > cut_[begin]) &&
           (end == cut_.size() || least > cut_[end]);
  }
  /// Boxes that hold a chain as one, the others by halves.
  void add_chains(const Piece& box) {
    constexpr std::size_t kSmall = 32;
    if (box.end - box.begin <= kSmall) return add_sites(box);
    if (add_chain(box)) return;
    const std::size_t middle = middle_of(cut_, box);
    if (middle == box.end) return add_sites(box);
    add_chains({box.begin, middle, 0});
    add_chains({middle, box.end, 0});
  }
  /// False, and nothing is done, when the sites are no chain, or two are alike on its axis: no line would part these.
  bool add_chain(const Piece& box) {
    const std::optional<int> axis = chain_axis(sites_, box.begin, box.end);
    if (!axis) return false;
    chain_.clear();
    for (std::size_t i = box.begin; i < box.end; ++i) {
      if (!repeats(i, box)) chain_.push_back(VertexId{static_cast<Index>(i)});
    }
    if (!sorter_.sort(sites_, *axis, chain_)) return false;
    mender_.add({knit_chain(knitter_, chain_, take_cells(chain_.size())), cut_[box.begin]});
    return true;
  }

  const Sites& sites_;
  std::span<const std::uint16_t> cut_;
  Piece piece_;
  std::size_t rank_;  ///< of the next site
  Knitter knitter_;
  Mender mender_;
  ChainSorter sorter_;
  std::vector<VertexId> chain_;
};

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

void divide_and_conquer(Mesh& mesh, std::span<const std::uint16_t> cut, bool in_chains, int threads,
                        const Progress& progress, std::size_t piece) {
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
    PieceWork work(mesh, hull, cut, pieces[p]);
    parts[p] = work.knit(in_chains);
    work.add_to(counts[p]);
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
