#include "delone/io/mesh_file.hpp"

#include <array>

#include "io/formats.hpp"
#include "io/mesh_io.hpp"

namespace delone::io {
namespace {

using Paths = std::vector<std::string>;
using Writer = Paths (*)(const std::string& path, const MeshView& mesh, const PictureOptions& picture);

template <void (*write)(const std::string&, const MeshView&)>
Paths one_file(const std::string& path, const MeshView& mesh, const PictureOptions&) {
  write(path, mesh);
  return {path};
}

template <void (*write)(const std::string&, const MeshView&, const PictureOptions&)>
Paths one_picture(const std::string& path, const MeshView& mesh, const PictureOptions& picture) {
  write(path, mesh, picture);
  return {path};
}

/// The path without its extension: where the several files of one format take their names from.
template <Paths (*write)(const std::string&, const MeshView&)>
Paths several_files(const std::string& path, const MeshView& mesh, const PictureOptions&) {
  if (path == "-") refuse_mesh("node and npy", "are written in twos and threes, not to standard output");
  const std::size_t dot = path.find_last_of('.');
  const bool has_extension = dot != std::string::npos && dot > path.find_last_of('/') + 1 && dot != 0;
  return write(has_extension ? path.substr(0, dot) : path, mesh);
}

struct Entry {
  std::string_view name;  // of the format, and the extension
  MeshFormat format;
  Writer write;
  bool packs;  // can be compressed
};

constexpr std::array kFormats{
    Entry{"vtu", MeshFormat::vtu, one_file<write_vtu>, false},
    Entry{"ply", MeshFormat::ply, one_file<write_ply>, true},
    Entry{"obj", MeshFormat::obj, one_file<write_obj>, true},
    Entry{"off", MeshFormat::off, one_file<write_off>, true},
    Entry{"node", MeshFormat::node_ele, several_files<write_node_ele>, false},
    Entry{"npy", MeshFormat::npy, several_files<write_npy>, false},
    Entry{"csv", MeshFormat::csv, one_file<write_csv>, true},
    Entry{"cells", MeshFormat::cells, one_file<write_cells>, true},
    Entry{"geojson", MeshFormat::geojson, one_file<write_geojson>, true},
    Entry{"svg", MeshFormat::svg, one_picture<write_svg>, true},
    Entry{"png", MeshFormat::png, one_picture<write_png>, false},
    Entry{"ele", MeshFormat::node_ele, several_files<write_node_ele>, false},
    Entry{"neigh", MeshFormat::node_ele, several_files<write_node_ele>, false},
    Entry{"node_ele", MeshFormat::node_ele, several_files<write_node_ele>, false},
    Entry{"json", MeshFormat::geojson, one_file<write_geojson>, true},
};

/// Merged polytopes none of which has more corners than a simplex are the simplices.
bool merges_nothing(const MeshView& mesh) {
  for (std::size_t cell = 0; cell < mesh.merged->size(); ++cell) {
    if ((*mesh.merged)[cell].size() != static_cast<std::size_t>(mesh.cells.corners)) return false;
  }
  return true;
}

}  // namespace

std::optional<MeshFormat> mesh_format(const std::string& name) { return format_named(kFormats, name); }

std::optional<MeshFormat> mesh_format_of_path(const std::string& path) { return format_of_extension(kFormats, path); }

Paths write_mesh(const std::string& path, MeshFormat format, const MeshView& mesh, const PictureOptions& picture) {
  const Entry& entry = entry_of(kFormats, format);
  require_packs(entry, path);
  MeshView shown = mesh;
  const bool rows_only = format == MeshFormat::csv || format == MeshFormat::cells;
  if (!rows_only && mesh.merged != nullptr && merges_nothing(mesh)) shown.merged = nullptr;
  return entry.write(path, shown, picture);
}

}  // namespace delone::io
