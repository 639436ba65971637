#include "delone/io/points_file.hpp"

#include <array>
#include <utility>

#include "delone/base/arithmetic.hpp"
#include "io/readers.hpp"

namespace delone::io {
namespace {

using Reader = PointTable (*)(const Source&, const ReadOptions&);

struct Entry {
  const char* name;  // of the format and, but for text, the extension
  PointFormat format;
  Reader read;
};

constexpr std::array kFormats{
    Entry{"text", PointFormat::text, read_text_points}, Entry{"npy", PointFormat::npy, read_npy_points},
    Entry{"node", PointFormat::node, read_node},        Entry{"xyz", PointFormat::xyz, read_xyz},
    Entry{"ply", PointFormat::ply, read_ply_points},    Entry{"obj", PointFormat::obj, read_obj_points},
    Entry{"off", PointFormat::off, read_off_points},
};

PointTable parse(const Source& source, const ReadOptions& options) {
  const ExactEnvironment rounding_to_nearest;
  const bool by_name = options.format == PointFormat::automatic;
  const PointFormat format =
      by_name ? point_format(Source::extension(source.name())).value_or(PointFormat::text) : options.format;
  for (const Entry& entry : kFormats) {
    if (entry.format == format) return entry.read(source, options);
  }
  return read_text_points(source, options);
}

}  // namespace

std::optional<PointFormat> point_format(const std::string& name) {
  for (const Entry& entry : kFormats) {
    if (name == entry.name) return entry.format;
  }
  for (const char* text : {"csv", "tsv", "txt"}) {
    if (name == text) return PointFormat::text;
  }
  return std::nullopt;
}

PointTable read_points(const std::string& path, const ReadOptions& options) {
  return parse(Source::read(path), options);
}

PointTable read_points_from_memory(const std::string& name, std::string_view bytes, const ReadOptions& options) {
  return parse(Source::borrow(name, bytes), options);
}

}  // namespace delone::io
