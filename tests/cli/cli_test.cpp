// The command line as its users meet it: every block of every .test file here is one test.
//
//   === an empty name for people; becomes the test's name
//   --- file points.csv          a file to put into the block's own folder
//   x,y
//   --- run                      a step: shell commands; `delone` is the program, $DATA the project's data/
//   delone info points.csv
//   --- out                      what standard output must be, line by line; nothing when left out
//   exact line
//   ~ regular expression         must match the whole line
//   ...                          any number of lines, also none
//   --- err                      the same for standard error
//   --- exit 2                   exit code; 0 when left out
//   --- unsanitized              skip this block where a sanitizer watches (it may not like what the block does)
//
// Expected values come from reasoning, which the comments (lines with # before the first ===, or between blocks) give.
#ifdef DELONE_EXECUTABLE
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

struct InputFile {
  std::string name;
  Lines lines;
};

struct Step {
  Lines commands, out, err;
  int exit_code = 0;
};

struct Block {
  std::string place;  // file:line
  std::string name;
  std::vector<InputFile> files;
  std::vector<Step> steps;
  bool unsanitized = false;
};

std::ostream& operator<<(std::ostream& stream, const Block& block) { return stream << block.place; }

class Parser {
 public:
  explicit Parser(const fs::path& path) : path_(path), stem_(path.stem().string()) {}

  std::vector<Block> blocks() {
    std::ifstream stream(path_);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) take(line, number);
    trim();
    return blocks_;
  }

 private:
  void take(const std::string& line, int number) {
    if (line.starts_with("=== ")) {
      trim();
      section_ = nullptr;
      blocks_.push_back({path_.filename().string() + ":" + std::to_string(number),
                         stem_ + "__" + identifier(line.substr(4)),
                         {},
                         {}});
    } else if (line.starts_with("--- ")) {
      trim();
      section_ = nullptr;
      open(line.substr(4), number);
    } else if (section_ != nullptr) {
      section_->push_back(line);
    } else if (!line.empty() && !line.starts_with("#")) {
      fail("text outside of a section", number);
    }
  }

  void open(const std::string& header, int number) {
    if (blocks_.empty()) fail("a section before the first block", number);
    Block& block = blocks_.back();
    const std::string word = header.substr(0, header.find(' '));
    const std::string rest = word.size() < header.size() ? header.substr(word.size() + 1) : "";
    if (word == "file") {
      block.files.push_back({rest, {}});
      section_ = &block.files.back().lines;
    } else if (word == "run") {
      block.steps.emplace_back();
      section_ = &block.steps.back().commands;
    } else if (word == "unsanitized") {
      block.unsanitized = true;
    } else if (block.steps.empty()) {
      fail("expectation before the first run", number);
    } else if (word == "out") {
      section_ = &block.steps.back().out;
    } else if (word == "err") {
      section_ = &block.steps.back().err;
    } else if (word == "exit") {
      block.steps.back().exit_code = std::stoi(rest);
    } else {
      fail("unknown section " + word, number);
    }
  }

  /// Blank lines and comments at the end of a section only separate it from the next.
  void trim() {
    if (section_ == nullptr) return;
    while (!section_->empty() && (section_->back().empty() || section_->back().starts_with("# "))) section_->pop_back();
  }

  static std::string identifier(std::string text) {
    for (char& c : text)
      if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return text;
  }

  [[noreturn]] void fail(const std::string& what, int number) const {
    throw std::runtime_error(path_.string() + ":" + std::to_string(number) + ": " + what);
  }

  fs::path path_;
  std::string stem_;
  std::vector<Block> blocks_;
  Lines* section_ = nullptr;
};

std::vector<Block> all_blocks() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(fs::path(DELONE_SOURCE_DIR) / "tests/cli"))
    if (entry.path().extension() == ".test") paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<Block> blocks;
  for (const fs::path& path : paths) std::ranges::move(Parser(path).blocks(), std::back_inserter(blocks));
  return blocks;
}

void write_lines(const fs::path& path, const Lines& lines) {
  std::ofstream stream(path, std::ios::binary);
  for (const std::string& line : lines) stream << line << '\n';
}

Lines read_lines(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  Lines lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool line_matches(const std::string& pattern, const std::string& line) {
  if (pattern.starts_with("~ ")) return std::regex_match(line, std::regex(pattern.substr(2)));
  return pattern == line;
}

/// matched[i][j]: do the patterns from i on match the lines from j on? Filled from the end.
bool lines_match(const Lines& patterns, const Lines& lines) {
  std::vector<std::vector<bool>> matched(patterns.size() + 1, std::vector<bool>(lines.size() + 1, false));
  matched[patterns.size()][lines.size()] = true;
  for (std::size_t i = patterns.size(); i-- > 0;) {
    for (std::size_t j = lines.size() + 1; j-- > 0;) {
      if (patterns[i] == "...")
        matched[i][j] = matched[i + 1][j] || (j < lines.size() && matched[i][j + 1]);
      else
        matched[i][j] = j < lines.size() && line_matches(patterns[i], lines[j]) && matched[i + 1][j + 1];
    }
  }
  return matched[0][0];
}

std::string text(const Lines& lines) {
  std::ostringstream stream;
  for (const std::string& line : lines) stream << "  | " << line << '\n';
  return stream.str();
}

class TemporaryFolder {
 public:
  TemporaryFolder() : path_((fs::temp_directory_path() / "delone-cli-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  fs::path path() const { return path_; }

 private:
  std::string path_;
};

class CommandLine : public testing::TestWithParam<Block> {};

TEST_P(CommandLine, does_what_the_block_says) {
  const Block& block = GetParam();
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  if (block.unsanitized) GTEST_SKIP() << "not under a sanitizer";
#endif
  const TemporaryFolder outside;
  const fs::path inside = outside.path() / "here";
  fs::create_directory(inside);
  for (const InputFile& file : block.files) write_lines(inside / file.name, file.lines);
  for (const Step& step : block.steps) {
    write_lines(outside.path() / "run.sh", step.commands);
    const fs::path executable = DELONE_EXECUTABLE;
    const std::string command = "cd '" + inside.string() + "' && PATH='" + executable.parent_path().string() +
                                "':\"$PATH\" DATA='" DELONE_SOURCE_DIR
                                "/data' LC_ALL=C sh ../run.sh >../out 2>../err </dev/null";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status)) << text(step.commands);
    const Lines out = read_lines(outside.path() / "out"), err = read_lines(outside.path() / "err");
    EXPECT_EQ(WEXITSTATUS(status), step.exit_code) << block.place << '\n' << text(step.commands) << text(err);
    EXPECT_TRUE(lines_match(step.out, out)) << block.place << '\n'
                                            << text(step.commands) << "standard output should be\n"
                                            << text(step.out) << "and is\n"
                                            << text(out);
    EXPECT_TRUE(lines_match(step.err, err)) << block.place << '\n'
                                            << text(step.commands) << "standard error should be\n"
                                            << text(step.err) << "and is\n"
                                            << text(err);
  }
}

INSTANTIATE_TEST_SUITE_P(Cli, CommandLine, testing::ValuesIn(all_blocks()),
                         [](const testing::TestParamInfo<Block>& test) { return test.param.name; });

}  // namespace
#endif
