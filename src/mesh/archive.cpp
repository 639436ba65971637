#include "delone/mesh/archive.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "delone/base/arithmetic.hpp"
#include "delone/base/buffer.hpp"
#include "delone/base/dispatch.hpp"
#include "delone/base/errors.hpp"
#include "delone/base/random.hpp"
#include "delone/geometry/kernel.hpp"
#include "delone/mesh/cavity.hpp"

namespace delone {
namespace {

constexpr std::uint64_t kNameAndVersion = 0x02'00'45'4E'4F'4C'45'44;  // "DELONE\0\2", the first letter lowest
constexpr std::uint64_t kVersionBits = 0xFFULL << 56;
constexpr std::uint64_t kLargestNarrowId = 0xFFFF'FFFF;

[[noreturn]] void refuse(const std::string& what) { throw InputError("saved triangulation: " + what); }

void require(bool condition, const char* what) {
  if (!condition) refuse(what);
}

class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(&out) {}

  void word(std::uint64_t w) {
    checksum_ = mix(checksum_ ^ w);
    std::array<char, 8> bytes;
    for (char& byte : bytes) {
      byte = static_cast<char>(w & 0xFF);
      w >>= 8;
    }
    out_->write(bytes.data(), bytes.size());
  }
  void number(double x) { word(std::bit_cast<std::uint64_t>(x)); }
  void finish() {
    word(checksum_);
    if (!out_->flush()) throw std::runtime_error("saved triangulation: it cannot be written");
  }

 private:
  std::ostream* out_;
  std::uint64_t checksum_ = 0;
};

/// An array of ids on its way into words; kNone becomes the largest id of the width.
class IdWriter {
 public:
  IdWriter(Writer& to, std::uint64_t width) : to_(&to), narrow_(width == 4) {}
  ~IdWriter() {
    if (half_) to_->word(low_);
  }
  IdWriter(const IdWriter&) = delete;
  IdWriter& operator=(const IdWriter&) = delete;

  void put(Index id) {
    if (!narrow_) {
      to_->word(id == kNone ? ~std::uint64_t{0} : id);
    } else if (half_ = !half_; half_) {
      low_ = id & kLargestNarrowId;
    } else {
      to_->word(low_ | (id & kLargestNarrowId) << 32);
    }
  }

 private:
  Writer* to_;
  bool narrow_;
  bool half_ = false;
  std::uint64_t low_ = 0;
};

class Reader {
 public:
  explicit Reader(std::istream& in) : in_(&in) {}

  std::uint64_t word() {
    std::array<char, 8> bytes;
    in_->read(bytes.data(), bytes.size());
    require(in_->gcount() == static_cast<std::streamsize>(bytes.size()), "it is cut off");
    std::uint64_t w = 0;
    for (std::size_t i = 8; i-- > 0;) w = w << 8 | static_cast<unsigned char>(bytes[i]);
    checksum_ = mix(checksum_ ^ w);
    return w;
  }
  double number() {
    const auto x = std::bit_cast<double>(word());
    require(std::isfinite(x), "a coordinate or weight is not finite");
    return x;
  }
  /// A word from 0 to `largest`.
  std::size_t count(std::uint64_t largest, const char* what) {
    const std::uint64_t w = word();
    if (w > largest) refuse(std::string(what) + " " + std::to_string(w) + " is out of range");
    return static_cast<std::size_t>(w);
  }
  void finish() {
    const std::uint64_t expected = checksum_;
    require(word() == expected, "it is damaged, its checksum is wrong");
  }

 private:
  std::istream* in_;
  std::uint64_t checksum_ = 0;
};

class IdReader {
 public:
  IdReader(Reader& from, std::size_t width) : from_(&from), narrow_(width == 4) {}

  /// An id below `end`, or kNone where that is allowed.
  Index get(std::size_t end, bool or_none = false) {
    const std::uint64_t id = next();
    if (or_none && id == (narrow_ ? kLargestNarrowId : ~std::uint64_t{0})) return kNone;
    require(id < end, "an id is out of range");
    return static_cast<Index>(id);
  }
  /// After the last id of an array.
  void finish() const { require(!half_ || rest_ == 0, "the end of an array is not filled with zeros"); }

