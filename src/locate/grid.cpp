#include "delone/locate/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "locate/reading.hpp"

namespace delone {
namespace {

constexpr std::size_t kEnough = 16;  // fewer vertices outside the box are no reason for a new one

std::span<const double> coordinates(const PointCopy& x, int dimension) {
  return {x.data(), static_cast<std::size_t>(dimension)};
}

/// Goes through the offsets of the buckets at `radius` from the middle in the largest norm; false after the last.
class Ring {
 public:
  Ring(std::size_t dimension, std::int64_t radius) : dimension_(dimension), radius_(radius) { offset.fill(-radius); }

  bool next() {
    std::size_t axis = 0;
    while (axis < dimension_ && offset[axis] == radius_) offset[axis++] = -radius_;
    if (axis == dimension_) return false;
    // Inside the ring the last axis jumps from side to side.
    const bool inner = axis == 0 && std::all_of(offset.begin() + 1, offset.begin() + static_cast<long>(dimension_),
                                                [&](std::int64_t o) { return std::abs(o) < radius_; });
    offset[axis] = inner ? radius_ : offset[axis] + 1;
    return true;
  }

  std::array<std::int64_t, kMaxDimension> offset{};

 private:
  std::size_t dimension_;
  std::int64_t radius_;
};

}  // namespace

CellId Grid::hint(const AnyTriangulation& t, std::span<const double> q) {
  require_query(t, q);
  ++counts_.hints;
  return cell_at(t, size_ == 0 ? kGhost : search(t, q));
}

/// A vertex near q: of the first vertices in the buckets of the nearest ring that has any the nearest one.
VertexId Grid::search(const AnyTriangulation& t, std::span<const double> q) {
  const Place middle = place_of(q);
  const std::int64_t widest = *std::max_element(count_.begin(), count_.begin() + static_cast<long>(dimension_));
  std::size_t left = max_visits;
  for (std::int64_t radius = 0; radius < widest; ++radius) {
    VertexId best = kGhost;
    double least = std::numeric_limits<double>::infinity();
    Ring ring(dimension_, radius);
    do {
      if (left-- == 0) return best == kGhost ? newest_ : best;
      Place place = middle;
      bool inside = true;
      for (std::size_t axis = 0; axis < dimension_; ++axis) {
        place[axis] += ring.offset[axis];
        inside = inside && place[axis] >= 0 && place[axis] < count_[axis];
      }
      if (!inside) continue;
      ++counts_.visited;
      std::size_t looked = 0;
      for (VertexId v = first_[bucket_at(place)]; v != kGhost && looked < max_distances; v = next_[raw(v)], ++looked) {
        const double distance = squared_distance(t.sites(), v, q);
        ++counts_.distances;
        if (best == kGhost || distance < least) best = v;
        least = std::min(distance, least);
      }
    } while (ring.next());
    if (best != kGhost) return best;
  }
  return newest_;
}

void Grid::update(const AnyTriangulation& t, const Edit& e) noexcept {
  try {
    dimension_ = static_cast<std::size_t>(t.dimension());
    if (e.rebuilt || first_.empty()) return rehash(t);
    for (const VertexId v : e.gone) leave(v);
    for (const VertexId v : e.came) enter(t, v);
    const bool crowded = size_ > 2 * size_at_rehash_ || outside_ > size_ / 4 + kEnough;
    if (crowded || 4 * size_ + kEnough < size_at_rehash_) rehash(t);
  } catch (const std::bad_alloc&) {
    forget();
  }
}

void Grid::rehash(const AnyTriangulation& t) {
  forget();
  low_.fill(std::numeric_limits<double>::infinity());
  high_.fill(-std::numeric_limits<double>::infinity());
  for_each_vertex(t, [&](VertexId v) {
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      const double half = 0.5 * t.sites().coordinate(v, static_cast<int>(axis));
      low_[axis] = std::min(low_[axis], half);
      high_[axis] = std::max(high_[axis], half);
    }
  });
  size_at_rehash_ = t.vertex_count();
  choose_buckets(size_at_rehash_);
  for_each_vertex(t, [&](VertexId v) { enter(t, v); });
}

