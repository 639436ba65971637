// The parts, one by one (Google Benchmark): the order of insertion, building by size and dimension, inserting one by
// one, and what is done with a finished triangulation. For the whole against its peers see report.cpp.
//   build-bench/bench/bench_micro --benchmark_filter=Build
#include <benchmark/benchmark.h>

#include <array>
#include <numeric>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/io/generate.hpp"
#include "delone/mesh/export.hpp"
#include "delone/order/brio.hpp"

namespace {

using delone::io::Generated;

delone::PointsView view(const Generated& points) { return {points.coordinates, points.dimension}; }

Generated uniform(const benchmark::State& state) {
  return delone::io::generate("uniform", static_cast<std::size_t>(state.range(0)), static_cast<int>(state.range(1)));
}

void count_points(benchmark::State& state) { state.SetItemsProcessed(state.iterations() * state.range(0)); }

void BrioOrder(benchmark::State& state) {
  const Generated points = uniform(state);
  std::vector<int> axes(static_cast<std::size_t>(state.range(1)));
  std::iota(axes.begin(), axes.end(), 0);
  for (auto _ : state) benchmark::DoNotOptimize(delone::brio_order(view(points), axes));
  count_points(state);
}
BENCHMARK(BrioOrder)->Args({100000, 2})->Args({1000000, 2})->Args({1000000, 3})->Unit(benchmark::kMillisecond);

void Build(benchmark::State& state) {
  const Generated points = uniform(state);
  for (auto _ : state) benchmark::DoNotOptimize(delone::build(view(points)));
  count_points(state);
}
BENCHMARK(Build)
    ->Args({100, 2})
    ->Args({5000, 2})
    ->Args({100000, 2})
    ->Args({100, 3})
    ->Args({5000, 3})
    ->Args({100000, 3})
    ->Args({1000, 4})
    ->Args({1000, 5})
    ->Args({300, 6})
    ->Unit(benchmark::kMicrosecond);

void BuildLattice(benchmark::State& state) {
  const auto points =
      delone::io::generate("lattice", static_cast<std::size_t>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(delone::build(view(points)));
  count_points(state);
}
BENCHMARK(BuildLattice)->Args({10000, 2})->Args({8000, 3})->Args({1296, 4})->Unit(benchmark::kMicrosecond);

/// In random order, each walk from where the last insertion ended or from wherever the library starts.
void InsertOneByOne(benchmark::State& state) {
  const Generated points = uniform(state);
  for (auto _ : state) {
    delone::AnyTriangulation t(points.dimension);
    for (std::size_t row = 0; row < view(points).size(); ++row) delone::insert(t, view(points)[row]);
    benchmark::DoNotOptimize(t);
  }
  count_points(state);
}
BENCHMARK(InsertOneByOne)->Args({5000, 2})->Args({5000, 3})->Unit(benchmark::kMillisecond);

void Cells(benchmark::State& state) {
  const Generated points = uniform(state);
  const auto t = delone::build(view(points));
  for (auto _ : state) benchmark::DoNotOptimize(delone::cells(t));
  count_points(state);
}
BENCHMARK(Cells)->Args({100000, 2})->Args({100000, 3})->Unit(benchmark::kMillisecond);

void CanonicalHash(benchmark::State& state) {
  const Generated points = uniform(state);
  const auto t = delone::build(view(points));
  for (auto _ : state) benchmark::DoNotOptimize(delone::canonical_hash(t));
  count_points(state);
}
BENCHMARK(CanonicalHash)->Args({100000, 2})->Args({100000, 3})->Unit(benchmark::kMillisecond);

}  // namespace
