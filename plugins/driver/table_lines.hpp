// Table lines are the cells of a comma- or tab-separated text, the format of run lists and
// journals.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace talweg::driver {

/// The cells of a line that is neither empty nor a comment, and the number of the line at which the
/// cells begin.
struct TableLine {
  std::size_t line = 0;
  std::vector<std::string> cells;
};
/// The lines of a table: comma- or tab-separated, cells quoted as in RFC 4180, `#` at the start of
/// a line for a comment. Throws Error(kBadFile) naming the line of a quote that is not closed or is
/// inside a cell.
std::vector<TableLine> table_lines(const std::string& path, std::string_view text);

/// Throws Error(kBadFile) that names the line.
[[noreturn]] void bad_line(const std::string& path, std::size_t line, const std::string& what);

}  // namespace talweg::driver
