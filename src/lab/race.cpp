#include "delone/lab/race.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace delone::lab {
namespace {

constexpr unsigned kLongestRun = 1200;  // seconds
constexpr double kUndisturbed = 0.97;

/// In the child: becomes the command, which writes into `end`.
[[noreturn]] void become(std::vector<std::string> command, int end) {
  dup2(end, STDOUT_FILENO);
  std::vector<char*> arguments;
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  alarm(kLongestRun);  // outlives the exec: no run holds up the rest for ever
  execv(arguments[0], arguments.data());
  _exit(127);
}

Sample run(const Contestant& c) {
  const Workload& w = c.workload;
  Sample sample;
  std::istringstream lines(output_of({c.worker, c.peer, w.kind, std::to_string(w.n), std::to_string(w.dimension), "1",
                                      std::to_string(w.bits), fmt::format("{}", w.weight), std::to_string(w.repeats)},
                                     &sample.peak_bytes));
  const auto take = [&](const char* name) {
    const auto found = sample.counts.extract(name);
    if (found.empty()) throw std::runtime_error(fmt::format("{}: expected a line '{}'", c.worker, name));
    return found.mapped();
  };
  double number = 0;
  for (std::string name; lines >> name >> number;) sample.counts[name] = number;
  sample.seconds = take("seconds");
  sample.processor = take("processor");
  sample.cells = static_cast<std::size_t>(take("cells"));
  sample.vertices = static_cast<std::size_t>(take("vertices"));
  sample.bytes = static_cast<std::size_t>(take("bytes"));
  sample.disturbed = sample.processor < kUndisturbed * sample.seconds;
  return sample;
}

void run_once(Contestant& c) try {
  Sample sample = run(c);
  for (int again = 0; again < 5 && sample.disturbed; ++again) sample = run(c);
  c.samples.push_back(std::move(sample));
} catch (const std::runtime_error&) {
  if (!c.may_fail) throw;
  c.failed = true;
}

}  // namespace

Spread spread(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  return {median, values.front(), values.back()};
}

Spread Contestant::seconds() const {
  std::vector<double> seconds;
  for (const Sample& sample : samples) seconds.push_back(sample.seconds);
  return spread(std::move(seconds));
}

std::string output_of(const std::vector<std::string>& command, std::size_t* peak_bytes) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) become(command, ends[1]);
  close(ends[1]);
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; (got = read(ends[0], buffer.data(), buffer.size())) > 0;)
    text.append(buffer.data(), static_cast<std::size_t>(got));
  close(ends[0]);
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error(fmt::format("failed: {}", fmt::join(command, " ")));
  if (peak_bytes != nullptr) *peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  return text;
}

void alternate(std::vector<Contestant>& contestants, int rounds, const std::function<void(const Contestant&)>& on_run) {
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      Contestant& c = contestants[(i + static_cast<std::size_t>(round)) % contestants.size()];
      if (!c.failed) run_once(c);
      on_run(c);
    }
  }
}

}  // namespace delone::lab
