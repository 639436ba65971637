#include "dual/polytope.hpp"

#include <algorithm>
#include <cmath>

namespace delone::dual_detail {

Point3 doubled_area(std::span<const Point3> polygon) {
  Point3 sum{};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum = sum + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[i]);
  return sum;
}

void FaceCutter::cut(const Plane& by) {
  if (polygon_.empty()) return;
  side_.resize(polygon_.size());
  bool beyond = false;
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    side_[i] = dot(by.normal, polygon_[i]) - by.offset;
    beyond = beyond || side_[i] > 0;
  }
  if (!beyond) return;
  next_.clear();
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    const std::size_t j = i + 1 == polygon_.size() ? 0 : i + 1;
    if (side_[i] <= 0) next_.push_back(polygon_[i]);
    if ((side_[i] < 0 && side_[j] > 0) || (side_[i] > 0 && side_[j] < 0))
      next_.push_back(polygon_[i] + side_[i] / (side_[i] - side_[j]) * (polygon_[j] - polygon_[i]));
  }
  polygon_.swap(next_);
}

const Polygon3& FaceCutter::end(double narrow) {
  double around = 0;
  next_.clear();
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    const Point3 edge = polygon_[i + 1 == polygon_.size() ? 0 : i + 1] - polygon_[i];
    const double along = length(edge);
    around += along;
    if (along > narrow) next_.push_back(polygon_[i]);
  }
  if (next_.size() >= 3) polygon_.swap(next_);
  if (polygon_.size() >= 3) {
    const Point3 area = doubled_area(polygon_);
    if (length(area) > narrow * around) return polygon_;
  }
  polygon_.clear();
  return polygon_;
}

Polytope::Polytope(const std::vector<Polygon3>& faces) {
  for (const Polygon3& face : faces) {
    faces_.push_back({loops_.size(), loops_.size() + face.size(), kNone});
    for (const Point3& at : face) {
      const auto known = std::ranges::find(corners_, at);
      loops_.push_back(static_cast<Corner>(known - corners_.begin()));
      if (known == corners_.end()) corners_.push_back(at);
    }
  }
}

void Polytope::move(const Point3& by) {
  for (Point3& corner : corners_) corner = corner + by;
}

Polygon3 Polytope::polygon(const Face& face) const {
  Polygon3 polygon;
  for (std::size_t i = face.begin; i < face.end; ++i) polygon.push_back(corner(i));
  return polygon;
}

/// Where an edge meets the plane, between a corner that stays and one that goes; the former, if it lies on the plane.
Polytope::Corner Polytope::crossing(Corner stays, Corner goes) {
  if (side_[stays] == 0) return stays;
  const Corner low = std::min(stays, goes);
  const Corner high = std::max(stays, goes);
  for (const Crossing& known : crossings_) {
    if (known.low == low && known.high == high) return known.at;
  }
  const auto at = static_cast<Corner>(corners_.size());
  const double share = side_[low] / (side_[low] - side_[high]);
  corners_.push_back(corners_[low] + share * (corners_[high] - corners_[low]));
  crossings_.push_back({low, high, at});
  return at;
}

/// Where the loop goes out and comes back, the new face has the edge between the two the other way.
void Polytope::cut_face(const Face& face) {
  const std::size_t begin = new_loops_.size();
  const std::size_t n = face.end - face.begin;
  const auto at = [&](std::size_t i) { return loops_[face.begin + i % n]; };
  std::size_t start = 0;
  while (start < n && !(stays(at(start)) && !stays(at(start + n - 1)))) ++start;  // comes back there
  if (start == n) {
    if (!stays(at(0))) return;
    new_loops_.insert(new_loops_.end(), loops_.begin() + static_cast<std::ptrdiff_t>(face.begin),
                      loops_.begin() + static_cast<std::ptrdiff_t>(face.end));
    new_faces_.push_back({begin, new_loops_.size(), face.across});
    return;
  }
  const auto push = [&](Corner c) {
    if (new_loops_.size() == begin || new_loops_.back() != c) new_loops_.push_back(c);
  };
  Corner back = crossing(at(start), at(start + n - 1));
  const Corner first = back;
  push(back);
  for (std::size_t i = start; i < start + n; ++i) {
    if (!stays(at(i))) {
      if (stays(at(i + 1)) && i + 1 < start + n) push(back = crossing(at(i + 1), at(i)));
      continue;
    }
    push(at(i));
    if (stays(at(i + 1))) continue;
    const Corner out = crossing(at(i), at(i + 1));
    push(out);
    std::size_t j = i + 1;
    while (!stays(at(j))) ++j;
    const Corner in = j == start + n ? first : crossing(at(j), at(j + n - 1));
    if (in != out) chords_.push_back({in, out});
  }
  if (new_loops_.back() == first && new_loops_.size() > begin + 1) new_loops_.pop_back();
  if (new_loops_.size() - begin >= 3) {
    new_faces_.push_back({begin, new_loops_.size(), face.across});
  } else {
    new_loops_.resize(begin);
  }
}

/// The chords make up closed loops: each crossing is on two faces, which pass it in opposite directions.
void Polytope::close(Index across) {
  while (!chords_.empty()) {
    const std::size_t begin = new_loops_.size();
    const Corner first = chords_.back()[0];
    Corner next = chords_.back()[1];
    chords_.pop_back();
    new_loops_.push_back(first);
    while (next != first) {
      new_loops_.push_back(next);
      const auto chord = std::ranges::find(chords_, next, [](const auto& c) { return c[0]; });
      if (chord == chords_.end()) break;
      next = (*chord)[1];
      *chord = chords_.back();
      chords_.pop_back();
    }
    if (new_loops_.size() - begin >= 3) {
      new_faces_.push_back({begin, new_loops_.size(), across});
    } else {
      new_loops_.resize(begin);
    }
  }
}

void Polytope::cut(const Plane& by) {
  side_.resize(corners_.size());
  bool beyond = false;
  for (std::size_t i = 0; i < side_.size(); ++i) {
    side_[i] = dot(by.normal, corners_[i]) - by.offset;
    beyond = beyond || side_[i] > 0;
  }
  if (!beyond) return;
  crossings_.clear();
  chords_.clear();
  new_loops_.clear();
  new_faces_.clear();
  for (const Face& face : faces_) cut_face(face);
  close(by.across);
  loops_.swap(new_loops_);
  faces_.swap(new_faces_);
  drop_corners();
}

/// Those that no face has any more.
void Polytope::drop_corners() {
  std::vector<Corner>& name = new_loops_;
  name.assign(corners_.size(), 0);
  for (const Corner c : loops_) name[c] = 1;
  Corner kept = 0;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    if (name[c] == 0) continue;
    corners_[kept] = corners_[c];
    name[c] = kept++;
  }
  corners_.resize(kept);
  for (Corner& c : loops_) c = name[c];
}

}  // namespace delone::dual_detail
