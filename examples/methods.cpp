// Many ways, one triangulation: every method that serves these points is tried, and compared by the canonical hash.
#include <iostream>
#include <span>
#include <vector>

#include "delone/delone.hpp"

int main() {
  std::vector<double> grid;  // many points of one circle: here methods could disagree
  for (int i = 0; i < 400; ++i) grid.insert(grid.end(), {double(i % 20), double(i / 20)});
  const delone::PointsView points(grid, 2);

  const std::uint64_t hash = delone::canonical_hash(delone::build(points));
  for (const delone::MethodInfo& method : delone::methods()) {
    const delone::AnyTriangulation t = delone::build(points, {.method = method.method});
    std::cout << method.name << ": " << t.cell_count() << " triangles, "
              << (delone::canonical_hash(t) == hash ? "the same" : "others") << '\n';
  }

  // What does not serve is refused before any work.
  try {
    delone::build(delone::PointsView(std::span(grid).first(600), 3), {.method = delone::Method::sweep});
  } catch (const delone::InputError& error) {
    std::cout << error.what() << '\n';
  }
}
