// What a run of `delone triangulate` tells: for people and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delone/check/delaunay.hpp"
#include "delone/mesh/triangulation.hpp"

namespace delone::cli {

struct Written {
  std::string path;
  std::vector<std::string> files;
  double seconds = 0;
};

struct Summary {
  std::string input;
  std::size_t rows = 0;
  int dimension = 0, affine_dimension = -1;
  std::vector<std::string> coordinate_names;
  bool weighted = false;
  std::size_t vertices = 0, duplicates = 0, hidden = 0, cells = 0, hull_facets = 0;
  std::optional<std::size_t> merged_cells;
  std::optional<std::string> canonical_hash;
  std::optional<CheckReport> check;
  std::size_t memory_bytes = 0;
  int threads = 1;
  std::string method;
  BuildStatistics statistics{};
  double read_seconds = 0, export_seconds = 0, hash_seconds = 0, check_seconds = 0, total_seconds = 0;
  std::vector<Written> written;
};

/// Aligned lines for people.
std::string to_words(const Summary& summary);

/// One JSON object, one key a line.
std::string to_json_text(const Summary& summary);

}  // namespace delone::cli
