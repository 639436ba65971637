// The table of [For92] figure 12, run again with all methods; and the experiment that [ES96] section 10 asks for.
// Source: [For92] 4.8, figure 12: seconds of four methods on a VAX 8550, points in the unit cube, and their lines of
// source. [ES96] 10: flipping beside the methods of Clarkson and Shor and of Seidel, in any dimension, with the kinds
// of points whose triangulations are small and large.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "delone/build/method.hpp"

namespace delone::lab {

/// One method on n points of a kind.
struct MethodRun {
  Method method = Method::automatic;
  std::string kind;
  int dimension = 2;
  std::size_t points = 0;
  double seconds = 0;  ///< processor time of one build, the mean of as many as take long enough to be measured
  std::size_t cells = 0;
  bool skipped = false;  ///< it would have taken longer than the limit, judging by the size before
};

struct FortuneOptions {
  std::vector<Method> methods;  ///< those that do not serve a dimension are left out there
  std::vector<std::string> kinds{"uniform"};
  std::vector<int> dimensions{2, 3, 4, 5};
  std::vector<std::size_t> sizes{500, 1000, 5000, 10000, 50000};
  double limit = 20;    ///< seconds that an entry may take
  double enough = 0.1;  ///< seconds that builds of an entry are repeated for
  std::uint64_t seed = 1;
  std::function<void(const MethodRun&)> on_run = nullptr;  ///< hears of every entry when it is done
};

/// Rows by dimension, kind, method, then size, ascending.
/// @throws InputError for an unknown kind
std::vector<MethodRun> run_methods(const FortuneOptions& options);

/// All methods but the automatic one.
std::vector<Method> all_methods();

/// Seconds in figure 12, 0 where it has none.
double seconds_1992(Method method, int dimension, std::size_t points);
/// Lines of source there, 0 where it has none.
int lines_1992(Method method);
/// Lines of source here that are neither blank nor comments alone: those of the method's own files. The methods that
/// make cavities have the engine's, whose lines count for `cavity` only.
int source_lines(Method method);

}  // namespace delone::lab
