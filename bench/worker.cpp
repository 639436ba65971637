// Runs one library once on one workload, in a process of its own: fresh memory, and nothing of a rival in the caches.
//   bench_worker PEER KIND N DIMENSION SEED BITS WEIGHT REPEATS   prints `seconds 0.5` and more, a line each
//   bench_worker --versions                                       prints what was compiled into it, a line each
// KIND is a kind of generated points, or the path of a file with columns x, y, z. The rows are shuffled; weights are
// uniform in [0, WEIGHT), none when WEIGHT is 0. With REPEATS there are so many times N points, and every N of them are
// triangulated for themselves: all numbers are sums.
#include <sys/mman.h>

#include <boost/version.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/peer.hpp"
#include "delone/io/generate.hpp"
#include "delone/io/points_file.hpp"

namespace {

using delone::bench::Peer;
using delone::bench::Run;

std::vector<Peer> all_peers() {
  using namespace delone::bench;
  std::vector<Peer> peers = delone_peers();
  const auto add = [&](const std::vector<Peer>& more) { peers.insert(peers.end(), more.begin(), more.end()); };
  add(file_peers());
#ifdef DELONE_BENCH_PEERS
  for (const auto& more : {cgal_2d_peers(), cgal_3d_peers(), cgal_d_peers(), qhull_peers()}) add(more);
#endif
  return peers;
}

/// An index below `bound`, the same on every machine.
std::size_t below(std::mt19937_64& random, std::size_t bound) { return static_cast<std::size_t>(random() % bound); }

std::vector<double> shuffled(const std::vector<double>& coordinates, std::size_t dimension, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::size_t> rows(coordinates.size() / dimension);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  for (std::size_t i = rows.size(); i > 1; --i) std::swap(rows[i - 1], rows[below(random, i)]);
  std::vector<double> result;
  result.reserve(coordinates.size());
  for (const std::size_t row : rows)
    for (std::size_t axis = 0; axis < dimension; ++axis) result.push_back(coordinates[row * dimension + axis]);
  return result;
}

int print_versions() {
  std::printf("compiler: %s\nflags: %s\nBoost: %s\n", DELONE_BENCH_COMPILER, DELONE_BENCH_FLAGS, BOOST_LIB_VERSION);
  std::string last;
  for (const Peer& peer : all_peers())
    if (peer.version != last) std::printf("%s: %s\n", peer.name.c_str(), (last = peer.version).c_str());
  return 0;
}

std::vector<double> points_of(const std::string& kind, std::size_t n, int dimension, std::uint64_t seed, int bits) {
  if (kind.find('/') == std::string::npos) return delone::io::generate(kind, n, dimension, seed, bits).coordinates;
  const std::vector<std::string> axes{"x", "y", "z"};
  return delone::io::read_points(kind, {.columns = {axes.begin(), axes.begin() + dimension}}).coordinates;
}

std::vector<double> uniform_weights(std::size_t n, double below, std::uint64_t seed) {
  std::vector<double> weights(n);
  std::mt19937_64 random(seed);
  for (double& w : weights) w = below * static_cast<double>(random() >> 11) * 0x1p-53;
  return weights;
}

/// Writes to a gibibyte of memory, in huge pages, and gives it back, so that what the peer is given next belongs to
/// this machine: where a hypervisor takes free memory back, writing to a page for the first time costs up to fifty
/// times what the system asks for a page, and which peer it falls on depends on the size of its pages and on who ran
/// before. The peak of the process's memory counts anew.
void claim_memory() {
  constexpr std::size_t kBytes = std::size_t{1} << 30;
  constexpr std::size_t kPage = 4096;
  void* const block = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (block == MAP_FAILED) throw std::runtime_error("no memory to claim before the clock");
  madvise(block, kBytes, MADV_HUGEPAGE);
  for (std::size_t at = 0; at < kBytes; at += kPage) static_cast<volatile char*>(block)[at] = 1;
  munmap(block, kBytes);
  if (!(std::ofstream("/proc/self/clear_refs") << 5 << std::flush))
    throw std::runtime_error("/proc/self/clear_refs cannot be written: the peak of memory would be wrong");
}

/// Runs the peer on the first, second, ... part of the points, and adds up.
Run run_parts(const Peer& peer, const delone::PointsView& points, std::size_t parts) {
  const std::size_t n = points.size() / parts;
  const auto width = static_cast<std::size_t>(points.dimension());
  Run sum;
  for (std::size_t part = 0; part < parts; ++part) {
    const auto weights = points.weighted() ? points.weights().subspan(part * n, n) : points.weights();
    sum += peer.run({points.coordinates().subspan(part * n * width, n * width), points.dimension(), weights});
  }
  return sum;
}

int run(int argc, char** argv) {
  if (argc == 2 && argv[1] == std::string("--versions")) return print_versions();
  if (argc != 9) {
    std::fprintf(stderr, "usage: bench_worker PEER KIND N DIMENSION SEED BITS WEIGHT REPEATS\n");
    return 2;
  }
  const std::string name = argv[1];
  const int dimension = std::atoi(argv[4]);
  const std::uint64_t seed = std::strtoull(argv[5], nullptr, 10);
  const double weight = std::strtod(argv[7], nullptr);
  const std::size_t repeats = std::strtoull(argv[8], nullptr, 10);
  const std::size_t n = std::strtoull(argv[3], nullptr, 10) * repeats;

  const auto width = static_cast<std::size_t>(dimension);
  const std::vector<double> points =
      shuffled(points_of(argv[2], n, dimension, seed, std::atoi(argv[6])), width, seed + 1);
  const std::vector<double> weights = uniform_weights(weight > 0 ? points.size() / width : 0, weight, seed + 2);
  for (const Peer& peer : all_peers()) {
    if (peer.name != name || !peer.fits(dimension, !weights.empty())) continue;
    claim_memory();
    const Run sum = run_parts(peer, {points, dimension, weights}, repeats);
    std::printf("seconds %.6f\nprocessor %.6f\ncells %zu\nvertices %zu\nbytes %zu\n", sum.seconds, sum.processor,
                sum.cells, sum.vertices, sum.bytes);
    for (const auto& [what, count] : sum.counts) std::printf("%s %.9g\n", what.c_str(), count);
    return 0;
  }
  std::fprintf(stderr, "bench_worker: %s has nothing for dimension %d%s\n", name.c_str(), dimension,
               weights.empty() ? "" : " with weights");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_worker: %s\n", error.what());
    return 1;
  }
}
