#include "delone/dual/clip.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <string>
#include <utility>

#include "base/chunks.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/buffer.hpp"
#include "dual/clipper.hpp"
#include "dual/measure.hpp"

namespace delone {
namespace {

using dual_detail::append_measures;
using dual_detail::Clipper;
using dual_detail::Frame;
using dual_detail::Point3;

void require_fit(int dimension, const Region& region) {
  if (dimension != region.dimension())
    throw InputError("points of dimension " + std::to_string(dimension) + " in a region of dimension " +
                     std::to_string(region.dimension()) + ": they must have the same, 2 or 3");
}

/// Things that cost something to make and are used by one thread at a time.
template <class T>
class Pool {
 public:
  template <class Make>
  std::unique_ptr<T> take(const Make& make) {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<T> last = std::move(idle_.back());
        idle_.pop_back();
        return last;
      }
    }
    return make();
  }
  void give(std::unique_ptr<T> thing) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(thing));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> idle_;
};

/// A block of cells, where they are and in their own units.
struct Block : dual_detail::ClippedBlock {
  CellMeasures measures;

  void clear() {
    sites.clear();
    doubtful.clear();
    shapes.corners.clear();
    shapes.loops.resize(1);
    shapes.cells.resize(1);
    shapes.rows.clear();
    shapes.across.clear();
    for (auto* numbers : {&measures.volume, &measures.surface, &measures.boundary, &measures.centroid,
                          &measures.second_moment, &measures.shared}) {
      numbers->clear();
    }
    measures.offsets.resize(1);
    measures.neighbours.clear();
  }
  void measure(const AnyTriangulation& t, const Frame& frame);
  void place_shapes(const Frame& frame);
  void place_measures(const Frame& frame);
};

void Block::measure(const AnyTriangulation& t, const Frame& frame) {
  std::vector<Point3> seen(sites.size());
  const auto d = static_cast<std::size_t>(frame.dimension);
  for (std::size_t cell = 0; cell < sites.size(); ++cell) {
    for (std::size_t axis = 0; axis < d; ++axis)
      seen[cell][axis] = frame.seen(t.sites().coordinate(sites[cell], static_cast<int>(axis)), axis);
  }
  append_measures(shapes, seen, measures);
}

void Block::place_shapes(const Frame& frame) {
  const auto d = static_cast<std::size_t>(frame.dimension);
  for (std::size_t i = 0; i < shapes.corners.size(); ++i) shapes.corners[i] = frame.placed(shapes.corners[i], i % d);
}

void Block::place_measures(const Frame& frame) {
  const auto d = static_cast<std::size_t>(frame.dimension);
  for (std::size_t i = 0; i < measures.centroid.size(); ++i)
    measures.centroid[i] = frame.placed(measures.centroid[i], i % d);
  const auto enlarge = [&](std::vector<double>& numbers, int power) {
    for (int i = 0; i < power; ++i) {
      for (double& x : numbers) x *= frame.unit;
    }
  };
  enlarge(measures.volume, frame.dimension);
  enlarge(measures.second_moment, frame.dimension + 2);
  for (auto* numbers : {&measures.surface, &measures.boundary, &measures.shared})
    enlarge(*numbers, frame.dimension - 1);
}

/// The sites in an order in which neighbours are near each other, a block at a time. In the plane that is their own. In
/// space sites follow the curve several times; there cells that are made one after the other are near each other, and
/// sites are sorted by the cells that they name as theirs.
class SiteBlocks {
 public:
  explicit SiteBlocks(const AnyTriangulation& t) : t_(t), count_(t.sites().size()) {
    if (t.affine_dimension() < 3) return;
    std::vector<std::pair<Index, Index>> keyed;  // cell, site
    keyed.reserve(t.sites().present_count());
    for (std::size_t s = 0; s < t.sites().size(); ++s) {
      const VertexId v{static_cast<Index>(s)};
      if (!t.sites().is_empty(v)) keyed.emplace_back(raw(t.complex().incident_cell(v)), static_cast<Index>(s));
    }
    std::ranges::sort(keyed);
    for (const auto& [cell, site] : keyed) sorted_.push_back(VertexId{site});
    count_ = sorted_.size();
  }

