// Points to try things with: random families, degenerate ones, and the worst cases of the papers.
// Sources: [Dev97] section 5.5.1 (uniform, ellipse, ellipse2, circle, parabola, and rounding to 24 bits);
//          [GKS92] section 2, figure 1 (gks-figure1) and section 4.3 (gks-zeta).
// The same arguments give the same doubles on every machine: the random numbers are our own, and nothing but + - * /
// and the square root, which IEEE 754 rounds correctly, touches a coordinate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace delone::io {

struct Generated {
  int dimension = 0;
  std::vector<double> coordinates;  ///< n x dimension
};

/// What a kind is, in which dimensions it exists, and the one it has when nobody asks for another.
struct KindInfo {
  std::string name;
  std::string text;
  int least_dimension = 1, most_dimension = 8, usual_dimension = 2;
};

/// The names of all kinds.
std::vector<std::string> kinds();

/// @throws InputError naming those that exist
KindInfo kind_info(const std::string& kind);

/// n points of a kind.
/// @param dimension  0 for the usual one of the kind
/// @param bits       0, or 1 to 52: move and scale all axes alike, and round to integers 0 .. 2^bits - 1. The scale is
/// a
///                   whole number where it is at least one, so that a lattice stays a lattice.
/// @throws InputError for an unknown kind or a dimension in which the kind does not exist
Generated generate(const std::string& kind, std::size_t n, int dimension = 0, std::uint64_t seed = 1, int bits = 0);

/// Can points be written to this path? "-" (standard output), .csv and .txt, also with .gz, and .npy.
bool is_points_path(const std::string& path);

/// Writes points as text with a header (x,y,z or x1,x2,...) and the shortest decimals that read back the same, or as
/// NPY.
/// @throws InputError when the extension says neither; std::runtime_error when writing fails
void write_points(const std::string& path, const Generated& points);

}  // namespace delone::io
