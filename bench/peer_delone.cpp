// Delone itself: with the options that a user gets by default, with several threads, and with points inserted one by
// one in the given order.
#include <memory>

#include "bench/peer.hpp"
#include "delone/build/build.hpp"
#include "delone/locate/hierarchy.hpp"
#include "delone/remove/remove.hpp"

namespace delone::bench {

namespace {

bool fits(int, bool) { return true; }

/// The run whose clock stops now and that has made `t`.
Run stopped(const Clock& clock, const AnyTriangulation& t) {
  Run run;
  clock.stop(run);
  run.cells = t.cell_count();
  run.vertices = t.vertex_count();
  run.bytes = t.memory_bytes();
  const BuildStatistics& statistics = t.statistics();
  const PredicateStats& tests = statistics.predicates;
  const auto count = [&](const char* name, auto number) { run.counts[name] = static_cast<double>(number); };
  count("order_seconds", statistics.order_seconds);
  count("insert_seconds", statistics.insert_seconds);
  count("orient_filter", tests.orient_filter);
  count("orient_exact", tests.orient_exact);
  count("conflict_filter", tests.conflict_filter);
  count("conflict_adaptive", tests.conflict_adaptive);
  count("conflict_exact", tests.conflict_exact);
  count("conflict_symbolic", tests.conflict_symbolic);
  count("walk_steps", statistics.walk_steps);
  count("cells_created", statistics.cells_created);
  count("put_off", statistics.put_off);
  count("in_turn", statistics.in_turn);
  return run;
}

template <int Threads>
Run run(PointsView points) {
  const Clock clock;
  const AnyTriangulation t = build(points, {.threads = Threads});
  return stopped(clock, t);
}

/// The points are located by a hierarchy.
Run run_one_by_one(PointsView points) {
  const Clock clock;
  AnyTriangulation t(points.dimension(), points.weighted());
  Hierarchy locator;
  for (std::size_t row = 0; row < points.size(); ++row) insert(t, points[row], points.weight(row), locator);
  Run run = stopped(clock, t);
  run.bytes += locator.memory_bytes();
  return run;
}

/// The time to remove one row in `Share`, one after the other; rows are in random order.
template <std::size_t Share>
Run remove_rows(PointsView points) {
  AnyTriangulation t = build(points);
  const Clock clock;
  for (std::size_t row = 0; row < points.size() / Share; ++row) remove(t, static_cast<Index>(row));
  return stopped(clock, t);
}

}  // namespace

std::vector<Peer> delone_peers() {
  return {{"Delone", DELONE_VERSION, fits, run<1>},
          {"Delone-threads-2", DELONE_VERSION, fits, run<2>},
          {"Delone-threads-8", DELONE_VERSION, fits, run<8>},
          {"Delone-threads-64", DELONE_VERSION, fits, run<64>},
          {"Delone-hierarchy", DELONE_VERSION, fits, run_one_by_one},
          {"Delone-remove-10", DELONE_VERSION, fits, remove_rows<10>},
          {"Delone-remove-20", DELONE_VERSION, fits, remove_rows<20>}};
}

}  // namespace delone::bench