 private:
  std::uint64_t next() {
    if (!narrow_) return from_->word();
    half_ = !half_;
    if (!half_) return rest_;
    const std::uint64_t w = from_->word();
    rest_ = w >> 32;
    return w & kLargestNarrowId;
  }

  Reader* from_;
  bool narrow_;
  bool half_ = false;
  std::uint64_t rest_ = 0;
};

// --- Saving ---

/// The numbers of sites without the empty slots; the ghost keeps its own.
class Numbers {
 public:
  explicit Numbers(const Sites& sites) : number_(sites.size(), kNone) {
    Index next = 0;
    for (std::size_t i = 0; i < number_.size(); ++i) {
      if (!sites.is_empty(VertexId{static_cast<Index>(i)})) number_[i] = next++;
    }
  }
  Index operator[](VertexId v) const { return v == kGhost ? kNone : number_[raw(v)]; }

 private:
  std::vector<Index> number_;
};

void save_sites(const AnyTriangulation& t, const Numbers& numbers, Writer& to, std::uint64_t width) {
  const Sites& sites = t.sites();
  const auto for_all = [&](auto&& f) {
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (const VertexId v{static_cast<Index>(i)}; !sites.is_empty(v)) f(v);
    }
  };
  for_all([&](VertexId v) {
    for (int axis = 0; axis < t.dimension(); ++axis) to.number(sites.coordinate(v, axis));
  });
  if (t.weighted()) for_all([&](VertexId v) { to.number(sites.weight(v)); });
  IdWriter ids(to, width);
  for (std::size_t row = 0; row < t.row_count(); ++row) {
    ids.put(sites.is_removed(static_cast<Index>(row)) ? kNone : numbers[sites.vertex(static_cast<Index>(row))]);
  }
}

void save_duplicates(const AnyTriangulation& t, const Numbers& numbers, Writer& to, std::uint64_t width) {
  std::vector<std::array<Index, 2>> pairs;
  for (const auto& [vertex, row] : t.mesh().duplicates) pairs.push_back({numbers[t.vertex(row)], numbers[vertex]});
  std::ranges::sort(pairs);
  IdWriter ids(to, width);
  for (const auto& [site, vertex] : pairs) {
    ids.put(site);
    ids.put(vertex);
  }
}

void save_cells(const Complex& complex, const Numbers& numbers, Writer& to, std::uint64_t width) {
  std::vector<Index> position(complex.slot_count(), kNone);  // without the dead ones
  Index live = 0;
  for (std::size_t s = 0; s < position.size(); ++s) {
    if (complex.is_live(CellId{static_cast<Index>(s)})) position[s] = live++;
  }
  IdWriter ids(to, width);
  for (std::size_t s = 0; s < position.size(); ++s) {
    if (position[s] == kNone) continue;
    const CellId c{static_cast<Index>(s)};
    for (int i = 0; i < complex.corners(); ++i) ids.put(numbers[complex.vertex(c, i)]);
    for (int i = 0; i < complex.corners(); ++i) {
      const FacetId f = complex.twin(c, i);
      ids.put(position[raw(complex.cell(f))] * static_cast<Index>(complex.corners()) +
              static_cast<Index>(complex.slot(f)));
    }
  }
}

// --- Loading: arrays grow as bytes arrive, so that a wrong count costs no memory; every id is checked before use. ---

struct Header {
  std::size_t width, dimension;
  bool weighted;
  Flat flat;
  std::size_t rows, sites, duplicates, cells;
};

