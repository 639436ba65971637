// The search for a cavity in space, four tests at a time.
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "delone/mesh/cavity.hpp"
#include "geometry/four_conflicts.hpp"

namespace delone {

#ifdef DELONE_FOURS

namespace {

/// Which bytes of four facets make a list of those whose bit is set.
constexpr auto kChosen = [] {
  std::array<std::array<std::uint8_t, 16>, 16> bytes{};
  for (unsigned set = 0; set < 16; ++set) {
    std::size_t to = 0;
    for (unsigned i = 0; i < 16; ++i) {
      if ((set >> (i / 4) & 1) != 0) bytes[set][to++] = static_cast<std::uint8_t>(i);
    }
  }
  return bytes;
}();

using Ids = Index __attribute__((vector_size(4 * sizeof(Index))));

/// Appends the facets whose bit is set. There is room for four.
DELONE_BY_FOURS [[gnu::always_inline]] inline void push_chosen(Refill<FacetId>& list, unsigned chosen,
                                                               const Ids& facets) {
  if constexpr (sizeof(Ids) == 16) {
    const __m128i all = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&facets));
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(kChosen[chosen].data()));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(list.place()), _mm_shuffle_epi8(all, bytes));
    list.keep(static_cast<std::size_t>(std::popcount(chosen)));
  } else {
    for (unsigned i = 0; i < 4; ++i) list.push_if((chosen >> i & 1) != 0, FacetId{facets[i]});
  }
}

/// Which of the cells across the facets of c that are `open` are in conflict with q; on the lifted hyperplanes of those
/// in `tie` it lies exactly.
[[gnu::noinline]] unsigned conflicts_one_by_one(ComplexView<3> complex, Kernel<3>& kernel, Scratch& scratch, CellId c,
                                                VertexId q, unsigned open, unsigned tie) {
  unsigned conflict = 0;
  for (; open != 0; open &= open - 1) {
    const int i = std::countr_zero(open);
    const CellId across = complex.cell(complex.twin(c, i));
    const bool conflicting = (tie >> i & 1) != 0 ? kernel.conflict_by_tie(complex.vertices(across), q)
                                                 : in_conflict(complex, kernel, scratch, across, q);
    conflict |= (conflicting ? 1U : 0U) << i;
  }
  return conflict;
}

/// The search in breadth of cavity.hpp, a cell of the cavity at a time: all cells across its facets are tested, also
/// those known to be in conflict, whose answers are dropped. Where ghosts take part, which is seldom, each is tested
/// alone; a finite cell's neighbour is a ghost when its apex is.
template <bool Weighted>
DELONE_BY_FOURS bool search(ComplexView<3> complex, Kernel<3>& kernel, VertexId q, CellId start, Scratch& scratch) {
  Refill cavity(scratch.cavity);
  Refill boundary(scratch.boundary);
  Scratch::Mark* const marks = scratch.marks.data();
  FourConflicts<Weighted> conflicts(kernel, q);
  const Territory territory = scratch.territory;
  std::size_t asked = 0;
  cavity.make_room(1);
  cavity.push(complex.facet(start, 0));
  marks[raw(start)] = Scratch::Mark::conflicting;
  scratch.numbers.begin(complex.vertices(start));
  if (!complex.is_ghost(start)) [[likely]]
    conflicts.expect(complex.vertices(start));
  for (std::size_t next = 0; next < cavity.size(); ++next) {
    cavity.make_room(4);
    boundary.make_room(4);
    const CellId c = complex.cell(cavity[next]);
    scratch.numbers.add(complex.vertex(cavity[next]), next);
    std::array<FacetId, 4> outside;
    std::array<VertexId, 4> apexes;
    unsigned known = 0;
    Index any = raw(complex.vertex(c, 3));  // where a ghost cell has its ghost (I4)
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) {
      outside[i] = complex.twin(c, static_cast<int>(i));
      apexes[i] = complex.vertex(outside[i]);
      known |= static_cast<unsigned>(marks[raw(complex.cell(outside[i]))]) << i;
      any |= raw(apexes[i]);
    }
    const bool ghosts = static_cast<std::make_signed_t<Index>>(any) < 0;  // no site's id comes near the highest bit
    FourAnswers answers{};
    if (!ghosts) [[likely]]
      answers = conflicts(complex.vertices(c), apexes);
    unsigned conflict = answers.conflict & answers.sure & ~known;
    if (const unsigned open = ~(answers.sure | known) & 15; open != 0) [[unlikely]] {
      conflict |= conflicts_one_by_one(complex, kernel, scratch, c, q, open, answers.tie);
      asked += static_cast<std::size_t>(std::popcount(open));
    }
    unsigned held = 15;
    if (!territory.whole() && (ghosts || !territory.holds_sites(apexes)))
        [[unlikely]] {  // what c has in common with a cell across is held
      for (std::size_t i = 0; i < 4; ++i) held &= ~((territory.holds(apexes[i]) ? 0U : 1U) << i);
      if ((conflict & ~held) != 0) return false;
    }
    known |= conflict;
    const unsigned bytes = known * 0x0020'4081 & 0x0101'0101;  // bit i in byte i
    const auto set_mark = [&](std::size_t i) {
      marks[raw(complex.cell(outside[i]))] = static_cast<Scratch::Mark>(static_cast<std::uint8_t>(bytes >> 8 * i));
    };
    if (held == 15) [[likely]] {
#pragma GCC unroll 4
      for (std::size_t i = 0; i < 4; ++i) set_mark(i);
    } else {
      for (std::size_t i = 0; i < 4; ++i) {
        if ((held >> i & 1) != 0) set_mark(i);
      }
    }
    // The same ids as in `outside`, but from memory: what is put together from parts waits for each, and the other way.
    const auto twins = complex.twins(c);
    Ids others;
    std::memcpy(&others, twins.data(), sizeof others);
    push_chosen(cavity, conflict, others);
    push_chosen(boundary, ~known & 15, raw(complex.facet(c, 0)) | Ids{0, 1, 2, 3});
  }
  kernel.count_filtered(cavity.size() - 1 + boundary.size() - asked);
  return true;
}

}  // namespace

std::optional<bool> find_cavity_by_fours(ComplexView<3> complex, Kernel<3>& kernel, VertexId q, CellId start,
                                         Scratch& scratch) {
  if (!can_test_fours() || kernel.flat()) return std::nullopt;
  return kernel.weighted() ? search<true>(complex, kernel, q, start, scratch)
                           : search<false>(complex, kernel, q, start, scratch);
}

#else

std::optional<bool> find_cavity_by_fours(ComplexView<3> /*complex*/, Kernel<3>& /*kernel*/, VertexId /*q*/,
                                         CellId /*start*/, Scratch& /*scratch*/) {
  return std::nullopt;
}

#endif

}  // namespace delone
