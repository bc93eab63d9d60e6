// talweg smooth: the whole method on the curves of a file, or on many files.
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "file_plan.hpp"
#include "output_file.hpp"
#include "progress_bar.hpp"
#include "repaired_mesh.hpp"
#include "report_table.hpp"
#include "run_journal.hpp"
#include "run_list.hpp"
#include "smooth_many.hpp"
#include "smooth_options.hpp"
#include "smooth_run.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"

namespace talweg::driver {
namespace {

struct SmoothCommand {
  SmoothOptions one;
  ManyOptions many;
};

std::string why_not_converged(const SmoothOptions& options, Outcome outcome) {
  if (outcome == Outcome::kMissed) return "the result misses points that it should pass";
  if (outcome == Outcome::kDeviation) return "no curve within --max-deviation was found";
  const bool budget = options.budget || options.budget_work;
  if (budget && outcome == Outcome::kLimit) return "the budget was used up";
  return fmt::format("the result did not converge ({})", to_string(outcome));
}

/// Prints the decisive warnings before everything else.
void lead_with_decisive(const SmoothingReport& report) {
  for (const Decisive& one : report.decisive) {
    std::fprintf(stderr, "talweg: warning: %s\n", one.sentence.c_str());
  }
}

void tell_ridges(const PlacedResult& result) {
  for (std::size_t c = 0; c < result.ridges.size(); ++c) {
    std::fprintf(text_stream(), "%s\n", result.ridges[c].sentence(c).c_str());
  }
}

int finish(const SmoothOptions& options, const GlobalOptions& global, const RunOutcome& outcome) {
  clear_progress_bar();
  const SmoothingReport& total = outcome.result.total;
  if (outcome.cancelled()) {
    std::fprintf(stderr, "talweg: cancelled; nothing was written.\n");
    return kCancelled;
  }
  const bool table = global.verbose || (options.outputs.empty() && options.report.empty());
  if (!table && !global.quiet) lead_with_decisive(total);
  write_run(options, outcome);
  if (!table && !global.quiet) tell_ridges(outcome.result);
  if (table && !global.quiet) std::fputs(table_of(total).c_str(), text_stream());
  if (total.termination == Outcome::kConverged) return kDone;
  if (!global.quiet) {
    std::fprintf(stderr, "talweg: %s; the best result was written all the same.\n",
                 why_not_converged(options, total.termination).c_str());
  }
  return kNotConverged;
}

[[noreturn]] void bad_usage(const char* message) { throw Error(ErrorCode::kBadUsage, message); }

int run(SmoothCommand command, const GlobalOptions& global) {
  const ManyOptions& many = command.many;
  if (many.resume && journal_of(many.summary).empty()) {
    bad_usage("--resume needs a --summary that is a file.");
  }
  if (!many.list.empty()) {
    if (!command.one.mesh.empty())
      bad_usage("--batch has the meshes in its list: no MESH beside it.");
    return smooth_many(read_run_list(many.list, command.one, many.summary), many, global);
  }
  SmoothOptions& options = command.one;
  if (options.mesh.empty()) bad_usage("A mesh is required, or --batch.");
  if (options.curves.empty() && options.labels.empty()) bad_usage("--curve is required.");
  check_method(options);
  if (options.independent || !many.summary.empty()) {
    const std::vector<ListedRun> runs = {{0, options}};
    check_files(runs, many.list, many.summary);
    return smooth_many(runs, many, global);
  }
  FilePlan files;
  plan_files(options, files);
  files.check();
  options.threads = global.threads;
  Workspace workspace(load_mesh(options.mesh, options.repair), 1);
  return finish(options, global, workspace.smooth(options, progress_bar(global.quiet)));
}

}  // namespace

Command add_smooth(CLI::App& app, const GlobalOptions& global) {
  auto o = std::make_shared<SmoothCommand>();
  CLI::App* command =
      app.add_subcommand("smooth", "Smooth drawn curves while they stay close to the drawing");
  command->add_option("mesh", o->one.mesh, mesh_help());
  add_smooth_options(*command, o->one);
  command->add_option("--batch", o->many.list,
                      "Many runs instead of one: a table (CSV or TSV) with the columns mesh, curve "
                      "and any option above; names of outputs may contain {mesh}, {curve}, "
                      "{folder} and {COLUMN}");
  command
      ->add_option("--jobs", o->many.jobs,
                   "Runs (or independent curves) at a time; never changes a result")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--summary", o->many.summary,
                      "All reports as one table (CSV), one line per curve, failures too");
  command->add_flag(
      "--resume", o->many.resume,
      "Keep outputs of an earlier run of the list if --summary, or the file SUMMARY.part "
      "that a killed run left, shows that they were made from the same files, options "
      "and version; make only the others");
  return [o, &global] { return run(*o, global); };
}

}  // namespace talweg::driver
