// talweg: curves on surface meshes from the command line.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cancellation.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "progress_bar.hpp"
#include "suggestion.hpp"
#include "talweg/core/version.hpp"
#include "talweg/heat/cholesky_factor.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

int fail(int code, const std::string& message) {
  clear_progress_bar();
  std::fprintf(stderr, "talweg: %s\n", message.c_str());
  return code;
}

/// Flushes the output before the exit code reports success.
int printed(int code) {
  std::cout.flush();
  if (std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return fail(kBadInput, "The output could not be written to the standard output.");
}

/// All options, with their dashes, of a command and of the commands above it.
std::vector<std::string> option_names(const CLI::App* app) {
  std::vector<std::string> names;
  for (; app != nullptr; app = app->get_parent()) {
    for (const CLI::Option* option : app->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  }
  return names;
}

/// The command on the command line, or the app itself if there is none.
const CLI::App* given_command(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  return given.empty() ? &app : given.back();
}

int run(const std::vector<std::string>& words) {
  CLI::App app("Curves on triangle meshes: draw, smooth while staying close, measure.", "talweg");
  app.set_version_flag(
      "--version", [] { return fmt::format("talweg {}\n{}", version(), factor_libraries()); },
      "Print the version, and the libraries that solve linear systems");
  app.fallthrough();
  app.allow_windows_style_options(false);  // "/tmp/mesh.ply" is a file everywhere
  app.footer(
      "Exit codes: 0 done, 1 bad usage, 2 bad input, 3 not converged or a limit was reached (the "
      "result is written), 4 cancelled, 5 internal error.\n"
      "An output named - is the standard output; an output named -.vtp is the standard output in "
      "the format .vtp.\n"
      "Example:\n"
      "  talweg draw vessel.ply --through 12,845,9001 -o drawn.obj\n"
      "  talweg smooth vessel.ply --curve drawn.obj --tau 2 -o smooth.vtp --report smooth.json\n"
      "  talweg measure vessel.ply smooth.vtp drawn.obj");
  GlobalOptions global;
  app.add_flag("-q,--quiet", global.quiet, "Print errors only");
  app.add_flag("-v,--verbose", global.verbose, "Print the warnings and times of each curve");
  app.add_option("--threads", global.threads, "Threads to use at most; never changes a result")
      ->check(CLI::Range(1U, 1024U))
      ->capture_default_str();
  app.add_option("--seed", global.seed, "Has no effect: no command uses random numbers")
      ->capture_default_str();

  std::vector<std::pair<const CLI::App*, Command>> commands;
  const auto add = [&](auto adder) {
    const std::size_t known = app.get_subcommands([](CLI::App*) { return true; }).size();
    Command command = adder(app, global);
    commands.emplace_back(app.get_subcommands([](CLI::App*) { return true; })[known],
                          std::move(command));
  };
  add(add_draw);
  add(add_smooth);
  add(add_measure);
  add(add_cut);
  add(add_offset);
  add(add_labels);
  add(add_compare);
  add(add_info);
  add(add_plugins);
  add(add_run);
  add(add_completion);
  app.allow_extras();  // unknown arguments get a message with a suggestion
  const std::vector<std::string> arguments(words.begin() + 1, words.end());
  check_values(app, arguments);
  // An unknown argument is reported before a missing one: it is often the missing one, misspelt.
  const auto check_all_taken = [&app] {
    const bool with_subcommands = !app.got_subcommand("run");  // `run` parses its own words
    for (const std::string& extra : app.remaining(with_subcommands)) refuse_unexpected(app, extra);
  };
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::Success& asked) {
    return printed(app.exit(asked));  // --help, --version
  } catch (const CLI::ParseError& error) {
    check_all_taken();
    return fail(kBadUsage, error.what() + std::string(" (see talweg --help)"));
  }
  check_all_taken();
  catch_interrupts();
  for (const auto& [subcommand, command] : commands) {
    if (subcommand->parsed()) {
      const int code = command();
      clear_progress_bar();
      return printed(code);
    }
  }
  return fail(kBadUsage,
              "A command is needed: draw, smooth, measure, cut, offset, labels, compare, info, "
              "plugins or run (see talweg --help)");
}

/// Whether an argument is the name of an option, of any command, that takes a list.
bool is_list(const CLI::App& app, const std::string& name) {
  if (!name.starts_with("-")) return false;
  const auto takes_list = [&](const CLI::App* command) {
    const CLI::Option* option = command->get_option_no_throw(name);
    return option != nullptr && option->get_delimiter() != '\0';
  };
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  return takes_list(&app) || std::any_of(commands.begin(), commands.end(), takes_list);
}

std::string empty_value(const std::string& name) {
  if (name.starts_with("-")) return fmt::format("The value of {} is empty.", name);
  if (name.empty()) return "An argument is empty.";
  return fmt::format("An argument is empty, after \"{}\".", name);
}

}  // namespace

void check_values(const CLI::App& app, const std::vector<std::string>& arguments) {
  std::string before;
  for (const std::string& argument : arguments) {
    const bool has_value = argument.starts_with("--") || argument.find('=') == 2;  // -o=FILE
    const std::size_t equals =
        argument.starts_with("-") && has_value ? argument.find('=') : std::string::npos;
    const bool inside = equals != std::string::npos;
    const std::string name = inside ? argument.substr(0, equals) : before;
    const std::string value = inside ? argument.substr(equals + 1) : argument;
    if (value.empty()) throw Error(ErrorCode::kBadUsage, empty_value(name));
    const bool gap =
        value.starts_with(',') || value.ends_with(',') || value.find(",,") != std::string::npos;
    if (gap && is_list(app, name)) {
      throw Error(ErrorCode::kBadUsage,
                  fmt::format("A value of the list {} {} is empty.", name, value));
    }
    before = argument;
  }
}

void refuse_unexpected(const CLI::App& app, const std::string& argument) {
  const CLI::App* command = given_command(app);
  std::vector<std::string> known;
  if (argument.starts_with("-")) {
    known = option_names(command);
  } else if (command == &app) {
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
      known.push_back(sub->get_name());
    }
  }
  throw Error(ErrorCode::kBadUsage,
              fmt::format("\"{}\" was not expected{} (see {} --help)", argument,
                          suggestion(argument.substr(0, argument.find('=')), known),
                          app.get_name().empty() ? "talweg" : app.get_name()));
}

}  // namespace talweg::driver

int main(int argc, char** argv) {
  using namespace talweg::driver;
  try {
    return run(command_line(argc, argv));
  } catch (...) {
    const Failure failure = current_failure();
    const int code = fail(failure.code, failure.message);
    // Without memory, OpenBLAS' threads never end, and the usual exit would wait for the threads.
    if (code == kInternal && std::fflush(nullptr) == 0) std::_Exit(code);
    return code;
  }
}
