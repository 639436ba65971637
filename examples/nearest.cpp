// Who is nearest, who are the three nearest, who is within reach, and where does a point lie? All answers are exact:
// where distances are equal, the lowest row comes first.
#include <iostream>

#include "delone/delone.hpp"

int main() {
  const std::vector<std::array<double, 2>> wells{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {7, 2}};
  const auto t = delone::triangulate(wells);

  const std::array<double, 2> middle{2, 2};  // as far from the first four
  const delone::Neighbour one = delone::nearest(t, middle);
  std::cout << "nearest: row " << one.row << ", squared distance " << one.squared_distance << '\n';
  std::cout << "three nearest:";
  for (const delone::Neighbour& n : delone::nearest(t, middle, 3)) std::cout << ' ' << n.row;
  std::cout << "\nwithin 5:";
  for (const delone::Neighbour& n : delone::within(t, middle, 5)) std::cout << ' ' << n.row;
  const delone::Location place = delone::locate(t, middle);
  std::cout << "\nlies on a face of dimension " << place.face_dimension() << " with rows";
  for (const delone::Index row : place.rows()) std::cout << ' ' << row;

  // Many queries at once are much faster than one by one, and answered in their order.
  const std::vector<std::array<double, 2>> houses{{6, 1}, {1, 1}, {5, 5}};
  std::cout << "\nhouses go to:";
  for (const delone::Neighbour& n : delone::nearest(t, houses)) std::cout << ' ' << n.row;
  std::cout << '\n';
}
