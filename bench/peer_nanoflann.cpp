#include <array>
#include <nanoflann.hpp>

#include "bench/query_peer.hpp"

namespace delone::bench {
namespace {

struct Rows {
  PointsView points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t row, std::size_t axis) const {
    return points.coordinates()[row * static_cast<std::size_t>(points.dimension()) + axis];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

template <int D>
class Tree : public QueryPeer {
 public:
  explicit Tree(PointsView points) : rows_{points}, index_(D, rows_, {10}) { index_.buildIndex(); }

  void nearest(PointsView queries, std::size_t k, std::span<std::uint32_t> rows) const override {
    std::array<double, 64> distances;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      index_.knnSearch(queries[i].data(), k, rows.data() + i * k, distances.data());
    }
  }

 private:
  Rows rows_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Rows>, Rows, D, std::uint32_t> index_;
};

}  // namespace

std::unique_ptr<QueryPeer> nanoflann_index(PointsView points) {
  if (points.dimension() == 2) return std::make_unique<Tree<2>>(points);
  return std::make_unique<Tree<3>>(points);
}

std::string nanoflann_version() {
  const int v = NANOFLANN_VERSION;  // 0xMmP
  return std::to_string(v >> 8) + "." + std::to_string(v >> 4 & 15) + "." + std::to_string(v & 15);
}

}  // namespace delone::bench
