#include "outputs.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>

#include "command.hpp"
#include "delone/base/errors.hpp"
#include "interrupt.hpp"

namespace delone::cli {
namespace fs = std::filesystem;

namespace {

fs::path follow_links(const fs::path& path) {
  std::error_code ignored;
  return fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
}

bool is_special(const fs::path& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

constexpr const char* kFormats = "vtu, ply, obj, off, node (with .ele and .neigh), npy, csv, cells, geojson, svg, png";

io::MeshFormat format_of(const std::string& path, const std::string& format) {
  if (!format.empty()) {
    if (const auto known = io::mesh_format(format)) return *known;
    throw UsageError("--format " + format + ": there is no such format; there are " + kFormats);
  }
  if (path == "-") return io::MeshFormat::cells;
  if (const auto known = io::mesh_format_of_path(path)) return *known;
  throw UsageError(path + ": the extension names no format (or say --format); there are " + kFormats);
}

/// The files that writing `output` makes.
std::vector<std::string> files_of(const Output& output) {
  if (output.path == "-") return {"-"};
  const auto with = [&](const char* ending) {
    fs::path path = output.path;
    return path.replace_extension(ending).string();
  };
  if (output.format == io::MeshFormat::node_ele) return {with(".node"), with(".ele"), with(".neigh")};
  if (output.format == io::MeshFormat::npy) return {with("_points.npy"), with("_cells.npy")};
  return {output.path};
}

/// One spelling for every way to name a file.
std::string identity(const std::string& path) {
  if (path == "-") return path;
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path, ignored), ignored).string();
}

bool makes_several_files(io::MeshFormat format) {
  return format == io::MeshFormat::node_ele || format == io::MeshFormat::npy;
}

int most_dimension(io::MeshFormat format) {
  using enum io::MeshFormat;
  switch (format) {
    case geojson:
    case svg:
    case png:
      return 2;
    case vtu:
    case ply:
    case obj:
    case off:
      return 3;
    case node_ele:
    case npy:
    case csv:
    case cells:
      break;
  }
  return kMaxDimension;
}

}  // namespace

void require_writable(const std::string& path) {
  if (path == "-") return;
  if (path.empty()) throw UsageError("-o: the name of the file is empty");
  const fs::path place = follow_links(path);
  const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
  std::error_code ignored;
  if (fs::is_directory(place, ignored)) throw UsageError(path + ": cannot write: it is a folder");
  if (fs::exists(place, ignored) && access(place.c_str(), W_OK) != 0)
    throw UsageError(path + ": cannot write: " + std::strerror(errno));
  if (is_special(place)) return;
  if (!fs::is_directory(folder, ignored))
    throw UsageError(path + ": cannot write: there is no folder " + folder.string());
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw UsageError(path + ": cannot write into folder " + folder.string() + ": " + std::strerror(errno));
}

void require_apart(const std::vector<Target>& targets, const std::vector<std::string>& inputs) {
  std::map<std::string, std::string> taken;  // identity of a file: the -o that makes it
  for (const auto& [path, files] : targets) {
    for (const std::string& file : files) {
      require_writable(file);
      const auto [earlier, is_new] = taken.emplace(identity(file), path);
      if (!is_new)
        throw UsageError("-o " + earlier->second + " and -o " + path + " would both write " +
                         (file == "-" ? "standard output" : file));
      for (const std::string& input : inputs) {
        if (file != "-" && input != "-" && identity(file) == identity(input))
          throw UsageError("-o " + path + " would replace the input " + input);
      }
    }
  }
}

std::vector<Output> plan_outputs(const std::vector<std::string>& paths, const std::string& format,
                                 const std::string& input) {
  std::vector<Output> outputs;
  std::vector<Target> targets;
  for (const std::string& path : paths) {
    const Output& output = outputs.emplace_back(Output{path, format_of(path, format)});
    if (path == "-" && makes_several_files(output.format))
      throw UsageError("-o - --format " + format + ": this format is written in several files, not to standard output");
    targets.push_back({path, files_of(output)});
  }
  require_apart(targets, {input});
  // Standard output last: whoever reads it sees the files complete when it ends.
  std::ranges::stable_partition(outputs, [](const Output& output) { return output.path != "-"; });
  return outputs;
}