/// Buckets of about the same length on all axes, on axes that are shorter than that a single one.
void Grid::choose_buckets(std::size_t vertices) {
  const double wanted = std::clamp(static_cast<double>(vertices) / per_bucket, 1.0, static_cast<double>(max_buckets));
  std::array<double, kMaxDimension> length{};  // as logarithms: products of lengths overflow
  std::array<bool, kMaxDimension> divided{};
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    divided[axis] = high_[axis] > low_[axis];
    length[axis] = divided[axis] ? std::log2(high_[axis] - low_[axis]) : 0.0;
  }
  double bucket = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    double volume = -std::log2(wanted);
    int axes = 0;
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      if (!divided[axis]) continue;
      volume += length[axis];
      ++axes;
    }
    bucket = axes == 0 ? 0.0 : volume / axes;
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      if (!divided[axis] || length[axis] >= bucket) continue;
      divided[axis] = false;
      changed = true;
    }
  }
  std::size_t buckets = 1;
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    const double count = divided[axis] ? std::floor(std::exp2(length[axis] - bucket) * (1 + 0x1p-40)) : 1.0;
    count_[axis] = static_cast<std::int64_t>(std::clamp(count, 1.0, wanted));
    buckets *= static_cast<std::size_t>(count_[axis]);
  }
  first_.assign(buckets, kGhost);
}

Grid::Place Grid::place_of(std::span<const double> q) const {
  Place place{};
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    const auto count = static_cast<double>(count_[axis]);
    const double at = (0.5 * q[axis] - low_[axis]) / (high_[axis] - low_[axis]) * count;
    if (at >= 1.0) place[axis] = static_cast<std::int64_t>(std::min(at, count - 1.0));  // else 0, also for 0 / 0
  }
  return place;
}

bool Grid::outside(std::span<const double> q) const {
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    if (0.5 * q[axis] < low_[axis] || 0.5 * q[axis] > high_[axis]) return true;
  }
  return false;
}

std::size_t Grid::bucket_at(const Place& place) const {
  std::size_t bucket = 0;
  for (std::size_t axis = dimension_; axis-- > 0;) {
    bucket = bucket * static_cast<std::size_t>(count_[axis]) + static_cast<std::size_t>(place[axis]);
  }
  return bucket;
}

void Grid::enter(const AnyTriangulation& t, VertexId v) {
  if (raw(v) >= bucket_.size()) {
    const std::size_t slots = std::max<std::size_t>(t.complex().vertex_slots(), raw(v) + std::size_t{1});
    next_.resize(slots, kGhost);
    previous_.resize(slots, kGhost);
    bucket_.resize(slots, kNone);
  }
  const PointCopy x = coordinates_of(t.sites(), v);
  const auto point = coordinates(x, t.dimension());
  const std::size_t bucket = bucket_at(place_of(point));
  const VertexId head = first_[bucket];
  next_[raw(v)] = head;
  previous_[raw(v)] = kGhost;
  if (head != kGhost) previous_[raw(head)] = v;
  first_[bucket] = v;
  bucket_[raw(v)] = static_cast<Index>(bucket);
  newest_ = v;
  ++size_;
  if (outside(point)) ++outside_;
}

void Grid::leave(VertexId v) {
  if (v == newest_) newest_ = kGhost;
  if (raw(v) >= bucket_.size() || bucket_[raw(v)] == kNone) return;
  const VertexId after = next_[raw(v)];
  const VertexId before = previous_[raw(v)];
  if (after != kGhost) previous_[raw(after)] = before;
  (before == kGhost ? first_[bucket_[raw(v)]] : next_[raw(before)]) = after;
  bucket_[raw(v)] = kNone;
  --size_;
}

void Grid::forget() {
  first_.clear();
  next_.clear();
  previous_.clear();
  bucket_.clear();
  newest_ = kGhost;
  size_ = size_at_rehash_ = outside_ = 0;
}

std::size_t Grid::memory_bytes() const {
  return sizeof *this + (first_.capacity() + next_.capacity() + previous_.capacity()) * sizeof(VertexId) +
         bucket_.capacity() * sizeof(Index);
}

}  // namespace delone
