#include "delone/locate/hierarchy.hpp"

#include <algorithm>
#include <new>

#include "delone/base/dispatch.hpp"
#include "delone/base/random.hpp"
#include "delone/build/build.hpp"
#include "delone/remove/remove.hpp"
#include "locate/marches.hpp"
#include "locate/reading.hpp"

namespace delone {
namespace {

constexpr std::size_t kFewRows = 64;  // so many that have left are no reason to build a level again

}  // namespace

Hierarchy::Level::Level(int dimension, double alpha, std::uint64_t seed) : triangulation(dimension) {
  sample.alpha = alpha;
  sample.seed = seed;
}

// Location.

CellId Hierarchy::hint(const AnyTriangulation& t, std::span<const double> q) {
  require_query(t, q);
  ++counts_.hints;
  if (t.affine_dimension() < 1) return any_cell(t);
  const ExactEnvironment environment;
  const VertexId v = descend(t, q);
  return arrive && v != kGhost ? march(t, v, q) : cell_at(t, v);
}

/// Marches on all levels above the user's. Returns the vertex there from which to go on, the ghost if none is known.
VertexId Hierarchy::descend(const AnyTriangulation& t, std::span<const double> q) {
  last_query_.clear();
  std::size_t used = levels_.size();
  while (used > 0 && levels_[used - 1].triangulation.vertex_count() < std::max<std::size_t>(minimal_size, 1)) --used;
  for (std::size_t i = used; i < levels_.size(); ++i) levels_[i].place = kNoCell;
  if (used == 0) return start_vertex(t, q);
  Index row = start_row(levels_[used - 1], q);
  for (std::size_t i = used; i-- > 0;) {
    Level& level = levels_[i];
    const AnyTriangulation& here = level.triangulation;
    level.place = march(here, here.vertex(row), q);
    VertexId v = nearest_corner(here, level.place, q);
    if (exact_nearest) v = nearest_vertex(here, v, q);
    row = level.below[here.row(v)];
  }
  last_query_.assign(q.begin(), q.end());
  return VertexId{row};
}

Index Hierarchy::start_row(Level& level, std::span<const double> q) const {
  const AnyTriangulation& here = level.triangulation;
  VertexId v = kGhost;
  if (jump_and_walk && here.vertex_count() >= minimal_sample_size) v = level.sample.nearest(q);
  if (v == kGhost && level.newest != kNone) v = here.vertex(level.newest);
  if (v == kGhost || !is_vertex(here, v)) {
    const CellId c = any_cell(here);  // of a hull facet
    for (int i = 0; i < here.complex().corners(); ++i) {
      if (here.complex().vertex(c, i) != kGhost) v = here.complex().vertex(c, i);
    }
    if (v == kGhost) v = here.complex().vertex(here.complex().cell(here.complex().twin(c, 0)), 0);  // a single point
  }
  return here.row(v);
}

VertexId Hierarchy::start_vertex(const AnyTriangulation& t, std::span<const double> q) {
  if (jump_and_walk && t.vertex_count() >= minimal_sample_size) return sample_.nearest(q);
  return newest_;
}

CellId Hierarchy::march(const AnyTriangulation& t, VertexId from, std::span<const double> q) {
  ++counts_.levels;
  if (t.affine_dimension() < 1) return t.complex().cell(t.complex().twin(any_cell(t), 0));
  const Query query(t, q);
  return with_dimension<1>(t.affine_dimension(), [&](auto k) {
    const ConstComplexView<k> complex(t.complex());
    Kernel<k> kernel(t.sites(), query.range);
    if constexpr (k == 2) {
      if (straight) return StraightWalk(complex, kernel, query.leading.data(), counts_).from(from);
    }
    return counted_walk(complex, kernel, query.leading.data(), cell_at(t, from), counts_);
  });
}

VertexId Hierarchy::nearest_corner(const AnyTriangulation& t, CellId c, std::span<const double> q) {
  VertexId best = kGhost;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < t.complex().corners(); ++i) {
    const VertexId v = t.complex().vertex(c, i);
    if (v == kGhost) continue;
    const double distance = squared_distance(t.sites(), v, q);
    ++counts_.distances;
    if (best == kGhost || distance < least) best = v;
    least = std::min(distance, least);
  }
  return best;
}

