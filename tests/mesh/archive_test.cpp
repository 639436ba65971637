#include "delone/mesh/archive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "delone/base/random.hpp"
#include "delone/build/insert.hpp"
#include "delone/mesh/export.hpp"
#include "delone/remove/remove.hpp"
#include "support/expectations.hpp"
#include "support/families.hpp"

namespace delone {
namespace {

using namespace test;
using ::testing::HasSubstr;

std::string saved(const AnyTriangulation& t) {
  std::ostringstream out;
  save(t, out);
  return out.str();
}

AnyTriangulation loaded(const std::string& bytes) {
  std::istringstream in(bytes);
  return load(in);
}

std::string complaint(const std::string& bytes) {
  try {
    loaded(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing to complain about";
}

/// The words of an archive, for tests that change some; `sealed` puts a checksum that fits under them.
std::vector<std::uint64_t> words(const std::string& bytes) {
  std::vector<std::uint64_t> result(bytes.size() / 8);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    result[i / 8] |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << i % 8 * 8;
  }
  return result;
}

std::string sealed(std::vector<std::uint64_t> words) {
  std::uint64_t checksum = 0;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) checksum = mix(checksum ^ words[i]);
  words.back() = checksum;
  std::string bytes;
  for (const std::uint64_t word : words) {
    for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<char>(word >> i * 8 & 0xFF));
  }
  return bytes;
}

TEST(Archive, what_is_loaded_is_what_was_saved) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : families(dimension, dimension < 3 ? 12 : 8, 1)) {
      const AnyTriangulation t = built(points);
      const AnyTriangulation again = loaded(saved(t));
      ASSERT_EQ(description(again), description(t)) << points;
      ASSERT_EQ(broken_invariant(again), "") << points;
      ASSERT_EQ(again.weighted(), t.weighted());
    }
  }
}

TEST(Archive, a_triangulation_without_points_is_saved_too) {
  for (const bool weighted : {false, true}) {
    const AnyTriangulation again = loaded(saved(AnyTriangulation(3, weighted)));
    EXPECT_EQ(again.dimension(), 3);
    EXPECT_EQ(again.affine_dimension(), -1);
    EXPECT_EQ(again.weighted(), weighted);
  }
}

TEST(Archive, insertion_goes_on_after_loading) {
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : {lattice(dimension, 40, 3, 1), uniform(dimension, 40, 2), flat(dimension, 1, 20, 3),
                                   with_random_weights(lattice(dimension, 40, 3, 4), 5)}) {
      const std::size_t n = points.size();
      AnyTriangulation t = built(rows(points, 0, n / 2));
      for (std::size_t row = n / 2; row < n - 6; ++row) insert(t, points.view()[row], points.view().weight(row));
      t = loaded(saved(t));
      for (std::size_t row = n - 6; row < n; ++row) insert(t, points.view()[row], points.view().weight(row));
      ASSERT_EQ(description(t), description(built(points))) << points;
    }
  }
}

TEST(Archive, slots_of_dead_cells_are_not_saved) {
  AnyTriangulation t = built(uniform(3, 200, 1));
  const PointSet more = uniform(3, 50, 2);
  for (std::size_t row = 0; row < more.size(); ++row) insert(t, more.view()[row]);
  const AnyTriangulation again = loaded(saved(t));
  EXPECT_EQ(again.complex().slot_count(), t.complex().live_count());
  EXPECT_EQ(description(again), description(t));
}

TEST(Archive, loading_stops_behind_the_last_byte) {
  const AnyTriangulation first = built(uniform(2, 10, 1));
  const AnyTriangulation second = built(uniform(3, 11, 2));
  std::istringstream in(saved(first) + saved(second));
  EXPECT_EQ(description(load(in)), description(first));
  EXPECT_EQ(description(load(in)), description(second));
}