Header load_header(Reader& from) {
  const std::uint64_t name = from.word();
  require((name & ~kVersionBits) == (kNameAndVersion & ~kVersionBits), "this is no saved triangulation");
  if (name != kNameAndVersion) refuse("version " + std::to_string(name >> 56) + " is unknown, this program reads 2");
  Header header{};
  header.width = from.count(8, "the width of ids");
  require(header.width == 4 || header.width == 8, "the width of ids is neither 4 nor 8");
  header.dimension = from.count(kMaxDimension, "the dimension");
  require(header.dimension > 0, "the dimension is 0");
  header.weighted = from.count(1, "the mark of weights") == 1;
  const std::uint64_t k = from.word() + 1;
  require(k <= header.dimension + 1, "the affine dimension is out of range");
  header.flat.dimension = static_cast<int>(k) - 1;
  for (int i = 0, last = -1; i < header.flat.dimension; ++i) {
    const int axis = static_cast<int>(from.count(header.dimension - 1, "axis"));
    require(axis > last, "the axes do not ascend");
    header.flat.axes[static_cast<std::size_t>(i)] = last = axis;
  }
  header.rows = from.count(kNone - 1, "the number of rows");
  header.sites = from.count(std::min<std::uint64_t>(header.rows, max_row_count(static_cast<int>(header.dimension))),
                            "the number of points");
  require(k == 0 ? header.sites == 0 : header.sites >= k, "the affine dimension does not fit the number of points");
  header.duplicates = from.count(header.sites, "the number of duplicates");
  header.cells = from.count(k == 0 ? 0 : Complex(static_cast<int>(k) - 1).nameable_slots(), "the number of cells");
  return header;
}

/// The row of each site. Before it the coordinates of as many sites have been read.
std::vector<Index> load_rows(const Header& header, Reader& from) {
  std::vector<Index> row_of(header.sites, kNone);
  IdReader ids(from, header.width);
  for (std::size_t row = 0; row < header.rows; ++row) {
    const Index site = ids.get(header.sites, true);
    if (site == kNone) continue;
    require(row_of[site] == kNone, "a site has two rows");
    row_of[site] = static_cast<Index>(row);
  }
  ids.finish();
  require(std::ranges::find(row_of, kNone) == row_of.end(), "a site has no row");
  return row_of;
}

Sites load_sites(const Header& header, Reader& from) {
  std::vector<double> coordinates, weights;
  for (std::size_t i = 0; i < header.sites * header.dimension; ++i) coordinates.push_back(from.number());
  for (std::size_t i = 0; header.weighted && i < header.sites; ++i) weights.push_back(from.number());
  Sites sites(static_cast<int>(header.dimension), header.weighted, header.flat);
  sites.reserve_more(header.sites);
  const std::vector<Index> row_of = load_rows(header, from);
  sites.grow_rows(header.rows);
  for (std::size_t i = 0; i < header.sites; ++i) {
    sites.append(std::span(coordinates).subspan(i * header.dimension, header.dimension),
                 header.weighted ? weights[i] : 0.0, row_of[i]);
  }
  return sites;
}

void load_duplicates(const Header& header, Reader& from, Mesh& mesh) {
  IdReader ids(from, header.width);
  for (std::size_t i = 0, next = 0; i < header.duplicates; ++i) {
    const VertexId site{ids.get(header.sites)};
    const VertexId vertex{ids.get(header.sites)};
    require(raw(site) >= next, "the duplicates do not ascend");
    next = raw(site) + std::size_t{1};
    require(
        site != vertex && mesh.sites.same_place(site, vertex) && mesh.sites.weight(site) == mesh.sites.weight(vertex),
        "a duplicate differs from its vertex");
    require(mesh.sites.row(vertex) < mesh.sites.row(site), "a duplicate has a lower row than its vertex");
    mesh.duplicates.add(site, vertex, mesh.sites.row(site));
  }
  ids.finish();
}

template <int K>
void load_cells(const Header& header, Reader& from, Mesh& mesh) {
  constexpr std::size_t kChunk = 4096;
  constexpr Index kCorners = K + 1;
  ComplexView<K> complex(mesh.complex);
  mesh.complex.reserve_more(0, header.sites);
  mesh.complex.grow_vertices(header.sites);
  IdReader ids(from, header.width);
  for (std::size_t i = 0; i < header.cells; ++i) {
    if (i % kChunk == 0) mesh.complex.reserve_more(std::min(kChunk, header.cells - i), header.sites);
    const CellId c = complex.create();
    std::size_t ghosts = 0;
    for (int j = 0; j <= K; ++j) {
      complex.set_vertex(c, j, VertexId{ids.get(header.sites, true)});
      ghosts += complex.vertex(c, j) == kGhost ? 1 : 0;
    }
    require(ghosts == (complex.is_ghost(c) ? 1U : 0U), "the ghost stands in a wrong place (I4)");
    for (int j = 0; j <= K; ++j) {
      const Index place = ids.get(header.cells * kCorners);
      complex.set_twin(c, j, complex.facet(CellId{place / kCorners}, static_cast<int>(place % kCorners)));
    }
    complex.settle(c);
    complex.count_ghost(c);
  }
  ids.finish();
}