VertexId Hierarchy::nearest_vertex(const AnyTriangulation& t, VertexId from, std::span<const double> q) {
  VertexId best = from;
  double least = squared_distance(t.sites(), from, q);
  for (VertexId at = kGhost; at != best;) {  // ends: the distance shrinks
    at = best;
    ++counts_.visited;
    for (const CellId c : t.star(at)) {
      const VertexId v = nearest_corner(t, c, q);
      const double distance = squared_distance(t.sites(), v, q);
      if (distance < least) best = v;
      least = std::min(distance, least);
    }
  }
  return best;
}

LocateCounts Hierarchy::counts() const {
  LocateCounts all = counts_;
  all.distances += sample_.counts().distances;
  for (const Level& level : levels_) all.distances += level.sample.counts().distances;
  return all;
}

// Changes.

void Hierarchy::update(const AnyTriangulation& t, const Edit& e) noexcept {
  try {
    sample_.alpha = alpha;
    sample_.seed = seed;
    if (jump_and_walk) sample_.update(t, e);
    if (e.rebuilt) return rebuild(t);
    for (const VertexId v : e.gone) leave(v);
    for (const VertexId v : e.came) enter(t, v);
  } catch (const std::bad_alloc&) {
    forget();
  }
}

/// How many levels above the user's a vertex stands on.
int Hierarchy::draw_height() {
  const std::uint64_t least = mix(seed ^ 0x4C65'7665'6C73U);
  int height = 0;
  while (height < max_levels && static_cast<double>(mix(least + drawn_++) >> 11) * 0x1p-53 * ratio < 1.0) ++height;
  return height;
}

void Hierarchy::enter(const AnyTriangulation& t, VertexId v) {
  newest_ = v;
  const int height = draw_height();
  if (height == 0) return;
  const PointCopy x = coordinates_of(t.sites(), v);
  const std::span point(x.data(), static_cast<std::size_t>(t.dimension()));
  if (!std::ranges::equal(last_query_, point)) descend(t, point);
  Index below = raw(v);
  for (std::size_t i = 0; i < static_cast<std::size_t>(height); ++i) {
    if (i == levels_.size()) levels_.emplace_back(t.dimension(), alpha, seed + i + 1);
    if (!raise(i, point, below)) break;
  }
  last_query_.clear();
}

/// Puts the point that is `below` one level lower on level i, and makes `below` its row there.
bool Hierarchy::raise(std::size_t i, std::span<const double> point, Index& below) {
  Level& level = levels_[i];
  level.below.reserve(level.below.size() + 1);
  level.above.reserve(level.above.size() + 1);
  const auto tell = [&](const Edit& e) { level.sample.update(level.triangulation, e); };
  const Inserted done = insert(level.triangulation, point, 0.0, {.near = level.place, .on_edit = tell});
  level.place = kNoCell;
  const bool inserted = done.outcome == Outcome::inserted;
  level.below.push_back(inserted ? below : kNone);
  level.above.push_back(kNone);
  if (!inserted) {
    ++level.left;
    return false;
  }
  level.newest = done.row;
  link_below(i, below, done.row);
  below = done.row;
  return true;
}

void Hierarchy::link_below(std::size_t i, Index below, Index row) {
  if (i == 0) {
    lowest_rows_[below] = row;
  } else {
    levels_[i - 1].above[below] = row;
  }
}

void Hierarchy::leave(VertexId v) {
  if (v == newest_) newest_ = kGhost;
  const auto found = lowest_rows_.find(raw(v));
  if (found == lowest_rows_.end()) return;
  Index row = found->second;
  lowest_rows_.erase(found);
  last_query_.clear();
  for (std::size_t i = 0; row != kNone; ++i) {
    const Index above = levels_[i].above[row];
    remove_row(i, row);
    row = above;
  }
  while (!levels_.empty() && levels_.back().triangulation.vertex_count() == 0) levels_.pop_back();
}