TEST(Archive, the_format_is_as_documented) {
  const PointSet points{"segment and a duplicate", 2, {0, 0, 3, 4, 0, 0}, {}};
  const std::string bytes = saved(built(points));
  EXPECT_EQ(bytes.substr(0, 8), std::string("DELONE\0\2", 8));
  const auto w = words(bytes);
  const std::vector<std::uint64_t> header(w.begin() + 1, w.begin() + 10);
  EXPECT_THAT(header, ::testing::ElementsAre(4, 2, 0, 1, 0, 3, 3, 1, 3));  // width, D, weighted, k, axis, r, n, d, m
  // 10 words, 6 coordinates, 3 rows in 2 words, 2 duplicates in 1, 12 ids in 6, the checksum
  EXPECT_EQ(w.size(), 10U + 6 + 2 + 1 + 6 + 1);
}

TEST(Archive, removed_rows_stay_removed) {
  for (const PointSet& points : families(2, 24, 3)) {
    SCOPED_TRACE(points.name);
    AnyTriangulation t = built(points);
    for (const Index row : {0U, 5U, 9U, static_cast<unsigned>(points.size()) - 1}) remove(t, row);
    insert(t, points.view()[5], points.view().weight(5));
    const AnyTriangulation back = loaded(saved(t));
    EXPECT_EQ(back.removed_count(), t.removed_count());
    for (std::size_t row = 0; row < t.row_count(); ++row)
      EXPECT_EQ(back.status(static_cast<Index>(row)), t.status(static_cast<Index>(row)));
    EXPECT_EQ(cells(back).vertices, cells(t).vertices);
    EXPECT_EQ(canonical_hash(back), canonical_hash(t));
    EXPECT_EQ(saved(loaded(saved(back))), saved(back));
  }
}

TEST(Archive, ids_of_eight_bytes_are_read_too) {
  const AnyTriangulation t = built(lattice(2, 9, 3, 1));
  const auto narrow = words(saved(t));
  const std::size_t n = t.row_count();
  const std::size_t numbers = 11 + 2 * n;  // header and coordinates
  std::vector<std::uint64_t> wide(narrow.begin(), narrow.begin() + static_cast<std::ptrdiff_t>(numbers));
  wide[1] = 8;
  std::size_t place = numbers;
  for (const std::size_t ids : {n, 2 * t.mesh().duplicates.size(), 6 * t.complex().live_count()}) {
    for (std::size_t i = 0; i < ids; ++i) {
      const std::uint64_t id = narrow[place + i / 2] >> i % 2 * 32 & 0xFFFFFFFF;
      wide.push_back(id == 0xFFFFFFFF ? ~std::uint64_t{0} : id);
    }
    place += (ids + 1) / 2;
  }
  wide.push_back(0);
  EXPECT_EQ(description(loaded(sealed(wide))), description(t));
}

TEST(Archive, every_way_to_cut_it_off_is_refused) {
  const std::string bytes = saved(built(lattice(2, 9, 3, 1)));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    ASSERT_EQ(complaint(bytes.substr(0, length)), "saved triangulation: it is cut off") << length;
  }
}

TEST(Archive, every_flipped_bit_is_noticed) {
  for (const bool weighted : {false, true}) {
    PointSet points = lattice(2, 9, 3, 1);
    if (weighted) points.weights.assign(points.size(), 1.0);
    const std::string bytes = saved(built(points));
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      std::string damaged = bytes;
      damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
      ASSERT_THROW(loaded(damaged), InputError) << bit;
    }
  }
}

TEST(Archive, other_files_and_versions_are_told_apart) {
  EXPECT_EQ(complaint("x,y\n1,2\n3,4\n"), "saved triangulation: this is no saved triangulation");
  std::string later = saved(built(uniform(2, 5, 1)));
  later[7] = 3;
  EXPECT_EQ(complaint(later), "saved triangulation: version 3 is unknown, this program reads 2");
}

