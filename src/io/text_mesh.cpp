// Cells as text: CSV with a header, and .cells, the same without header and separated by blanks.
// Merged polytopes make rows of different lengths under a header as long as the longest.
#include <algorithm>

#include "io/mesh_io.hpp"

namespace delone::io {
namespace {

void write_rows(Output& out, const MeshView& mesh, char separator) {
  const auto write_row = [&](std::span<const Index> row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i != 0) out << separator;
      out << row[i];
    }
    out << '\n';
  };
  const std::size_t count = mesh.merged != nullptr ? mesh.merged->size() : mesh.cells.size();
  for (std::size_t cell = 0; cell < count; ++cell) {
    write_row(mesh.merged != nullptr ? (*mesh.merged)[cell] : mesh.cells[cell]);
  }
}

std::size_t most_corners(const MeshView& mesh) {
  if (mesh.merged == nullptr) return static_cast<std::size_t>(mesh.cells.corners);
  std::size_t most = 0;
  for (std::size_t cell = 0; cell < mesh.merged->size(); ++cell) most = std::max(most, (*mesh.merged)[cell].size());
  return most;
}

}  // namespace

void write_csv(const std::string& path, const MeshView& mesh) {
  Output out(path);
  const std::size_t corners = most_corners(mesh);
  for (std::size_t i = 0; i < corners; ++i) out.print("{}v{}", i == 0 ? "" : ",", i);
  if (corners != 0) out << '\n';
  write_rows(out, mesh, ',');
  out.commit();
}

void write_cells(const std::string& path, const MeshView& mesh) {
  Output out(path);
  write_rows(out, mesh, ' ');
  out.commit();
}

}  // namespace delone::io
