// Delone itself, with the options that a user gets by default.
#include <memory>

#include "bench/peer.hpp"
#include "delone/build/build.hpp"

namespace delone::bench {

namespace {

bool fits(int, bool) { return true; }

Run run(PointsView points) {
  const Clock clock;
  const AnyTriangulation t = build(points);
  Run run;
  clock.stop(run);
  run.cells = t.cell_count();
  run.vertices = t.vertex_count();
  run.bytes = t.memory_bytes();
  return run;
}

}  // namespace

std::vector<Peer> delone_peers() { return {{"Delone", DELONE_VERSION, fits, run}}; }

}  // namespace delone::bench
