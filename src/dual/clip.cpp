#include "delone/dual/clip.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <string>
#include <utility>

#include "base/chunks.hpp"
#include "base/part_of.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/buffer.hpp"
#include "dual/clipper.hpp"
#include "dual/measure.hpp"
#include "dual/measure_directly.hpp"
#include "dual/measure_table.hpp"

namespace delone {
namespace {

using dual_detail::append_measures;
using dual_detail::Clipper;
using dual_detail::Frame;
using dual_detail::measure_directly;
using dual_detail::MeasureTable;
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
  /// Where they are, from shapes as they are seen.
  void measure(const AnyTriangulation& t, const Frame& frame);
  void place_shapes(const Frame& frame);

 private:
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
  place_measures(frame);
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
    for (double& x : numbers) x = frame.enlarged(x, power);
  };
  enlarge(measures.volume, frame.dimension);
  enlarge(measures.second_moment, frame.dimension + 2);
  for (auto* numbers : {&measures.surface, &measures.boundary, &measures.shared})
    enlarge(*numbers, frame.dimension - 1);
}

/// Sites in an order in which neighbours are near each other, a block at a time. In the plane that is their own. In
/// space sites follow the curve several times; there cells that are made one after the other are near each other, and
/// sites are sorted by the cells that they name as theirs.
class SiteBlocks {
 public:
  /// All sites.
  explicit SiteBlocks(const AnyTriangulation& t) : t_(t), count_(t.sites().size()) {
    if (t.affine_dimension() < 3) return;
    for (std::size_t s = 0; s < count_; ++s) {
      const VertexId v{static_cast<Index>(s)};
      if (!t.sites().is_empty(v)) listed_.push_back(v);
    }
    sort();
  }
  /// Some of them.
  SiteBlocks(const AnyTriangulation& t, std::vector<VertexId> some) : t_(t), listed_(std::move(some)) { sort(); }

  std::size_t count() const { return count_; }
  void read(std::size_t begin, std::size_t end, std::vector<VertexId>& sites) const {
    sites.clear();
    for (std::size_t s = begin; s < end; ++s) {
      const VertexId v = listed_.empty() ? VertexId{static_cast<Index>(s)} : listed_[s];
      if (!t_.sites().is_empty(v)) sites.push_back(v);
    }
  }

 private:
  void sort() {
    count_ = listed_.size();
    if (t_.affine_dimension() == 3)
      std::ranges::sort(listed_, {}, [&](VertexId v) { return std::pair(t_.complex().incident_cell(v), v); });
  }

  const AnyTriangulation& t_;
  std::size_t count_ = 0;
  std::vector<VertexId> listed_;
};

/// Blocks of cells in the order of sites: sink(number, block), from any thread.
template <int D, class Sink>
void produce(const AnyTriangulation& t, const Frame& frame, const SiteBlocks& sites, const ClipOptions& options,
             const Sink& sink) {
  struct Worker {
    Worker(const AnyTriangulation& of, const Frame& in) : clipper(of, in) {}
    Clipper<D> clipper;
    Block block;
    std::vector<VertexId> sites;
  };
  Pool<Worker> workers;
  const auto work = [&](std::size_t begin, std::size_t end, std::size_t number) {
    const ExactEnvironment environment;
    auto worker = workers.take([&] { return std::make_unique<Worker>(t, frame); });
    worker->block.clear();
    sites.read(begin, end, worker->sites);
    worker->clipper.read(worker->sites, worker->block);
    sink(number, worker->block);
    workers.give(std::move(worker));
  };
  for_chunks(sites.count(), options.threads, work, options.progress);
}

template <class Sink>
void produce(const AnyTriangulation& t, const Frame& frame, const SiteBlocks& sites, const ClipOptions& options,
             const Sink& sink) {
  if (t.dimension() == 2) {
    produce<2>(t, frame, sites, options, sink);
  } else {
    produce<3>(t, frame, sites, options, sink);
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

}  // namespace

CellShapes clipped_cells(const AnyTriangulation& t, const Region& region, const ClipOptions& options) {
  require_fit(t.dimension(), region);
  const ExactEnvironment environment;
  const Frame frame(region);
  std::vector<CellShapes> blocks(block_count(t));
  produce(t, frame, SiteBlocks(t), options, [&](std::size_t number, Block& block) {
    block.place_shapes(frame);
    blocks[number] = block.shapes;
  });
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
  require_fit(t.dimension(), region);
  const ExactEnvironment environment;
  const Frame frame(region);
  const bool direct = t.affine_dimension() == t.dimension() && !frame.sides.empty();
  const double share = direct ? 0.9 : 0;  // of the work
  const ClipOptions most{options.threads, part_of(options.progress, 0, share)};
  const ClipOptions rest{options.threads, part_of(options.progress, share, 1)};
  MeasureTable table(t);
  const SiteBlocks others = direct ? SiteBlocks(t, measure_directly(t, frame, most, table)) : SiteBlocks(t);
  produce(t, frame, others, rest, [&](std::size_t, Block& block) {
    block.measure(t, frame);
    table.put(block, block.measures);
  });
  return table.rows();
}

void for_cells(const AnyTriangulation& t, const Region& region, const VisitCells& visit, const ClipOptions& options) {
  require_fit(t.dimension(), region);
  const ExactEnvironment environment;
  const Frame frame(region);
  std::mutex one_at_a_time;
  produce(t, frame, SiteBlocks(t), options, [&](std::size_t, Block& block) {
    block.measure(t, frame);
    block.place_shapes(frame);
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
