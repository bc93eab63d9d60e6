// A run list is a table with one run a line, and names of outputs made from it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "smooth_options.hpp"

namespace talweg::driver {

/// One run, and the line of the list that it stands on.
struct ListedRun {
  std::size_t line = 0;
  SmoothOptions options;
};

/// The runs of a table with a header: comma- or tab-separated, cells quoted as in RFC 4180, `#` at
/// the start of a line for a comment. Columns are `mesh`, `curve`, and any option of `smooth` by
/// its name, with - or _; an empty cell is an option that is not given, and `base` holds what holds
/// for all lines. In the names of outputs and reports {mesh} and {curve} are the files' names
/// without folder and ending, {folder} is the mesh's folder, and {COLUMN} the cell of any column.
/// Paths are relative to the working folder.
///
/// Throws Error(kBadFile) with the line for a bad header or cell, a column that is neither an
/// option nor in the name of an output, a run without mesh, curve or output (unless
/// there is a `summary`, the name of a file), and as check_files() does.
std::vector<ListedRun> read_run_list(const std::string& path, const SmoothOptions& base,
                                     const std::string& summary);

/// Throws Error(kBadUsage) where two runs would write the same file or one writes what another one,
/// or the list, is read from; and for outputs that cannot be written, as FilePlan::check() does.
void check_files(const std::vector<ListedRun>& runs, const std::string& list,
                 const std::string& summary);

/// The cells of each line that is neither empty nor a comment, with the line it begins on.
struct TableLine {
  std::size_t line = 0;
  std::vector<std::string> cells;
};
/// Throws Error(kBadFile) naming the line of a quote that is not closed or stands inside a cell.
std::vector<TableLine> table_lines(const std::string& path, std::string_view text);

}  // namespace talweg::driver
