// Cells are sums of simplices with one corner in common. A simplex of dimension D with corners v_i and volume V has its
// centroid at their mean, and the integral of |x|^2 over it is V (sum |v_i|^2 + |sum v_i|^2) / ((D + 1) (D + 2)).
#include "dual/measure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace delone::dual_detail {
namespace {

template <int D>
class Measurer {
 public:
  Measurer(const CellShapes& shapes, CellMeasures& measures) : shapes_(shapes), measures_(measures) {}

  void add(std::size_t cell, const Point3& at) {
    Place site;
    std::copy_n(at.begin(), D, site.begin());
    moments_ = {};
    shared_.clear();
    surface_ = boundary_ = 0;
    apex_ = {};
    if (!shapes_.empty(cell)) {
      apex_ = corner(shapes_.loops[shapes_.cells[cell]]);
      for (std::size_t l = shapes_.cells[cell]; l < shapes_.cells[cell + 1]; ++l) {
        if constexpr (D == 2) {
          add_loop(l);
        } else {
          add_face(l);
        }
      }
    }
    measures_.volume.push_back(moments_.volume);
    measures_.surface.push_back(surface_);
    measures_.boundary.push_back(boundary_);
    measures_.second_moment.push_back(moments_.second_about(apex_, site));
    for (const double x : moments_.centroid(apex_, site)) measures_.centroid.push_back(x);
    add_neighbours();
  }

 private:
  using Place = typename Moments<D>::Place;

  /// Seen from the apex.
  Place corner(std::size_t i) const {
    Place x;
    std::copy_n(shapes_.corners.begin() + static_cast<std::ptrdiff_t>(i * D), D, x.begin());
    return x - apex_;
  }

  void share(Index across, double size) {
    surface_ += size;
    if (across == kNone) {
      boundary_ += size;
    } else if (size > 0) {
      shared_.emplace_back(across, size);
    }
  }

  void add_loop(std::size_t l) {
    const std::size_t begin = shapes_.loops[l];
    const std::size_t end = shapes_.loops[l + 1];
    Index across = shapes_.across[end - 1];
    Place a = corner(end - 1);
    double a_squared = dot(a, a);
    for (std::size_t i = begin; i < end; ++i) {
      const Place b = corner(i);
      const Place edge = b - a;
      share(across, length(edge));
      const double b_squared = dot(b, b);
      moments_.add_simplex(a[0] * edge[1] - a[1] * edge[0], a + b, a_squared + b_squared);
      across = shapes_.across[i];
      a = b;
      a_squared = b_squared;
    }
  }

  void add_face(std::size_t l) {
    const std::size_t begin = shapes_.loops[l];
    const Place a = corner(begin);
    const double a_squared = dot(a, a);
    Place area{};
    Place b = corner(begin + 1);
    double b_squared = dot(b, b);
    for (std::size_t i = begin + 2; i < shapes_.loops[l + 1]; ++i) {
      const Place c = corner(i);
      const double c_squared = dot(c, c);
      const Place triangle = cross(b - a, c - b);
      area = area + triangle;
      moments_.add_simplex(dot(a, triangle), a + b + c, a_squared + b_squared + c_squared);
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
  Place apex_{};  ///< the first corner of the cell
  Moments<D> moments_;
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
