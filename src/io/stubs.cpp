#include "io/complain.hpp"
#include "io/mesh_io.hpp"
#include "io/readers.hpp"
namespace delone::io {
PointTable read_ply_points(const Source& s, const ReadOptions&) { complain(s.name(), "todo"); }
void write_ply(const std::string&, const MeshView&) {}
void write_geojson(const std::string&, const MeshView&) {}
void write_svg(const std::string&, const MeshView&, const PictureOptions&) {}
void write_png(const std::string&, const MeshView&, const PictureOptions&) {}
std::vector<std::string> write_node_ele(const std::string&, const MeshView&) { return {}; }
std::vector<std::string> write_npy(const std::string&, const MeshView&) { return {}; }
CellTable read_ply_cells(const Source& s, std::size_t) { complain(s.name(), "todo"); }
CellTable read_vtu_cells(const Source& s, std::size_t) { complain(s.name(), "todo"); }
CellTable read_geojson_cells(const Source& s, std::size_t) { complain(s.name(), "todo"); }
}  // namespace delone::io
