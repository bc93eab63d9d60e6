// A run list is a table with one run per line, whose cells also name the outputs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "smooth_options.hpp"

namespace talweg::driver {

/// One run, and its line in the list.
struct ListedRun {
  std::size_t line = 0;
  SmoothOptions options;
};

/// The runs of a table with a header: comma- or tab-separated, cells quoted as in RFC 4180, `#` at
/// the start of a line for a comment. Columns are `mesh`, `curve`, and any option of `smooth` by
/// its name, with - or _. An empty cell means that the option is not given; `base` has the options
/// for all lines. In the names of outputs and reports {mesh} and {curve} are the files' names
/// without folder and extension, {folder} is the mesh's folder, and {COLUMN} the cell of any
/// column. Paths are relative to the working folder.
///
/// Throws Error(kBadFile) with the line for a bad header or cell, for a column that is neither an
/// option nor used in the name of an output, for a run without mesh, curve or output (unless
/// `summary`, the name of a file, is given), and as check_files() does.
std::vector<ListedRun> read_run_list(const std::string& path, const SmoothOptions& base,
                                     const std::string& summary);

/// Throws Error(kBadUsage) if two runs would write the same file, or if a run writes the list or a
/// file that another run reads; and for outputs that cannot be written, as FilePlan::check() does.
void check_files(const std::vector<ListedRun>& runs, const std::string& list,
                 const std::string& summary);

}  // namespace talweg::driver
