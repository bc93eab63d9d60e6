// talweg: curves on surface meshes from the command line.
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "cancellation.hpp"
#include "commands.hpp"
#include "failure.hpp"
#include "progress_bar.hpp"
#include "talweg/core/version.hpp"

namespace talweg::driver {
namespace {

int fail(int code, const std::string& message) {
  clear_progress_bar();
  std::fprintf(stderr, "talweg: %s\n", message.c_str());
  return code;
}

int run(int argc, char** argv) {
  CLI::App app("Curves on triangle meshes: draw, smooth while staying close, measure.", "talweg");
  app.set_version_flag("--version", std::string("talweg ") + version());
  app.fallthrough();
  app.footer(
      "Exit codes: 0 done, 1 bad usage, 2 bad input, 3 not converged or a limit was reached (the "
      "result is written), 4 cancelled, 5 internal error.\n"
      "Example:\n"
      "  talweg draw vessel.ply --through 12,845,9001 -o drawn.obj\n"
      "  talweg smooth vessel.ply --curve drawn.obj --tau 2 -o smooth.vtp --report smooth.json\n"
      "  talweg measure vessel.ply smooth.vtp drawn.obj");
  GlobalOptions global;
  app.add_flag("-q,--quiet", global.quiet, "Print nothing but errors");
  app.add_flag("-v,--verbose", global.verbose, "Print the warnings and times of each curve");
  app.add_option("--threads", global.threads, "Threads to use at most; never changes a result")
      ->check(CLI::Range(1U, 1024U))
      ->capture_default_str();
  app.add_option("--seed", global.seed,
                 "Seed of everything random; nothing in draw, smooth, measure and info is")
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
  add(add_labels);
  add(add_compare);
  add(add_info);
  add(add_plugins);
  add(add_run);
  app.allow_extras();  // they get a sentence of ours
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);  // --help, --version
  } catch (const CLI::ParseError& error) {
    return fail(kBadUsage, error.what() + std::string(" (see talweg --help)"));
  }
  for (const std::string& extra : app.remaining(!app.got_subcommand("run"))) {  // run has its own
    return fail(kBadUsage, "\"" + extra + "\" was not expected (see talweg --help)");
  }
  catch_interrupts();
  for (const auto& [subcommand, command] : commands) {
    if (subcommand->parsed()) {
      const int code = command();
      clear_progress_bar();
      if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        return fail(kBadInput, "What was to be printed could not be written to the standard output.");
      }
      return code;
    }
  }
  return fail(kBadUsage,
              "A command is needed: draw, smooth, measure, cut, labels, compare, info, plugins or run (see "
              "talweg --help)");
}

}  // namespace
}  // namespace talweg::driver

int main(int argc, char** argv) {
  using namespace talweg::driver;
  try {
    return run(argc, argv);
  } catch (...) {
    const Failure failure = current_failure();
    return fail(failure.code, failure.message);
  }
}
