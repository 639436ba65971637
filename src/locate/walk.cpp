#include "delone/locate/walk.hpp"

#include <algorithm>

#include "delone/base/dispatch.hpp"
#include "delone/base/random.hpp"
#include "locate/marches.hpp"
#include "locate/reading.hpp"

namespace delone {
namespace {

/// The closed cell that contains q. Facets are tested one by one from a random one on. @param random  gives 64 bits
template <int K, class Random>
CellId remembering_walk(const ConstComplexView<K>& complex, Kernel<K>& kernel, const double* q, CellId c, Random random,
                        LocateCounts& counts) {
  const auto leaves_by = [&](int i) {
    ++counts.facet_tests;
    return kernel.orient(complex.vertices(c), i, q) < 0;
  };
  if (const int ghost = complex.ghost_slot(c); ghost >= 0) {
    ++counts.facet_tests;
    if (kernel.orient(complex.vertices(c), ghost, q) > 0) return c;
    c = complex.cell(complex.twin(c, ghost));
  }
  int entered = -1;
  for (std::uint64_t left = 16 + 4 * static_cast<std::uint64_t>(complex.slot_count()); left != 0; --left) {
    int leave = -1;
    const int first = static_cast<int>(random() % (K + 1));
    for (int i = 0; i <= K && leave < 0; ++i) {
      const int slot = complex.turned(first, i);
      if (slot != entered && leaves_by(slot)) leave = slot;
    }
    if (leave < 0) return c;
    const FacetId across = complex.twin(c, leave);
    c = complex.cell(across);
    ++counts.crossed;
    if (complex.is_ghost(c)) return c;
    entered = complex.slot(across);
  }
  return exhaustive_locate(complex, kernel, q);
}

}  // namespace

CellId Walk::start_cell(const AnyTriangulation& t) const {
  if (start == Start::first_vertex) return cell_at(t, first_);
  const bool live = last_ != kNoCell && raw(last_) < t.complex().slot_count() && t.complex().is_live(last_);
  return live ? last_ : any_cell(t);
}

CellId Walk::hint(const AnyTriangulation& t, std::span<const double> q) {
  require_query(t, q);
  ++counts_.hints;
  if (t.affine_dimension() < 1) return any_cell(t);
  const ExactEnvironment environment;
  const Query query(t, q);
  ++counts_.levels;
  last_ = with_dimension<1>(t.affine_dimension(), [&](auto k) {
    const ConstComplexView<k> complex(t.complex());
    Kernel<k> kernel(t.sites(), query.range);
    if (method == Method::visibility) {
      return counted_walk(complex, kernel, query.leading.data(), start_cell(t), counts_);
    }
    const auto random = [&] { return mix(mix(seed) + drawn_++); };
    return remembering_walk(complex, kernel, query.leading.data(), start_cell(t), random, counts_);
  });
  return last_;
}

void Walk::update(const AnyTriangulation& t, const Edit& e) noexcept {
  last_ = e.created.empty() ? kNoCell : e.created.front();
  if (e.rebuilt || std::ranges::find(e.gone, first_) != e.gone.end()) first_ = kGhost;
  if (first_ != kGhost || any_cell(t) == kNoCell) return;
  const CellId c = any_cell(t);
  for (int i = 0; i < t.complex().corners(); ++i) {
    if (t.complex().vertex(c, i) != kGhost) first_ = t.complex().vertex(c, i);
  }
}

}  // namespace delone
