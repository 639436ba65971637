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

/// Sums over simplices whose corners are seen from the site.
struct Moments {
  int dimension;
  double volume = 0, second = 0;
  Point3 first{};

  /// @param volume_of_simplex  signed
  template <std::size_t Corners>
  void add(double volume_of_simplex, const std::array<Point3, Corners>& corners) {
    Point3 sum{};
    double squares = 0;
    for (const Point3& v : corners) {
      sum = sum + v;
      squares += dot(v, v);
    }
    volume += volume_of_simplex;
    first = first + volume_of_simplex / static_cast<double>(Corners) * sum;
    second += volume_of_simplex * (squares + dot(sum, sum)) / static_cast<double>(Corners * (Corners + 1));
  }
};

class Measurer {
 public:
  Measurer(const CellShapes& shapes, CellMeasures& measures) : shapes_(shapes), measures_(measures) {}

  void add(std::size_t cell, const Point3& site) {
    Moments moments{shapes_.dimension};
    shared_.clear();
    double boundary = 0;
    double surface = 0;
    const auto share = [&](Index across, double size) {
      surface += size;
      if (across == kNone) {
        boundary += size;
      } else if (size > 0) {
        shared_.emplace_back(across, size);
      }
    };
    if (shapes_.dimension == 2) {
      add_plane(cell, site, moments, share);
    } else {
      add_space(cell, site, moments, share);
    }
    measures_.volume.push_back(moments.volume);
    measures_.surface.push_back(surface);
    measures_.boundary.push_back(boundary);
    measures_.second_moment.push_back(moments.second);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(shapes_.dimension); ++axis) {
      const double shift = moments.volume > 0 ? moments.first[axis] / moments.volume : 0;
      measures_.centroid.push_back(site[axis] + shift);
    }
    add_neighbours();
  }

 private:
  Point3 corner(std::size_t i) const {
    Point3 x{};
    const auto d = static_cast<std::size_t>(shapes_.dimension);
    std::copy_n(shapes_.corners.begin() + static_cast<std::ptrdiff_t>(i * d), d, x.begin());
    return x;
  }

  template <class Share>
  void add_plane(std::size_t cell, const Point3& site, Moments& moments, const Share& share) {
    if (shapes_.empty(cell)) return;
    const Point3 apex = corner(shapes_.loops[shapes_.cells[cell]]);
    for (std::size_t l = shapes_.cells[cell]; l < shapes_.cells[cell + 1]; ++l) {
      for (std::size_t i = shapes_.loops[l]; i < shapes_.loops[l + 1]; ++i) {
        const Point3 a = corner(i);
        const Point3 b = corner(i + 1 == shapes_.loops[l + 1] ? shapes_.loops[l] : i + 1);
        const Point3 edge = b - a;
        share(shapes_.across[i], length(edge));
        const Point3 arm = a - apex;
        moments.add((arm[0] * edge[1] - arm[1] * edge[0]) / 2, std::array{apex - site, a - site, b - site});
      }
    }
  }

  template <class Share>
  void add_space(std::size_t cell, const Point3& site, Moments& moments, const Share& share) {
    if (shapes_.empty(cell)) return;
    const Point3 apex = corner(shapes_.loops[shapes_.cells[cell]]);
    for (std::size_t l = shapes_.cells[cell]; l < shapes_.cells[cell + 1]; ++l) {
      const Point3 a = corner(shapes_.loops[l]);
      const Point3 arm = a - apex;
      Point3 area{};
      Point3 b = corner(shapes_.loops[l] + 1);
      for (std::size_t i = shapes_.loops[l] + 2; i < shapes_.loops[l + 1]; ++i) {
        const Point3 c = corner(i);
        const Point3 triangle = cross(b - a, c - b);
        area = area + triangle;
        moments.add(dot(arm, triangle) / 6, std::array{apex - site, a - site, b - site, c - site});
        b = c;
      }
      share(shapes_.across[l], length(area) / 2);
    }
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
};

}  // namespace

void append_measures(const CellShapes& shapes, const SiteOfCell& site, CellMeasures& measures) {
  measures.dimension = shapes.dimension;
  Measurer measurer(shapes, measures);
  for (std::size_t cell = 0; cell < shapes.size(); ++cell) measurer.add(cell, site(cell));
}

}  // namespace delone::dual_detail