TEST(Archive, wrong_numbers_under_a_right_checksum_are_refused) {
  const auto original = words(saved(built(uniform(2, 5, 1))));
  const auto with = [&](std::size_t place, std::uint64_t word) {
    auto changed = original;
    changed[place] = word;
    return complaint(sealed(changed));
  };
  EXPECT_EQ(with(1, 5), "saved triangulation: the width of ids is neither 4 nor 8");
  EXPECT_EQ(with(2, 0), "saved triangulation: the dimension is 0");
  EXPECT_EQ(with(2, 9), "saved triangulation: the dimension 9 is out of range");
  EXPECT_EQ(with(3, 2), "saved triangulation: the mark of weights 2 is out of range");
  EXPECT_EQ(with(4, 3), "saved triangulation: the affine dimension is out of range");
  EXPECT_EQ(with(6, 0), "saved triangulation: the axes do not ascend");
  EXPECT_EQ(with(8, 2), "saved triangulation: the affine dimension does not fit the number of points");
  EXPECT_EQ(with(7, ~std::uint64_t{0} >> 1),
            "saved triangulation: the number of rows 9223372036854775807 is out of range");
  EXPECT_EQ(with(8, 6), "saved triangulation: the number of points 6 is out of range");
  EXPECT_EQ(with(9, 6), "saved triangulation: the number of duplicates 6 is out of range");
  EXPECT_EQ(with(10, 1000000), "saved triangulation: an id is out of range");
  EXPECT_EQ(with(11, std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity())),
            "saved triangulation: a coordinate or weight is not finite");
  EXPECT_EQ(with(21, 0), "saved triangulation: a site has two rows");
}

TEST(Archive, a_huge_count_costs_no_memory) {
  auto changed = words(saved(built(uniform(2, 5, 1))));
  changed[7] = changed[8] = 500'000'000;
  EXPECT_EQ(complaint(sealed(changed)), "saved triangulation: it is cut off");
  changed[7] = changed[8] = 5;
  changed[10] = 1'000'000'000;
  EXPECT_EQ(complaint(sealed(changed)), "saved triangulation: an id is out of range");
  if constexpr (sizeof(Index) == 4) {  // more than four ids of facets each leave room for
    changed[10] = 1'200'000'000;
    EXPECT_EQ(complaint(sealed(changed)), "saved triangulation: the number of cells 1200000000 is out of range");
  }
}

/// A mesh of triangles whose edges match, and of ghosts on the other edges; nothing else need be right.
AnyTriangulation forged(const PointSet& points, std::vector<std::array<Index, 3>> triangles) {
  Mesh mesh(Sites(2, false, Flat{2, {0, 1}}));
  mesh.sites.reserve_more(points.size());
  for (std::size_t row = 0; row < points.size(); ++row)
    mesh.sites.append(points.view()[row], 0.0, static_cast<Index>(row));
  mesh.complex.reserve_more(100, points.size());
  mesh.complex.grow_vertices(points.size());
  ComplexView<2> complex(mesh.complex);
  using Edge = std::pair<Index, Index>;
  std::map<Edge, FacetId> facets;
  const auto edge = [](const std::array<Index, 3>& t, std::size_t i) { return Edge{t[(i + 1) % 3], t[(i + 2) % 3]}; };
  const auto make = [&](const std::array<Index, 3>& t) {
    const CellId c = complex.create();
    for (std::size_t i = 0; i < 3; ++i) {
      complex.set_vertex(c, static_cast<int>(i), VertexId{t[i]});
      facets[edge(t, i)] = complex.facet(c, static_cast<int>(i));
    }
    complex.settle(c);
    complex.count_ghost(c);
  };
  for (const auto& t : triangles) make(t);
  const std::map<Edge, FacetId> inner = facets;
  for (const auto& [e, f] : inner) {
    if (!inner.contains({e.second, e.first})) make({e.second, e.first, kNone});
  }
  for (const auto& [e, f] : facets) complex.link(f, facets.at({e.second, e.first}));
  mesh.vertex_count = points.size();
  return AnyTriangulation(std::move(mesh));
}

