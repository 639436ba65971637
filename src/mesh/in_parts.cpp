// Each site belongs to a box, each box to a thread. A thread inserts the sites of its box as ever, but changes no cell
// that has a vertex in another box, and puts off a site for which it would have to (Territory says why nobody is in
// anybody's way then: no locks, no marks that others see). What is put off lies along the sides of boxes; it is shared
// out again in other boxes, and when little is left one thread inserts it. As a triangulation does not depend on the
// order of insertion, nothing has to be mended.
//
// Source: [MPR19], where threads own pieces of a curve, notice what others touch by the owner of each vertex, put it
// off and move the pieces. Departures: cells of several boxes stay through a pass, so nothing depends on who was first;
// boxes through medians, since they are convex, as the way of a walk is, and as easy to cut in any dimension.
//
// Cost: a share of the insertions, and for a round of m uniform sites in K dimensions O(m^(1 - 1/K)) that are put off.
#include "mesh/in_parts.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/chunks.hpp"
#include "base/part_of.hpp"
#include "base/tell_every.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/mesh/inserter.hpp"
#include "mesh/incremental.hpp"

namespace delone {
namespace {

constexpr std::size_t kMostBoxes = 255;

/// Boxes for about as many of some sites each, by cuts through medians, each across the axis on which the middle eighth
/// of the sites reaches farthest, then the middle half: few lie near a cut, and sites along one are next cut across it.
template <int K>
class Boxes {
 public:
  Boxes(const Sites& sites, const Buffer<Index>& some, std::size_t count) : x_(sites.leading()) {
    constexpr std::size_t kSample = 1 << 11;  // of the sites of a box, to find where to cut
    std::vector<Index> sample;
    for (std::size_t i = 0; i < some.size(); i += some.size() / (kSample * count) + 1) sample.push_back(some[i]);
    cut(sample, count);
  }

  std::uint8_t box_of(Index site) const {
    std::size_t node = 0;
    while (nodes_[node].upper != 0)
      node = at(site, nodes_[node].axis) < nodes_[node].bound ? node + 1 : nodes_[node].upper;
    return nodes_[node].box;
  }

 private:
  struct Node {
    std::size_t axis = 0;
    double bound = 0.0;     ///< what lies below is in the next node,
    std::size_t upper = 0;  ///< the rest in this one; none: a box
    std::uint8_t box = 0;
  };

  double at(Index site, std::size_t axis) const { return x_[site * std::size_t{K} + axis]; }

  void cut(std::span<Index> sites, std::size_t boxes) {
    const std::size_t node = nodes_.size();
    nodes_.push_back({.box = boxes_});
    if (boxes == 1) {
      ++boxes_;
      return;
    }
    const auto nth = [&](std::size_t rank, std::size_t axis) {
      const auto place = [&](Index site) { return at(site, axis); };
      std::ranges::nth_element(sites, sites.begin() + static_cast<std::ptrdiff_t>(rank), {}, place);
      return place(sites[rank]);
    };
    const std::size_t lower = sites.size() * (boxes / 2) / boxes;
    if (!sites.empty()) {
      const auto reach = [&](std::size_t part, std::size_t axis) {  // of the middle one of so many parts
        const std::size_t half = sites.size() / (2 * part);
        return nth(sites.size() / 2 + half, axis) * 0.5 - nth(sites.size() / 2 - half, axis) * 0.5;
      };
      std::pair widest(-1.0, -1.0);
      for (std::size_t axis = 0; axis < K; ++axis) {
        const std::pair width(reach(8, axis), reach(2, axis));
        if (width > widest) nodes_[node].axis = axis;
        widest = std::max(width, widest);
      }
      nodes_[node].bound = nth(lower, nodes_[node].axis);
    }
    cut(sites.first(lower), boxes / 2);
    nodes_[node].upper = nodes_.size();
    cut(sites.subspan(lower), boxes - boxes / 2);
  }

  const double* x_;
  std::vector<Node> nodes_;
  std::uint8_t boxes_ = 0;
};

/// A round: sites to insert, along a curve, into a mesh whose sites before them are vertices, or are none.
struct Round {
  std::size_t first, last;
  Buffer<Index> waiting;  ///< of the sites from first to last - 1, ascending

