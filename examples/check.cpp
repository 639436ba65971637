// Check a triangulation that some other program made. Two triangles cover this kite in two ways; only one is Delaunay,
// and the checker, which decides with exact integers only, names the point that is in the way of the other.
#include <iostream>

#include "delone/delone.hpp"

int main() {
  const std::vector<std::array<double, 2>> kite{{0, 0}, {3, -1}, {6, 0}, {3, 1}};
  const delone::PointsView points{std::span(kite)};

  const delone::CellTable along{.corners = 3, .vertices = {0, 1, 2, 0, 2, 3}, .neighbours = {}};
  const delone::CellTable across{.corners = 3, .vertices = {0, 1, 3, 1, 2, 3}, .neighbours = {}};
  for (const delone::CellTable& cells : {along, across}) {
    const delone::CheckReport report = delone::check(points, cells);
    std::cout << (report.passed() ? "valid\n" : "not valid\n");
    for (const std::string& violation : report.violations) std::cout << "  " << violation << '\n';
  }
}
