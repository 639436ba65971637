#include "dual/clipper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delone/exact/double_double.hpp"

namespace delone::dual_detail {
namespace {

constexpr Index kWindow = kNone - 1;  // beyond an edge of the window around some cells

/// Does the loop go around x? Rounded.
bool goes_around(std::span<const Corner> loop, const std::array<double, 2>& x) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& a = loop[i].at;
    const auto& b = loop[i + 1 == loop.size() ? 0 : i + 1].at;
    if ((a[1] > x[1]) == (b[1] > x[1])) continue;
    inside ^= x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
  }
  return inside;
}

bool reaches_over(const Polygon3& polygon, const Plane& side) {
  return std::ranges::any_of(polygon, [&](const Point3& x) { return dot(side.normal, x) > side.offset; });
}

bool is_within(const StarCell& c) { return !c.ghost && c.centre.within; }
bool is_near(const StarCell& c) { return c.ghost || c.centre.near; }

}  // namespace

Plane bisector(std::span<const double> near, double near_weight, std::span<const double> far, double far_weight,
               const Frame& frame, std::span<const double> eye, Index across) {
  // In double-doubles: of sites far away large terms cancel.
  DoubleDouble offset = DoubleDouble::difference(near_weight / 2, far_weight / 2);
  Plane plane{{}, 0, across};
  for (std::size_t axis = 0; axis < near.size(); ++axis) {
    plane.normal[axis] = frame.scaled(far[axis] - near[axis]);
    const DoubleDouble middle = DoubleDouble::difference(near[axis] / 2, eye[axis] / 2) +
                                DoubleDouble::difference(far[axis] / 2, eye[axis] / 2);
    offset = offset + DoubleDouble::difference(far[axis], near[axis]) * middle;
  }
  plane.offset = frame.scaled(frame.scaled(offset.high()));
  return plane;
}

void CellWriter::add(std::span<const Corner> loop) {
  for (const Corner& corner : loop) {
    shapes_->corners.insert(shapes_->corners.end(), corner.at.begin(), corner.at.end());
    shapes_->across.push_back(corner.across);
  }
  shapes_->loops.push_back(shapes_->across.size());
}

void CellWriter::add_without_short_edges(std::span<const Corner> loop) {
  const double narrow = kNarrow * frame_.radius;
  kept_.clear();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& [x, y] = loop[i].at;
    const auto& [next_x, next_y] = loop[i + 1 == loop.size() ? 0 : i + 1].at;
    if (std::hypot(next_x - x, next_y - y) > narrow) kept_.push_back(loop[i]);
  }
  add(kept_.size() >= 3 ? std::span<const Corner>(kept_) : loop);
}

void CellWriter::add(const Loops& loops) {
  const auto loop = [&](std::size_t l) {
    const std::size_t begin = l == 0 ? 0 : loops.ends[l - 1];
    return std::span(loops.corners).subspan(begin, loops.ends[l] - begin);
  };
  if (loops.ends.size() == 1) return add_without_short_edges(loop(0));
  std::vector<double> area(loops.ends.size());
  for (std::size_t l = 0; l < area.size(); ++l) area[l] = doubled_area(loop(l).data(), loop(l).data() + loop(l).size());
  // The smallest piece around a hole; where rounding hides it, the largest piece.
  const auto piece_of = [&](std::size_t hole) {
    std::size_t best = static_cast<std::size_t>(std::ranges::max_element(area) - area.begin());
    for (std::size_t l = 0; l < area.size(); ++l) {
      if (area[l] > 0 && area[l] <= area[best] && goes_around(loop(l), loop(hole)[0].at)) best = l;
    }
    return best;
  };
  std::vector<std::size_t> piece(area.size());
  for (std::size_t l = 0; l < area.size(); ++l) {
    if (area[l] < 0) piece[l] = piece_of(l);
  }
  for (std::size_t l = 0; l < area.size(); ++l) {
    if (area[l] < 0) continue;
    add_without_short_edges(loop(l));
    for (std::size_t hole = 0; hole < area.size(); ++hole) {
      if (piece[hole] == l && area[hole] < 0) add_without_short_edges(loop(hole));
    }
  }
}

