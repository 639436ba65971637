// Grow a triangulation: a point at a time, told of every change, then a batch. In the end it is the triangulation that
// building from all points at once gives, cell for cell.
#include <iostream>

#include "delone/delone.hpp"

int main() {
  auto t = delone::triangulate<2>({{0, 0}, {4, 0}, {4, 4}, {0, 4}});

  delone::InsertOptions options;
  options.on_edit = [](const delone::Edit& edit) {
    std::cout << edit.removed.size() << " cells gave way to " << edit.created.size() << '\n';
  };
  for (const std::array<double, 2> point : {std::array{1.0, 1.0}, std::array{4.0, 0.0}, std::array{9.0, 2.0}}) {
    const delone::Inserted inserted = delone::insert(t, point, 0.0, options);
    std::cout << "row " << inserted.row
              << (inserted.outcome == delone::Outcome::duplicate ? " is a duplicate\n" : " is a vertex\n");
  }

  const std::vector<std::array<double, 2>> batch{{2, 3}, {3, 2}, {2, 1}};
  delone::insert(t, delone::PointsView(std::span(batch)));

  const std::vector<double> all = t.coordinates();
  const auto anew = delone::build(delone::PointsView(all, 2));
  std::cout << t.cell_count() << " triangles, the same as built at once: "
            << (delone::canonical_hash(t) == delone::canonical_hash(anew) ? "yes" : "no") << '\n';
}
