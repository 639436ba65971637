// The smallest program that uses the installed library: a square with its centre has four triangles.
#include <array>
#include <cstdio>
#include <vector>

#include "delone/build/build.hpp"

int main() {
  const std::vector<std::array<double, 2>> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  const auto t = delone::build(points);
  std::printf("%zu vertices, %zu cells\n", t.vertex_count(), t.cell_count());
  return t.vertex_count() == 5 && t.cell_count() == 4 ? 0 : 1;
}
