// Write the answers to queries, in the order of the queries: as text, or as an array for NumPy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delone/query/locate.hpp"
#include "delone/query/nearest.hpp"

namespace delone::io {

enum class QueryFormat { csv, npy };

std::optional<QueryFormat> query_format(const std::string& name);          ///< "csv", "npy"
std::optional<QueryFormat> query_format_of_path(const std::string& path);  ///< by extension, also before ".gz"

/// Rows of query, row and distance, or with weights its power: text with a header, or an n x 3 array of doubles.
/// "-" is standard output.  @throws std::runtime_error when writing fails
void write_neighbours(const std::string& path, QueryFormat format, const NeighbourLists& lists, bool weighted);

/// Rows of query, place (vertex, face, cell, outside) and the face's rows, separated by blanks; or an array of
/// integers, a row per query, the face's rows ascending and then -1 up to `corners` columns.
/// @throws std::runtime_error when writing fails
void write_locations(const std::string& path, QueryFormat format, const std::vector<Location>& locations,
                     std::size_t corners);

}  // namespace delone::io
