// Source: [For92] 4.6 and [GS85] section 9; [Dwyer87] (cuts across alternating axes, so that parts stay square and
// seams short). Departures: cuts come with the order of the sites: those of the boxes that Hilbert's curve goes
// through, or of strips, not halves of equal number. Boxes may hold rows, which are knit from one end to the other.
//
// Heights are perturbed by coordinates alone, so each part is the canonical triangulation of its sites.
#include "mesh/divide_conquer.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/chunks.hpp"
#include "delone/order/brio.hpp"
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

/// The boxes or strips of `whole` that are small enough, or of one place.
template <class F>
std::vector<Piece> pieces_of(std::span<const std::uint16_t> cut, const Piece& whole, const F& small_enough) {
  std::vector<Piece> done;
  std::vector<Piece> open{whole};
  std::size_t rank = whole.rank;
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    const auto inner = cut.subspan(piece.begin + 1, piece.end - piece.begin - 1);
    const bool whole_piece = inner.empty() || small_enough(piece);
    const std::uint16_t least_deep = whole_piece ? CurveCuts::kSamePlace : std::ranges::min(inner);
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

/// The axis along which the sites of a box lie in a row, as far as eight of them tell: they stay as close to a line as
/// a sixteenth of its length.
std::optional<int> row_axis(const Sites& sites, const Piece& box) {
  std::array<const double*, 8> x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = sites.at(VertexId{static_cast<Index>(box.begin + (box.end - box.begin - 1) * i / (x.size() - 1))});
  }
  std::array<std::pair<const double*, const double*>, 2> ends;
  std::array<double, 2> length;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [least, most] = std::ranges::minmax_element(x, {}, [&](const double* p) { return p[axis]; });
    ends[axis] = {*least, *most};
    length[axis] = (*most)[axis] - (*least)[axis];
  }
  const int axis = length[0] >= length[1] ? 0 : 1;
  const auto [from, to] = ends[static_cast<std::size_t>(axis)];
  const Pair along{to[0] - from[0], to[1] - from[1]};
  const double most = (along[0] * along[0] + along[1] * along[1]) / 16.0;
  const bool close = std::ranges::all_of(
      x, [&](const double* p) { return std::abs(along[0] * (p[1] - from[1]) - along[1] * (p[0] - from[0])) <= most; });
  return close ? std::optional(axis) : std::nullopt;
}

/// A piece of a curve, triangulated alone, is a fan but for details: all see the end where it bends most, or least. Of
/// two halves of it one is knit in vain. So what lies in a row is knit from that end to the other, one fan after the
/// next. Where this makes many cells another row begins; rows are merged two by two, then.
Part knit_row(Knitter& knitter, std::span<VertexId> row, CellId first) {
  constexpr std::uint64_t kMany = 8;  // for each site; 5 are usual
  constexpr std::uint64_t kSlack = 64;
  if (!knitter.fan_from_front(row)) std::ranges::reverse(row);
  const auto fan_at = [&](std::size_t i) {
    return knitter.fan(row.subspan(i), CellId{raw(first) + static_cast<Index>(2 * i)});
  };
  Mender mender(knitter);
  std::size_t end = 0;
  for (std::size_t number = 0; end < row.size(); ++number) {
    const std::size_t begin = end;
    const std::uint64_t made = knitter.cells_made();
    auto [part, size] = fan_at(begin);
    end += size;
    while (end < row.size() && knitter.cells_made() - made < kMany * (end - begin) + kSlack) {
      const Knitter::Fan next = fan_at(end);
      part = knitter.merge(part, next.part);
      end += next.size;
    }
    mender.add({part, static_cast<std::uint16_t>(64 - std::countr_zero(number))});
  }
  return mender.finish().part;
}

/// Triangulates pieces, each for itself.
class PieceWork {
 public:
  PieceWork(Mesh& mesh, Buffer<CellId>& hull, std::span<const std::uint16_t> cut)
      : sites_(mesh.sites), cut_(cut), knitter_(mesh, hull), mender_(knitter_) {}

  CutPart whole(const Piece& piece) {
    add_one_by_one(piece);
    return mender_.finish();
  }
  /// The same where boxes may hold rows.
  CutPart by_rows(const Piece& piece) {
    const auto is_small = [](const Piece& box) { return box.end - box.begin <= 32; };
    const auto stays_whole = [&](const Piece& box) { return is_small(box) || row_axis(sites_, box); };
    for (const Piece& box : pieces_of(cut_, piece, stays_whole)) {
      if (is_small(box) || !add_row(box)) add_one_by_one(box);
    }
    return mender_.finish();
  }
  void add_to(BuildStatistics& statistics) const { knitter_.add_to(statistics); }

