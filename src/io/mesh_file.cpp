#include "delone/io/mesh_file.hpp"

#include <array>

#include "io/complain.hpp"
#include "io/mesh_io.hpp"
#include "io/source.hpp"

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
  const char* name;  // of the format and, where it is none of the aliases below, the extension
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
};

struct Alias {
  const char* name;
  MeshFormat format;
};

constexpr std::array kAliases{
    Alias{"ele", MeshFormat::node_ele},
    Alias{"neigh", MeshFormat::node_ele},
    Alias{"node_ele", MeshFormat::node_ele},
    Alias{"json", MeshFormat::geojson},
};

const Entry& entry_of(MeshFormat format) {
  for (const Entry& entry : kFormats) {
    if (entry.format == format) return entry;
  }
  return kFormats.front();
}

/// Merged polytopes none of which has more corners than a simplex are the simplices.
bool merges_nothing(const MeshView& mesh) {
  for (std::size_t cell = 0; cell < mesh.merged->size(); ++cell) {
    if ((*mesh.merged)[cell].size() != static_cast<std::size_t>(mesh.cells.corners)) return false;
  }
  return true;
}

}  // namespace

std::optional<MeshFormat> mesh_format(const std::string& name) {
  for (const Entry& entry : kFormats) {
    if (name == entry.name) return entry.format;
  }
  for (const Alias& alias : kAliases) {
    if (name == alias.name) return alias.format;
  }
  return std::nullopt;
}

std::optional<MeshFormat> mesh_format_of_path(const std::string& path) {
  const std::optional<MeshFormat> format = mesh_format(Source::extension(path));
  if (format && path.ends_with(".gz") && !entry_of(*format).packs) return std::nullopt;
  return format;
}

Paths write_mesh(const std::string& path, MeshFormat format, const MeshView& mesh, const PictureOptions& picture) {
  const Entry& entry = entry_of(format);
  if (path.ends_with(".gz") && !entry.packs) refuse_mesh(entry.name, "are not compressed: leave out .gz");
  MeshView shown = mesh;
  const bool rows_only = format == MeshFormat::csv || format == MeshFormat::cells;
  if (!rows_only && mesh.merged != nullptr && merges_nothing(mesh)) shown.merged = nullptr;
  return entry.write(path, shown, picture);
}

}  // namespace delone::io
