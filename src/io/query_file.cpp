#include "delone/io/query_file.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>

#include "io/npy.hpp"
#include "io/output.hpp"

namespace delone::io {
namespace {

const char* word(Place place) {
  switch (place) {
    case Place::vertex:
      return "vertex";
    case Place::face:
      return "face";
    case Place::cell:
      return "cell";
    case Place::outside:
      break;
  }
  return "outside";
}

}  // namespace

std::optional<QueryFormat> query_format(const std::string& name) {
  if (name == "csv") return QueryFormat::csv;
  if (name == "npy") return QueryFormat::npy;
  return std::nullopt;
}

std::optional<QueryFormat> query_format_of_path(const std::string& path) {
  std::filesystem::path name = path;
  if (name.extension() == ".gz") name = name.stem();
  const std::string extension = name.extension().string();
  return extension.empty() ? std::nullopt : query_format(extension.substr(1));
}

void write_neighbours(const std::string& path, QueryFormat format, const NeighbourLists& lists, bool weighted) {
  Output output(path);
  if (format == QueryFormat::npy) {
    output << npy_header("<f8", lists.rows.size(), 3);
  } else {
    output << (weighted ? "query,row,power\n" : "query,row,distance\n");
  }
  for (std::size_t query = 0; query < lists.size(); ++query) {
    for (std::size_t i = lists.offsets[query]; i < lists.offsets[query + 1]; ++i) {
      const double distance = weighted ? lists.squared_distances[i] : std::sqrt(lists.squared_distances[i]);
      if (format == QueryFormat::npy) {
        output.put(static_cast<double>(query));
        output.put(static_cast<double>(lists.rows[i]));
        output.put(distance);
      } else {
        output << query << ',' << lists.rows[i] << ',' << distance << '\n';
      }
    }
  }
  output.commit();
}

void write_locations(const std::string& path, QueryFormat format, const std::vector<Location>& locations,
                     std::size_t corners) {
  Output output(path);
  if (format == QueryFormat::npy) {
    output << npy_header("<i8", locations.size(), corners);
    for (const Location& location : locations) {
      for (std::size_t i = 0; i < corners; ++i) {
        output.put(i < location.row_count ? static_cast<std::int64_t>(location.corners[i]) : std::int64_t{-1});
      }
    }
    return output.commit();
  }
  output << "query,place,rows\n";
  for (std::size_t query = 0; query < locations.size(); ++query) {
    output << query << ',' << word(locations[query].place) << ',';
    const char* blank = "";
    for (const Index row : locations[query].rows()) {
      output << blank << row;
      blank = " ";
    }
    output << '\n';
  }
  output.commit();
}

}  // namespace delone::io
