// Cells are sums of simplices with one corner in common. A simplex of dimension D with corners v_i and volume V has its
// centroid at their mean, and the integral of |x|^2 over it is V (sum |v_i|^2 + |sum v_i|^2) / ((D + 1) (D + 2)).
#include "dual/measure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dual/polytope.hpp"

namespace delone::dual_detail {
namespace {

double length(const Point3& a) { return std::sqrt(dot(a, a)); }

/// Sums over simplices that have one corner in the origin.
struct Moments {
  double volume = 0, second = 0;
  Point3 first{};

  /// @param simplex  its volume times D!, signed  @param sum  of its other corners  @param squares  of their lengths
  void add(double simplex, const Point3& sum, double squares) {
    volume += simplex;
    first = first + simplex * sum;
    second += simplex * (squares + dot(sum, sum));
  }
  /// When all simplices are added.
  template <int D>
  void scale() {
    constexpr double kParts = D == 2 ? 2 : 6;
    volume /= kParts;
    first = 1 / (kParts * (D + 1)) * first;
    second /= kParts * (D + 1) * (D + 2);
  }
};

template <int D>
class Measurer {
 public:
  Measurer(const CellShapes& shapes, CellMeasures& measures) : shapes_(shapes), measures_(measures) {}

  void add(std::size_t cell, const Point3& site) {
    Moments moments;
    shared_.clear();
    surface_ = boundary_ = 0;
    apex_ = {};
    if (!shapes_.empty(cell)) {
      apex_ = corner(shapes_.loops[shapes_.cells[cell]]);
      for (std::size_t l = shapes_.cells[cell]; l < shapes_.cells[cell + 1]; ++l) {
        if constexpr (D == 2) {
          add_loop(l, moments);
        } else {
          add_face(l, moments);
        }
      }
    }
    moments.scale<D>();
    measures_.volume.push_back(moments.volume);
    measures_.surface.push_back(surface_);
    measures_.boundary.push_back(boundary_);
    const Point3 shift = apex_ - site;
    measures_.second_moment.push_back(moments.second + 2 * dot(shift, moments.first) +
                                      dot(shift, shift) * moments.volume);
    for (std::size_t axis = 0; axis < D; ++axis)
      measures_.centroid.push_back(moments.volume > 0 ? apex_[axis] + moments.first[axis] / moments.volume
                                                      : site[axis]);
    add_neighbours();
  }

 private:
  /// Seen from the apex.
  Point3 corner(std::size_t i) const {
    Point3 x{};
    for (std::size_t axis = 0; axis < D; ++axis) x[axis] = shapes_.corners[i * D + axis] - apex_[axis];
    return x;
  }

  void share(Index across, double size) {
    surface_ += size;
    if (across == kNone) {
      boundary_ += size;
    } else if (size > 0) {
      shared_.emplace_back(across, size);
    }
  }

  void add_loop(std::size_t l, Moments& moments) {
    const std::size_t begin = shapes_.loops[l];
    const std::size_t end = shapes_.loops[l + 1];
    Index across = shapes_.across[end - 1];
    Point3 a = corner(end - 1);
    double a_squared = dot(a, a);
    for (std::size_t i = begin; i < end; ++i) {
      const Point3 b = corner(i);
      const Point3 edge = b - a;
      share(across, length(edge));
      const double squared = dot(b, b);
      moments.add(a[0] * edge[1] - a[1] * edge[0], a + b, a_squared + squared);
      across = shapes_.across[i];
      a = b;
      a_squared = squared;
    }
  }

  void add_face(std::size_t l, Moments& moments) {
    const std::size_t begin = shapes_.loops[l];
    const Point3 a = corner(begin);
    const double a_squared = dot(a, a);
    Point3 area{};
    Point3 b = corner(begin + 1);
    double b_squared = dot(b, b);
    for (std::size_t i = begin + 2; i < shapes_.loops[l + 1]; ++i) {
      const Point3 c = corner(i);
      const double c_squared = dot(c, c);
      const Point3 triangle = cross(b - a, c - b);
      area = area + triangle;
      moments.add(dot(a, triangle), a + b + c, a_squared + b_squared + c_squared);
      b = c;
      b_squared = c_squared;
    }
    share(shapes_.across[l], length(area) / 2);
  }

  /// Ascending, what is shared in several parts summed up.
  void add_neighbours() {
    std::ranges::sort(shared_);
    for (std::size_t i = 0; i < shared_.size(); ++i) {
      if (i > 0 && shared_[i].first == shared_[i - 1].first) {
        measures_.shared.back() += shared_[i].second;
      } else {
        measures_.neighbours.push_back(shared_[i].first);
        measures_.shared.push_back(shared_[i].second);
      }
    }
    measures_.offsets.push_back(measures_.neighbours.size());
  }

  const CellShapes& shapes_;
  CellMeasures& measures_;
  std::vector<std::pair<Index, double>> shared_;
  Point3 apex_{};  ///< the first corner of the cell
  double surface_ = 0, boundary_ = 0;
};

template <int D>
void append(const CellShapes& shapes, const std::vector<Point3>& sites, CellMeasures& measures) {
  Measurer<D> measurer(shapes, measures);
  for (std::size_t cell = 0; cell < shapes.size(); ++cell) measurer.add(cell, sites[cell]);
}

}  // namespace

void append_measures(const CellShapes& shapes, const std::vector<Point3>& sites, CellMeasures& measures) {
  measures.dimension = shapes.dimension;
  shapes.dimension == 2 ? append<2>(shapes, sites, measures) : append<3>(shapes, sites, measures);
}

}  // namespace delone::dual_detail
