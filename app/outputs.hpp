// The files a run is to write: named, checked against each other and against the dimension before any work.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "delone/apps/furthest.hpp"
#include "delone/io/mesh_file.hpp"
#include "delone/mesh/triangulation.hpp"
#include "summary.hpp"

namespace delone::cli {

struct Output {
  std::string path;
  io::MeshFormat format;
};

/// @param input   the file of the points, which no output may replace
/// @param format  "" to go by the extensions
/// @throws UsageError for an unknown format, two outputs in one file, a place that cannot be written
std::vector<Output> plan_outputs(const std::vector<std::string>& paths, const std::string& format,
                                 const std::string& input);

/// One -o, and the files that it makes.
struct Target {
  std::string path;
  std::vector<std::string> files;
};

/// @param inputs  the files that are read, which no output may replace
/// @throws UsageError for two outputs in one file, a place that cannot be written
void require_apart(const std::vector<Target>& targets, const std::vector<std::string>& inputs);

/// Refuses what can be seen to be unwritable: no such folder, a folder in its place, no permission.
/// @throws UsageError
void require_writable(const std::string& path);

/// @throws UsageError when a format cannot hold points of this dimension
void require_dimension(const std::vector<Output>& outputs, int dimension);

/// @throws UsageError when a format cannot hold merged cells of points of this dimension
void require_merged(const std::vector<Output>& outputs, int dimension);

/// Does a format among these show neighbours, or what they tell: the surface of tetrahedra, edges seen once?
bool want_neighbours(const std::vector<Output>& outputs);

/// Calls `write`, which tells the files it wrote, and takes its time. A file that is begun is finished.
/// @throws Cancelled afterwards, when that was asked for meanwhile
Written write_one(const std::string& path, const std::function<std::vector<std::string>()>& write);

/// Writes every output. @throws Cancelled between two of them
std::vector<Written> write_meshes(const std::vector<Output>& outputs, const io::MeshView& mesh);

/// What became of a row, in a word.
const char* word(Status status);
/// Of every row.
std::vector<std::string> status_words(const AnyTriangulation& triangulation);

/// Fills in the counts.
void count(const AnyTriangulation& triangulation, Summary& summary);
void count(const FurthestDelaunay& furthest, Summary& summary);

}  // namespace delone::cli