  std::size_t count() const { return count_; }
  void read(std::size_t begin, std::size_t end, std::vector<VertexId>& sites) const {
    sites.clear();
    for (std::size_t s = begin; s < end; ++s) {
      const VertexId v = sorted_.empty() ? VertexId{static_cast<Index>(s)} : sorted_[s];
      if (!t_.sites().is_empty(v)) sites.push_back(v);
    }
  }

 private:
  const AnyTriangulation& t_;
  std::size_t count_;
  std::vector<VertexId> sorted_;
};

enum class Want { shapes, measures, both };

/// Blocks of cells in the order of sites: sink(number, block), from any thread.
template <int D, class Sink>
void produce(const AnyTriangulation& t, const Region& region, Want want, const ClipOptions& options, const Sink& sink) {
  struct Worker {
    Worker(const AnyTriangulation& of, const Frame& in) : clipper(of, in) {}
    Clipper<D> clipper;
    Block block;
    std::vector<VertexId> sites;
  };
  const Frame frame(region);
  const SiteBlocks sites(t);
  Pool<Worker> workers;
  const auto work = [&](std::size_t begin, std::size_t end, std::size_t number) {
    const ExactEnvironment environment;
    auto worker = workers.take([&] { return std::make_unique<Worker>(t, frame); });
    worker->block.clear();
    sites.read(begin, end, worker->sites);
    worker->clipper.read(worker->sites, worker->block);
    if (want != Want::shapes) {
      worker->block.measure(t, frame);
      worker->block.place_measures(frame);
    }
    if (want != Want::measures) worker->block.place_shapes(frame);
    sink(number, worker->block);
    workers.give(std::move(worker));
  };
  for_chunks(sites.count(), options.threads, work, options.progress);
}

template <class Sink>
void produce(const AnyTriangulation& t, const Region& region, Want want, const ClipOptions& options, const Sink& sink) {
  require_fit(t.dimension(), region);
  const ExactEnvironment environment;
  if (t.dimension() == 2) {
    produce<2>(t, region, want, options, sink);
  } else {
    produce<3>(t, region, want, options, sink);
  }
}

std::size_t block_count(const AnyTriangulation& t) { return (t.sites().size() + kChunk - 1) / kChunk; }

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from, std::size_t begin, std::size_t end) {
  to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
            from.begin() + static_cast<std::ptrdiff_t>(end));
}

void append_cell(CellShapes& to, const CellShapes& from, std::size_t cell) {
  const auto d = static_cast<std::size_t>(from.dimension);
  const std::size_t begin = from.cells[cell];
  const std::size_t end = from.cells[cell + 1];
  const std::size_t shift = to.loops.back() - from.loops[begin];  // may wrap, and back
  append(to.corners, from.corners, from.loops[begin] * d, from.loops[end] * d);
  for (std::size_t l = begin; l < end; ++l) to.loops.push_back(from.loops[l + 1] + shift);
  if (from.dimension == 2) {
    append(to.across, from.across, from.loops[begin], from.loops[end]);
  } else {
    append(to.across, from.across, begin, end);
  }
}

/// What a cell measures, side by side in memory: rows are written in no order. Its surface is the boundary and what is
/// shared.
struct Line {
  double volume = 0, boundary = 0, second_moment = 0;
  std::array<double, 3> centroid;
  std::size_t begin = 0, count = 0;  ///< of the neighbours
};

/// The measures of blocks, until all are there.
class Collected {
 public:
  explicit Collected(std::size_t rows) {
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    lines_.resize(rows, Line{.centroid = {kNowhere, kNowhere, kNowhere}});
  }

  void add(const Block& block) {
    const CellMeasures& from = block.measures;
    const std::size_t begin = append(block);
    const auto d = static_cast<std::size_t>(from.dimension);
    for (std::size_t cell = 0; cell < block.shapes.size(); ++cell) {
      Line& line = lines_[block.shapes.rows[cell]];
      line.volume = from.volume[cell];
      line.boundary = from.boundary[cell];
      line.second_moment = from.second_moment[cell];
      for (std::size_t axis = 0; axis < d; ++axis) line.centroid[axis] = from.centroid[cell * d + axis];
      line.begin = begin + from.offsets[cell];
      line.count = from.offsets[cell + 1] - from.offsets[cell];
    }
  }