 private:
  template <class F>
  void for_each_place(const Piece& box, const F& visit) const {
    for (std::size_t i = box.begin; i < box.end; ++i) {
      if (i == box.begin || cut_[i] != CurveCuts::kSamePlace) visit(VertexId{static_cast<Index>(i)});
    }
  }
  void add_one_by_one(const Piece& box) {
    std::size_t rank = box.rank;
    for_each_place(box, [&](VertexId v) {
      mender_.add({knitter_.single(v, CellId{static_cast<Index>(2 * rank++)}), cut_[raw(v)]});
    });
  }
  /// False, and nothing is done, when the box is no row, or two sites are alike on its axis.
  bool add_row(const Piece& box) {
    const std::optional<int> axis = row_axis(sites_, box);
    if (!axis) return false;
    row_.clear();
    for_each_place(box, [&](VertexId v) { row_.push_back(v); });
    const auto place = [&](VertexId v) { return sites_.at(v)[*axis]; };
    sort_row(place);
    if (std::ranges::adjacent_find(row_, {}, place) != row_.end()) return false;
    mender_.add({knit_row(knitter_, row_, CellId{static_cast<Index>(2 * box.rank)}), cut_[box.begin]});
    return true;
  }
  template <class F>
  void sort_row(const F& place) {
    if (!spread_row(place)) {
      std::ranges::sort(row_, {}, place);
      return;
    }
    for (auto next = row_.begin() + 1; next != row_.end(); ++next) {
      const VertexId v = *next;
      auto to = next;
      for (; to != row_.begin() && place(*(to - 1)) > place(v); --to) *to = *(to - 1);
      *to = v;
    }
  }
  /// Sites of a row are mostly spread so evenly that division tells each about where it belongs. False, and nothing is
  /// done, when many would go to one place.
  template <class F>
  bool spread_row(const F& place) {
    constexpr Index kMany = 16;
    double least = place(row_.front());
    double most = least;
    for (const VertexId v : row_) {
      least = std::min(least, place(v));
      most = std::max(most, place(v));
    }
    const double scale = static_cast<double>(row_.size() - 1) / (most - least);
    if (!(scale > 0.0 && std::isfinite(scale))) return false;
    const auto bucket = [&](VertexId v) { return static_cast<std::size_t>((place(v) - least) * scale); };
    bucket_end_.assign(row_.size() + 1, 0);
    Index fullest = 0;
    for (const VertexId v : row_) fullest = std::max(fullest, ++bucket_end_[bucket(v) + 1]);
    if (fullest > kMany) return false;
    std::inclusive_scan(bucket_end_.begin(), bucket_end_.end(), bucket_end_.begin());
    sorted_.resize(row_.size());
    for (const VertexId v : row_) sorted_[bucket_end_[bucket(v)]++] = v;
    row_.swap(sorted_);
    return true;
  }

  const Sites& sites_;
  std::span<const std::uint16_t> cut_;
  Knitter knitter_;
  Mender mender_;
  std::vector<VertexId> row_, sorted_;
  std::vector<Index> bucket_end_;
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

void divide_and_conquer(Mesh& mesh, std::span<const std::uint16_t> cut, bool in_rows, int threads,
                        const Progress& progress, std::size_t piece) {
  const std::size_t n = mesh.sites.size();
  mesh.vertex_count = set_duplicates_aside(mesh, cut);
  mesh.complex.reserve_more(2 * mesh.vertex_count - 2, n);
  mesh.complex.grow_vertices(n);
  ComplexView<2> complex(mesh.complex);
  complex.create_row(2 * mesh.vertex_count - 2);
  Buffer<CellId> hull;
  hull.resize(n);

  const std::vector<Piece> pieces =
      pieces_of(cut, {0, n, 0}, [&](const Piece& box) { return box.end - box.begin <= piece; });
  std::vector<CutPart> parts(pieces.size());
  std::vector<BuildStatistics> counts(pieces.size());
  const auto triangulate_piece = [&](std::size_t, std::size_t, std::size_t p) {
    PieceWork work(mesh, hull, cut);
    parts[p] = in_rows ? work.by_rows(pieces[p]) : work.whole(pieces[p]);
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
