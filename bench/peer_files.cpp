// Delone's files: reading points from CSV, and writing what was built as VTU.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "bench/peer.hpp"
#include "delone/build/build.hpp"
#include "delone/io/generate.hpp"
#include "delone/io/mesh_file.hpp"
#include "delone/io/points_file.hpp"
#include "delone/mesh/export.hpp"

namespace delone::bench {

namespace {

/// A folder that is gone when the run is over.
class Folder {
 public:
  Folder() : path_((std::filesystem::temp_directory_path() / "delone-bench-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("cannot make a folder in " + path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const char* name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

Run read_csv(PointsView points) {
  const Folder folder;
  const std::string path = folder / "points.csv";
  io::write_points(path, {points.dimension(), {points.coordinates().begin(), points.coordinates().end()}});
  const Clock clock;
  const io::PointTable table = io::read_points(path);
  Run run;
  clock.stop(run);
  run.vertices = table.size();
  run.bytes = std::filesystem::file_size(path);
  return run;
}

/// The table of cells included, as for `delone triangulate -o cells.vtu`.
Run write_vtu(PointsView points) {
  const Folder folder;
  const std::string path = folder / "cells.vtu";
  io::PointTable table;
  table.dimension = points.dimension();
  table.coordinates = {points.coordinates().begin(), points.coordinates().end()};
  const AnyTriangulation t = build(points);
  const Clock clock;
  const CellTable cell_table = cells(t, false);
  io::write_mesh(path, io::MeshFormat::vtu, {.points = table, .cells = cell_table, .elevation = ""});
  Run run;
  clock.stop(run);
  run.cells = t.cell_count();
  run.vertices = t.vertex_count();
  run.bytes = std::filesystem::file_size(path);
  return run;
}

}  // namespace

std::vector<Peer> file_peers() {
  const auto to_vtu = [](int dimension, bool weighted) { return dimension <= 3 && !weighted; };
  return {{"Delone-read-csv", DELONE_VERSION, [](int, bool weighted) { return !weighted; }, read_csv},
          {"Delone-write-vtu", DELONE_VERSION, to_vtu, write_vtu}};
}

}  // namespace delone::bench
