// docs/papers.md and the sources speak of the same papers. A table row of papers.md is a paper that the code uses;
// papers that wait for their code are listed below the table without a row.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

const std::regex kKey(R"(\[([A-Z][A-Za-z+]*(?:[0-9]{4}|[0-9]{2})[a-z]?|Slides)\])");

/// Keys in the comments of every source, with the first file that names them.
std::map<std::string, std::string> keys_in_code() {
  std::map<std::string, std::string> keys;
  for (const char* root : {"include", "src", "app", "tests", "bench", "examples", "fuzz"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(DELONE_SOURCE_DIR) / root)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      if (entry.path().filename() == "papers_test.cpp") continue;
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        const std::size_t comment = line.find("//");
        if (comment == std::string::npos) continue;
        line.erase(0, comment);
        for (auto i = std::sregex_iterator(line.begin(), line.end(), kKey); i != std::sregex_iterator(); ++i)
          keys.emplace((*i)[1], fs::relative(entry.path(), DELONE_SOURCE_DIR).string());
      }
    }
  }
  return keys;
}

/// Keys that open a row of the table in docs/papers.md.
std::set<std::string> keys_in_table() {
  static const std::regex row(R"(^\|\s*\[([A-Za-z0-9+]+)\])");
  std::set<std::string> keys;
  std::ifstream stream(fs::path(DELONE_SOURCE_DIR) / "docs" / "papers.md");
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, row)) keys.insert(match[1]);
  }
  return keys;
}

TEST(Papers, every_key_in_the_code_has_its_row) {
  const auto table = keys_in_table();
  for (const auto& [key, file] : keys_in_code())
    EXPECT_TRUE(table.contains(key)) << "[" << key << "] in " << file << " has no row in docs/papers.md";
}

TEST(Papers, every_row_is_used_by_the_code) {
  const auto code = keys_in_code();
  for (const std::string& key : keys_in_table())
    EXPECT_TRUE(code.contains(key)) << "[" << key << "] has a row in docs/papers.md, but no source names it";
}

}  // namespace
