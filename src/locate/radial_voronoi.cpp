// Source: [GKS92] section 5.
//
// A cell of the Delaunay triangulation is a Voronoi vertex, a ghost cell one at infinity, and each half-edge from s to
// k is the radial triangle of s that is based on the bisector of s and k. So a new site's star are its sectors, and the
// half-edges of the cells that it removes, and of those around them, are the triangles that it destroys. Where Voronoi
// vertices coincide, triangles are empty; the arguments below hold for closed triangles, empty ones included.
#include "delone/locate/radial_voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "delone/base/arithmetic.hpp"
#include "delone/base/random.hpp"
#include "delone/mesh/inserter.hpp"

namespace delone {
namespace {

constexpr Flat kBothAxes{2, {0, 1}};
constexpr Heading kEast{{0.0, 0.0}, {1.0, 0.0}};
constexpr Heading kNorth{{0.0, 0.0}, {0.0, 1.0}};

/// The vertices of `t` by ascending row.
std::vector<VertexId> vertices_by_row(const AnyTriangulation& t) {
  std::vector<VertexId> vertices;
  vertices.reserve(t.vertex_count());
  for (const Index row : t.present_rows()) {
    const VertexId v = t.vertex(row);
    if (t.complex().incident_cell(v) != kNoCell) vertices.push_back(v);
  }
  return vertices;
}

/// The vertices in random order, but for the third.
/// Departure from [GKS92] section 5: the first version has three sites that are not in line, because only then is there
/// a Voronoi vertex. The third is the first by row that fits the first two, so the others stay in random order and the
/// expected bounds hold: a triangle depends on at most four sites, so that the r-th changes it with probability at most
/// 4 / (r - 3).
std::vector<VertexId> insertion_order(const AnyTriangulation& t, std::uint64_t seed) {
  const std::vector<VertexId> by_row = vertices_by_row(t);
  std::vector<VertexId> order = by_row;
  for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[mix(mix(seed) + i) % (i + 1)]);
  Kernel<2> kernel(t.sites());
  const auto spans = [&](VertexId v) { return kernel.orient({order[0], order[1], v}) != 0; };
  const auto third = std::ranges::find(order, *std::ranges::find_if(by_row, spans));
  std::rotate(order.begin() + 2, third, third + 1);
  return order;
}

void append(Sites& sites, const AnyTriangulation& t, const std::vector<VertexId>& order) {
  sites.reserve_more(order.size());
  for (const VertexId v : order) {
    sites.append(std::array{t.sites().coordinate(v, 0), t.sites().coordinate(v, 1)}, 0.0, t.sites().row(v));
  }
}

}  // namespace

/// Inserts the sites of a diagram one after the other.
class RadialVoronoi::Builder {
 public:
  explicit Builder(RadialVoronoi& diagram) : d_(&diagram), mesh_(&diagram.mesh_) {
    const std::size_t n = mesh_->sites.size();
    mesh_->complex.reserve_more(2 * n + 64, n);
    mesh_->complex.grow_vertices(n);
    make_first_cells<2>(*mesh_);
    sector_of_.resize(n);
    d_->planes_.push_back({0, 0});
  }

  void insert_all() {
    for (const VertexId v : {VertexId{0}, VertexId{1}, VertexId{2}}) {
      add_plane(v);
      for (std::size_t t = 0; t < star_.size(); ++t) attach(t, Part::inside, inside_edge(t));
    }
    Inserter<2> inserter(*mesh_);
    Kernel<2> kernel(mesh_->sites);
    for (std::size_t i = 3; i < mesh_->sites.size(); ++i) {
      const VertexId v{static_cast<Index>(i)};
      inserter.insert(v, cell_in_conflict(v, kernel));
      add_plane(v);
      destroy_triangles(inserter.edit());
      create_triangles();
    }
  }

 private:
  /// A sector of the site that has just come, and where it ends: the cell of the site, the neighbour and the next one.
  struct Corner {
    VertexId neighbour;
    CellId cell;
    bool starts_up;
  };

