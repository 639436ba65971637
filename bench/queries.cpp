// Nearest neighbours beside nanoflann: both take turns on the same points and queries, round after round, in one
// process. Prints bench/QUERIES.md.
//   bench_queries [--quick] [ROUNDS]
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/query_peer.hpp"
#include "bench/rounds.hpp"
#include "delone/build/build.hpp"
#include "delone/order/brio.hpp"
#include "delone/query/nearest.hpp"

namespace {

using namespace delone;
using bench::number;
using bench::undisturbed_seconds;
using bench::uniform;

std::vector<double> along_curve(PointsView points) {
  const std::vector<int> axes{0, 1, 2};
  std::vector<double> sorted;
  for (const Index row : curve_order(points, std::span(axes).first(static_cast<std::size_t>(points.dimension())))) {
    sorted.insert(sorted.end(), points[row].begin(), points[row].end());
  }
  return sorted;
}

struct Task {
  std::string what;
  std::size_t queries;
  std::function<void()> ours, theirs;  // theirs may be empty
  std::vector<double> our_seconds{}, their_seconds{};
};

std::string microseconds(const std::vector<double>& seconds, std::size_t queries) {
  return bench::spread_text(seconds, 1e6 / static_cast<double>(queries), 2);
}

void report(int dimension, std::size_t n, int rounds) {
  const auto d = static_cast<std::size_t>(dimension);
  const std::vector<double> coordinates = uniform(n * d, 1);
  const std::vector<double> query_coordinates = uniform(n * d, 2);
  const PointsView points(coordinates, dimension);
  const PointsView queries(query_coordinates, dimension);
  const std::vector<double> sorted_coordinates = along_curve(queries);
  const PointsView sorted(sorted_coordinates, dimension);
  const PointsView few(queries.coordinates().first(n / 10 * d), dimension);

  AnyTriangulation t(dimension);
  const double build_seconds = undisturbed_seconds([&] { t = build(points); });
  std::unique_ptr<bench::QueryPeer> tree;
  const double tree_seconds = undisturbed_seconds([&] { tree = bench::nanoflann_index(points); });

  std::vector<Neighbour> one;
  std::vector<Neighbour> singles(n);
  NeighbourLists eight;
  std::vector<std::uint32_t> theirs(n);
  std::vector<std::uint32_t> their_eight(8 * n);
  const auto tree_nearest = [&](PointsView which) { tree->nearest(which, 1, theirs); };
  std::vector<Task> tasks;
  tasks.push_back({"batch, random order", n, [&] { one = nearest(t, queries); }, [&] { tree_nearest(queries); }});
  tasks.push_back({"batch, 8 nearest", n, [&] { eight = nearest(t, queries, 8); },
                   [&] { tree->nearest(queries, 8, their_eight); }});
  tasks.push_back({"batch, queries along a curve", n, [&] { nearest(t, sorted); }, [&] { tree_nearest(sorted); }});
  tasks.push_back({"one by one, along a curve, from the last answer", n,
                   [&] {
                     CellId near = kNoCell;
                     for (std::size_t i = 0; i < n; ++i) {
                       singles[i] = nearest(t, sorted[i], near);
                       near = t.complex().incident_cell(t.vertex(singles[i].row));
                     }
                   },
                   [&] { tree_nearest(sorted); }});
  tasks.push_back({"one by one, random order, no hint", few.size(),
                   [&] {
                     for (std::size_t i = 0; i < few.size(); ++i) singles[i] = nearest(t, few[i]);
                   },
                   [&] { tree_nearest(few); }});
  tasks.push_back({"one by one, random order, a hint beside the answer",
                   few.size(),
                   [&] {
                     for (std::size_t i = 0; i < few.size(); ++i) {
                       singles[i] = nearest(t, few[i], t.complex().incident_cell(t.vertex(one[i].row)));
                     }
                   },
                   {}});
  for (int round = 0; round < rounds; ++round) {
    for (Task& task : tasks) {
      task.our_seconds.push_back(undisturbed_seconds(task.ours));
      if (task.theirs) task.their_seconds.push_back(undisturbed_seconds(task.theirs));
    }
  }
  tree_nearest(queries);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < n; ++i) differing += one[i].row != theirs[i] ? 1 : 0;

  std::printf("\n## %dD, %zu uniform points, as many random queries\n\n", dimension, n);
  std::printf(
      "Microseconds a query. Building took %.2f s (Delone, the triangulation) and %.2f s (nanoflann, the tree). ",
      build_seconds, tree_seconds);
  std::printf("%zu nearest rows differ.\n\n| queries | Delone | nanoflann | ratio |\n| --- | --- | --- | --- |\n",
              differing);
  for (const Task& task : tasks) {
    std::string ratio;
    if (task.theirs) ratio = number(lab::spread(task.their_seconds).median / lab::spread(task.our_seconds).median, 2);
    std::printf("| %s | %s | %s | %s |\n", task.what.c_str(), microseconds(task.our_seconds, task.queries).c_str(),
                microseconds(task.their_seconds, task.queries).c_str(), ratio.c_str());
  }
  std::fflush(stdout);
}

void run(bool quick, int rounds) {
  std::printf(
      "# Queries\n\n%s* compiler: %s\n* flags: %s\n* Delone: %s\n* nanoflann: %s, 10 points a leaf\n\n",
      bench::when_and_where(quick ? ", QUICK" : ", " + std::to_string(rounds) + (rounds == 1 ? " round" : " rounds"))
          .c_str(),
      DELONE_BENCH_COMPILER, DELONE_BENCH_FLAGS, DELONE_VERSION, bench::nanoflann_version().c_str());
  std::printf(
      "One thread, one process; both take turns on the same points and queries, round after round, and a run that had\n"
      "to share its processor is repeated. A batch of Delone contains sorting the queries and putting the answers in\n"
      "their order; nanoflann answers them one after the other. Given are the median and, in brackets, the least and\n"
      "the largest value; ratio: nanoflann's median by Delone's.\n");
  for (const int dimension : {2, 3}) report(dimension, quick ? 100000 : 1000000, rounds);
}

}  // namespace

int main(int argc, char** argv) { return bench::main_of("bench_queries", argc, argv, run); }