void CellWriter::add_face(const Polygon3& face, Index across) {
  if (face.empty()) return;
  for (const Point3& corner : face) shapes_->corners.insert(shapes_->corners.end(), corner.begin(), corner.end());
  shapes_->loops.push_back(shapes_->corners.size() / 3);
  shapes_->across.push_back(across);
}

void CellWriter::add_face(const Star& star, std::size_t begin, std::size_t end, Index across) {
  std::vector<double>& corners = shapes_->corners;
  std::size_t to = corners.size();
  corners.resize(to + 3 * (end - begin));
  for (std::size_t i = begin; i < end; ++i, to += 3) std::ranges::copy(star.at(i).centre.at, &corners[to]);
  shapes_->loops.push_back(corners.size() / 3);
  shapes_->across.push_back(across);
}

void CellWriter::add_cut_face(const Polygon3& face, Index across, std::span<const Plane> cuts) {
  cutter_.begin(face);
  for (const Plane& cut : cuts) cutter_.cut(cut);
  add_face(cutter_.end(kNarrow * frame_.radius), across);
}

std::span<const double> CellWriter::look_from(std::span<const double> site) {
  eye_ = {};
  for (std::size_t axis = 0; axis < site.size(); ++axis) eye_[axis] = frame_.seen(site[axis], axis);
  if (dot(eye_, eye_) <= 256 * frame_.radius * frame_.radius) return site;
  eye_ = {};
  return std::span(frame_.middle).first(static_cast<std::size_t>(frame_.dimension));
}

Loops CellWriter::seen_from_eye(Loops loops) const {
  for (Corner& corner : loops.corners) corner.at = {corner.at[0] - eye_[0], corner.at[1] - eye_[1]};
  return loops;
}

void CellWriter::add_seen_from_eye(Loops loops) {
  for (Corner& corner : loops.corners) corner.at = {corner.at[0] + eye_[0], corner.at[1] + eye_[1]};
  if (!loops.empty()) add(loops);
}

/// What is as flat as rounding is nothing: a bisector runs along a side of the region.
void CellWriter::add_cut_region(std::span<const Plane> cuts) {
  polytope_ = frame_.polytope;
  polytope_.move(-1.0 * eye_);
  for (const Plane& cut : cuts) polytope_.cut(cut);
  if (polytope_.empty()) return;
  const Point3 apex = polytope_.corner(0);
  double volume = 0, surface = 0;
  for (const Polytope::Face& face : polytope_.faces()) {
    const Polygon3 polygon = polytope_.polygon(face);
    const Point3 area = doubled_area(polygon);
    surface += length(area) / 2;
    volume += dot(area, polygon[0] - apex) / 6;
  }
  if (volume <= kNarrow * frame_.radius * surface) return;
  polytope_.move(eye_);
  for (const Polytope::Face& face : polytope_.faces()) add_cut_face(polytope_.polygon(face), face.across, {});
}

template <int D>
std::array<double, Clipper<D>::kAxes> Clipper<D>::place(VertexId v) const {
  std::array<double, kAxes> x;
  for (int axis = 0; axis < D; ++axis) x[static_cast<std::size_t>(axis)] = t_.sites().coordinate(v, axis);
  return x;
}

template <int D>
Plane Clipper<D>::bisector_of(VertexId v, VertexId u, std::span<const double> eye) const {
  return bisector(place(v), t_.sites().weight(v), place(u), t_.sites().weight(u), frame_, eye, t_.sites().row(u));
}

template <int D>
void Clipper<D>::end_cell(VertexId v) {
  writer_.end_cell(t_.sites().row(v));
  block_->sites.push_back(v);
}

