// Insert points one by one: the triangulation is right after each, and equal to the one built from all of them at once.
#include <array>
#include <iostream>
#include <span>
#include <vector>

#include "delone/build/build.hpp"
#include "delone/build/insert.hpp"
#include "delone/mesh/export.hpp"

int main() {
  const std::vector<std::array<double, 2>> points{{0, 0}, {1, 0}, {2, 0}, {1, 1}, {1, -1}, {1, 0}};
  delone::AnyTriangulation t(2);
  for (const auto& point : points) {
    const auto [row, outcome] = delone::insert(t, point);
    std::cout << "row " << row << (outcome == delone::Outcome::inserted ? "" : " (already there)") << ": dimension "
              << t.affine_dimension() << ", " << t.cell_count() << " cells\n";
  }
  const auto built = delone::build(delone::PointsView(std::span(points)));
  std::cout << "same as built at once: " << (delone::canonical_hash(t) == delone::canonical_hash(built) ? "yes" : "no")
            << '\n';
}
