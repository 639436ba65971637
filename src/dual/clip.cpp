#include "delone/dual/clip.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/chunks.hpp"
#include "delone/base/arithmetic.hpp"
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

/// Moves what is seen from the middle to where it is.
void place(std::vector<double>& coordinates, const Frame& frame) {
  const auto d = static_cast<std::size_t>(frame.dimension);
  for (std::size_t i = 0; i < coordinates.size(); ++i) coordinates[i] += frame.middle[i % d];
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

/// Blocks of cells in the order of sites: sink(block, shapes, measures), from any thread. Measures only where asked
/// for.
template <int D, class Sink>
void produce(const AnyTriangulation& t, const Region& region, bool measured, const ClipOptions& options,
             const Sink& sink) {
  const Frame frame(region);
  Pool<Clipper<D>> clippers;
  const auto work = [&](std::size_t begin, std::size_t end, std::size_t block) {
    const ExactEnvironment environment;
    auto clipper = clippers.take([&] { return std::make_unique<Clipper<D>>(t, frame); });
    CellShapes shapes;
    clipper->block(begin, end, shapes);
    clippers.give(std::move(clipper));
    CellMeasures measures;
    if (measured) {
      const auto site = [&](std::size_t cell) {
        Point3 at{};
        for (int axis = 0; axis < D; ++axis) {
          const auto a = static_cast<std::size_t>(axis);
          at[a] = t.sites().coordinate(t.vertex(shapes.rows[cell]), axis) - frame.middle[a];
        }
        return at;
      };
      append_measures(shapes, site, measures);
      place(measures.centroid, frame);
      for (std::size_t cell = 0; cell < shapes.size(); ++cell) {
        if (measures.volume[cell] > 0) continue;
        for (int axis = 0; axis < D; ++axis)
          measures.centroid[cell * D + static_cast<std::size_t>(axis)] =
              t.sites().coordinate(t.vertex(shapes.rows[cell]), axis);
      }
    }
    place(shapes.corners, frame);
    sink(block, std::move(shapes), std::move(measures));
  };
  for_chunks(t.sites().size(), options.threads, work, options.progress);
}

template <class Sink>
void produce(const AnyTriangulation& t, const Region& region, bool measured, const ClipOptions& options,
             const Sink& sink) {
  require_fit(t.dimension(), region);
  const ExactEnvironment environment;
  if (t.dimension() == 2) {
    produce<2>(t, region, measured, options, sink);
  } else {
    produce<3>(t, region, measured, options, sink);
  }
}

std::size_t block_count(const AnyTriangulation& t) { return (t.sites().size() + kChunk - 1) / kChunk; }

/// Where the cell of each row stands among blocks.
struct Place {
  std::size_t block = 0, cell = 0;
  bool found = false;
};

std::vector<Place> places(const std::vector<std::vector<Index>>& rows_of_blocks, std::size_t row_count) {
  std::vector<Place> places(row_count);
  for (std::size_t block = 0; block < rows_of_blocks.size(); ++block) {
    const std::vector<Index>& rows = rows_of_blocks[block];
    for (std::size_t cell = 0; cell < rows.size(); ++cell) places[rows[cell]] = {block, cell, true};
  }
  return places;
}

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

void append_cell(CellMeasures& to, const CellMeasures& from, std::size_t cell) {
  const auto d = static_cast<std::size_t>(from.dimension);
  to.volume.push_back(from.volume[cell]);
  to.surface.push_back(from.surface[cell]);
  to.boundary.push_back(from.boundary[cell]);
  to.second_moment.push_back(from.second_moment[cell]);
  append(to.centroid, from.centroid, cell * d, (cell + 1) * d);
  append(to.neighbours, from.neighbours, from.offsets[cell], from.offsets[cell + 1]);
  append(to.shared, from.shared, from.offsets[cell], from.offsets[cell + 1]);
}

void append_nothing(CellMeasures& to) {
  for (auto* numbers : {&to.volume, &to.surface, &to.boundary, &to.second_moment}) numbers->push_back(0);
  to.centroid.insert(to.centroid.end(), static_cast<std::size_t>(to.dimension),
                     std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

CellShapes clipped_cells(const AnyTriangulation& t, const Region& region, const ClipOptions& options) {
  std::vector<CellShapes> blocks(block_count(t));
  std::vector<std::vector<Index>> rows(blocks.size());
  produce(t, region, false, options, [&](std::size_t block, CellShapes&& shapes, CellMeasures&&) {
    rows[block] = shapes.rows;
    blocks[block] = std::move(shapes);
  });
  CellShapes all;
  all.dimension = t.dimension();
  const std::vector<Place> place = places(rows, t.row_count());
  for (std::size_t row = 0; row < place.size(); ++row) {
    if (place[row].found) append_cell(all, blocks[place[row].block], place[row].cell);
    all.rows.push_back(static_cast<Index>(row));
    all.cells.push_back(all.loops.size() - 1);
  }
  return all;
}

CellMeasures measure_cells(const AnyTriangulation& t, const Region& region, const ClipOptions& options) {
  std::vector<CellMeasures> blocks(block_count(t));
  std::vector<std::vector<Index>> rows(blocks.size());
  produce(t, region, true, options, [&](std::size_t block, CellShapes&& shapes, CellMeasures&& measures) {
    rows[block] = std::move(shapes.rows);
    blocks[block] = std::move(measures);
  });
  CellMeasures all;
  all.dimension = t.dimension();
  for (const Place& place : places(rows, t.row_count())) {
    if (place.found) {
      append_cell(all, blocks[place.block], place.cell);
    } else {
      append_nothing(all);
    }
    all.offsets.push_back(all.neighbours.size());
  }
  return all;
}

void for_cells(const AnyTriangulation& t, const Region& region, const VisitCells& visit, const ClipOptions& options) {
  std::mutex one_at_a_time;
  produce(t, region, true, options, [&](std::size_t, CellShapes&& shapes, CellMeasures&& measures) {
    const std::lock_guard lock(one_at_a_time);
    visit(shapes, measures);
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
    planes.clear();
    for (std::size_t i = offsets[cell]; i < offsets[cell + 1]; ++i)
      planes.push_back(dual_detail::bisector(points[cuts[i].near], points.weight(cuts[i].near), points[cuts[i].far],
                                             points.weight(cuts[i].far), frame.middle, cuts[i].across));
    if (region.dimension() == 3) {
      writer.add_polytope(planes);
    } else {
      dual_detail::Loops loops = frame.loops;
      for (const auto& plane : planes)
        cutter.cut(loops, {{plane.normal[0], plane.normal[1]}, plane.offset}, plane.across);
      if (!loops.empty()) writer.add(loops);
    }
    writer.end_cell(static_cast<Index>(cell));
  }
  place(shapes.corners, frame);
  return shapes;
}

CellMeasures measure_shapes(const CellShapes& shapes, PointsView sites) {
  CellMeasures measures;
  append_measures(
      shapes,
      [&](std::size_t cell) {
        Point3 at{};
        std::ranges::copy(sites[cell], at.begin());
        return at;
      },
      measures);
  return measures;
}

}  // namespace delone
