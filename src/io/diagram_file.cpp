#include "delone/io/diagram_file.hpp"

#include <array>

#include "io/diagram_io.hpp"
#include "io/formats.hpp"

namespace delone::io {
namespace {

using Writer = void (*)(const std::string& path, const DiagramView& diagram, const PictureOptions& picture);

template <void (*write)(const std::string&, const DiagramView&)>
void data(const std::string& path, const DiagramView& diagram, const PictureOptions&) {
  write(path, diagram);
}

struct Entry {
  std::string_view name;  // of the format, and the extension
  DiagramFormat format;
  Writer write;
  bool packs;  // can be compressed
  bool space;  // can hold cells of space
};

constexpr std::array kFormats{
    Entry{"vtu", DiagramFormat::vtu, data<write_diagram_vtu>, false, true},
    Entry{"geojson", DiagramFormat::geojson, data<write_diagram_geojson>, true, false},
    Entry{"svg", DiagramFormat::svg, write_diagram_svg, true, false},
    Entry{"png", DiagramFormat::png, write_diagram_png, false, false},
    Entry{"csv", DiagramFormat::csv, data<write_diagram_csv>, true, true},
    Entry{"json", DiagramFormat::geojson, data<write_diagram_geojson>, true, false},
};

}  // namespace

std::optional<DiagramFormat> diagram_format(const std::string& name) { return format_named(kFormats, name); }

std::optional<DiagramFormat> diagram_format_of_path(const std::string& path) {
  return format_of_extension(kFormats, path);
}

bool holds_space(DiagramFormat format) { return entry_of(kFormats, format).space; }

void write_diagram(const std::string& path, DiagramFormat format, const DiagramView& diagram,
                   const PictureOptions& picture) {
  const Entry& entry = entry_of(kFormats, format);
  require_packs(entry, path);
  if (diagram.shapes.dimension != 2 && !entry.space)
    throw InputError(fmt::format("{} files hold cells of the plane, these are of space: write vtu or csv", entry.name));
  entry.write(path, diagram, picture);
}

}  // namespace delone::io
