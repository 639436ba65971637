// Voronoi cells with their measures: in space beside voro++, in the plane beside the triangulation itself. Both take
// turns on the same points, round after round, in one process. Prints bench/CELLS.md.
//   bench_cells [--quick] [ROUNDS]
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/cells_peer.hpp"
#include "bench/rounds.hpp"
#include "delone/build/build.hpp"
#include "delone/dual/clip.hpp"

namespace {

using namespace delone;
using bench::number;
using bench::spread_text;
using bench::undisturbed_seconds;

Region unit_box(int dimension) {
  const std::vector<double> low(static_cast<std::size_t>(dimension), 0.0);
  const std::vector<double> high(static_cast<std::size_t>(dimension), 1.0);
  return Region::box(low, high);
}

struct Target {
  std::string what;
  double wanted, reached;
  bool met;
};

Target space(std::size_t n, int rounds, std::string& report) {
  const std::vector<double> coordinates = bench::uniform(3 * n, 1);
  const PointsView points(coordinates, 3);
  const Region box = unit_box(3);
  CellMeasures ours;
  std::vector<double> theirs;
  std::vector<double> triangulation, cells, both, peer;
  for (int round = 0; round < rounds; ++round) {
    AnyTriangulation t(3);
    triangulation.push_back(undisturbed_seconds([&] { t = build(points); }));
    cells.push_back(undisturbed_seconds([&] { ours = measure_cells(t, box); }));
    both.push_back(triangulation.back() + cells.back());
    peer.push_back(undisturbed_seconds([&] { theirs = bench::voro_volumes(points); }));
  }
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(ours.volume[i] - theirs[i]) / theirs[i]);
  const double ratio = lab::spread(peer).median / lab::spread(both).median;
  report += "| " + std::to_string(n) + " | " + spread_text(triangulation, 1, 3) + " | " + spread_text(cells, 1, 3) +
            " | " + spread_text(both, 1, 3) + " | " + spread_text(peer, 1, 3) + " | " + number(ratio, 2) + " | " +
            number(largest * 1e12, 1) + "e-12 |\n";
  return {"3D, " + std::to_string(n) + " uniform points in a box, triangulation included, times as fast as voro++", 2.5,
          ratio, ratio >= 2.5};
}

std::vector<Target> plane(std::size_t n, int rounds, std::string& report) {
  const std::vector<double> coordinates = bench::uniform(2 * n, 1);
  const PointsView points(coordinates, 2);
  const Region box = unit_box(2);
  CellMeasures ours;
  std::vector<double> triangulation, cells, blocks;
  for (int round = 0; round < rounds; ++round) {
    AnyTriangulation t(2);
    triangulation.push_back(undisturbed_seconds([&] { t = build(points); }));
    cells.push_back(undisturbed_seconds([&] { ours = measure_cells(t, box); }));
    double sum = 0;
    const auto add = [&](const CellShapes&, const CellMeasures& some) {
      for (const double area : some.volume) sum += area;
    };
    blocks.push_back(undisturbed_seconds([&] { for_cells(t, box, add); }));
  }
  double sum = 0;
  for (const double area : ours.volume) sum += area;
  const double ratio = lab::spread(cells).median / lab::spread(triangulation).median;
  report += "| " + std::to_string(n) + " | " + spread_text(triangulation, 1, 3) + " | " + spread_text(cells, 1, 3) +
            " | " + spread_text(blocks, 1, 3) + " | " + number(ratio, 2) + " | " + number(std::abs(sum - 1) * 1e15, 1) +
            "e-15 |\n";
  const double in_blocks = lab::spread(blocks).median / lab::spread(triangulation).median;
  const std::string what = "2D, " + std::to_string(n) + " uniform points, time by that of the triangulation, at most: ";
  return {{what + "cells with their areas, in blocks (`for_cells`)", 2.0, in_blocks, in_blocks <= 2.0},
          {what + "all measures as arrays (`measure_cells`)", 2.0, ratio, ratio <= 2.0}};
}

void run(bool quick, int rounds) {
  std::string in_space, in_plane;
  std::vector<Target> targets;
  targets.push_back(space(quick ? 20000 : 100000, rounds, in_space));
  if (!quick) space(1000000, 1, in_space);
  for (const Target& target : plane(quick ? 100000 : 1000000, rounds, in_plane)) targets.push_back(target);
  std::printf("# Cells\n\n%s* compiler: %s\n* flags: %s\n* Delone: %s\n* voro++: %s, as Debian builds it\n\n",
              bench::when_and_where(quick ? ", QUICK" : ", " + std::to_string(rounds) + " rounds").c_str(),
              DELONE_BENCH_COMPILER, DELONE_BENCH_FLAGS, DELONE_VERSION, bench::voro_version().c_str());
  std::printf(
      "One thread, one process; both take turns on the same points, round after round, and a run that had to share "
      "its\n"
      "processor is repeated. Seconds: the median and, in brackets, the least and the largest value. Delone measures\n"
      "volume, surface, centroid, second moment, and every neighbour with the shared area; voro++ only the volume.\n\n"
      "## Targets\n\n| what | target | reached | met |\n| --- | --- | --- | --- |\n");
  for (const Target& target : targets)
    std::printf("| %s | %s | %s | %s |\n", target.what.c_str(), number(target.wanted, 1).c_str(),
                number(target.reached, 2).c_str(), target.met ? "yes" : "NO");
  std::printf(
      "\n## 3D, uniform points in a box\n\n| points | triangulation | cells | both | voro++ | voro++ by both | largest "
      "relative difference of a volume |\n| --- | --- | --- | --- | --- | --- | --- |\n%s"
      "\n## 2D, uniform points in a box\n\nIn blocks: the same a block of cells at a time, shapes included "
      "(`for_cells`).\n\n"
      "| points | triangulation | cells | in blocks | cells by triangulation | sum of areas off by |\n"
      "| --- | --- | --- | --- | --- | --- |\n%s",
      in_space.c_str(), in_plane.c_str());
}

}  // namespace

int main(int argc, char** argv) { return bench::main_of("bench_cells", argc, argv, run); }