  ComplexView<2> complex() const { return ComplexView<2>(mesh_->complex); }

  /// The diagram locates the sites from which it is built. Of the two Voronoi vertices u, v of the triangle s u v that
  /// holds q, one is nearer to q than to s: with q - s = a (u - s) + b (v - s) and a + b <= 1, one of the dot products
  /// of q - s with u - s and v - s is at least |q - s|^2. The walk from there stays among the cells in conflict with q.
  CellId cell_in_conflict(VertexId q, Kernel<2>& kernel) {
    RadialSteps steps;
    const FacetId f = d_->fate(d_->last_triangle(d_->point(q), steps)).half_edge();
    const ComplexView<2> cells = complex();
    const CellId c = cells.cell(f);
    return in_conflict(cells, kernel, mesh_->scratch, c, q) ? c : cells.cell(cells.twin(f));
  }

  /// Turns the star of v into sectors.
  void add_plane(VertexId v) {
    const ComplexView<2> cells = complex();
    star_.clear();
    CellId c = cells.incident_cell(v);
    do {
      const int slot = cells.turned(cells.slot_of(c, v), 1);
      star_.push_back({cells.vertex(c, slot), c, false});
      c = cells.cell(cells.twin(c, slot));
    } while (c != cells.incident_cell(v));
    for (std::size_t t = 0; t < star_.size(); ++t) {
      star_[t].starts_up = leads_up(v, star_[before(t)].neighbour, star_[t].neighbour);
    }
    // Between two rays is less than half a turn, so some lead up and some down.
    std::size_t first = 0;
    while (!star_[first].starts_up || star_[before(first)].starts_up) ++first;
    std::rotate(star_.begin(), star_.begin() + static_cast<std::ptrdiff_t>(first), star_.end());
    first_sector_ = d_->sectors_.size();
    if (std::max(first_sector_ + star_.size(), cells.facet_slots()) > Fate::kNames) {
      throw InputError("too many sites: a radial Voronoi diagram cannot name all their sectors");
    }
    for (std::size_t t = 0; t < star_.size(); ++t) {
      const VertexId k = star_[t].neighbour;
      d_->sectors_.push_back({v, k, {}});
      if (k != kGhost) sector_of_[raw(k)] = sector(t);
    }
    const auto ups = std::ranges::count(star_, true, &Corner::starts_up);
    d_->planes_[raw(v)] = {sector(0), sector(static_cast<std::size_t>(ups))};
    d_->planes_.push_back({sector(star_.size()), 0});
  }

  /// Whether the ray from o through the Voronoi vertex of o, a, b leads up, or along the x axis.
  bool leads_up(VertexId o, VertexId a, VertexId b) const {
    const int side = d_->side_of_ray(o, a, b, kEast);
    return side < 0 || (side == 0 && d_->side_of_ray(o, a, b, kNorth) > 0);
  }

  /// Every vertex of a removed cell is a neighbour of the new site, and has a sector to point to.
  void destroy_triangles(const Edit& edit) {
    for (const CellId c : edit.removed) {
      for (int slot = 0; slot < 3; ++slot) destroy(ComplexView<2>::facet(c, slot));
    }
    for (std::size_t t = 0; t < star_.size(); ++t) destroy(outside_edge(t));
  }

  void destroy(FacetId f) {
    const Triangle old = triangle_of_[raw(f)];
    if (old.sector != kNone) set_fate(old, Fate::cut_by(sector_of_[raw(d_->site(old))]));
  }

  void create_triangles() {
    for (std::size_t t = 0; t < star_.size(); ++t) {
      attach(t, Part::inside, inside_edge(t));
      attach(t, Part::across, complex().twin(inside_edge(t)));
      attach(t, Part::towards_next, complex().twin(outside_edge(t)));
      attach(t, Part::towards_previous, outside_edge(before(t)));
    }
  }

