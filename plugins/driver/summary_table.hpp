// The summary table has the reports of many curves, one per line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "talweg/core/measure/report.hpp"

namespace talweg::driver {

/// A curve of a run. An empty number means all curves of the run.
struct SummaryRow {
  std::string number;
  std::string status;  ///< the report's termination, "failed" or "cancelled"
  std::string message;
  /// The report's cells as one string, as in the table's line, to save memory with thousands of
  /// runs. Empty without a result.
  std::string cells;

  bool operator==(const SummaryRow&) const = default;
};

SummaryRow row_of(std::size_t number, const SmoothingReport& report);

/// All rows of a run.
struct SummaryRun {
  std::size_t line = 0;  ///< line in the list; 0 without a list
  std::string mesh, curve;
  std::vector<SummaryRow> rows;
  std::string inputs, outputs;  ///< stamps (run_stamp.hpp); empty if missing
};

/// `line mesh curve number status message`, the report's names without times and memory, so that
/// equal results give equal tables, `curves` (how many rows the run has), `inputs` and `outputs`.
std::vector<std::string> summary_columns();
/// The lines of the table as comma-separated values, quoted as in RFC 4180, with line ends.
std::string summary_header();
std::string summary_lines(const SummaryRun& run);

/// The inverse of the text: runs from the cells of a table's lines. Runs with missing rows are left
/// out.
std::vector<SummaryRun> runs_of(const std::vector<std::vector<std::string>>& lines);

}  // namespace talweg::driver
