#include "delone/locate/jump_and_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "delone/base/random.hpp"
#include "locate/reading.hpp"

namespace delone {

std::size_t JumpAndWalk::size_for(std::size_t n, int dimension) const {
  if (n == 0) return 0;
  const double size = alpha * std::pow(static_cast<double>(n), 1.0 / (dimension + 1));
  return std::clamp(static_cast<std::size_t>(std::llround(size)), std::size_t{1}, n);
}

CellId JumpAndWalk::hint(const AnyTriangulation& t, std::span<const double> q) {
  require_query(t, q);
  ++counts_.hints;
  return cell_at(t, nearest(q));
}

VertexId JumpAndWalk::nearest(std::span<const double> q) {
  VertexId best = sample_.empty() ? kGhost : sample_.front();
  double least = std::numeric_limits<double>::infinity();
  const double* x = coordinates_.data();
  for (const VertexId v : sample_) {
    double sum = 0.0;
    for (const double y : q) {
      sum += (*x - y) * (*x - y);
      ++x;
    }
    best = sum < least ? v : best;
    least = std::min(sum, least);
  }
  counts_.distances += sample_.size();
  return best;
}

void JumpAndWalk::update(const AnyTriangulation& t, const Edit& e) noexcept {
  try {
    dimension_ = static_cast<std::size_t>(t.dimension());
    if (e.rebuilt) forget();
    for (const VertexId v : e.gone) {
      for (std::size_t i = sample_.size(); i-- > 0;) {
        if (sample_[i] == v) drop(i);
      }
    }
    for (const VertexId v : e.came) {  // so that every vertex is a member with the same probability
      if (random() % t.vertex_count() < sample_.size()) replace(t, random() % sample_.size(), v);
    }
    keep_size(t);
  } catch (const std::bad_alloc&) {
    forget();
  }
}

void JumpAndWalk::keep_size(const AnyTriangulation& t) {
  const std::size_t size = size_for(t.vertex_count(), t.dimension());
  while (sample_.size() > size) drop(random() % sample_.size());
  while (sample_.size() < size) add(t, random_vertex(t));
}

std::uint64_t JumpAndWalk::random() { return mix(mix(seed) + drawn_++); }

/// Any id that is a vertex. Where few are, the next one after a random id.
VertexId JumpAndWalk::random_vertex(const AnyTriangulation& t) {
  constexpr int kTries = 64;
  const std::size_t ids = t.complex().vertex_slots();
  for (int i = 0; i < kTries; ++i) {
    const VertexId v{static_cast<Index>(random() % ids)};
    if (is_vertex(t, v)) return v;
  }
  std::size_t id = random() % ids;
  while (!is_vertex(t, VertexId{static_cast<Index>(id)})) id = id + 1 == ids ? 0 : id + 1;  // ends: there is a vertex
  return VertexId{static_cast<Index>(id)};
}

void JumpAndWalk::add(const AnyTriangulation& t, VertexId v) {
  coordinates_.resize((sample_.size() + 1) * dimension_);
  sample_.push_back(v);
  replace(t, sample_.size() - 1, v);
}

void JumpAndWalk::replace(const AnyTriangulation& t, std::size_t place, VertexId v) {
  sample_[place] = v;
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    coordinates_[place * dimension_ + axis] = t.sites().coordinate(v, static_cast<int>(axis));
  }
}

void JumpAndWalk::drop(std::size_t place) {
  const std::size_t last = sample_.size() - 1;
  sample_[place] = sample_[last];
  std::copy_n(coordinates_.data() + last * dimension_, dimension_, coordinates_.data() + place * dimension_);
  sample_.pop_back();
  coordinates_.resize(last * dimension_);
}

void JumpAndWalk::forget() {
  sample_.clear();
  coordinates_.clear();
}

std::size_t JumpAndWalk::memory_bytes() const {
  return sizeof *this + sample_.capacity() * sizeof(VertexId) + coordinates_.capacity() * sizeof(double);
}

}  // namespace delone
