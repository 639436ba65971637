// Take points out again: rows keep their numbers, duplicates take over, and what stays is as built from the rest.
#include <iostream>

#include "delone/delone.hpp"

int main() {
  const std::vector<std::array<double, 2>> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}, {2, 1}, {1, 3}};
  auto t = delone::triangulate(points);
  std::cout << t.cell_count() << " triangles\n";

  const delone::Removed first = delone::remove(t, 4);
  std::cout << "row 4 goes, row " << first.heir << " stands for its place: " << t.cell_count() << " triangles\n";
  delone::remove(t, 5);
  std::cout << "row 5 goes, too: " << t.cell_count() << " triangles, " << t.removed_count() << " rows removed\n";

  const delone::Inserted back = delone::insert(t, std::array{2.0, 1.0});
  std::cout << "the point comes back as row " << back.row << ": " << t.cell_count() << " triangles\n";
  std::cout << "nearest to (3, 1) is row " << delone::nearest(t, std::array{3.0, 1.0}).row << '\n';
}