TEST(Archive, positive_cells_that_match_but_are_not_delaunay_are_refused) {
  const PointSet kite{"kite", 2, {0, 0, 2, -1, 2, 1, 5, 0}, {}};
  EXPECT_EQ(complaint(saved(forged(kite, {{0, 1, 2}, {1, 3, 2}}))), "nothing to complain about");
  EXPECT_EQ(complaint(saved(forged(kite, {{0, 1, 3}, {0, 3, 2}}))),
            "saved triangulation: the cells are not those of its points");
  const PointSet square{"square", 2, {0, 0, 1, 0, 0, 1, 1, 1}, {}};
  EXPECT_EQ(complaint(saved(forged(square, {{0, 1, 3}, {0, 3, 2}}))), "nothing to complain about");
  EXPECT_EQ(complaint(saved(forged(square, {{0, 1, 2}, {1, 3, 2}}))),  // right but for the rule for ties
            "saved triangulation: the cells are not those of its points");
}

TEST(Archive, cells_that_wind_around_twice_or_lie_apart_are_refused) {
  // Around the centre goes a pentagram: each two neighbours are locally Delaunay, and each corner of the hull is
  // convex.
  const PointSet pentagon{"pentagon", 2, {0, 0, 10, 0, 3, 9, -8, 6, -8, -6, 3, -9}, {}};
  EXPECT_EQ(complaint(saved(forged(pentagon, {{0, 1, 3}, {0, 3, 5}, {0, 5, 2}, {0, 2, 4}, {0, 4, 1}}))),
            "saved triangulation: cells overlap");
  const PointSet apart{"apart", 2, {0, 0, 1, 0, 0, 1, 10, 10, 11, 10, 10, 11}, {}};
  EXPECT_EQ(complaint(saved(forged(apart, {{0, 1, 2}, {3, 4, 5}}))),
            "saved triangulation: a hull facet looks the wrong way (I4)");
  const PointSet corner{"reflex", 2, {0, 0, 4, 1, 1, 1, 1, 4}, {}};
  EXPECT_EQ(complaint(saved(forged(corner, {{0, 1, 2}, {0, 2, 3}}))),
            "saved triangulation: the cells are not those of its points");
  const PointSet turned{"clockwise", 2, {0, 0, 1, 0, 0, 1}, {}};
  EXPECT_EQ(complaint(saved(forged(turned, {{0, 2, 1}}))), "saved triangulation: a cell is not positive (I4)");
}

/// Whatever is changed, under a right checksum: refused, or safe to use.
TEST(Archive, random_damage_is_refused_or_harmless) {
  std::size_t refused = 0;
  Random random(5);
  for (int dimension = 1; dimension <= 4; ++dimension) {
    for (const PointSet& points : {lattice(dimension, 9, 3, 1), uniform(dimension, 9, 1), flat(dimension, 1, 6, 1)}) {
      PointSet weighted = points;
      for (std::size_t i = 0; i < points.size(); ++i) weighted.weights.push_back(static_cast<double>(i % 3));
      const auto original = words(saved(built(random() % 2 == 0 ? points : weighted)));
      for (int trial = 0; trial < 1500; ++trial) {
        auto changed = original;
        const std::size_t place = 1 + random() % (changed.size() - 2);
        switch (random() % 4) {
          case 0:
            changed[place] ^= std::uint64_t{1} << random() % 64;
            break;
          case 1:
            changed[place] = changed[1 + random() % (changed.size() - 2)];
            break;
          case 2:  // two ids trade places
            changed[place] = changed[place] << 32 | changed[place] >> 32;
            break;
          default:
            changed[place] ^= random() % 8 << (random() % 2 * 32);
        }
        try {
          AnyTriangulation t = loaded(sealed(changed));
          EXPECT_EQ(broken_invariant(t), "");
          description(t);
          const PointSet more = uniform(t.dimension(), 3, 9);
          for (std::size_t row = 0; row < more.size(); ++row) insert(t, more.view()[row]);
        } catch (const InputError&) {
          ++refused;
        }
      }
    }
  }
  EXPECT_GT(refused, 5000U);
}

TEST(Archive, a_stream_that_fails_is_reported) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(save(built(uniform(2, 5, 1)), out), std::runtime_error);
}

}  // namespace
}  // namespace delone