  /// Names the triangle of a half-edge, unless that starts at the ghost.
  void attach(std::size_t t, Part part, FacetId f) {
    if (raw(f) >= triangle_of_.size()) {
      triangle_of_.reserve_more(complex().facet_slots() - triangle_of_.size());
      triangle_of_.resize(complex().facet_slots(), {kNone, Part::inside});
    }
    const bool exists = part == Part::inside || star_[t].neighbour != kGhost;
    triangle_of_[raw(f)] = exists ? Triangle{sector(t), part} : Triangle{kNone, part};
    if (!exists) return;
    set_fate({sector(t), part}, Fate::alive(f));
    ++d_->triangle_count_;
  }

  void set_fate(Triangle at, Fate fate) { d_->sectors_[at.sector].fates[static_cast<std::size_t>(at.part)] = fate; }

  Index sector(std::size_t t) const { return static_cast<Index>(first_sector_ + t); }
  std::size_t before(std::size_t t) const { return (t == 0 ? star_.size() : t) - 1; }
  int slot_of_site(std::size_t t) const { return complex().slot_of(star_[t].cell, d_->sectors_[first_sector_].site); }
  /// From the site to neighbour t.
  FacetId inside_edge(std::size_t t) const {
    return ComplexView<2>::facet(star_[t].cell, ComplexView<2>::turned(slot_of_site(t), 2));
  }
  /// From neighbour t + 1 to neighbour t, seen from beyond the star.
  FacetId outside_edge(std::size_t t) const { return complex().twin(star_[t].cell, slot_of_site(t)); }

  RadialVoronoi* d_;
  Mesh* mesh_;
  std::vector<Corner> star_;
  std::size_t first_sector_ = 0;  // of the star
  Buffer<Triangle> triangle_of_;  // by half-edge
  Buffer<Index> sector_of_;       // by vertex; right for the neighbours of the site that has just come
};

RadialVoronoi::RadialVoronoi(const AnyTriangulation& t, std::uint64_t seed) : mesh_(Sites(2, false, kBothAxes)) {
  if (t.dimension() != 2 || t.weighted()) {
    throw InputError("a radial Voronoi diagram needs a triangulation of the plane without weights");
  }
  const ExactEnvironment environment;
  if (t.affine_dimension() < 2) {
    keep_in_order(t);
    return;
  }
  append(mesh_.sites, t, insertion_order(t, seed));
  Builder(*this).insert_all();
  sectors_.shrink_to_fit();
  planes_.shrink_to_fit();
  mesh_.complex.shrink();
  mesh_.sites.shrink();
  mesh_.scratch = {};
}

std::size_t RadialVoronoi::memory_bytes() const {
  return sizeof(*this) + mesh_.sites.memory_bytes() + mesh_.complex.memory_bytes() +
         sectors_.capacity() * sizeof(Sector) + planes_.capacity() * sizeof(Plane);
}

Index RadialVoronoi::nearest(std::span<const double> q) const {
  RadialSteps steps;
  return nearest(q, steps);
}

Index RadialVoronoi::nearest(std::span<const double> q, RadialSteps& steps) const {
  if (q.size() != 2 || !std::isfinite(q[0]) || !std::isfinite(q[1])) {
    throw InputError("a query is two finite coordinates");
  }
  const ExactEnvironment environment;
  const Point2 p{q[0], q[1]};
  if (site_count() == 0) return kNone;
  if (sectors_.empty()) return nearest_on_line(p, steps);
  return lowest_nearest(last_triangle(p, steps), p, steps);
}

void RadialVoronoi::keep_in_order(const AnyTriangulation& t) {
  std::vector<VertexId> order = vertices_by_row(t);
  std::ranges::sort(order, {},
                    [&](VertexId v) { return std::pair(t.sites().coordinate(v, 0), t.sites().coordinate(v, 1)); });
  append(mesh_.sites, t, order);
  mesh_.sites.shrink();
}

