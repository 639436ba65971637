// Runs one library once on one workload, in a process of its own: fresh memory, and nothing of a rival in the caches.
//   bench_worker PEER KIND N DIMENSION SEED BITS WEIGHT   prints seconds, processor seconds, cells, ...
//   bench_worker --versions                               prints what was compiled into it, a line each
// The rows are shuffled; weights are uniform in [0, WEIGHT), none when WEIGHT is 0.
#include <boost/version.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>
#include <string>
#include <vector>

#include "bench/peer.hpp"
#include "delone/io/generate.hpp"

namespace {

using delone::bench::Peer;

std::vector<Peer> all_peers() {
  std::vector<Peer> peers = delone::bench::delone_peers();
#ifdef DELONE_BENCH_PEERS
  for (const auto& more : {delone::bench::cgal_2d_peers(), delone::bench::cgal_3d_peers(),
                           delone::bench::cgal_d_peers(), delone::bench::qhull_peers()})
    peers.insert(peers.end(), more.begin(), more.end());
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

int run(int argc, char** argv) {
  if (argc == 2 && argv[1] == std::string("--versions")) return print_versions();
  if (argc != 8) {
    std::fprintf(stderr, "usage: bench_worker PEER KIND N DIMENSION SEED BITS WEIGHT\n");
    return 2;
  }
  const std::string name = argv[1];
  const int dimension = std::atoi(argv[4]);
  const std::uint64_t seed = std::strtoull(argv[5], nullptr, 10);
  const double weight = std::strtod(argv[7], nullptr);

  auto generated =
      delone::io::generate(argv[2], std::strtoull(argv[3], nullptr, 10), dimension, seed, std::atoi(argv[6]));
  const std::vector<double> points = shuffled(generated.coordinates, static_cast<std::size_t>(dimension), seed + 1);
  generated.coordinates = {};
  std::vector<double> weights(weight > 0 ? points.size() / static_cast<std::size_t>(dimension) : 0);
  std::mt19937_64 random(seed + 2);
  for (double& w : weights) w = weight * static_cast<double>(random() >> 11) * 0x1p-53;

  const delone::PointsView view(points, dimension, weights);
  for (const Peer& peer : all_peers()) {
    if (peer.name != name || !peer.fits(dimension, !weights.empty())) continue;
    const auto result = peer.run(view);
    std::printf("%.6f %.6f %zu %zu %zu\n", result.seconds, result.processor, result.cells, result.vertices,
                result.bytes);
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
