// Read points from files of many formats, exactly, or say in one line what is wrong and where.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "delone/geometry/points.hpp"

namespace delone::io {

enum class PointFormat { automatic, text, npy, node, xyz, ply, obj, off };

/// A column of the file that is neither coordinate nor weight, carried along for the writers.
struct Attribute {
  std::string name;
  std::vector<double> numbers;     ///< one per row, when every entry is a number
  std::vector<std::string> texts;  ///< one per row otherwise; exactly one of the two is filled
};

/// Points as read: n rows of `dimension` coordinates, optional weights, the other columns on request.
struct PointTable {
  int dimension = 0;
  std::vector<std::string> coordinate_names;  ///< one per axis; "1", "2", ... where the file has no header
  std::vector<double> coordinates;
  std::vector<double> weights;
  std::vector<Attribute> attributes;
  bool one_based = false;  ///< the file counts its rows from 1 (.node)

  std::size_t size() const { return dimension == 0 ? 0 : coordinates.size() / static_cast<std::size_t>(dimension); }
  PointsView view() const { return PointsView(coordinates, dimension, weights); }
};

struct ReadOptions {
  PointFormat format =
      PointFormat::automatic;             ///< by extension; a further ".gz" or gzip magic bytes are looked through
  std::vector<std::string> columns = {};  ///< names or 1-based numbers or "last"; empty: all numeric but the weight
  std::string weights = {};               ///< column of weights, or empty
  std::string radii = {};                 ///< column of radii: the weight is the double nearest to radius^2
  int dimension = 0;                      ///< demanded number of coordinates, 0 for any
  bool attributes = false;                ///< keep the remaining columns
};

/// Reads the points of `path`; "-" is standard input, text unless the options say otherwise.
///
/// Text is delimited by tabs, semicolons, commas or blanks, as its first row shows; '#' begins a comment line. A first
/// row without any number is a header. Columns whose first entry is a number are numeric and must be so throughout. In
/// .node, .xyz and .obj files columns are counted as they stand in the file: index, element and keyword are the first.
/// An empty file has no points, of the demanded dimension or 2; after a header alone every column but the weight is a
/// coordinate, as long as there are at most 8.
/// @throws InputError with one line naming file, row and column, and what was expected
PointTable read_points(const std::string& path, const ReadOptions& options = {});

/// The name of a format as the command line spells it, and back; empty when there is none.
std::optional<PointFormat> point_format(const std::string& name);

}  // namespace delone::io
