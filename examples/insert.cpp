// Grow a triangulation from nothing: a point at a time, told of every change, then a batch. In the end it is the
// triangulation that building from all points at once gives, cell for cell.
#include <iostream>

#include "delone/delone.hpp"

int main() {
  delone::Triangulation<2> t;
  delone::InsertOptions options;
  options.on_edit = [](const delone::Edit& edit) {
    if (edit.rebuilt) return;
    std::cout << "  cells that gave way, ghosts included: " << edit.removed.size()
              << ", new ones: " << edit.created.size() << '\n';
  };
  const std::vector<std::array<double, 2>> points{{0, 0}, {1, 0}, {4, 0}, {1, 3}, {1, 1}, {1, 0}};
  for (const auto& point : points) {
    const auto [row, outcome] = delone::insert(t, point, 0.0, options);
    std::cout << "row " << row << (outcome == delone::Outcome::duplicate ? " (a duplicate)" : "")
              << ": affine dimension " << t.affine_dimension() << ", cells " << t.cell_count() << '\n';
  }

  const std::vector<std::array<double, 2>> batch{{2, 3}, {3, 2}, {2, 1}};
  delone::insert(t, batch);
  const std::vector<double> all = t.coordinates();
  const auto at_once = delone::build(delone::PointsView(all, 2));
  std::cout << t.cell_count() << " cells, the same as built at once: "
            << (delone::canonical_hash(t) == delone::canonical_hash(at_once) ? "yes" : "no") << '\n';
}
