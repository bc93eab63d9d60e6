#include "smooth_many.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cancellation.hpp"
#include "failure.hpp"
#include "output_file.hpp"
#include "progress_bar.hpp"
#include "run_journal.hpp"
#include "run_stamp.hpp"
#include "shared_work.hpp"
#include "smooth_run.hpp"
#include "summary_table.hpp"

namespace talweg::driver {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFailuresShown = 10;

/// A mesh of one or more runs. The first run opens it and the last one releases it.
class SharedMesh {
 public:
  void add_run() { ++left_; }
  /// Opens the mesh if it is not open yet. Each call rethrows the error of the first attempt.
  MeshFromFile take(const SmoothOptions& options) {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    if (mesh_.opened) return mesh_;
    try {
      mesh_ = load_mesh(options.mesh, options.repair);
    } catch (...) {
      failure_ = std::current_exception();
      throw;
    }
    return mesh_;
  }
  void finish_run() {
    const std::lock_guard lock(mutex_);
    if (--left_ == 0) mesh_ = {};
  }

 private:
  std::mutex mutex_;
  MeshFromFile mesh_;
  std::exception_ptr failure_;
  std::size_t left_ = 0;
};

/// A key that all runs on one mesh have in common.
std::string mesh_of(const SmoothOptions& options) { return options.mesh + '\n' + options.repair; }

/// The outcome of a run; its curves are in its files.
struct RunRecord {
  bool cancelled = true;  ///< until the run is done
  bool kept = false;      ///< from an earlier program
  bool again = false;     ///< an output existed before the run
  std::optional<Failure> failure;
  std::vector<CurveFailure> failed_curves;
  SummaryRun summary;
  std::vector<std::string> decisive;  ///< ": ..." or ", curve 2: ...": see decisive_of()

  [[nodiscard]] int code() const {
    if (cancelled) return kCancelled;
    if (failure) return failure->code;
    const auto converged = [](const SummaryRow& row) {
      return row.status == to_string(Outcome::kConverged);
    };
    int worst = std::ranges::all_of(summary.rows, converged) ? kDone : kNotConverged;
    for (const CurveFailure& curve : failed_curves) {
      if (worst != kInternal) worst = curve.why.code;
    }
    return worst;
  }
};

std::string curve_name(const SmoothOptions& options) {
  return options.curves.empty() ? options.labels
                                : fmt::format("{}", fmt::join(options.curves, " "));
}

/// The rows of a run, failed curves among them, by number.
std::vector<SummaryRow> rows_of(const RunOutcome& outcome) {
  std::vector<SummaryRow> rows;
  auto failed = outcome.failures.begin();
  const auto add_failed = [&](std::size_t before) {
    for (; failed != outcome.failures.end() && failed->curve < before; ++failed) {
      rows.push_back({std::to_string(failed->curve), "failed", failed->why.message, {}});
    }
  };
  for (std::size_t c = 0; c < outcome.numbers.size(); ++c) {
    add_failed(outcome.numbers[c]);
    rows.push_back(row_of(outcome.numbers[c], outcome.result.reports[c]));
  }
  add_failed(std::string::npos);
  return rows;
}

/// The decisive warnings of a run, by which its results may be of no use. A warning that is not
/// about all curves names its curves.
std::vector<std::string> decisive_of(const RunOutcome& outcome) {
  const std::vector<SmoothingReport>& reports = outcome.result.reports;
  std::vector<std::string> lines;
  for (std::size_t c = 0; c < reports.size(); ++c) {
    for (const Decisive& one : reports[c].decisive) {
      const auto has = [&](const SmoothingReport& report) {
        const auto is_same = [&](const Decisive& d) { return d.sentence == one.sentence; };
        return std::ranges::any_of(report.decisive, is_same);
      };
      const bool of_all = std::ranges::all_of(reports, has);
      if (of_all && c > 0) continue;
      const std::string curve = of_all ? "" : fmt::format(", curve {}", outcome.numbers[c]);
      lines.push_back(fmt::format("{}: {}", curve, one.sentence));
    }
  }
  return lines;
}

bool any_output_exists(const SmoothOptions& options) {
  std::error_code ignored;
  return std::ranges::any_of(options.outputs,
                             [&](const std::string& path) { return fs::exists(path, ignored); });
}

/// Ignores errors, because the writing that follows reports them.
void make_folder_of(const std::string& output) {
  std::error_code ignored;
  fs::create_directories(fs::path(output).parent_path(), ignored);
}

class ManyRuns {
 public:
  ManyRuns(std::vector<ListedRun> runs, const ManyOptions& options, const GlobalOptions& global)
      : runs_(std::move(runs)),
        options_(options),
        records_(runs_.size()),
        bar_(runs_.size(), global.quiet) {
    std::map<std::string, std::size_t> first;  // first run on each mesh
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto [at, is_new] = first.emplace(mesh_of(runs_[i].options), i);
      meshes_[mesh_of(runs_[i].options)].add_run();
      order_.emplace_back(at->second, i);
      SummaryRun& place = records_[i].summary;
      place.line = runs_[i].line;
      place.mesh = runs_[i].options.mesh;
      place.curve = curve_name(runs_[i].options);
      runs_[i].options.threads = std::max(1U, global.threads / static_cast<unsigned>(options.jobs));
    }
    // Runs on one mesh are consecutive, so that no more meshes are open than there are jobs.
    std::sort(order_.begin(), order_.end());
    if (!journal_of(options.summary).empty()) {
      make_folder_of(options.summary);
      journal_.emplace(options.summary, options.resume);
    }
  }