void Hierarchy::remove_row(std::size_t i, Index row) {
  Level& level = levels_[i];
  level.below[row] = level.above[row] = kNone;
  if (row == level.newest) level.newest = kNone;
  ++level.left;
  const auto tell = [&](const Edit& e) { level.sample.update(level.triangulation, e); };
  remove(level.triangulation, row, {.on_edit = tell});
  level.place = kNoCell;
  if (2 * level.left > level.below.size() + kFewRows) renew(i);  // rows are not used again
}

/// Builds level i again from the rows that have not left, and numbers these anew.
void Hierarchy::renew(std::size_t i) {
  Level& level = levels_[i];
  std::vector<double> points;
  std::size_t rows = 0;
  for (std::size_t row = 0; row < level.below.size(); ++row) {
    if (level.below[row] == kNone) continue;
    const std::vector<double> x = level.triangulation.point(static_cast<Index>(row));
    points.insert(points.end(), x.begin(), x.end());
    const auto renamed = static_cast<Index>(rows++);
    level.below[renamed] = level.below[row];
    level.above[renamed] = level.above[row];
    link_below(i, level.below[renamed], renamed);
    if (level.above[renamed] != kNone) levels_[i + 1].below[level.above[renamed]] = renamed;
  }
  level.below.resize(rows);
  level.above.resize(rows);
  level.left = 0;
  level.newest = rows == 0 ? kNone : static_cast<Index>(rows - 1);
  level.place = kNoCell;
  level.triangulation = build(PointsView(points, level.triangulation.dimension()));
  level.sample.update(level.triangulation, {.rebuilt = true});
}

/// All levels anew. Marches then begin at any vertex of the highest one.
void Hierarchy::rebuild(const AnyTriangulation& t) {
  forget();
  std::vector<std::vector<double>> points;  // of each level
  std::uint64_t seen = 0;
  for_each_vertex(t, [&](VertexId v) {
    if (mix(seed + seen) % (seen + 1) == 0) newest_ = v;  // any one: the last ids lie at the end of a curve
    ++seen;
    const auto height = static_cast<std::size_t>(draw_height());
    const PointCopy x = coordinates_of(t.sites(), v);
    Index below = raw(v);
    for (std::size_t i = 0; i < height; ++i) {
      if (i == levels_.size()) {
        levels_.emplace_back(t.dimension(), alpha, seed + i + 1);
        points.emplace_back();
      }
      Level& level = levels_[i];
      points[i].insert(points[i].end(), x.begin(), x.begin() + t.dimension());
      const auto row = static_cast<Index>(level.below.size());
      level.below.push_back(below);
      level.above.push_back(kNone);
      link_below(i, below, row);
      below = row;
    }
  });
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    levels_[i].triangulation = build(PointsView(points[i], t.dimension()));
    levels_[i].sample.update(levels_[i].triangulation, {.rebuilt = true});
    levels_[i].newest = static_cast<Index>(mix(seed + i) % levels_[i].below.size());
  }
}

void Hierarchy::forget() {
  levels_.clear();
  lowest_rows_.clear();
  last_query_.clear();
  newest_ = kGhost;
}

std::size_t Hierarchy::memory_bytes() const {
  std::size_t bytes = sizeof *this + sample_.memory_bytes() - sizeof sample_ + last_query_.capacity() * sizeof(double) +
                      lowest_rows_.size() * (2 * sizeof(Index) + 2 * sizeof(void*)) +
                      lowest_rows_.bucket_count() * sizeof(void*) + levels_.capacity() * sizeof(Level);
  for (const Level& level : levels_) {
    bytes += level.triangulation.memory_bytes() - sizeof level.triangulation + level.sample.memory_bytes() -
             sizeof level.sample + (level.below.capacity() + level.above.capacity()) * sizeof(Index);
  }
  return bytes;
}

}  // namespace delone