  Round(std::size_t from, std::size_t to) : first(from), last(to), waiting(to - from) {
    std::iota(waiting.begin(), waiting.end(), static_cast<Index>(from));
  }
};

/// Where the threads find slots for new cells.
struct Room {
  std::size_t row;  ///< that a box takes at a time: boxes should seldom meet in one page of memory, and leave few over
  std::size_t end;
};

/// What one thread works on: a mesh of the same sites and cells, with lists and counts of its own.
class Part {
 public:
  /// @param box_of  per site
  void begin(Mesh& whole, const std::uint8_t* box_of, std::uint8_t box, std::size_t boxes, const Room& room) {
    put_off_.clear();
    mesh_.sites = whole.sites.lent();
    mesh_.complex = whole.complex.part(box, boxes, room.row, room.end);
    mesh_.duplicates = {};
    mesh_.vertex_count = 0;
    mesh_.statistics = {};
    mesh_.scratch.marks = whole.scratch.marks.lent();
    mesh_.scratch.planes = whole.scratch.planes.lent();
    mesh_.scratch.territory = {box_of, box};
  }

  /// Inserts the sites of the box. Those that are put off are listed; so are all when no more cells are to be had.
  /// @param go_on  is told before each how many came before; nothing more is done when it says no
  template <int K, class GoOn>
  void insert(const Round& round, const GoOn& go_on) {
    Inserter<K> inserter(mesh_);
    CellId home = cell_of_box(round.first);  // where a vertex was made
    CellId near = home;                      // where the last walk ended
    bool slots = home != kNoCell;
    std::size_t turn = 0;
    for (const Index site : round.waiting) {
      if (!mesh_.scratch.territory.holds(VertexId{site})) continue;
      if (!go_on(turn++)) return;
      std::optional<Outcome> outcome;
      try {
        if (slots) outcome = inserter.try_insert(VertexId{site}, near);
        if (slots && inserter.last_cell() == kNoCell && near != home)
          outcome = inserter.try_insert(VertexId{site}, home);
      } catch (const NoMoreSlots&) {
        slots = false;
      }
      near = inserter.last_cell() != kNoCell ? inserter.last_cell() : home;
      if (outcome) {
        home = near;
      } else {
        put_off_.push_back(site);
      }
    }
    mesh_.statistics.put_off = put_off_.size();
    mesh_.statistics.in_turn = turn;
  }

  Mesh& mesh() { return mesh_; }
  const std::vector<Index>& put_off() const { return put_off_; }

 private:
  /// At the last vertex among the sites below `end` that is in the box.
  CellId cell_of_box(std::size_t end) const {
    for (VertexId v{static_cast<Index>(end)}; raw(v) > 0;) {
      v = VertexId{raw(v) - 1};
      if (mesh_.scratch.territory.holds(v) && mesh_.complex.incident_cell(v) != kNoCell)
        return mesh_.complex.incident_cell(v);
    }
    return kNoCell;
  }

  Mesh mesh_{Sites(1)};
  std::vector<Index> put_off_;
};
static_assert(std::is_nothrow_move_constructible_v<Part>, "a vector moves them, and copies no memory that was lent");

template <int K>
class PartwiseInserter {
 public:
  /// @param start  sites below it do not count for progress
  PartwiseInserter(Mesh& mesh, std::size_t start, int threads, std::size_t few, const Progress& progress)
      : mesh_(&mesh), start_(start), threads_(threads), few_(few), progress_(&progress) {}

  void insert(std::size_t first, std::size_t last) {
    Round round(first, last);
    for (std::size_t most = std::min({static_cast<std::size_t>(threads_), kMostBoxes, first / few_});;) {
      const std::size_t before = round.waiting.size();
      const std::size_t boxes = std::min(most, before / few_);
      if (boxes < 2 || before < last / 256) break;  // to find the box of each site would take longer
      insert_in_boxes(round, boxes);
      if (round.waiting.size() > before / 2) most = boxes / 2;  // too small for so coarse a mesh
    }
    insert_rest(round);
  }

 private:
  void insert_in_boxes(Round& round, std::size_t boxes) {
    const Boxes<K> cut(mesh_->sites, round.waiting, boxes);
    box_of_.resize(mesh_->sites.size());
    for_chunks(round.last, threads_, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t site = begin; site < end; ++site) box_of_[site] = cut.box_of(static_cast<Index>(site));
    });
    const Room room = make_room(round.waiting.size(), boxes);
    if (parts_.size() < boxes) parts_.resize(boxes);
    std::atomic<bool> stopped = false;
    const auto caller = std::this_thread::get_id();
    const auto insert_box = [&](std::size_t box) {
      const bool telling = std::this_thread::get_id() == caller;
      parts_[box].begin(*mesh_, box_of_.data(), static_cast<std::uint8_t>(box), boxes, room);
      parts_[box].template insert<K>(round, [&](std::size_t turn) {
        if (telling) tell_done(turn, std::min(round.last, round.last - round.waiting.size() + turn * boxes));
        return !stopped;
      });
    };
    const auto guarded = [&](std::size_t box, std::size_t /*end*/, std::size_t /*chunk*/) {
      try {
        insert_box(box);
      } catch (...) {  // ends the others
        stopped = true;
        throw;
      }
    };
    for_chunks(boxes, threads_, guarded, {}, 1);
    end_parts(round, std::span(parts_).first(boxes));
  }

