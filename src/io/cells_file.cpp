#include "delone/io/cells_file.hpp"

#include <array>

#include "io/complain.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

using Reader = CellTable (*)(const Source&, std::size_t point_count);

struct Entry {
  const char* name;  // of the format and the extension
  Reader read;
};

constexpr std::array kFormats{
    Entry{"cells", read_text_cells},   Entry{"csv", read_text_cells},  Entry{"ele", read_ele},
    Entry{"npy", read_npy_cells},      Entry{"vtu", read_vtu_cells},   Entry{"ply", read_ply_cells},
    Entry{"off", read_off_cells},      Entry{"obj", read_obj_cells},   Entry{"geojson", read_geojson_cells},
    Entry{"json", read_geojson_cells}, Entry{"text", read_text_cells},
};

CellTable parse(const Source& source, std::size_t point_count, const std::string& format) {
  const std::string name = format.empty() ? Source::extension(source.name()) : format;
  for (const Entry& entry : kFormats) {
    if (name == entry.name) return entry.read(source, point_count);
  }
  if (!format.empty()) complain(source.name(), "there is no format of cells named " + quoted(format));
  return read_text_cells(source, point_count);
}

}  // namespace

CellTable read_cells(const std::string& path, std::size_t point_count, const std::string& format) {
  return parse(Source::read(path), point_count, format);
}

CellTable read_cells_from_memory(const std::string& name, std::string_view bytes, std::size_t point_count,
                                 const std::string& format) {
  return parse(Source::borrow(name, bytes), point_count, format);
}

}  // namespace delone::io
