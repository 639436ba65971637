// A swarm that moves: 400 points turn about two centres, each by its own step, and the triangulation follows. Most
// moves keep every cell. Ten pictures are written, swarm_0.svg to swarm_9.svg, into the folder named on the command
// line; without one, none.
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>

#include "delone/delone.hpp"

namespace {

constexpr std::size_t kPoints = 400;

/// Corners of the unit square, where the swarm lives, and points on spirals within.
std::vector<std::array<double, 2>> swarm() {
  std::vector<std::array<double, 2>> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t i = points.size(); i < kPoints; ++i) {
    const double turn = 2.4 * static_cast<double>(i);  // close to the golden angle
    const double radius = 0.22 * std::sqrt(static_cast<double>(i) / kPoints);
    const double side = i % 2 == 0 ? 0.3 : 0.7;
    points.push_back({side + radius * std::cos(turn), 0.5 + radius * std::sin(turn)});
  }
  return points;
}

/// One step: along circles about the point's centre, faster inside, and a little towards the middle.
std::array<double, 2> step(const std::array<double, 2>& p, bool left) {
  const double x = p[0] - (left ? 0.3 : 0.7);
  const double y = p[1] - 0.5;
  const double angle = (left ? 0.004 : -0.004) / (0.1 + std::hypot(x, y));
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {(left ? 0.3 : 0.7) + c * x - s * y + (left ? 2e-4 : -2e-4), 0.5 + s * x + c * y};
}

void draw(const delone::Triangulation<2>& t, const std::string& path) {
  std::ofstream svg(path);
  svg << R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="-0.02 -0.02 1.04 1.04" width="600" height="600">)"
      << R"(<g fill="none" stroke="#246" stroke-width="0.0015">)";
  const delone::CellTable triangles = delone::cells(t);
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    svg << "<polygon points=\"";
    for (const delone::Index row : triangles[c]) svg << t.point(row)[0] << ',' << 1 - t.point(row)[1] << ' ';
    svg << "\"/>\n";
  }
  svg << "</g></svg>\n";
}

}  // namespace

int main(int argc, char** argv) {
  auto t = delone::triangulate(swarm());
  std::size_t moves = 0;
  std::size_t in_place = 0;
  for (int picture = 0; picture < 10; ++picture) {
    for (int tick = 0; tick < 25; ++tick) {
      for (delone::Index row = 4; row < kPoints; ++row) {
        const delone::Moved moved = delone::move(t, row, step(t.point(row), row % 2 == 0));
        ++moves;
        in_place += moved.motion == delone::Motion::in_place ? 1 : 0;
      }
    }
    if (argc > 1) draw(t, std::string(argv[1]) + "/swarm_" + std::to_string(picture) + ".svg");
  }
  const std::vector<double> places = t.coordinates();
  const bool same = delone::canonical_hash(t) == delone::canonical_hash(delone::build(delone::PointsView(places, 2)));
  std::cout << moves << " moves, most of them in place: " << (2 * in_place > moves ? "yes" : "no")
            << "\nthe same as built from the places at the end: " << (same ? "yes" : "no") << '\n';
}
