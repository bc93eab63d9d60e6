// Each of the driver's commands adds itself to the command line and returns an exit code when run.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace talweg::driver {

enum ExitCode {
  kDone = 0,
  kBadUsage = 1,
  kBadInput = 2,
  kNotConverged = 3,  ///< results are written nevertheless
  kCancelled = 4,
  kInternal = 5,
};

struct GlobalOptions {
  bool quiet = false;
  bool verbose = false;
  unsigned threads = 2;
  unsigned seed = 1;  ///< has no effect
};

using Command = std::function<int()>;

/// Throws Error(kBadUsage) naming the first argument with a missing value (mostly an unset variable
/// of a shell): an empty argument, `--tau=`, or a list with nothing between two commas.
void check_values(const CLI::App& app, const std::vector<std::string>& arguments);

/// Throws Error(kBadUsage) for an unknown argument, and suggests a similar known argument.
[[noreturn]] void refuse_unexpected(const CLI::App& app, const std::string& argument);

Command add_draw(CLI::App& app, const GlobalOptions& global);
Command add_smooth(CLI::App& app, const GlobalOptions& global);
Command add_measure(CLI::App& app, const GlobalOptions& global);
Command add_offset(CLI::App& app, const GlobalOptions& global);
Command add_labels(CLI::App& app, const GlobalOptions& global);
Command add_cut(CLI::App& app, const GlobalOptions& global);
Command add_compare(CLI::App& app, const GlobalOptions& global);
Command add_plugins(CLI::App& app, const GlobalOptions& global);
Command add_run(CLI::App& app, const GlobalOptions& global);
Command add_info(CLI::App& app, const GlobalOptions& global);
Command add_completion(CLI::App& app, const GlobalOptions& global);

}  // namespace talweg::driver
