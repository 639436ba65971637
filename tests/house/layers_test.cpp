// The layer rules of the house, executed: every #include of the project is read, and a wrong one fails the test.
// A file includes its own layer and lower ones; beside that stand the rules that two layers of one height never meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, int> kLayers{
    {"base", 1},   {"exact", 2}, {"topology", 2}, {"geometry", 3}, {"order", 3}, {"mesh", 4},
    {"locate", 5}, {"build", 5}, {"remove", 5},   {"dual", 5},     {"query", 5}, {"check", 5},
    {"apps", 6},   {"io", 6},    {"parallel", 6}, {"lab", 6},      {"mpi", 7},   {"app", 8},
};

/// Folders that never see each other, although their heights would allow it.
const std::vector<std::array<std::string, 2>> kForbidden{
    {"topology", "exact"}, {"topology", "geometry"}, {"topology", "order"}, {"exact", "topology"},
    {"check", "build"},    {"check", "remove"},      {"dual", "build"},     {"query", "build"},
};

/// What the installed headers never name: users need only the C++ standard library.
const std::vector<std::string> kNotInPublicHeaders{"boost/", "Eigen/", "gmp",       "CGAL/",       "zlib", "cairo",
                                                   "CLI/",   "fmt/",   "nlohmann/", "fast_float/", "mpfr"};

struct Include {
  fs::path file;  // relative to the source directory
  std::size_t line;
  std::string target;  // as written between the quotes or angle brackets
};

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const char* root : {"include", "src", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(DELONE_SOURCE_DIR) / root))
      if (entry.is_regular_file() && (entry.path().extension() == ".hpp" || entry.path().extension() == ".cpp"))
        files.push_back(fs::relative(entry.path(), DELONE_SOURCE_DIR));
  std::ranges::sort(files);
  return files;
}

std::vector<Include> includes() {
  static const std::regex pattern(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  std::vector<Include> found;
  for (const fs::path& file : sources()) {
    std::ifstream stream(fs::path(DELONE_SOURCE_DIR) / file);
    std::string text;
    for (std::size_t line = 1; std::getline(stream, text); ++line) {
      std::smatch match;
      if (std::regex_search(text, match, pattern)) found.push_back({file, line, match[1]});
    }
  }
  return found;
}

/// The folder under include/delone or src that a file lies in, "app" for the command line, "" for delone.hpp itself.
std::string folder_of(const fs::path& file) {
  auto part = file.begin();
  if (*part == "app") return "app";
  std::advance(part, *part == "include" ? 2 : 1);
  return std::next(part) == file.end() ? "" : part->string();
}

/// The folder that an include names: "delone/mesh/x.hpp" and "mesh/x.hpp" lie in "mesh", a neighbour "x.hpp" beside the
/// file itself; "" when it is not a header of the project.
std::string folder_of(const Include& include) {
  fs::path target = include.target;
  if (*target.begin() == "delone") target = target.lexically_relative("delone");
  if (std::next(target.begin()) == target.end()) {
    const fs::path beside = fs::path(DELONE_SOURCE_DIR) / include.file.parent_path() / target;
    return fs::exists(beside) ? folder_of(include.file) : "";
  }
  const std::string first = target.begin()->string();
  return kLayers.contains(first) ? first : "";
}

std::string place(const Include& include) {
  return include.file.string() + ":" + std::to_string(include.line) + " includes " + include.target;
}

TEST(Layers, every_folder_has_its_layer) {
  for (const fs::path& file : sources()) {
    const std::string folder = folder_of(file);
    EXPECT_TRUE(folder.empty() || kLayers.contains(folder))
        << file << ": add '" << folder << "' to the table of layers";
  }
}

TEST(Layers, a_file_includes_its_own_layer_and_lower_ones) {
  ASSERT_FALSE(includes().empty());
  for (const Include& include : includes()) {
    const std::string from = folder_of(include.file);
    const std::string to = folder_of(include);
    if (from.empty() || to.empty() || !kLayers.contains(from)) continue;
    EXPECT_LE(kLayers.at(to), kLayers.at(from)) << place(include);
  }
}

TEST(Layers, folders_that_must_not_meet_do_not) {
  for (const Include& include : includes())
    for (const auto& [from, to] : kForbidden)
      EXPECT_FALSE(folder_of(include.file) == from && folder_of(include) == to) << place(include);
}

TEST(Layers, a_builder_includes_no_other_builder) {
  for (const Include& include : includes()) {
    if (folder_of(include.file) != "build" || folder_of(include) != "build") continue;
    const std::string own = include.file.stem().string();
    const std::string other = fs::path(include.target).stem().string();
    // build.hpp is the door: it knows the builders, and they know what its options are.
    EXPECT_TRUE(own == "build" || other == "build" || own == other) << place(include);
  }
}

TEST(Layers, installed_headers_need_only_the_standard_library) {
  for (const Include& include : includes()) {
    if (*include.file.begin() != "include") continue;
    for (const std::string& library : kNotInPublicHeaders)
      EXPECT_FALSE(include.target.starts_with(library)) << place(include);
  }
}

TEST(Layers, installed_headers_include_no_header_of_src) {
  for (const Include& include : includes()) {
    if (*include.file.begin() != "include" || folder_of(include).empty()) continue;
    EXPECT_TRUE(fs::exists(fs::path(DELONE_SOURCE_DIR) / "include" / include.target)) << place(include);
  }
}

}  // namespace