/// The outward normal of a hull facet, of length 1: a ghost cell is positive with its ghost outside. Rounded where the
/// facet is not too thin for that.
template <int D>
Point3 Clipper<D>::ray(CellId ghost) const {
  const Complex& complex = t_.complex();
  std::array<VertexId, kAxes> facet;
  std::array<Point3, kAxes> at{};
  for (std::size_t i = 0; i < kAxes; ++i) {
    facet[i] = complex.vertex(ghost, static_cast<int>(i));
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      at[i][axis] = frame_.scaled(place(facet[i])[axis] - place(facet[0])[axis]);
  }
  const Point3 along = at[1] - at[0];
  Point3 normal{-along[1], along[0], 0};
  if constexpr (D == 3) {
    const Point3 other = at[2] - at[0];
    normal = cross(along, other);
    const double sine = std::sqrt(dot(normal, normal) / (dot(along, along) * dot(other, other)));
    if (!(sine > 0x1p-6 && sine < 2)) {
      const FacetId inside = complex.twin(ghost, D);
      const Vector exact =
          outward_normal(t_.sites(), facet, complex.vertex(complex.cell(inside), complex.slot(inside)));
      std::copy_n(exact.begin(), 3, normal.begin());
    }
  }
  return 1 / std::hypot(normal[0], normal[1], normal[2]) * normal;
}

/// So far that no line between two of them meets the region: they lead no more than a right angle apart. The rays of a
/// cell, or a facet, lead less than two right angles apart.
template <int D>
void Clipper<D>::add_far_corners(const Point3& a, CellId first, CellId last, const Point3& b, const Point3& axis) {
  const double far = 8 * (frame_.radius + std::sqrt(std::max(dot(a, a), dot(b, b))));
  const Point3 from = ray(first);
  const Point3 to = ray(last);
  polygon_.push_back(a + far * from);
  if (dot(from, to) < 0) {
    const Point3 quarter = 1 / length(axis) * cross(axis, from);
    polygon_.push_back(0.5 * (a + b) + far * quarter);
  }
  polygon_.push_back(b + far * to);
}

/// The corners of a facet of the cell of v in space, the run begin to end of its ring, counter-clockwise from outside.
template <int D>
void Clipper<D>::read_facet(VertexId v, VertexId neighbour, std::size_t begin, std::size_t end) {
  polygon_.clear();
  const auto next = [&](std::size_t i) { return i + 1 == end ? begin : i + 1; };
  for (std::size_t i = begin; i < end; ++i) {
    const StarCell& c = star_.at(i);
    const StarCell& before = star_.at(i == begin ? end - 1 : i - 1);
    if (!c.ghost) {
      polygon_.push_back(c.centre.at);
    } else if (!before.ghost) {
      const std::size_t last = star_.at(next(i)).ghost ? next(i) : i;
      add_far_corners(before.centre.at, c.cell, star_.at(last).cell, star_.at(next(last)).centre.at,
                      direction(t_.sites(), frame_, v, neighbour));
    }
  }
}

template <int D>
void Clipper<D>::read(std::span<const VertexId> sites, ClippedBlock& block) {
  block_ = &block;
  writer_.begin(block.shapes);
  if constexpr (D == 2) {
    planar_block(sites);
  } else {
    for (const VertexId v : sites) {
      if (is_vertex(v)) write_spatial(v);
      end_cell(v);
    }
  }
}

template <int D>
void Clipper<D>::planar_block(std::span<const VertexId> sites) {
  cells_.clear();
  corners_.clear();
  for (const VertexId v : sites) cells_.push_back(read_planar(v));
  if (frame_.sides.empty() || !full_) return divide(cells_, frame_.loops);
  for (const PlanarCell& cell : cells_) {
    if (cell.exists) write_planar(cell);
    end_cell(cell.site);
  }
}

/// In the plane: of the cell of a hull vertex, whose edge i comes from infinity, while the one before leads there.
/// Returns whether both begin near the region.
template <int D>
bool Clipper<D>::read_far_corners(std::size_t i) {
  const Complex& complex = t_.complex();
  const CellId c = star_.at(i).cell;
  const Centre before = star_.at(i == 0 ? star_.ring.size() - 1 : i - 1).centre;
  const Centre after = centres_[complex.cell(complex.twin(c, D))];
  int slot = 0;
  while (complex.vertex(c, slot) != star_.facets[i].neighbour) ++slot;
  polygon_.clear();
  add_far_corners(before.at, complex.cell(complex.twin(c, slot)), c, after.at, {0, 0, 1});
  return before.near && after.near;
}

