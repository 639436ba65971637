#include "delone/build/build.hpp"

#include "delone/base/arithmetic.hpp"
#include "mesh/anew.hpp"

namespace delone {

AnyTriangulation build(PointsView points, const BuildOptions& options) {
  require_row_count(points.size(), points.dimension());
  require_finite(points);
  const ExactEnvironment environment;
  return triangulated(points, options.threads, options.progress);
}

}  // namespace delone
