#include "io/diagram_io.hpp"

#include <algorithm>

namespace delone::io {
namespace {

/// Twice the area of a loop, counter-clockwise positive, from its first corner, so that small loops far away keep their
/// digits.
double doubled_area(const CellShapes& shapes, std::size_t loop) {
  const double* const begin = shapes.corners.data() + 2 * shapes.loops[loop];
  const double* const end = shapes.corners.data() + 2 * shapes.loops[loop + 1];
  double sum = 0;
  for (const double* c = begin; c + 2 < end; c += 2)
    sum += (c[0] - begin[0]) * (c[3] - begin[1]) - (c[1] - begin[1]) * (c[2] - begin[0]);
  return sum;
}

}  // namespace

std::string free_name(const PointTable& points, std::string name) {
  const auto taken = [&] {
    return std::ranges::find(points.attributes, name, &Attribute::name) != points.attributes.end() ||
           std::ranges::find(points.coordinate_names, name) != points.coordinate_names.end();
  };
  while (taken()) name.insert(0, "cell_");
  return name;
}

std::vector<CellNumbers> measures_of(const DiagramView& diagram) {
  const CellMeasures& measures = diagram.measures;
  const bool plane = measures.dimension == 2;
  const auto dimension = static_cast<std::size_t>(measures.dimension);
  std::vector<double> neighbours;
  for (std::size_t cell = 0; cell < measures.size(); ++cell)
    neighbours.push_back(static_cast<double>(measures.offsets[cell + 1] - measures.offsets[cell]));
  std::vector<CellNumbers> all{{plane ? "area" : "volume", measures.volume},
                               {plane ? "perimeter" : "surface", measures.surface},
                               {"boundary", measures.boundary},
                               {"neighbours", std::move(neighbours), true}};
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    CellNumbers& centre = all.emplace_back(CellNumbers{std::string("c") + "xyz" [axis], {}});
    for (std::size_t cell = 0; cell < measures.size(); ++cell)
      centre.numbers.push_back(measures.centroid[cell * dimension + axis]);
  }
  all.push_back({"second_moment", measures.second_moment});
  for (CellNumbers& column : all) column.name = free_name(diagram.points, std::move(column.name));
  return all;
}

std::size_t piece_end(const CellShapes& shapes, std::size_t cell, std::size_t loop) {
  do ++loop;
  while (loop < shapes.cells[cell + 1] && doubled_area(shapes, loop) < 0);
  return loop;
}

}  // namespace delone::io