/// Whether c and the cell across its facet `i` have the facet's vertices in common and are oriented alike: with the
/// apex of one in the other's place, both name the same vertices in orders of opposite parity (I2, I3).
template <int K>
bool matches_across(const ComplexView<K>& complex, CellId c, int i) {
  const FacetId across = complex.twin(c, i);
  const auto mine = complex.vertices(c);
  auto theirs = complex.vertices(complex.cell(across));
  theirs[static_cast<std::size_t>(complex.slot(across))] = mine[static_cast<std::size_t>(i)];
  bool odd = false;
  for (std::size_t j = 0; j <= K; ++j) {
    const auto found = std::find(theirs.begin() + static_cast<std::ptrdiff_t>(j), theirs.end(), mine[j]);
    if (found == theirs.end()) return false;
    if (found != theirs.begin() + static_cast<std::ptrdiff_t>(j)) {
      std::swap(*found, theirs[j]);
      odd = !odd;
    }
  }
  return odd || K == 0;  // two cells without facets have nothing to turn over
}

/// I1, I2, I3, the ghost cells of I4, and some hull.
template <int K>
void require_matching_facets(const ComplexView<K>& complex) {
  std::size_t ghosts = 0;
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    for (int i = 0; i <= K; ++i) {
      const FacetId across = complex.twin(c, i);
      require(complex.twin(across) == complex.facet(c, i) && complex.cell(across) != c, "twins do not match (I1)");
      require(matches_across(complex, c, i), "neighbours do not share their facet (I2, I3)");
    }
    if (const int ghost = complex.ghost_slot(c); ghost >= 0) {
      require(!complex.is_ghost(complex.cell(complex.twin(c, ghost))), "a hull facet has no cell behind it");
      ++ghosts;
    }
  }
  require(ghosts > 0, "there is no hull");
  require(K > 0 || complex.slot_count() == 2, "a single point has two cells");
}

/// A point inside of a cell c, close to its vertices in turn: v0 + e (v1 - v0) + e^2 (v2 - v0) + ... for a tiny e > 0.
/// It lies on no hyperplane of the vertices, and on which side of one is a matter of orientations alone.
template <int K>
class InnerPoint {
 public:
  explicit InnerPoint(const typename Kernel<K>::Cell& cell) : corners_(cell) {}

  /// Orientation of a simplex with this point in slot i. It is linear in the point: the first corner off the
  /// hyperplane of the others decides.
  int orient(Kernel<K>& kernel, typename Kernel<K>::Cell simplex, int i) const {
    for (const VertexId corner : corners_) {
      simplex[static_cast<std::size_t>(i)] = corner;
      if (const int sign = kernel.orient(simplex); sign != 0) return sign;
    }
    return 0;
  }
  bool is_in(Kernel<K>& kernel, const typename Kernel<K>::Cell& simplex) const {
    for (int i = 0; i <= K; ++i) {
      if (orient(kernel, simplex, i) <= 0) return false;
    }
    return true;
  }

 private:
  typename Kernel<K>::Cell corners_;
};