  void go() {
    std::vector<Desk> desks(options_.jobs);
    share_work(runs_.size(), options_.jobs, [&](std::size_t worker, std::size_t k) {
      const std::size_t i = order_[k].second;
      if (!interrupted() && !keep(i)) work(desks[worker], i);
      meshes_.at(mesh_of(runs_[i].options)).finish_run();
      bar_.done(records_[i].failure.has_value() || !records_[i].failed_curves.empty());
    });
  }

  [[nodiscard]] std::optional<RunJournal>& journal() { return journal_; }
  [[nodiscard]] const std::vector<RunRecord>& records() const { return records_; }
  [[nodiscard]] const std::vector<ListedRun>& runs() const { return runs_; }

 private:
  /// The mesh and the workspace of a worker.
  struct Desk {
    std::string mesh;
    std::optional<Workspace> workspace;
  };

  /// Keeps the outcome of an earlier program if the run would have the same outcome again.
  bool keep(std::size_t i) {
    if (options_.summary.empty()) return false;
    const SmoothOptions& options = runs_[i].options;
    RunRecord& record = records_[i];
    record.summary.inputs = stamps_.of(options);
    if (!options_.resume) return false;
    const SummaryRun* earlier = journal_->earlier(record.summary.inputs, outputs_stamp(options));
    record.again = earlier == nullptr && any_output_exists(options);
    if (earlier == nullptr) return false;
    record.summary.rows = earlier->rows;
    record.summary.outputs = earlier->outputs;
    record.kept = true;
    record.cancelled = false;
    return true;
  }

  void work(Desk& desk, std::size_t i) {
    const SmoothOptions& options = runs_[i].options;
    RunRecord& record = records_[i];
    try {
      if (desk.mesh != mesh_of(options) || !desk.workspace) {
        desk.workspace.reset();  // before the next mesh is opened
        desk.mesh = mesh_of(options);
        // A single run uses the threads for its curves.
        const std::size_t threads = runs_.size() == 1 ? options_.jobs : 1;
        desk.workspace.emplace(meshes_.at(desk.mesh).take(options), threads);
      }
      RunOutcome outcome = desk.workspace->smooth(options, [&](const char*, double) {
        bar_.tick();
        return !interrupted();
      });
      if (outcome.cancelled()) return;
      for (const std::string& output : options.outputs) make_folder_of(output);
      make_folder_of(options.report);
      write_run(options, outcome);
      record.decisive = decisive_of(outcome);
      record.summary.rows = rows_of(outcome);
      record.failed_curves = std::move(outcome.failures);
      if (!options_.summary.empty()) record.summary.outputs = outputs_stamp(options);
      if (journal_) journal_->add(record.summary);
    } catch (const WaitCancelled&) {
      return;
    } catch (...) {
      record.failure = current_failure();
    }
    record.cancelled = false;
  }

  std::vector<ListedRun> runs_;
  const ManyOptions& options_;
  std::vector<RunRecord> records_;
  std::map<std::string, SharedMesh> meshes_;
  std::vector<std::pair<std::size_t, std::size_t>> order_;  // {first run on the mesh, run}
  InputStamps stamps_;
  std::optional<RunJournal> journal_;
  CountedBar bar_;
};

std::string summary_of(const ManyRuns& many) {
  std::string text = summary_header();
  for (const RunRecord& record : many.records()) {
    SummaryRun run = record.summary;
    if (record.cancelled) {
      run.rows = {{"", "cancelled", "", {}}};
    } else if (record.failure) {
      run.rows = {{"", "failed", record.failure->message, {}}};
    }
    text += summary_lines(run);
  }
  return text;
}

