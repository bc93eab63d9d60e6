#include "run_journal.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "output_file.hpp"
#include "table_lines.hpp"
#include "talweg/core/io/file_bytes.hpp"

namespace talweg::driver {
namespace {

namespace fs = std::filesystem;

bool has_result(const SummaryRow& row) { return !row.cells.empty(); }

/// Whether the journal has a result for every curve of the run, which then need not be repeated.
bool is_done(const SummaryRun& run) {
  return !run.inputs.empty() && !run.outputs.empty() && std::ranges::all_of(run.rows, has_result);
}

}  // namespace

std::string journal_of(const std::string& summary) {
  std::error_code ignored;
  if (summary.empty() || is_standard_output(summary)) return {};
  if (fs::exists(summary, ignored) && !fs::is_regular_file(summary, ignored)) return {};
  return summary + ".part";
}

RunJournal::RunJournal(std::string summary, bool resume)
    : summary_(std::move(summary)), path_(journal_of(summary_)) {
  if (resume) {
    read(summary_);
    read(path_);
  }
  std::string kept = summary_header();
  for (const auto& [stamps, run] : earlier_) kept += summary_lines(run);
  write_file(path_, kept);
  file_ = open_file(path_, FileUse::kAppend);
  if (!file_) cannot_write(path_, reason_of(errno));
}

void RunJournal::read(const std::string& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return;
  const std::string text = read_file(path);
  // A program that was killed may have left half a line.
  const std::string_view whole = std::string_view(text).substr(0, text.rfind('\n') + 1);
  std::vector<std::vector<std::string>> lines;
  for (TableLine& line : table_lines(path, whole)) lines.push_back(std::move(line.cells));
  if (lines.empty() || lines.front() != summary_columns()) {
    other_table_ = path + " has other columns than this version's summaries";
    return;
  }
  for (SummaryRun& run : runs_of(lines)) {
    if (is_done(run)) earlier_.insert_or_assign({run.inputs, run.outputs}, std::move(run));
  }
}

const SummaryRun* RunJournal::earlier(const std::string& inputs, const std::string& outputs) const {
  const auto found = earlier_.find({inputs, outputs});
  return found == earlier_.end() ? nullptr : &found->second;
}

void RunJournal::add(const SummaryRun& run) {
  if (!is_done(run)) return;
  const std::string lines = summary_lines(run);
  const std::lock_guard lock(mutex_);
  // A run is written in one piece, so that a killed program leaves whole runs.
  if (std::fwrite(lines.data(), 1, lines.size(), file_.get()) != lines.size() ||
      std::fflush(file_.get()) != 0) {
    cannot_write(path_, reason_of(errno));
  }
}

void RunJournal::close() {
  file_.reset();
  std::error_code ignored;
  fs::remove(path_, ignored);
}

}  // namespace talweg::driver