  /// Where boxes find room for the cells that so many sites more need, each as many as those before, or a few more.
  Room make_room(std::size_t sites, std::size_t boxes) {
    Complex& complex = mesh_->complex;
    const double each = static_cast<double>(complex.live_count()) / static_cast<double>(mesh_->vertex_count);
    const auto expected = static_cast<std::size_t>(1.05 * each * static_cast<double>(sites));
    const std::size_t row = std::clamp<std::size_t>(expected / boxes / 16, 256, 1 << 15);
    const std::size_t end = std::min(complex.slot_count() + expected + boxes * row, complex.nameable_slots());
    complex.reserve_slots(end);
    mesh_->scratch.reserve_cells(K, end);
    return {row, end};
  }

  /// Makes one of mesh and parts again.
  void end_parts(Round& round, std::span<Part> parts) {
    round.waiting.clear();
    std::vector<Complex*> complexes;
    std::uint64_t in_turn = 0;
    for (Part& part : parts) {
      Mesh& mesh = part.mesh();
      complexes.push_back(&mesh.complex);
      std::ranges::copy(part.put_off(), round.waiting.extend(part.put_off().size()));
      for (const auto& [vertex, row] : mesh.duplicates) mesh_->duplicates.add(mesh_->sites.vertex(row), vertex, row);
      mesh_->vertex_count += mesh.vertex_count;
      in_turn = std::max(in_turn, mesh.statistics.in_turn);
      mesh.statistics.in_turn = 0;
      mesh_->statistics += mesh.statistics;
    }
    mesh_->statistics.in_turn += in_turn;
    const auto moves = mesh_->complex.end_parts(complexes);
    if constexpr (K > 3) {
      for (const auto& [from, to] : moves) mesh_->scratch.plane<K>(to) = mesh_->scratch.plane<K>(from);
    }
    std::ranges::sort(round.waiting);
  }

  void insert_rest(const Round& round) {
    Inserter<K> inserter(*mesh_);
    CellId near = mesh_->complex.incident_cell(kGhost);
    std::size_t done = round.last - round.waiting.size();
    for (const Index site : round.waiting) {
      tell_done(done, done);
      ++done;
      inserter.insert(VertexId{site}, near);
      near = inserter.last_cell();
    }
    mesh_->statistics.in_turn += round.waiting.size();
  }

  /// Now and then tells that about so many sites are done; never fewer than before.
  void tell_done(std::size_t turn, std::size_t done) {
    if (turn % insertions_a_call(K) != 0 || !*progress_) return;
    told_ = std::max(told_, done - start_);
    tell_every(1, *progress_, told_, mesh_->sites.size() - start_);
  }

  Mesh* mesh_;
  std::size_t start_;
  int threads_;
  std::size_t few_;
  const Progress* progress_;
  std::size_t told_ = 0;
  Buffer<std::uint8_t> box_of_;  ///< per site, up to the last of a round
  std::vector<Part> parts_;
};

}  // namespace

void insert_rounds(Mesh& mesh, std::size_t first, std::span<const std::size_t> round_ends, int threads,
                   const Progress& progress, std::size_t few) {
  const int k = mesh.complex.dimension();
  if (threads < 2 || k < 2 || mesh.hidden.kept()) return insert_range(mesh, first, mesh.sites.size(), progress);
  mesh.complex.reserve_more(0, mesh.sites.size());
  mesh.complex.grow_vertices(mesh.sites.size());
  with_dimension<2>(k, [&](auto dimension) {
    PartwiseInserter<dimension> inserter(mesh, first, threads, few, progress);
    for (std::size_t begin = first; const std::size_t end : round_ends) {
      inserter.insert(begin, std::max(begin, end));
      begin = std::max(begin, end);
    }
  });
}

void insert_all_in_rounds(Mesh& mesh, std::span<const std::size_t> round_ends, int threads, const Progress& progress) {
  const int k = mesh.complex.dimension();
  if (threads < 2 || k < 2) return insert_all(mesh, progress);
  const std::size_t count = mesh.sites.size();
  const std::size_t first = std::max(round_ends.front(), static_cast<std::size_t>(k) + 1);
  const double share = static_cast<double>(first) / static_cast<double>(count);
  insert_first(mesh, first, part_of(progress, 0.0, share));
  insert_rounds(mesh, first, round_ends.subspan(1), threads, part_of(progress, share, 1.0));
}

}  // namespace delone