  /// Row by row.
  CellMeasures measures(int dimension) const;
  const std::vector<std::array<Index, 2>>& doubtful() const { return doubtful_; }

 private:
  /// Returns where the neighbours of the block begin.
  std::size_t append(const Block& block) {
    const std::lock_guard lock(mutex_);
    const std::size_t begin = neighbours_.size();
    std::ranges::copy(block.measures.neighbours, neighbours_.extend(block.measures.neighbours.size()));
    std::ranges::copy(block.measures.shared, shared_.extend(block.measures.shared.size()));
    doubtful_.insert(doubtful_.end(), block.doubtful.begin(), block.doubtful.end());
    return begin;
  }

  Buffer<Line> lines_;
  std::mutex mutex_;
  Buffer<Index> neighbours_;
  Buffer<double> shared_;
  std::vector<std::array<Index, 2>> doubtful_;
};

CellMeasures Collected::measures(int dimension) const {
  CellMeasures all;
  all.dimension = dimension;
  for (auto* numbers : {&all.volume, &all.surface, &all.boundary, &all.second_moment}) numbers->reserve(lines_.size());
  all.centroid.reserve(lines_.size() * static_cast<std::size_t>(dimension));
  all.offsets.reserve(lines_.size() + 1);
  all.neighbours.reserve(neighbours_.size());
  all.shared.reserve(neighbours_.size());
  constexpr std::size_t kAhead = 16;
  for (std::size_t row = 0; row < lines_.size(); ++row) {
    const Line& soon = lines_[std::min(row + kAhead, lines_.size() - 1)];
    __builtin_prefetch(neighbours_.data() + soon.begin);
    __builtin_prefetch(shared_.data() + soon.begin);
    const Line& line = lines_[row];
    all.volume.push_back(line.volume);
    all.boundary.push_back(line.boundary);
    all.second_moment.push_back(line.second_moment);
    all.centroid.insert(all.centroid.end(), line.centroid.begin(), line.centroid.begin() + dimension);
    const Index* const neighbours = neighbours_.data() + line.begin;
    const double* const shared = shared_.data() + line.begin;
    all.surface.push_back(std::accumulate(shared, shared + line.count, line.boundary));
    all.neighbours.insert(all.neighbours.end(), neighbours, neighbours + line.count);
    all.shared.insert(all.shared.end(), shared, shared + line.count);
    all.offsets.push_back(all.neighbours.size());
  }
  return all;
}

/// Where `row` says what it shares with `other`; nothing when it does not know of it.
double* shared_with(CellMeasures& all, Index row, Index other) {
  const auto begin = all.neighbours.begin() + static_cast<std::ptrdiff_t>(all.offsets[row]);
  const auto end = all.neighbours.begin() + static_cast<std::ptrdiff_t>(all.offsets[row + std::size_t{1}]);
  const auto found = std::lower_bound(begin, end, other);
  return found == end || *found != other ? nullptr
                                         : &all.shared[static_cast<std::size_t>(found - all.neighbours.begin())];
}

/// What two cells share is what the lower row says. What only one of them knows of is the boundary of the region, which
/// ends where a bisector runs.
void agree(const std::vector<std::array<Index, 2>>& doubtful, CellMeasures& all) {
  for (const auto& [a, b] : doubtful) {
    double* const low = shared_with(all, std::min(a, b), std::max(a, b));
    double* const high = shared_with(all, std::max(a, b), std::min(a, b));
    if (low != nullptr && high != nullptr) {
      *high = *low;
    } else if (low != nullptr || high != nullptr) {
      all.boundary[low != nullptr ? std::min(a, b) : std::max(a, b)] +=
          std::exchange(*(low != nullptr ? low : high), 0.0);
    }
  }
}