void require_dimension(const std::vector<Output>& outputs, int dimension) {
  for (const Output& output : outputs) {
    const int most = most_dimension(output.format);
    if (dimension > most)
      throw UsageError("-o " + output.path + ": this format holds points of dimension " + std::to_string(most) +
                       (most == 2 ? "" : " at most") + ", not " + std::to_string(dimension) +
                       "; choose coordinates with --columns, or another format");
  }
}

void require_merged(const std::vector<Output>& outputs, int dimension) {
  using enum io::MeshFormat;
  for (const Output& output : outputs) {
    if (output.format == cells || output.format == csv) continue;
    const char* const fault = makes_several_files(output.format) ? "this format holds no merged cells"
                              : dimension > 2                    ? "this format holds merged cells only in the plane"
                                                                 : nullptr;
    if (fault != nullptr)
      throw UsageError("-o " + output.path + ": " + fault + "; write .cells or .csv, or leave out --merged");
  }
}

bool want_neighbours(const std::vector<Output>& outputs) {
  using enum io::MeshFormat;
  return std::ranges::any_of(outputs, [](const Output& output) {
    return output.format == node_ele || output.format == obj || output.format == off || output.format == svg ||
           output.format == png;
  });
}

Written write_one(const std::string& path, const std::function<std::vector<std::string>()>& write) {
  const DeferInterrupt defer;
  const Stopwatch writing;
  Written written{path, {}, 0};
  unless_nobody_reads(path, [&] { written.files = write(); });
  written.seconds = writing.seconds();
  if (interrupted() != 0) throw Cancelled();
  return written;
}

std::vector<Written> write_meshes(const std::vector<Output>& outputs, const io::MeshView& mesh) {
  std::vector<Written> all;
  for (const Output& output : outputs)
    all.push_back(write_one(output.path, [&] { return io::write_mesh(output.path, output.format, mesh); }));
  return all;
}

const char* word(Status status) {
  switch (status) {
    case Status::vertex:
      return "vertex";
    case Status::duplicate:
      return "duplicate";
    case Status::hidden:
      return "hidden";
    case Status::removed:
      break;
  }
  return "removed";
}

std::vector<std::string> status_words(const AnyTriangulation& triangulation) {
  std::vector<std::string> words(triangulation.row_count());
  for (std::size_t row = 0; row < words.size(); ++row) {
    words[row] = word(triangulation.status(static_cast<Index>(row)).status);
  }
  return words;
}

void count(const AnyTriangulation& triangulation, Summary& summary) {
  summary.affine_dimension = triangulation.affine_dimension();
  summary.weighted = triangulation.weighted();
  summary.vertices = triangulation.vertex_count();
  summary.duplicates = triangulation.duplicate_count();
  summary.hidden = triangulation.hidden_count();
  summary.cells = triangulation.cell_count();
  summary.hull_facets = triangulation.hull_facet_count();
  summary.memory_bytes = triangulation.memory_bytes();
  summary.statistics = triangulation.statistics();
}

void count(const FurthestDelaunay& furthest, Summary& summary) {
  summary.affine_dimension = furthest.affine_dimension;
  for (const RowStatus& row : furthest.status) {
    ++(row.status == Status::vertex      ? summary.vertices
       : row.status == Status::duplicate ? summary.duplicates
                                         : summary.hidden);
  }
  summary.cells = furthest.cells.size();
  summary.hull_facets = furthest.hull_facets;
  summary.memory_bytes = furthest.memory_bytes;
  summary.statistics = furthest.statistics;
}

}  // namespace delone::cli
