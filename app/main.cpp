// The command line: parse, call, convert, report. No geometry lives here.
#include <signal.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "command.hpp"
#include "delone/base/arithmetic.hpp"
#include "delone/base/errors.hpp"
#include "interrupt.hpp"

namespace {

using namespace delone;

int fail(std::string message) {
  while (!message.empty() && message.back() == '\n') message.pop_back();
  std::ranges::replace(message, '\n', ' ');
  std::fprintf(stderr, "delone: %s\n", message.c_str());
  return cli::kBadInput;
}

int run(const cli::Command& command) {
  try {
    return command();
  } catch (const Cancelled&) {
    std::fputs("delone: interrupted\n", stderr);
    return 128 + std::max(cli::interrupted(), 1);
  } catch (const std::bad_alloc&) {
    return fail("out of memory");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Exact Delaunay and regular triangulations in any dimension from 1 to 8.", "delone");
  app.set_version_flag("--version", "delone " DELONE_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  app.get_formatter()->column_width(26);
  app.footer(
      "Exit codes: 0 done, 1 a check failed, 2 bad input or usage.\n"
      "delone COMMAND --help explains a command and gives examples. To begin:\n"
      "  delone generate uniform -n 1000 -o points.csv\n"
      "  delone triangulate points.csv -o picture.svg -o mesh.vtu --check");

  cli::Command command;
  cli::add_triangulate(app, command);
  cli::add_hull(app, command);
  cli::add_voronoi(app, command);
  cli::add_info(app, command);
  cli::add_check(app, command);
  cli::add_nearest(app, command);
  cli::add_locate(app, command);
  cli::add_generate(app, command);
  cli::add_edit(app, command);
  cli::add_bench(app, command);
  cli::add_lab(app, command);
  if (argc < 2) {
    std::fputs(app.help().c_str(), stderr);
    return cli::kBadInput;
  }
  const std::string first = argv[1];
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  if (!first.starts_with('-') && std::ranges::find(commands, first, &CLI::App::get_name) == commands.end()) {
    std::string names;
    for (const CLI::App* known : commands) names += (names.empty() ? "" : ", ") + known->get_name();
    return fail("there is no command '" + first + "'; there are " + names);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {  // --help and --version
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    return fail(std::string(error.what()) + " (see delone " + (chosen.empty() ? "" : chosen.front()->get_name() + " ") +
                "--help)");
  }
  return run(command);
}

}  // namespace

int main(int argc, char** argv) {
  signal(SIGPIPE, SIG_IGN);  // a reader that leaves early shows up as a failed write
  cli::handle_interrupts();
  for (const std::string& problem : arithmetic_problems())
    std::fprintf(stderr, "delone: warning: %s\n", problem.c_str());
  try {
    return parse_and_run(argc, argv);
  } catch (const std::bad_alloc&) {
    return fail("out of memory");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}