void drop_unshared(CellMeasures& all) {
  if (std::ranges::find(all.shared, 0.0) == all.shared.end()) return;
  std::size_t kept = 0;
  std::size_t begin = 0;
  for (std::size_t row = 0; row + 1 < all.offsets.size(); ++row) {
    const std::size_t end = all.offsets[row + 1];
    for (; begin < end; ++begin) {
      if (all.shared[begin] == 0) continue;
      all.neighbours[kept] = all.neighbours[begin];
      all.shared[kept++] = all.shared[begin];
    }
    all.offsets[row + 1] = kept;
  }
  all.neighbours.resize(kept);
  all.shared.resize(kept);
}

}  // namespace

CellShapes clipped_cells(const AnyTriangulation& t, const Region& region, const ClipOptions& options) {
  std::vector<CellShapes> blocks(block_count(t));
  produce(t, region, Want::shapes, options,
          [&](std::size_t number, const Block& block) { blocks[number] = block.shapes; });
  std::vector<std::pair<std::size_t, std::size_t>> place(t.row_count(), {blocks.size(), 0});
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    for (std::size_t cell = 0; cell < blocks[block].size(); ++cell) place[blocks[block].rows[cell]] = {block, cell};
  }
  CellShapes all;
  all.dimension = t.dimension();
  for (std::size_t row = 0; row < place.size(); ++row) {
    if (place[row].first < blocks.size()) append_cell(all, blocks[place[row].first], place[row].second);
    all.rows.push_back(static_cast<Index>(row));
    all.cells.push_back(all.loops.size() - 1);
  }
  return all;
}

CellMeasures measure_cells(const AnyTriangulation& t, const Region& region, const ClipOptions& options) {
  Collected collected(t.row_count());
  produce(t, region, Want::measures, options, [&](std::size_t, const Block& block) { collected.add(block); });
  CellMeasures all = collected.measures(t.dimension());
  agree(collected.doubtful(), all);
  drop_unshared(all);
  return all;
}

void for_cells(const AnyTriangulation& t, const Region& region, const VisitCells& visit, const ClipOptions& options) {
  std::mutex one_at_a_time;
  produce(t, region, Want::both, options, [&](std::size_t, const Block& block) {
    const std::lock_guard lock(one_at_a_time);
    visit(block.shapes, block.measures);
  });
}

CellShapes cut_cells(PointsView points, const Region& region, const std::vector<std::size_t>& offsets,
                     const std::vector<Bisector>& cuts, const ClipOptions& options) {
  require_fit(points.dimension(), region);
  const ExactEnvironment environment;
  const Frame frame(region);
  CellShapes shapes;
  dual_detail::CellWriter writer(frame);
  dual_detail::LoopCutter cutter;
  std::vector<dual_detail::Plane> planes;
  writer.begin(shapes);
  for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell) {
    tell(options.progress, cell, offsets.size());
    const bool whole = offsets[cell] == offsets[cell + 1];
    const auto eye = writer.look_from(whole ? std::span<const double>() : points[cuts[offsets[cell]].near]);
    planes.clear();
    for (std::size_t i = offsets[cell]; i < offsets[cell + 1]; ++i)
      planes.push_back(dual_detail::bisector(points[cuts[i].near], points.weight(cuts[i].near), points[cuts[i].far],
                                             points.weight(cuts[i].far), frame, eye, cuts[i].across));
    if (region.dimension() == 3) {
      writer.add_cut_region(planes);
    } else {
      dual_detail::Loops loops = writer.seen_from_eye(frame.loops);
      for (const auto& plane : planes)
        cutter.cut(loops, {{plane.normal[0], plane.normal[1]}, plane.offset}, plane.across);
      writer.add_seen_from_eye(std::move(loops));
    }
    writer.end_cell(static_cast<Index>(cell));
  }
  for (std::size_t i = 0; i < shapes.corners.size(); ++i)
    shapes.corners[i] = frame.placed(shapes.corners[i], i % static_cast<std::size_t>(frame.dimension));
  return shapes;
}

CellMeasures measure_shapes(const CellShapes& shapes, PointsView sites) {
  std::vector<Point3> places(shapes.size());
  for (std::size_t cell = 0; cell < places.size(); ++cell) std::ranges::copy(sites[cell], places[cell].begin());
  CellMeasures measures;
  append_measures(shapes, places, measures);
  return measures;
}

}  // namespace delone
