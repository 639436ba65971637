#include "delone/locate/quad_buckets.hpp"

#include <algorithm>
#include <limits>
#include <new>

#include "locate/reading.hpp"

namespace delone {
namespace {

constexpr int kDepth = 32;
constexpr std::size_t kEnough = 16;  // fewer vertices outside the root are no reason for a new one

}  // namespace

CellId QuadBuckets::hint(const AnyTriangulation& t, std::span<const double> q) {
  require_query(t, q);
  ++counts_.hints;
  if (size_ == 0) return any_cell(t);
  const Key key = key_of(q);
  Index node = 0;
  while (nodes_[node].children != kNone) {
    ++counts_.visited;
    const Index child = child_towards(node, key);
    if (nodes_[child].label == kGhost) break;
    node = child;
  }
  VertexId best = kGhost;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](VertexId v) {
    const double distance = squared_distance(t.sites(), v, q);
    ++counts_.distances;
    if (best == kGhost || distance < least) best = v;
    least = std::min(distance, least);
  };
  if (const Index children = nodes_[node].children; children != kNone) {
    for (Index i = children; i < children + fan(); ++i) {
      if (nodes_[i].label != kGhost) look(nodes_[i].label);
    }
  } else {
    std::size_t left = std::max(capacity, fan());  // a bucket of the greatest depth may hold more
    for (VertexId v = nodes_[node].label; v != kGhost && left-- > 0; v = next_[raw(v)]) look(v);
  }
  return cell_at(t, best);
}

void QuadBuckets::update(const AnyTriangulation& t, const Edit& e) noexcept {
  try {
    dimension_ = static_cast<std::size_t>(t.dimension());
    if (e.rebuilt || nodes_.empty()) return rehash(t);
    for (const VertexId v : e.gone) leave(v);
    for (const VertexId v : e.came) enter(t, v);
    if (outside_ > size_ / 4 + kEnough || 4 * size_ + kEnough < size_at_rehash_) rehash(t);
  } catch (const std::bad_alloc&) {
    forget();
  }
}

void QuadBuckets::rehash(const AnyTriangulation& t) {
  forget();
  std::array<double, kMaxDimension> high{};
  low_.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for_each_vertex(t, [&](VertexId v) {
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      const double half = 0.5 * t.sites().coordinate(v, static_cast<int>(axis));
      low_[axis] = std::min(low_[axis], half);
      high[axis] = std::max(high[axis], half);
    }
  });
  side_ = 0.0;
  for (std::size_t axis = 0; axis < dimension_; ++axis) side_ = std::max(side_, high[axis] - low_[axis]);
  nodes_.emplace_back();
  for_each_vertex(t, [&](VertexId v) { enter(t, v); });
  size_at_rehash_ = size_;
}

QuadBuckets::Key QuadBuckets::key_of(std::span<const double> q) const {
  constexpr double kLast = 0xFFFF'FFFFu;
  Key key{};
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    const double at = (0.5 * q[axis] - low_[axis]) / side_ * 0x1p32;
    if (at >= 1.0) key[axis] = static_cast<std::uint32_t>(std::min(at, kLast));  // else 0, also for 0 / 0
  }
  return key;
}

bool QuadBuckets::outside(std::span<const double> q) const {
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    const double at = 0.5 * q[axis] - low_[axis];
    if (at < 0.0 || at > side_) return true;
  }
  return false;
}

Index QuadBuckets::child_towards(Index node, const Key& key) const {
  Index child = 0;
  const int bit = kDepth - 1 - nodes_[node].level;
  for (std::size_t axis = 0; axis < dimension_; ++axis) child |= static_cast<Index>(key[axis] >> bit & 1U) << axis;
  return nodes_[node].children + child;
}

void QuadBuckets::enter(const AnyTriangulation& t, VertexId v) {
  if (raw(v) >= node_of_.size()) {
    const std::size_t slots = std::max<std::size_t>(t.complex().vertex_slots(), raw(v) + std::size_t{1});
    next_.resize(slots, kGhost);
    previous_.resize(slots, kGhost);
    node_of_.resize(slots, kNone);
  }
  const PointCopy x = coordinates_of(t.sites(), v);
  const std::span point(x.data(), dimension_);
  const Key key = key_of(point);
  Index node = 0;
  while (nodes_[node].children != kNone) {
    if (nodes_[node].label == kGhost) nodes_[node].label = v;
    node = child_towards(node, key);
  }
  push(node, v);
  ++size_;
  if (outside(point)) ++outside_;
  if (nodes_[node].size > std::max(capacity, fan() / 2) && nodes_[node].level < kDepth) divide(t, node);
}

void QuadBuckets::push(Index node, VertexId v) {
  const VertexId head = nodes_[node].label;
  next_[raw(v)] = head;
  previous_[raw(v)] = kGhost;
  if (head != kGhost) previous_[raw(head)] = v;
  nodes_[node].label = v;
  ++nodes_[node].size;
  node_of_[raw(v)] = node;
}

/// Deals the vertices of a bucket out to 2^D new ones; again where all fall into one.
void QuadBuckets::divide(const AnyTriangulation& t, Index node) {
  while (nodes_[node].size > std::max(capacity, fan() / 2) && nodes_[node].level < kDepth) {
    const auto children = static_cast<Index>(nodes_.size());
    nodes_.resize(nodes_.size() + fan(), {.parent = node, .level = nodes_[node].level + 1});
    nodes_[node].children = children;
    Index largest = children;
    for (VertexId v = nodes_[node].label; v != kGhost;) {
      const VertexId after = next_[raw(v)];
      const PointCopy x = coordinates_of(t.sites(), v);
      const Index child = child_towards(node, key_of(std::span(x.data(), dimension_)));
      push(child, v);
      if (nodes_[child].size > nodes_[largest].size) largest = child;
      v = after;
    }
    nodes_[node].size = 0;
    node = largest;
  }
}

void QuadBuckets::leave(VertexId v) {
  if (raw(v) >= node_of_.size() || node_of_[raw(v)] == kNone) return;
  Index node = node_of_[raw(v)];
  const VertexId after = next_[raw(v)];
  const VertexId before = previous_[raw(v)];
  if (after != kGhost) previous_[raw(after)] = before;
  (before == kGhost ? nodes_[node].label : next_[raw(before)]) = after;
  --nodes_[node].size;
  node_of_[raw(v)] = kNone;
  --size_;
  for (node = nodes_[node].parent; node != kNone; node = nodes_[node].parent) {
    if (nodes_[node].label != v) continue;
    nodes_[node].label = kGhost;
    for (Index i = nodes_[node].children; i < nodes_[node].children + fan(); ++i) {
      if (nodes_[i].label != kGhost) nodes_[node].label = nodes_[i].label;
    }
  }
}

void QuadBuckets::forget() {
  nodes_.clear();
  next_.clear();
  previous_.clear();
  node_of_.clear();
  size_ = size_at_rehash_ = outside_ = 0;
}

std::size_t QuadBuckets::memory_bytes() const {
  return sizeof *this + nodes_.capacity() * sizeof(Node) +
         (next_.capacity() + previous_.capacity()) * sizeof(VertexId) + node_of_.capacity() * sizeof(Index);
}

}  // namespace delone
