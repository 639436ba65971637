#include "outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "command.hpp"
#include "output_file.hpp"

namespace delone::cli {
namespace fs = std::filesystem;

namespace {

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
  if (output.format == io::MeshFormat::npy) return {output.path, with(".points.npy"), with(".cells.npy")};
  return {output.path};
}

/// One spelling for every way to name a file.
std::string identity(const std::string& path) {
  if (path == "-") return path;
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path, ignored), ignored).string();
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

std::vector<Output> plan_outputs(const std::vector<std::string>& paths, const std::string& format,
                                 const std::string& input) {
  std::vector<Output> outputs;
  std::map<std::string, std::string> taken;  // identity of a file: the -o that makes it
  for (const std::string& path : paths) {
    const Output output{path, format_of(path, format)};
    for (const std::string& file : files_of(output)) {
      require_writable(file);
      const auto [earlier, is_new] = taken.emplace(identity(file), path);
      if (!is_new)
        throw UsageError("-o " + earlier->second + " and -o " + path + " would both write " +
                         (file == "-" ? "standard output" : file));
      if (file != "-" && input != "-" && identity(file) == identity(input))
        throw UsageError("-o " + path + " would replace the input " + input);
    }
    outputs.push_back(output);
  }
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

}  // namespace delone::cli
