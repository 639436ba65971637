// Libraries that take turns on the same points. Each run is a process of its own, `bench_worker` or what stands in for
// it: fresh memory, and nothing of a rival in the caches.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace delone::lab {

struct Spread {
  double median = 0, least = 0, most = 0;
};
/// Of at least one value.
Spread spread(std::vector<double> values);

/// What the worker is asked to triangulate.
struct Workload {
  std::string title;
  std::string kind;   ///< as for io::generate, or the path of a file with columns x, y, z
  std::size_t n = 0;  ///< a file has as many points as it has
  int dimension = 2;
  int bits = 0;             ///< as for io::generate
  double weight = 0;        ///< weights are uniform below it
  std::size_t repeats = 1;  ///< so many times n points, one after the other in one process
};

/// What one run said of itself: a line `name number` for each.
struct Sample {
  double seconds = 0, processor = 0;  ///< wall time of construction, and the processor's share in it
  std::size_t cells = 0, vertices = 0, bytes = 0;
  std::size_t peak_bytes = 0;            ///< of the whole process, as the system says
  std::map<std::string, double> counts;  ///< everything else
  bool disturbed = false;                ///< it had to share its processor, however often it was repeated
};

/// One library in one build on one workload, with what was measured so far.
struct Contestant {
  std::string label;
  std::string worker;  ///< path of the program
  std::string peer;    ///< as the worker calls the library
  Workload workload;
  std::vector<Sample> samples = {};
  bool may_fail = false;  ///< a rival that stops with an error is reported as such, not a fault of the run
  bool failed = false;

  /// Of the seconds. Requires a sample.
  Spread seconds() const;
};

/// What a command prints on its standard output; its peak memory goes to `peak_bytes`.
/// @throws std::runtime_error naming the command when it does not end well
std::string output_of(const std::vector<std::string>& command, std::size_t* peak_bytes = nullptr);

/// Rounds in which every contestant runs once; the order turns from round to round. All rounds have the same points. A
/// run that had a processor for less than 97 % of its time is thrown away and repeated, up to five times.
/// @param on_run  hears of every run when it is done
/// @throws std::runtime_error when a run fails that may not
void alternate(std::vector<Contestant>& contestants, int rounds, const std::function<void(const Contestant&)>& on_run);

}  // namespace delone::lab