template <int D>
typename Clipper<D>::PlanarCell Clipper<D>::read_planar(VertexId v) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  PlanarCell cell{v, corners_.size(), 0, is_vertex(v), full_, full_, {kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  star_.clear();
  if (cell.exists) stars_.read(v, star_);
  for (std::size_t i = 0; i < star_.facets.size(); ++i) {
    const Index across = t_.sites().row(star_.facets[i].neighbour);
    if (!full_) {
      corners_.push_back({{}, across});
      continue;
    }
    const StarCell& c = star_.at(i);
    if (c.ghost) {
      cell.within = false;
      cell.placed = read_far_corners(i) && cell.placed;
      for (const Point3& at : polygon_) corners_.push_back({{at[0], at[1]}, kWindow});
      corners_.back().across = across;
    } else {
      cell.within = cell.within && c.centre.within;
      cell.placed = cell.placed && c.centre.near;
      corners_.push_back({{c.centre.at[0], c.centre.at[1]}, across});
    }
  }
  for (std::size_t i = cell.begin; i < corners_.size(); ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = corners_[i].at[axis];
      cell.low[axis] = std::min(cell.low[axis], x);
      cell.high[axis] = std::max(cell.high[axis], x);
    }
  }
  cell.end = corners_.size();
  return cell;
}

template <int D>
void Clipper<D>::write_planar(const PlanarCell& cell) {
  const auto corners = std::span(corners_).subspan(cell.begin, cell.end - cell.begin);
  if (!cell.placed) return cut_region(cell, frame_.loops);
  if (cell.within) return writer_.add(corners);
  for (const Corner& corner : corners) {
    if (corner.across != kWindow) block_->doubtful.push_back({t_.sites().row(cell.site), corner.across});
  }
  Loops loops{{corners.begin(), corners.end()}, {corners.size()}};
  for (const Plane& side : frame_.sides) cutter_.cut(loops, {{side.normal[0], side.normal[1]}, side.offset}, kNone);
  if (!loops.empty()) writer_.add(loops);
}

/// What of a region lies in a window around cells.
template <int D>
Loops Clipper<D>::around(std::span<const PlanarCell> cells, Loops region) {
  std::array<double, 2> low{frame_.high[0], frame_.high[1]};
  std::array<double, 2> high{frame_.low[0], frame_.low[1]};
  for (const PlanarCell& cell : cells) {
    if (!cell.exists) continue;
    if (!cell.placed) return region;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], cell.low[axis]);
      high[axis] = std::max(high[axis], cell.high[axis]);
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double margin = (high[axis] - low[axis]) / 32 + 0x1p-40 * frame_.radius;
    HalfPlane side{{}, high[axis] + margin};
    side.normal[axis] = 1;
    cutter_.cut(region, side, kWindow);
    side.normal[axis] = -1;
    side.offset = margin - low[axis];
    cutter_.cut(region, side, kWindow);
  }
  return region;
}

/// Halves the cells until the region around them is nothing but a window, or they are few.
template <int D>
void Clipper<D>::divide(std::span<const PlanarCell> cells, Loops region) {
  constexpr std::size_t kFewCells = 4;
  constexpr std::size_t kFewCorners = 8;
  region = around(cells, std::move(region));
  const bool whole = region.ends.size() == 1 &&
                     std::ranges::all_of(region.corners, [](const Corner& corner) { return corner.across == kWindow; });
  if (!region.empty() && !whole && cells.size() > kFewCells && region.corners.size() > kFewCorners) {
    divide(cells.first(cells.size() / 2), region);
    divide(cells.subspan(cells.size() / 2), std::move(region));
    return;
  }
  for (const PlanarCell& cell : cells) {
    if (cell.exists && whole) {
      writer_.add(std::span(corners_).subspan(cell.begin, cell.end - cell.begin));
    } else if (cell.exists && !region.empty()) {
      cut_region(cell, region);
    }
    end_cell(cell.site);
  }
}

