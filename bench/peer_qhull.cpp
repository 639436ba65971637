// Qhull, by its reentrant library and the options that SciPy gives it.
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "bench/peer.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace delone::bench {

namespace {

struct Qhull {
  qhT state{};
  ~Qhull() {
    qh_freeqhull(&state, qh_ALL);
    int leftover = 0, total = 0;
    qh_memfreeshort(&state, &leftover, &total);
  }
};

Run run(PointsView view) {
  std::vector<double> copy(view.coordinates().begin(), view.coordinates().end());
  char options[] = "qhull d Qbb Qc Q12";
  char options_high[] = "qhull d Qbb Qc Qx Q12";
  return measure(
      [&] {
        auto qhull = std::make_unique<Qhull>();
        qh_zero(&qhull->state, stderr);
        if (qh_new_qhull(&qhull->state, view.dimension(), static_cast<int>(view.size()), copy.data(), False,
                         view.dimension() > 4 ? options_high : options, nullptr, stderr) != 0)
          throw std::runtime_error("Qhull refuses these points");
        return qhull;
      },
      [](const Qhull& qhull, Run& run) {
        const qhT* qh = &qhull.state;
        for (const facetT* facet = qh->facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next)
          if (!facet->upperdelaunay) ++run.cells;
      });
}

}  // namespace

std::vector<Peer> qhull_peers() {
  return {{"Qhull", qh_version2, [](int, bool weighted) { return !weighted; }, run}};
}

}  // namespace delone::bench