/// Departure from [GKS92] section 5: sites on one line have parallel bisectors, in the order of the sites. Binary
/// search for the last bisector that q has crossed. At most two sites are as near.
Index RadialVoronoi::nearest_on_line(Point2 q, RadialSteps& steps) const {
  const auto site_at = [](std::size_t i) { return VertexId{static_cast<Index>(i)}; };
  std::size_t first = 0;
  std::size_t last = site_count() - 1;
  while (first < last) {
    const std::size_t middle = first + (last - first) / 2;
    ++steps.bisectors;
    const int side = nearer(q, point(site_at(middle)), point(site_at(middle + 1)));
    if (side == 0) return std::min(mesh_.sites.row(site_at(middle)), mesh_.sites.row(site_at(middle + 1)));
    if (side > 0) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return mesh_.sites.row(site_at(first));
}

/// The closed triangle `at` of the final diagram holds q, so its site s is nearest, and others are as near only if the
/// site of its base is. All these are the corners of a Delaunay polygon with q in its middle, or of an edge: the
/// triangles of a polygon form a tree, so none is met twice.
Index RadialVoronoi::lowest_nearest(Triangle at, Point2 q, RadialSteps& steps) const {
  const Point2 s = point(site(at));
  const auto as_near = [&](VertexId v) {
    if (v == kGhost) return false;
    ++steps.bisectors;
    return nearer(q, s, point(v)) == 0;
  };
  Index lowest = mesh_.sites.row(site(at));
  if (!as_near(base(at))) return lowest;
  lowest = std::min(lowest, mesh_.sites.row(base(at)));
  const Complex& complex = mesh_.complex;
  const FacetId edge = fate(at).half_edge();
  std::vector<FacetId> entered{edge, complex.twin(complex.cell(edge), complex.slot(edge))};
  while (!entered.empty()) {
    const CellId c = complex.cell(entered.back());
    const int slot = complex.slot(entered.back());
    entered.pop_back();
    if (!as_near(complex.vertex(c, slot))) continue;
    lowest = std::min(lowest, mesh_.sites.row(complex.vertex(c, slot)));
    for (const int turn : {1, 2}) entered.push_back(complex.twin(c, (slot + turn) % 3));
  }
  return lowest;
}

Point2 RadialVoronoi::point(VertexId v) const {
  const double* x = mesh_.sites.at(v);
  return {x[0], x[1]};
}

Index RadialVoronoi::next(Index sector) const {
  const Index site = raw(sectors_[sector].site);
  return sector + 1 == planes_[site + 1].first ? planes_[site].first : sector + 1;
}

Index RadialVoronoi::previous(Index sector) const {
  const Index site = raw(sectors_[sector].site);
  return (sector == planes_[site].first ? planes_[site + 1].first : sector) - 1;
}

VertexId RadialVoronoi::site(Triangle at) const {
  const Sector& sector = sectors_[at.sector];
  return at.part == Part::inside ? sector.site : sector.neighbour;
}

VertexId RadialVoronoi::base(Triangle at) const {
  switch (at.part) {
    case Part::inside:
      return sectors_[at.sector].neighbour;
    case Part::towards_next:
      return sectors_[next(at.sector)].neighbour;
    case Part::across:
      return sectors_[at.sector].site;
    case Part::towards_previous:
      break;
  }
  return sectors_[previous(at.sector)].neighbour;
}

/// On which side of the ray from o through the Voronoi vertex of o, a, b, one of which may be the ghost, d leads.
int RadialVoronoi::side_of_ray(VertexId o, VertexId a, VertexId b, Heading d) const {
  if (a == kGhost) return same_way({point(o), point(b)}, d);
  if (b == kGhost) return -same_way({point(o), point(a)}, d);
  return delone::side_of_ray(point(o), point(a), point(b), d);
}

RadialVoronoi::Triangle RadialVoronoi::first_triangle(Point2 q, RadialSteps& steps) const {
  VertexId s{0};
  for (const VertexId v : {VertexId{1}, VertexId{2}}) {
    ++steps.bisectors;
    if (nearer(q, point(v), point(s)) > 0) s = v;
  }
  return {sector_towards(s, q, steps), Part::inside};
}

/// Invariant: the closed triangle `at` holds q in the current version, so its site s is nearest to q among the sites of
/// that version. A version that does not destroy it changes nothing: its new site is at least as far from both Voronoi
/// vertices as s, and so from q.
///
/// Departure from [GKS92] section 5: a destroyed triangle points to the new site's sector on the bisector with s, as
/// the first remark after theorem 5.4 suggests, and q is compared with the bisector first, because the proof of 5.4,
/// which searches q by angle first, expects the sector that it finds to be based on that bisector when s remains
/// nearer. Of uniform sites it is not in three cases of ten: the way from the new site to q leads through a third
/// region.
RadialVoronoi::Triangle RadialVoronoi::last_triangle(Point2 q, RadialSteps& steps) const {
  Triangle at = first_triangle(q, steps);
  ++steps.triangles;
  for (Fate f = fate(at); !f.is_alive(); f = fate(at)) {
    const VertexId newcomer = sectors_[f.sector()].site;
    ++steps.triangles;
    ++steps.bisectors;
    if (nearer(q, point(newcomer), point(site(at))) > 0) {
      at = {sector_towards(newcomer, q, steps), Part::inside};
      steps.passed += distance(at.sector, f.sector());
    } else {
      at = {f.sector(), part_beyond(f.sector(), base(at), q, steps)};
    }
  }
  return at;
}

/// A sector of o that holds q. The first rays of the upper sectors lie within half a turn, and so do those of the lower
/// ones, and q is looked for on its own side: there the sign tells the order of the angles.
/// Departure from [GKS92] section 5: the paper does not say where its polar order begins; here it begins with the x
/// axis, so that coordinates tell on which side q lies, and no two rays are ever compared.
Index RadialVoronoi::sector_towards(VertexId o, Point2 q, RadialSteps& steps) const {
  const Plane plane = planes_[raw(o)];
  const Index end = planes_[raw(o) + 1].first;
  const Point2 centre = point(o);
  const bool up = q[1] >= centre[1];  // against the x axis the last upper sector holds q, too
  Index first = up ? plane.first : plane.lower;
  Index last = up ? plane.lower : end;
  while (first < last) {
    const Index middle = first + (last - first) / 2;
    ++steps.rays;
    const Index before = (middle == plane.first ? end : middle) - 1;
    if (side_of_ray(o, sectors_[before].neighbour, sectors_[middle].neighbour, {centre, q}) < 0) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return (first == plane.first ? end : first) - 1;
}

/// q lay in the closed triangle of s that was based on `old_base`, and is still nearest to s: which triangle of s
/// beyond the base of `sector` holds it.
/// Departure from [GKS92] section 5: at most one ray is asked, not up to three triangles, because the old triangle
/// tells more. If it lost both Voronoi vertices, what is left of it lies before the new base; if one, the ray through
/// the new vertex on its base cuts it in two.
RadialVoronoi::Part RadialVoronoi::part_beyond(Index sector, VertexId old_base, Point2 q, RadialSteps& steps) const {
  const VertexId newcomer = sectors_[sector].site;
  const VertexId s = sectors_[sector].neighbour;
  const Heading d{point(s), q};
  if (const VertexId k = sectors_[next(sector)].neighbour; k == old_base) {
    ++steps.rays;
    return side_of_ray(s, k, newcomer, d) < 0 ? Part::towards_next : Part::across;
  }
  if (const VertexId k = sectors_[previous(sector)].neighbour; k == old_base) {
    ++steps.rays;
    return side_of_ray(s, newcomer, k, d) > 0 ? Part::towards_previous : Part::across;
  }
  return Part::across;
}

/// Sectors from one to the other of the same plane, the shorter way round.
std::size_t RadialVoronoi::distance(Index sector, Index other) const {
  const Index site = raw(sectors_[sector].site);
  const std::size_t all = planes_[site + 1].first - planes_[site].first;
  const std::size_t apart = sector > other ? sector - other : other - sector;
  return std::min(apart, all - apart);
}

}  // namespace delone
