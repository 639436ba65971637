// The convex hull of a cube's corners, with points inside and on its faces: corners are exact, faces may be merged.
#include "delone/apps/hull.hpp"

#include <iostream>
#include <vector>

int main() {
  std::vector<double> points;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 3; ++z) points.insert(points.end(), {double(x), double(y), double(z)});
    }
  }
  const delone::ConvexHull hull = delone::convex_hull(delone::PointsView(points, 3));
  std::cout << hull.corners.size() << " corners, " << hull.facets.size() << " triangles, " << hull.faces.size()
            << " faces\n";
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    for (const delone::Index row : hull.faces[f]) std::cout << row << ' ';
    std::cout << '\n';
  }
  std::cout << "volume " << hull.volume << ", area " << hull.area << '\n';
}