std::string place_of(const ListedRun& run, const ManyOptions& options) {
  return run.line > 0 ? fmt::format("{}, line {} ({})", options.list, run.line, run.options.mesh)
                      : run.options.mesh;
}

/// Prints the decisive warnings on stderr before everything else, up to a limit. The earlier
/// program has printed the warnings of kept runs.
void tell_decisive(const ManyRuns& many, const ManyOptions& options) {
  std::size_t lines = 0;
  for (std::size_t i = 0; i < many.runs().size(); ++i) {
    for (const std::string& sentence : many.records()[i].decisive) {
      if (++lines > kFailuresShown) continue;
      std::fprintf(stderr, "talweg: warning: %s%s\n", place_of(many.runs()[i], options).c_str(),
                   sentence.c_str());
    }
  }
  if (lines > kFailuresShown) {
    std::fprintf(stderr, "talweg: warning: %zu more warnings%s%s.\n", lines - kFailuresShown,
                 options.summary.empty() ? "; --summary lists all" : " are in ",
                 options.summary.c_str());
  }
}

/// Writes one line to stderr for each failure, up to a limit; returns the number of runs that
/// failed completely or in part.
std::size_t tell_failures(const ManyRuns& many, const ManyOptions& options) {
  std::size_t failed = 0, shown = 0, lines = 0;
  const auto tell = [&](const ListedRun& run, const std::string& what, const std::string& why) {
    ++lines;
    if (shown == kFailuresShown) return;
    ++shown;
    std::fprintf(stderr, "talweg: %s%s: %s\n", place_of(run, options).c_str(), what.c_str(),
                 why.c_str());
  };
  for (std::size_t i = 0; i < many.runs().size(); ++i) {
    const RunRecord& record = many.records()[i];
    if (record.failure) tell(many.runs()[i], "", record.failure->message);
    for (const CurveFailure& curve : record.failed_curves) {
      tell(many.runs()[i], fmt::format(", curve {}", curve.curve), curve.why.message);
    }
    if (record.failure || !record.failed_curves.empty()) ++failed;
  }
  if (lines > shown) {
    std::fprintf(stderr, "talweg: %zu more failed%s%s.\n", lines - shown,
                 options.summary.empty() ? "; --summary lists all" : "; all are in ",
                 options.summary.c_str());
  }
  return failed;
}

int worst_code(const ManyRuns& many) {
  // From the mildest to the worst outcome.
  constexpr std::array<int, 6> kSeverity = {kDone,     kNotConverged, kBadUsage,
                                            kBadInput, kInternal,     kCancelled};
  const auto severity = [&](int code) {
    return std::find(kSeverity.begin(), kSeverity.end(), code) - kSeverity.begin();
  };
  int worst = kDone;
  for (const RunRecord& record : many.records()) {
    if (severity(record.code()) > severity(worst)) worst = record.code();
  }
  return worst;
}

void tell_counts(ManyRuns& many, const ManyOptions& options, std::size_t failed) {
  const auto number = [&](const auto& is) {
    return static_cast<std::size_t>(std::ranges::count_if(many.records(), is));
  };
  const std::size_t count = many.runs().size();
  const std::size_t unfinished = number([](const RunRecord& r) { return r.cancelled; });
  const std::size_t kept = number([](const RunRecord& r) { return r.kept; });
  std::string before;
  if (options.resume) {
    const std::size_t again = number([](const RunRecord& r) { return r.again && !r.cancelled; });
    before = fmt::format("{} kept as they were, {} made of which {} anew; ", kept,
                         count - kept - unfinished, again);
    if (!many.journal()->other_table().empty()) {
      std::fprintf(stderr, "talweg: nothing could be kept: %s.\n",
                   many.journal()->other_table().c_str());
    }
  }
  std::fprintf(text_stream(),
               "%zu run%s: %s%zu done, %zu of them not converged; %zu failed, %zu cancelled\n",
               count, count == 1 ? "" : "s", before.c_str(), count - failed - unfinished,
               number([](const RunRecord& r) { return r.code() == kNotConverged; }), failed,
               unfinished);
}

}  // namespace

int smooth_many(std::vector<ListedRun> runs, const ManyOptions& options,
                const GlobalOptions& global) {
  ManyRuns many(std::move(runs), options, global);
  many.go();
  clear_progress_bar();
  if (!global.quiet) tell_decisive(many, options);
  if (!options.summary.empty()) write_output(options.summary, summary_of(many));
  if (many.journal()) many.journal()->close();
  const std::size_t failed = tell_failures(many, options);
  if (!global.quiet) tell_counts(many, options, failed);
  return worst_code(many);
}

}  // namespace talweg::driver
