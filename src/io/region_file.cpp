#include "delone/io/region_file.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "delone/base/arithmetic.hpp"
#include "io/complain.hpp"
#include "io/numbers.hpp"
#include "io/readers.hpp"
#include "io/rows.hpp"

namespace delone::io {
namespace {

using Corner = std::array<double, 2>;

void add_corner(Ring& ring, const Corner& corner) {
  if (ring.empty() || ring.back() != corner) ring.push_back(corner);
}

/// Leaves out the first corner where it comes again at the end.
void close(Ring& ring) {
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
}

/// The columns of half-spaces, the offset last.
struct Header {
  int dimension;
  std::vector<std::string> names;
};

const std::array kHeaders{Header{2, {"a", "b", "d"}}, Header{2, {"nx", "ny", "offset"}},
                          Header{3, {"a", "b", "c", "d"}}, Header{3, {"nx", "ny", "nz", "offset"}}};

const Header* half_space_header(const Rows& rows) {
  std::vector<std::string> names;
  for (std::size_t column = 0; column < rows.size(); ++column) names.push_back(rows.field(column).text());
  const auto found = std::ranges::find(kHeaders, names, &Header::names);
  return found == kHeaders.end() ? nullptr : found;
}

std::vector<HalfSpace> read_half_spaces(Rows& rows, const Header& header) {
  rows.set_names(header.names);
  std::vector<HalfSpace> half_spaces;
  while (rows.next()) {
    rows.require_size(header.names.size());
    HalfSpace& half_space = half_spaces.emplace_back();
    for (std::size_t axis = 0; axis + 1 < rows.size(); ++axis) half_space.normal[axis] = rows.number(axis);
    half_space.offset = rows.number(rows.size() - 1);
  }
  return half_spaces;
}

/// The ring of the row at hand and the rows that follow under its name; false when the file ends there.
bool read_ring(Rows& rows, std::size_t width, Ring& ring) {
  const bool named = width > 2;
  const std::string name = named ? rows.field(0).text() : "";
  const std::size_t line = rows.line();
  bool more = true;
  while (more && (!named || rows.field(0).text() == name)) {
    rows.require_size(width);
    add_corner(ring, {rows.number(width - 2), rows.number(width - 1)});
    more = rows.next();
  }
  close(ring);
  if (ring.size() < 3) {
    complain(rows.source().name(), Place{.line = line},
             fmt::format("{}: expected at least 3 different corners, found {}",
                         named ? "ring " + io::quoted(name) : "the ring", ring.size()));
  }
  return more;
}

std::vector<Ring> read_rings(Rows& rows) {
  const std::size_t width = rows.size();
  if (width < 2) rows.refuse_row("expected the two coordinates of a corner, found 1 column");
  std::vector<Ring> rings;
  const bool header = !looks_like_number(rows[width - 1]) && !looks_like_number(rows[width - 2]);
  for (bool more = !header || rows.next(); more;) more = read_ring(rows, width, rings.emplace_back());
  return rings;
}

/// The rings of GeoJSON (RFC 7946).
class GeoRings {
 public:
  explicit GeoRings(const Source& source) : file_(source.name()) {
    const auto document = Json::parse(source.bytes(), nullptr, false);
    if (document.is_discarded()) complain(file_, "expected JSON, found something else or a file that is cut off");
    if (type_of(document) == "FeatureCollection") {
      for (const Json& feature : list_of(document, "features")) add_feature(feature);
    } else {
      add_feature(document);
    }
  }
  std::vector<Ring> take() { return std::move(rings_); }

 private:
  using Json = nlohmann::json;

  static std::string type_of(const Json& object) {
    const bool typed = object.is_object() && object.contains("type") && object["type"].is_string();
    return typed ? object["type"].get<std::string>() : "";
  }

  const Json& list_of(const Json& object, const char* name) const {
    if (!object.contains(name)) complain(file_, fmt::format("{} has no {}", type_of(object), io::quoted(name)));
    return require_list(object[name]);
  }

  const Json& require_list(const Json& list) const {
    if (!list.is_array())
      complain(file_, fmt::format("ring {}: expected a list, found {}", rings_.size(), list.type_name()));
    return list;
  }

  void add_feature(const Json& object) {
    const std::string type = type_of(object);
    if (type.empty()) complain(file_, "expected an object of GeoJSON with its \"type\"");
    if (type != "Feature") return add_geometry(object);
    if (object.contains("geometry") && !object["geometry"].is_null()) add_geometry(object["geometry"]);
  }

  void add_geometry(const Json& geometry) {
    const std::string type = type_of(geometry);
    if (type == "Polygon") add_polygon(list_of(geometry, "coordinates"));
    if (type != "MultiPolygon") return;
    for (const Json& polygon : list_of(geometry, "coordinates")) add_polygon(polygon);
  }

  void add_polygon(const Json& polygon) {
    for (const Json& ring : require_list(polygon)) add_ring(ring);
  }

  void add_ring(const Json& positions) {
    Ring ring;
    for (std::size_t i = 0; i < require_list(positions).size(); ++i) {
      const Json& position = positions[i];
      const bool numbers =
          position.is_array() && position.size() >= 2 && position[0].is_number() && position[1].is_number();
      if (!numbers) complain(file_, fmt::format("ring {}, corner {}: expected two numbers", rings_.size(), i));
      add_corner(ring, {position[0].get<double>(), position[1].get<double>()});
    }
    close(ring);
    if (ring.size() < 3) {
      complain(file_,
               fmt::format("ring {}: expected at least 3 different corners, found {}", rings_.size(), ring.size()));
    }
    rings_.push_back(std::move(ring));
  }

  std::string file_;
  std::vector<Ring> rings_;
};

bool is_json(const Source& source) {
  const std::size_t first = source.bytes().find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && source.bytes()[first] == '{';
}

Region parse(const Source& source, int dimension) {
  const std::string& file = source.name();
  std::vector<Ring> rings;
  if (is_json(source)) {
    rings = GeoRings(source).take();
  } else {
    Rows rows(source, detect_delimiter(source));
    if (!rows.next()) complain(file, "expected a region, found nothing");
    if (const Header* header = half_space_header(rows)) {
      if (header->dimension != dimension) {
        complain(file, fmt::format("expected half-spaces of dimension {}, as the points have; found columns {}",
                                   dimension, listed(header->names)));
      }
      return Region::half_spaces(dimension, read_half_spaces(rows, *header));
    }
    if (dimension == 2) rings = read_rings(rows);
  }
  if (dimension != 2) {
    complain(
        file,
        "rings bound regions of the plane; of space expected half-spaces under a header a,b,c,d or nx,ny,nz,offset");
  }
  if (rings.empty()) complain(file, "expected at least one ring, found none");
  return Region::polygon(std::move(rings));
}

/// What a region is refused for names its ring or half-space, but not the file.
Region parse_and_name(const Source& source, int dimension) {
  const ExactEnvironment rounding_to_nearest;
  try {
    return parse(source, dimension);
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (message.starts_with(source.name() + ": ")) throw;
    complain(source.name(), message);
  }
}

}  // namespace

Region read_region(const std::string& path, int dimension) { return parse_and_name(Source::read(path), dimension); }

Region read_region_from_memory(const std::string& name, std::string_view bytes, int dimension) {
  return parse_and_name(Source::borrow(name, bytes), dimension);
}

}  // namespace delone::io