/// That the cells are the regular triangulation of their vertices, so that every later search ends where it should:
/// finite cells are positive; a point o in one of them is in no other, and strictly inside of every facet of the hull;
/// no cell conflicts with the vertex across a facet. So the hull is star-shaped about o, then convex, and covered once;
/// heights are convex across each facet, then everywhere. (The argument in full: src/check/complex_check_impl.hpp.)
template <int K>
void require_regular(const ComplexView<K>& complex, const Sites& sites) {
  Kernel<K> kernel(sites);
  const CellId outer = complex.incident_cell(kGhost);
  const InnerPoint<K> o(complex.vertices(complex.cell(complex.twin(outer, complex.ghost_slot(outer)))));
  std::size_t cells_over_o = 0;
  for (std::size_t s = 0; s < complex.slot_count(); ++s) {
    const CellId c{static_cast<Index>(s)};
    const auto v = complex.vertices(c);
    const int ghost = complex.ghost_slot(c);
    if (ghost >= 0) {
      require(o.orient(kernel, v, ghost) < 0, "a hull facet looks the wrong way (I4)");
    } else {
      require(kernel.orient(v) > 0, "a cell is not positive (I4)");
      cells_over_o += o.is_in(kernel, v) ? 1 : 0;
    }
    for (int i = 0; i <= K; ++i) {
      const FacetId across = complex.twin(c, i);
      const CellId d = complex.cell(across);
      if (raw(d) < raw(c) || complex.is_ghost(d) != (ghost >= 0)) continue;
      const VertexId q = complex.vertex(across);
      const auto below = [&](CellId f) { return kernel.conflict(complex.vertices(f), q); };
      require(!in_conflict(complex, kernel, c, q, below), "the cells are not those of its points");
    }
  }
  require(cells_over_o == 1, "cells overlap");
}

void require_settled_rows(const Mesh& mesh) {
  const Complex& complex = mesh.complex;
  for (const auto& [vertex, row] : mesh.duplicates) {
    require(complex.incident_cell(mesh.sites.vertex(row)) == kNoCell, "a duplicate is a vertex too");
    require(mesh.duplicates.vertex_of(vertex) == kGhost, "a duplicate repeats a duplicate");
  }
  require(mesh.sites.weighted() || mesh.vertex_count + mesh.duplicates.size() == mesh.sites.size(),
          "a point is neither a vertex nor a duplicate");
}

}  // namespace

void save(const AnyTriangulation& t, std::ostream& out) {
  const Complex& complex = t.complex();
  const auto corners = static_cast<std::size_t>(complex.corners());
  const std::uint64_t width =
      std::max<std::uint64_t>(t.row_count(), complex.live_count() * corners) < kLargestNarrowId ? 4 : 8;
  Writer to(out);
  to.word(kNameAndVersion);
  to.word(width);
  to.word(static_cast<std::uint64_t>(t.dimension()));
  to.word(t.weighted() ? 1 : 0);
  to.word(static_cast<std::uint64_t>(static_cast<std::int64_t>(t.affine_dimension())));
  for (int i = 0; i < t.affine_dimension(); ++i) {
    to.word(static_cast<std::uint64_t>(t.sites().flat().axes[static_cast<std::size_t>(i)]));
  }
  to.word(t.row_count());
  to.word(t.sites().present_count());
  to.word(t.mesh().duplicates.size());
  to.word(complex.live_count());
  const Numbers numbers(t.sites());
  save_sites(t, numbers, to, width);
  save_duplicates(t, numbers, to, width);
  save_cells(complex, numbers, to, width);
  to.finish();
}

AnyTriangulation load(std::istream& in) {
  const ExactEnvironment environment;
  Reader from(in);
  const Header header = load_header(from);
  Mesh mesh(load_sites(header, from));
  load_duplicates(header, from, mesh);
  if (header.flat.dimension >= 0) {
    with_dimension(header.flat.dimension, [&](auto k) { load_cells<k>(header, from, mesh); });
  }
  from.finish();
  if (header.flat.dimension >= 0) {
    with_dimension(header.flat.dimension, [&](auto k) {
      const ComplexView<k> complex(mesh.complex);
      require_matching_facets(complex);
      if constexpr (k > 0) require_regular(complex, mesh.sites);
    });
  }
  for (std::size_t i = 0; i < header.sites; ++i) {
    if (mesh.complex.incident_cell(VertexId{static_cast<Index>(i)}) != kNoCell) ++mesh.vertex_count;
  }
  require_settled_rows(mesh);
  mesh.complex.shrink();
  mesh.sites.shrink();
  return AnyTriangulation(std::move(mesh));
}

}  // namespace delone