template <int D>
void Clipper<D>::cut_region(const PlanarCell& cell, const Loops& region) {
  const auto site = place(cell.site);
  const auto eye = writer_.look_from(site);
  Loops left = writer_.seen_from_eye(region);
  for (std::size_t i = cell.begin; i < cell.end; ++i) {
    if (corners_[i].across == kWindow) continue;
    const Plane plane = bisector_of(cell.site, t_.vertex(corners_[i].across), eye);
    block_->doubtful.push_back({t_.sites().row(cell.site), plane.across});
    cutter_.cut(left, {{plane.normal[0], plane.normal[1]}, plane.offset}, plane.across);
  }
  writer_.add_seen_from_eye(std::move(left));
}

/// From centres, where all are near; else from the bisectors alone.
template <int D>
void Clipper<D>::write_spatial(VertexId v) {
  stars_.read(v, star_);
  if (full_ && std::ranges::all_of(star_.cells, is_within)) {
    std::size_t begin = 0;
    for (const Facet& facet : star_.facets) {
      writer_.add_face(star_, begin, facet.end, t_.sites().row(facet.neighbour));
      begin = facet.end;
    }
    return;
  }
  for (const Facet& facet : star_.facets)
    block_->doubtful.push_back({t_.sites().row(v), t_.sites().row(facet.neighbour)});
  if (full_ && std::ranges::all_of(star_.cells, is_near) && !lies_on_side(v)) return write_placed(v);
  const auto site = place(v);
  read_planes(v, writer_.look_from(site));
  writer_.add_cut_region(planes_);
}

/// The bisectors with all neighbours, seen from an eye.
template <int D>
void Clipper<D>::read_planes(VertexId v, std::span<const double> eye) {
  planes_.clear();
  for (const Facet& facet : star_.facets) planes_.push_back(bisector_of(v, facet.neighbour, eye));
}

/// Calls f(number) for the facets in turn, with polygon_ as that facet.
template <int D>
template <class F>
void Clipper<D>::for_facets(VertexId v, const F& f) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < star_.facets.size(); ++i) {
    read_facet(v, star_.facets[i].neighbour, begin, star_.facets[i].end);
    begin = star_.facets[i].end;
    f(i);
  }
}

/// Does a facet of the cell lie on a side of the region, up to rounding? Then neither can tell which of them it is.
template <int D>
bool Clipper<D>::lies_on_side(VertexId v) {
  bool found = false;
  for_facets(v, [&](std::size_t) {
    for (const Plane& side : frame_.sides) {
      const auto is_on = [&](const Point3& x) {
        return std::abs(dot(side.normal, x) - side.offset) < 0x1p-44 * frame_.radius;
      };
      found = found || std::ranges::all_of(polygon_, is_on);
    }
  });
  return found;
}

/// Faces from centres; where one reaches over sides of the region it is cut by them, and so are the faces of the region
/// on these sides by the cell. A cell without end may reach over sides that none of its facets does.
template <int D>
void Clipper<D>::write_placed(VertexId v) {
  crossed_.assign(frame_.sides.size(), std::ranges::any_of(star_.cells, &StarCell::ghost));
  for_facets(v, [&](std::size_t i) {
    sides_.clear();
    for (std::size_t side = 0; side < frame_.sides.size(); ++side) {
      if (!reaches_over(polygon_, frame_.sides[side])) continue;
      crossed_[side] = true;
      sides_.push_back(frame_.sides[side]);
    }
    const Index across = t_.sites().row(star_.facets[i].neighbour);
    if (sides_.empty()) return writer_.add_face(polygon_, across);
    writer_.add_cut_face(polygon_, across, sides_);
  });
  read_planes(v, std::span(frame_.middle).first(kAxes));
  for (std::size_t side = 0; side < frame_.sides.size(); ++side) {
    if (crossed_[side]) writer_.add_cut_face(frame_.faces[side], kNone, planes_);
  }
}

template class Clipper<2>;
template class Clipper<3>;

}  // namespace delone::dual_detail
