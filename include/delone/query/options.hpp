// What all queries in batches have in common.
#pragma once

#include "delone/base/progress.hpp"

namespace delone {

/// Queries of a batch are answered along a curve through space, each from where the last one ended, and given back in
/// the order in which they came.
struct QueryOptions {
  int threads = 1;         ///< share out the curve. Never changes the result
  Progress progress = {};  ///< told of progress, may cancel
};

}  // namespace delone
